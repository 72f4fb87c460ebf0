"""What a page is told of a design, bit by bit, what is wanted first before the rest: job of a worker."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ..errors import ParameterError, Problem, ProblemsError
from ..materials import DENSITY, material
from .approximation import approximations
from .built import built_from
from .design import Design, design_of
from .document import built_document, plain
from .drawn import drawn
from .kinds import article
from .overlays import overlays

Answer = bytes | dict[str, Any]


def answers(request: Mapping[str, Any]) -> Iterator[Answer]:
    """The shape, as `viewer.frame` has it; then sizes and properties, properties of the polyhedron, what is drawn over.

    request   "design": names and values; "density": kg/m³, or "material": its name; "have": keys of topologies that
              the page has already; "id": what the shape is told with, by which the page knows what it answers

    Raises GearwrightError where the design cannot be built, or the density is none.
    """
    design = design_of(request["design"])
    element = built_element(design)
    density = density_of(request)
    yield drawn(design.kind, element, request.get("id"), frozenset(request.get("have", ())))
    built = built_from(design.kind, element, density, 0.0)
    yield {
        "answer": "values",
        "document": plain(built_document(built)),
        "origin": design.kind.origin,
        "remarks": list(element.remarks),
    }
    yield {"answer": "overlays", **overlays(design.kind, built)}
    yield {"answer": "approximation", **plain(approximations(built, density))}


def built_element(design: Design) -> Any:
    """The element of a design. Raises ProblemsError with everything that is wrong with it."""
    element, problems = design.element()
    if problems:
        raise ProblemsError(f"{article(design.kind.name).capitalize()} {design.kind.name} cannot be built so", problems)
    return element


def density_of(request: Mapping[str, Any]) -> float | None:
    """kg/m³, by itself or by a material's name; None where neither is given. Raises ParameterError where it is none."""
    if request.get("material") is not None:
        return material(request["material"]).density
    density = request.get("density")
    if density is not None and (problem := DENSITY.problem(density)):
        raise ParameterError("Mass", [Problem(f"density = {density}", problem)])
    return None if density is None else float(density)
