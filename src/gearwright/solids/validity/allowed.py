"""What the moments of faces mean that do not bound a solid: the rules of each kind of problem that can be allowed."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...moments.faces import face_vectors
from ...moments.polyhedron import PolyhedronMoments, polyhedron_moments
from .report import PolyhedronValidity


def allowed_moments(validity: PolyhedronValidity) -> tuple[PolyhedronMoments, float]:
    """Moments of the faces as they are, and their area.

    Faces that are not planar are fans from the mean of their corners. Edges that faces use more often one way close
    by triangles to the centre of the bounding box, which count nothing there; they are no part of the area.
    """
    vertices, indices, offsets = _split(validity)
    area = float(np.linalg.norm(face_vectors(vertices, indices, offsets), axis=-1).sum())
    excess = validity.edges.excess
    if len(excess):
        used = vertices[indices]
        low, high = used.min(axis=0), used.max(axis=0)
        apex = np.full((len(excess), 1), len(vertices))
        vertices = np.concatenate([vertices, [low + (high - low) / 2.0]])
        indices = np.concatenate([indices, np.concatenate([excess[:, ::-1], apex], axis=1).reshape(-1)])
        offsets = np.concatenate([offsets, offsets[-1] + 3 * np.arange(1, len(excess) + 1)])
    return polyhedron_moments(vertices, indices, offsets), area


def _split(validity: PolyhedronValidity) -> tuple[Array, Indices, Indices]:
    """The faces with those that are not planar cut into triangles round the mean of their corners."""
    vertices, indices, offsets = validity.vertices, validity.indices, validity.offsets
    chosen = validity.nonplanar_faces
    if not len(chosen):
        return vertices, indices, offsets
    sizes = np.diff(offsets)
    kept = np.ones(len(sizes), bool)
    kept[chosen] = False
    apexes, triangles = [], []
    for number, face in enumerate(chosen):
        corners = indices[offsets[face] : offsets[face + 1]]
        apexes.append(vertices[corners[0]] + (vertices[corners] - vertices[corners[0]]).mean(axis=0))
        apex = np.full(len(corners), len(vertices) + number)
        triangles.append(np.stack([apex, corners, np.roll(corners, -1)], axis=1))
    cut = np.concatenate(triangles)
    return (
        np.concatenate([vertices, apexes]),
        np.concatenate([indices[np.repeat(kept, sizes)], cut.reshape(-1)]),
        np.concatenate([[0], np.cumsum(np.concatenate([sizes[kept], np.full(len(cut), 3)]))]),
    )
