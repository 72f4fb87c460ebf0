"""The examination of a polyhedron's faces: linear in their number, but for shells inside shells."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...moments.planarity import FaceMeasures, face_measures
from .doubles import doubled_faces
from .edge_defects import EdgeDefects
from .edges import EdgeUses, Flags, bounding_uses, edge_defects, edge_uses
from .nesting import nesting
from .report import PolyhedronValidity
from .shells import Patches, patches, pinched_vertices, shells

PLANARITY = 1e-6
"""How far corners may be off their face's plane, in diagonals of the box round what it is connected with: what a file
with seven digits leaves. Beyond it the face has no single answer."""

_ROUNDINGS = 4.0
"""How far corners may be off, in roundings of the file: √3 in space, and as much again for the plane itself."""

_SPACINGS = 4.0
"""The same in spacings of float64 at the largest coordinate of what it is connected with."""

_SLIVER = 1e-12
"""A face counts as degenerate where its area is less than this × its extent squared."""


def examine(vertices: Array, indices: Indices, offsets: Indices, rounding: float = 0.0) -> PolyhedronValidity:
    """Examines faces in the form of `moments.faces`; corners in range, at least three a face.

    rounding   largest error of a coordinate, in lengths: how coarsely a file holds them
    """
    used = np.zeros(len(vertices), bool)
    used[indices] = True
    largest = float(np.abs(vertices[used]).max(initial=0.0))
    _, exponent = np.frexp(largest)
    points = np.ldexp(vertices, -exponent)  # exact, and no product overflows or vanishes
    uses = edge_uses(len(vertices), indices, offsets)
    bounding = bounding_uses(uses)
    edges = edge_defects(bounding, indices, offsets)
    found = patches(bounding, len(offsets) - 1)
    parts = shells(bounding, found.first)
    measures = face_measures(points, indices, offsets)
    nested = nesting(points, indices, offsets, parts, measures.areas)
    duplicates, back_to_back = doubled_faces(indices, offsets, found.first)
    accepted = _planarity(nested.boxes, float(np.ldexp(rounding, -exponent)))
    off = np.flatnonzero(measures.deviations)
    shares = measures.deviations[off] / accepted[parts.labels[off]]
    nonplanar = off[shares > 1.0]
    # of the face that comes closest to what is accepted, or exceeds it most
    planarity = accepted[parts.labels[off[np.argmax(shares)]]] if len(off) else accepted.min(initial=np.inf)
    area = float(measures.areas.sum())
    sizes = np.bincount(parts.labels, minlength=len(parts.closed))
    firsts = np.unique(parts.labels, return_index=True)[1]
    return PolyhedronValidity(
        vertices=vertices,
        indices=indices,
        offsets=offsets,
        edges=edges,
        flipped_faces=np.flatnonzero(found.minority()),
        one_sided=_groups_with(found.one_sided, found.first),
        unexplained_flips=_unexplained(edges, found, bounding),
        degenerate_faces=_degenerate(indices, offsets, measures),
        nonplanar_faces=nonplanar,
        deviations=np.ldexp(measures.deviations[nonplanar], exponent),
        deviation=float(np.ldexp(measures.deviations.max(initial=0.0), exponent)),
        planarity=float(np.ldexp(planarity, exponent)) if len(accepted) else 0.0,
        duplicates=duplicates,
        back_to_back=back_to_back,
        pinched_vertices=pinched_vertices(uses, len(vertices), indices, offsets),
        unused_vertices=np.flatnonzero(~used),
        labels=parts.labels,
        inward=np.stack([firsts[nested.inward], sizes[nested.inward]], axis=-1),
        buried=np.stack([firsts[nested.buried], sizes[nested.buried]], axis=-1),
        body_labels=nested.bodies()[parts.labels],
        closure=float(np.linalg.norm(measures.residual)) / area if area else 0.0,
        flat=bool(len(sizes)) and bool(parts.closed.all()) and not nested.volumes.any(),
    )


def _planarity(boxes: Array, rounding: float) -> Array:
    """How far corners may be off their faces' planes (s,), of shells with these boxes (s, 2, 3)."""
    diagonals = np.linalg.norm(boxes[:, 1] - boxes[:, 0], axis=1)
    spacings = np.spacing(np.abs(boxes).max(axis=(1, 2), initial=0.0))
    return np.maximum(np.maximum(PLANARITY * diagonals, _ROUNDINGS * rounding), _SPACINGS * spacings)


def _degenerate(indices: Indices, offsets: Indices, measures: FaceMeasures) -> Indices:
    """Faces (k,) without area, or with one corner twice in a row."""
    stays = np.zeros(len(offsets) - 1, bool)
    twice = np.flatnonzero(indices[1:] == indices[:-1])
    face = np.searchsorted(offsets, twice, side="right") - 1
    stays[face[twice + 1 < offsets[face + 1]]] = True
    stays |= indices[offsets[:-1]] == indices[offsets[1:] - 1]
    return np.flatnonzero(stays | (measures.areas <= _SLIVER * measures.extents**2))


def _unexplained(edges: EdgeDefects, found: Patches, bounding: EdgeUses) -> bool:
    """Whether faces disagree along edges, but none of them is flipped and none lies on a one-sided patch."""
    if not len(edges.flipped) or found.minority().any():
        return False
    counts = np.diff(bounding.starts)
    two = bounding.starts[:-1][counts == 2]
    alike = two[bounding.forward[two] == bounding.forward[two + 1]]
    one_sided = int(found.one_sided[bounding.faces[alike]].sum())
    return one_sided < len(edges.flipped)


def _groups_with(faces: Flags, labels: Indices) -> Indices:
    """Of groups, by labels (f,), that hold one of the chosen faces (f,): first face and number of faces (k, 2)."""
    numbers, first, counts = np.unique(labels, return_index=True, return_counts=True)
    chosen = np.isin(numbers, labels[faces])
    return np.stack([first[chosen], counts[chosen]], axis=-1).astype(np.int64)
