"""Whether two bodies overlap, or touch otherwise than with the plane faces along which they are glued."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..boundary.boundary import Boundary
from ..boundary.contact import APART, COINCIDENT, HEADLINE, Contact
from ..boundary.extent import rough_diagonal
from ..boundary.joining import meeting
from ..boundary.nearness import Skin
from ..boundary.sampling import sampling
from ..boundary.tessellation import tessellate
from ..errors import GeometryError, Problem
from .self_intersections import find_self_intersections

_COARSE = 2e-3  # chord tolerance, relative to a body's diagonal, of the polyhedra that are searched
_MOST_PAIRS = 4_000_000  # points × triangles looked at: a second or so
_REACH = 0.05  # of the larger body: how far off the other body's box a patch is still looked at between its points
_REMEDY = "only solids that lie apart or against each other can be added; move one of them, or check its length unit"
_IN_PLANE = 10.0 * COINCIDENT  # of the larger body: points of a plane in which the bodies are glued


def united(first: Boundary, second: Boundary) -> Boundary:
    """The boundary of two bodies that lie apart or against each other with plane faces.

    Raises GeometryError saying where, if they overlap or touch in another way: where points all over either skin
    lie in the other body, or where their polyhedra pass through each other by more than their chords.
    """
    met = meeting(first, second)
    one, other = _Body(met.first), _Body(met.second)
    problem = _interference(one, other, met.contacts, "first", "second") or _interference(
        other, one, met.contacts, "second", "first"
    )
    problem = problem or _crossing(one, other)
    if problem:
        raise GeometryError(HEADLINE, [problem])
    return met.boundary


@dataclass(frozen=True)
class _Body:
    boundary: Boundary

    @cached_property
    def diagonal(self) -> float:
        return rough_diagonal(self.boundary)

    @property
    def tolerance(self) -> float:
        return _COARSE * self.diagonal

    @cached_property
    def skin(self) -> Skin:
        return Skin.of(self.boundary)

    @cached_property
    def polyhedron(self) -> tuple[Array, Indices]:
        return tessellate(self.boundary, sampling(self.boundary, self.tolerance))

    @cached_property
    def points(self) -> Array:
        """Points (n, 3) of the true surface all over it."""
        return np.concatenate([self.skin.points, self.polyhedron[0]])

    @cached_property
    def box(self) -> Array:
        return np.stack([self.points.min(axis=0) - self.tolerance, self.points.max(axis=0) + self.tolerance])


def _interference(body: _Body, other: _Body, found: Sequence[Contact], name: str, other_name: str) -> Problem | None:
    """What is wrong with where points of a body's surface lie against another body."""
    from ..moments.components import winding_number

    size = max(body.diagonal, other.diagonal)
    sag = other.tolerance / 100.0
    points = _outside(body.points[_in_box(body.points, other.box)], found, size)
    vertices, triangles = other.polyhedron
    points = points[:: 1 + len(points) * len(triangles) // _MOST_PAIRS]
    points = np.concatenate([points, _nearest(body.skin, other, found, size)])
    if not len(points):
        return None
    distance = other.skin.signed_distance(points, sag)
    touching = np.abs(distance) <= APART * size
    if touching.any():
        where = _place(points[int(np.argmax(touching))])
        return Problem(
            f"the {name} touches the {other_name} near {where}",
            "solids can only be glued along plane faces that lie on one another, their borders the same or nested; move"
            " the piece onto the face, leave a gap, or make both as one section",
        )
    near = 2.0 * other.tolerance
    inside = (distance < 0.0) & (np.abs(distance) <= near)
    for i in np.flatnonzero(np.abs(distance) > near):
        inside[i] = winding_number(points[i], vertices, triangles) > 0.5
        if inside[i]:
            break
    if not inside.any():
        return None
    where = _place(points[int(np.argmax(inside))])
    return Problem(
        f"the {name} overlaps the {other_name} near {where}",
        _REMEDY,
    )


def _crossing(one: _Body, other: _Body) -> Problem | None:
    """Where the polyhedra of two bodies pass through each other so far that the bodies must: a bar through a wall."""
    vertices, triangles = zip(*(_facing(*pair) for pair in ((one, other), (other, one))), strict=True)
    if not all(map(len, triangles)):
        return None
    count = len(triangles[0])
    both = np.concatenate([triangles[0], triangles[1] + len(vertices[0])])
    found = find_self_intersections(np.concatenate(vertices), both, np.arange(len(both)))
    between = (found.pairs[:, 0] < count) & (found.pairs[:, 1] >= count)
    deep = np.flatnonzero(between & (found.depths > 2.0 * (one.tolerance + other.tolerance)))
    if not len(deep):
        return None
    return Problem(f"the first passes through the second near {_place(found.points[deep[0]])}", _REMEDY)


def _facing(body: _Body, other: _Body) -> tuple[Array, Indices]:
    """A body's vertices, and those of its triangles whose boxes reach into the other's."""
    vertices, triangles = body.polyhedron
    low, high = other.polyhedron[0].min(axis=0), other.polyhedron[0].max(axis=0)
    margin = APART * max(body.diagonal, other.diagonal)
    corners = vertices[triangles]
    into = (corners.max(axis=1) > low + margin) & (corners.min(axis=1) < high - margin)
    return vertices, triangles[into.all(axis=1)]


def _nearest(skin: Skin, other: _Body, found: Sequence[Contact], size: float) -> Array:
    """Places (n, 3) where free patches of a skin come nearest to another body: tangents lie between the points."""
    if not len(skin.points):
        return skin.points
    flat: NDArray[np.bool_] = np.any(
        [contact.plane.deviation(skin.points) <= _IN_PLANE * size for contact in found], axis=0
    )
    faces = skin.owners * (1 + skin.images.max()) + skin.images
    glued = np.isin(faces, faces[flat]) if found else np.zeros(len(faces), bool)
    reach = np.array([[-_REACH], [_REACH]]) * size
    eligible = np.flatnonzero(~glued & _in_box(skin.points, other.box + reach))
    if not len(eligible):
        return np.empty((0, 3))
    return skin.nearest_to(other.skin, eligible, other.tolerance / 100.0)[0]


def _outside(points: Array, found: Sequence[Contact], size: float) -> Array:
    """Those of some points (n, 3) that lie in no plane in which the bodies are glued."""
    for contact in found:
        points = points[contact.plane.deviation(points) > _IN_PLANE * size]
    return points


def _in_box(points: Array, box: Array) -> NDArray[np.bool_]:
    return np.all((points >= box[0]) & (points <= box[1]), axis=1)


def _place(point: Array) -> str:
    return "(" + ", ".join(f"{x:.6g}" for x in point) + ")"
