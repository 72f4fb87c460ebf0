"""The polyhedra of what is built, and how far their properties are from the exact ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..solids.properties import MassProperties
from .built import Built, units_and_density
from .document import properties_document


def approximations(built: Built, density: float | None) -> dict[str, Any]:
    """{"parts": properties of each part's polyhedron of the default tolerance, "errors": of each, "triangles": count}.

    Errors are those of `solids.convergence`: the volume's is relative, the centroid's over the diagonal of the bounding
    box, the inertia's the norm of the difference about the centroid over the norm.

    density   kg/m³, or None
    """
    _, own_density = units_and_density(built.units.length, density)
    parts, errors, triangles = {}, {}, {}
    for name, part in built.parts.items():
        polyhedron = part.gear.polyhedron()
        found = polyhedron.properties(own_density)
        parts[name] = properties_document(found, built.units)
        errors[name] = _errors(found, part.properties)
        triangles[name] = len(polyhedron.simple_triangles())
    return {"parts": parts, "errors": errors, "triangles": triangles}


def _errors(found: MassProperties, exact: MassProperties) -> dict[str, float]:
    low, high = exact.bounding_box if exact.bounding_box is not None else (exact.centroid, exact.centroid)
    diagonal = float(np.linalg.norm(high - low)) or 1.0
    difference = np.linalg.norm(found.central_inertia - exact.central_inertia)
    return {
        "volume": abs(found.volume - exact.volume) / exact.volume,
        "centroid": float(np.linalg.norm(found.centroid - exact.centroid)) / diagonal,
        "inertia": float(difference / np.linalg.norm(exact.central_inertia)),
    }
