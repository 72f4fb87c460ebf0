"""How large polygon faces are, and how far their corners lie off a plane."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled

_DIRECTIONLESS = 1e-13
"""Below this × a face's extent squared the direction of its area vector is rounding error."""


class FaceMeasures(NamedTuple):
    """Measures of faces.

    areas       (f,) length of the area vector: the area in the mean plane
    extents     (f,) largest distance of a corner from the first one
    deviations  (f,) largest distance of a corner from the mean plane: through the mean of the corners, normal to
                the area vector, or where that vanishes along the corners' two greatest extents; 0 of triangles
    residual    (3,) Σ of all area vectors: 0 where the faces close
    """

    areas: Array
    extents: Array
    deviations: Array
    residual: Array


def face_measures(vertices: Array, indices: Indices, offsets: Indices) -> FaceMeasures:
    """Measures of faces in the form of `moments.faces`."""
    areas, extents, deviations, residual = _measures(vertices, indices, offsets)
    vanishing = (areas <= _DIRECTIONLESS * extents**2) & (np.diff(offsets) > 3)
    for f in np.flatnonzero(vanishing):
        corners = vertices[indices[offsets[f] : offsets[f + 1]]]
        local = corners - corners[0]
        local = local - local.mean(axis=0)
        deviations[f] = np.abs(local @ np.linalg.svd(local, full_matrices=False)[2][-1]).max()
    return FaceMeasures(areas, extents, deviations, residual)


@compiled
def _measures(vertices: Array, indices: Indices, offsets: Indices) -> tuple[Array, Array, Array, Array]:
    count = len(offsets) - 1
    areas, extents, deviations = np.empty(count), np.empty(count), np.zeros(count)
    total, lost = np.zeros(3), np.zeros(3)
    normal, mean = np.empty(3), np.empty(3)
    for f in range(count):
        first, size = indices[offsets[f]], offsets[f + 1] - offsets[f]
        normal[:] = 0.0
        mean[:] = 0.0
        reach = 0.0
        bx, by, bz = 0.0, 0.0, 0.0
        for c in range(offsets[f] + 1, offsets[f + 1]):
            cx = vertices[indices[c], 0] - vertices[first, 0]
            cy = vertices[indices[c], 1] - vertices[first, 1]
            cz = vertices[indices[c], 2] - vertices[first, 2]
            normal[0] += (by * cz - bz * cy) / 2.0
            normal[1] += (bz * cx - bx * cz) / 2.0
            normal[2] += (bx * cy - by * cx) / 2.0
            mean[0] += cx / size
            mean[1] += cy / size
            mean[2] += cz / size
            reach = max(reach, cx * cx + cy * cy + cz * cz)
            bx, by, bz = cx, cy, cz
        areas[f] = np.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2)
        extents[f] = np.sqrt(reach)
        for k in range(3):
            added = total[k] + normal[k]
            larger = abs(total[k]) >= abs(normal[k])
            lost[k] += (total[k] - added) + normal[k] if larger else (normal[k] - added) + total[k]
            total[k] = added
        if size > 3 and areas[f] > 0.0:
            for c in range(offsets[f], offsets[f + 1]):
                off = 0.0
                for k in range(3):
                    off += (vertices[indices[c], k] - vertices[first, k] - mean[k]) * normal[k]
                deviations[f] = max(deviations[f], abs(off) / areas[f])
    return areas, extents, deviations, total + lost
