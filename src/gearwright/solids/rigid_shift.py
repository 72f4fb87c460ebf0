"""Whether a body that lies elsewhere is a solid moved as a whole: by which turn, shift or mirror."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from ..boundary.nearness import Skin
from ..curves.curve import turn
from ..rotations import quaternion_of

_SAMPLES = 300  # points of the body
_FITTED = 80  # of these, for least squares
_SAG = 1e-4  # of the diagonal: chords of the borders of end faces, enough to place a body
_NEARLY = 30.0  # times the limit: surfaces no farther apart are tried where they are alone
_SYMMETRIC = 1e-2  # of the largest: principal moments so near each other leave their axes to the teeth
_ANGLES = 8  # tried a tooth, or an eighth of a turn
_MOST_ANGLES = 1500
_REFINED = 2  # of all places tried, the best


@dataclass(frozen=True, kw_only=True, eq=False)
class RigidShift:
    """The map r → R r + t of a solid onto a body; where R mirrors, the body is the solid's mirror image, moved.

    rotation   R (3, 3)
    shift      t (3,)
    """

    rotation: Array
    shift: Array

    @property
    def mirrored(self) -> bool:
        return bool(np.linalg.det(self.rotation) < 0.0)

    def seen_from(self, rotation: Array, shift: Array) -> RigidShift:
        """The same motion of a solid that stands where r → R r + t puts it, in the frame in which it stands there."""
        turned = rotation @ self.rotation @ rotation.T
        return RigidShift(rotation=turned, shift=rotation @ self.shift + shift - turned @ shift)

    def to_dict(self) -> dict[str, Any]:
        return {"rotation": self.rotation, "shift": self.shift, "mirrored": self.mirrored}

    def words(self, length_unit: str, size: float, within: float) -> str:
        """What was done to the solid of a size: "turned by 12° about (0, 0, 1), then moved by (1, 0, 0) mm".

        As exactly as surfaces tell that may be off by so much (length).
        """
        w, *axis = quaternion_of(-self.rotation if self.mirrored else self.rotation)
        sine = float(np.linalg.norm(axis))
        angle = 2.0 * float(np.arctan2(sine, w))
        said = ["mirrored in the origin"] if self.mirrored else []
        if angle * size > 2.0 * within:
            about = in_brackets(_told(np.array(axis) / sine, within / (size * angle)))
            said.append(f"turned by {float(_told(np.degrees(angle), np.degrees(within / size))):.6g}° about {about}")
        if np.linalg.norm(self.shift) > within:
            said.append(f"moved by {in_brackets(_told(self.shift, within))} {length_unit}".rstrip())
        return ", then ".join(said) or "hardly moved"


def _told(values: Array, within: float) -> Array:
    """Values without the digits that something so much off does not tell."""
    return np.round(values, max(0, int(np.ceil(-np.log10(within)))))


def in_brackets(values: Sequence[float] | Array) -> str:
    """Coordinates as a person reads them."""
    return "(" + ", ".join(f"{float(x) + 0.0:.6g}" for x in values) + ")"


@dataclass(frozen=True, kw_only=True, eq=False)
class Lie:
    """Where a body or solid lies by its moments: volume, centroid (3,), second moment (3, 3) about that."""

    volume: float
    centroid: Array
    second: Array


def rigid_shift(points: Array, body: Lie, skin: Skin, solid: Lie, *, within: float, layer: float) -> RigidShift | None:
    """How a solid must be moved to be a body; None where no such motion was found.

    points   (n, 3) of the body's surface
    within   (length) how far they may be off the solid so moved
    layer    how far, relatively, volume and second moments may differ

    Placed by centroids and principal axes, where these are free by trying turns; then by least squares, and proved by
    distances from the exact surface. A mirror image is looked for last.
    """
    if abs(body.volume - solid.volume) > layer * solid.volume:
        return None
    own, values = np.linalg.eigvalsh(solid.second), np.linalg.eigvalsh(body.second)
    if np.max(np.abs(own - values)) > 10.0 * layer * own[-1]:
        return None
    some = points[np.unique(np.linspace(0, len(points) - 1, _SAMPLES).astype(int))]
    size = float(np.linalg.norm(np.ptp(skin.points, axis=0)))
    distance = _signed(skin, size)
    near = float(np.max(np.abs(distance(some)))) < _NEARLY * within
    for mirrored in (False,) if near else (False, True):
        rotations = [np.eye(3)] if near else _rotations(body.second, solid.second, skin, mirrored)
        tried = [
            (float(np.mean(skin.sampled_distance(_back(some, rotation, shift)) ** 2)), rotation, shift)
            for rotation in rotations
            for shift in [body.centroid - rotation @ solid.centroid]
        ]
        for _, rotation, shift in sorted(tried, key=lambda one: one[0])[:_REFINED]:
            if np.max(np.abs(distance(_back(some, rotation, shift)))) <= within:
                return RigidShift(rotation=rotation, shift=shift)
            refined = _refined(distance, some[:: 1 + len(some) // _FITTED], rotation, shift, size)
            if np.max(np.abs(distance(_back(some, refined.rotation, refined.shift)))) <= within:
                return refined
    return None


def _back(points: Array, rotation: Array, shift: Array) -> Array:
    return (points - shift) @ rotation


def _signed(skin: Skin, size: float) -> Callable[[Array], Array]:
    return lambda points: skin.signed_distance(points, _SAG * size)


def _rotations(body: Array, solid: Array, skin: Skin, mirrored: bool) -> Iterator[Array]:
    """Rotations (3, 3), or with mirroring, of a solid's principal axes onto a body's, by their second moments.

    Where two moments are nearly the same, turns about the third axis, too.
    """
    values, own = np.linalg.eigh(solid)
    _, axes = np.linalg.eigh(body)
    gaps = np.diff(values) > _SYMMETRIC * values[-1]
    sense = -1.0 if mirrored else 1.0
    yield sense * np.eye(3)
    for signs in product((1.0, -1.0), repeat=3):
        rotation = axes @ np.diag(signs) @ own.T
        if np.linalg.det(rotation) * sense < 0.0:
            continue
        yield rotation
        if gaps.sum() == 1:
            about = own[:, 2 if gaps[1] else 0]
            yield from (rotation @ _turn(about, angle) for angle in _angles(_orders(skin)))


def _orders(skin: Skin) -> Indices:
    return np.array([patch.pattern.order for patch in skin.boundary.patches])


def _angles(orders: Indices) -> Array:
    """Angles to try: through one sector where all is repeated alike, else all the way round."""
    finest, common = int(np.max(orders, initial=1)), int(np.gcd.reduce(orders)) or 1
    count = min(_ANGLES * max(finest, 8) // common, _MOST_ANGLES)
    return 2.0 * np.pi / common * np.arange(count) / count


def _turn(axis: Array, angle: float) -> Array:
    """The rotation (3, 3) about an axis (3,) of length 1."""
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across /= np.linalg.norm(across)
    frame = np.stack([across, np.cross(axis, across), axis], axis=1)
    return np.asarray(frame @ turn(angle, 3) @ frame.T)


def _refined(
    distance: Callable[[Array], Array], points: Array, rotation: Array, shift: Array, size: float
) -> RigidShift:
    """The motion near a given one by which points come nearest to the surface, in the mean square."""
    from scipy.optimize import least_squares

    middle = points.mean(axis=0)

    def moved(x: Array) -> tuple[Array, Array]:
        angle = float(np.linalg.norm(x[:3]))
        small = _turn(x[:3] / angle, angle) if angle > 0.0 else np.eye(3)
        return small @ rotation, small @ (shift - middle) + middle + size * x[3:]

    def off(x: Array) -> Array:
        return distance(_back(points, *moved(x))) / size

    found = least_squares(
        off, np.zeros(6), diff_step=1e-6, x_scale=1e-3, xtol=1e-13, ftol=1e-13, gtol=1e-15, max_nfev=15
    )
    best, there = moved(found.x)
    return RigidShift(rotation=best, shift=there)
