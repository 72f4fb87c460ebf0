"""Where the eye is: a view that suits the bodies, and the camera that fits them into a frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Indices

Vector = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class View:
    """From where the bodies are seen.

    direction    from the bodies towards the eye, any length
    up           away from the ground they lie on, any length
    perspective  0 orthographic; else radius of the bodies / distance of the eye, 0.3 at most
    """

    direction: Vector
    up: Vector = (0.0, 0.0, 1.0)
    perspective: float = 0.12

    def __post_init__(self) -> None:
        for name in ("direction", "up"):
            vector = np.asarray(getattr(self, name), dtype=float)
            if vector.shape != (3,) or not np.isfinite(vector).all() or not vector.any():
                raise ValueError(f"view {name} = {getattr(self, name)}: three numbers, not all zero, are needed")
        if not 0.0 <= self.perspective <= 0.3:
            raise ValueError(f"view perspective = {self.perspective}: 0 (orthographic) to 0.3 are possible")


@dataclass(frozen=True, kw_only=True)
class Camera:
    """Maps points to the picture.

    Seen coordinates: x right, y up, z towards the eye, in bounding radii about the bodies' middle.
    Screen coordinates: x right, y down from the upper left corner, and nearness z, all in pixels. With
    f = 1/(1 − k z), k the perspective, they are f × seen × pixels, so that planes stay planes: depth is
    linear on the screen.

    rotation  (3, 3)  rows: the seen axes in the bodies' frame
    middle    (3,)    origin of the seen coordinates, in the bodies' frame
    radius            length that is 1 in seen coordinates
    up        (3,)    unit vector away from the ground, seen coordinates
    pixels            screen pixels of one radius at the middle
    origin    (2,)    screen position of the middle
    """

    rotation: Array
    middle: Array
    radius: float
    up: Array
    perspective: float
    pixels: float
    origin: Array

    def seen(self, points: Array) -> Array:
        """Seen coordinates of points (..., 3)."""
        return np.asarray((points - self.middle) @ self.rotation.T / self.radius)

    def screen(self, seen: Array) -> Array:
        """Screen coordinates of seen points (..., 3)."""
        scaled = seen * (self.pixels / (1.0 - self.perspective * seen[..., 2:]))
        return scaled * np.array([1.0, -1.0, 1.0]) + np.array([*self.origin, 0.0])

    def unscreen(self, screen: Array) -> Array:
        """Seen coordinates of screen points (..., 3): the inverse of screen."""
        scaled = (screen - np.array([*self.origin, 0.0])) * (np.array([1.0, -1.0, 1.0]) / self.pixels)
        return np.asarray(scaled / (1.0 + self.perspective * scaled[..., 2:]))


def camera(points: Array, view: View, frame: tuple[float, float, float, float]) -> Camera:
    """The camera that fits points (n, 3) into a frame (left, top, right, bottom) of the picture, in pixels."""
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = float(np.max(np.linalg.norm(points - middle, axis=-1))) or 1.0
    rotation = _rotation(view)
    seen = (points - middle) @ rotation.T / radius
    flat = seen[:, :2] / (1.0 - view.perspective * seen[:, 2:]) * np.array([1.0, -1.0])
    low, high = flat.min(axis=0), flat.max(axis=0)
    left, top, right, bottom = frame
    pixels = float(min((right - left) / max(high[0] - low[0], 1e-9), (bottom - top) / max(high[1] - low[1], 1e-9)))
    origin = np.array([left + right, top + bottom]) / 2 - pixels * (low + high) / 2
    up = rotation @ np.asarray(view.up, dtype=float)
    return Camera(
        rotation=rotation, middle=middle, radius=radius, up=up / np.linalg.norm(up),
        perspective=view.perspective, pixels=pixels, origin=origin,
    )  # fmt: skip


def towards_eye(points: Array, camera: Camera) -> Array:
    """Unit vectors (s, 3) from seen points to the eye."""
    towards = np.array([0.0, 0.0, 1.0]) - camera.perspective * points
    return np.asarray(towards / np.linalg.norm(towards, axis=-1, keepdims=True))


def _rotation(view: View) -> Array:
    """Rows right, up, towards the eye; where up is the viewing direction itself, +y or +x is up in the picture."""
    towards = np.asarray(view.direction, dtype=float)
    towards = towards / np.linalg.norm(towards)
    for up in (np.asarray(view.up, dtype=float), np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])):
        right = np.cross(up, towards)
        if np.linalg.norm(right) > 1e-6 * np.linalg.norm(up):
            right = right / np.linalg.norm(right)
            return np.stack([right, np.cross(towards, right), towards])
    raise AssertionError("+x and +y cannot both be the viewing direction")


def suitable_view(bodies: Sequence[tuple[Array, Indices]]) -> View:
    """A view that shows the working faces of bodies given as (vertices, triangles); see `view_of`."""
    return view_of([_shape(vertices, triangles) for vertices, triangles in bodies])


def view_of(shapes: Sequence[Shape]) -> View:
    """A view that shows the working faces of bodies.

    A round body lies with its axis upright, teeth up where it tapers like a bevel gear. Of two whose axes meet, the
    larger lies so, and the eye is on the side where the axes meet, which both bodies' teeth face. Anything else is
    seen from above +z.
    """
    largest = max(range(len(shapes)), key=lambda index: shapes[index].size)
    towards = _towards_apex(shapes) if len(shapes) == 2 else None
    if towards is None:
        up = shapes[largest].axis
        start = np.eye(3)[int(np.argmin(np.abs(up)))]
        front = np.cross(up, start) / np.linalg.norm(np.cross(up, start))
        direction = 0.75 * up + 0.8 * front + 0.35 * np.cross(up, front)
    else:
        up = towards[largest]
        aside = towards[1 - largest] - up * float(towards[1 - largest] @ up)
        aside = aside / np.linalg.norm(aside)
        direction = 0.62 * up + 0.62 * aside + 0.55 * np.cross(up, aside)
    return View(direction=_vector(direction), up=_vector(up))


@dataclass(frozen=True, kw_only=True)
class Shape:
    """A body's middle, its axis (up) and whether it is round about it; its size (root mean square)."""

    middle: Array
    axis: Array
    is_round: bool
    size: float


def _towards_apex(shapes: Sequence[Shape]) -> tuple[Array, Array] | None:
    """Axes of two round bodies, turned towards the point where they meet; None if they do not meet."""
    first, second = shapes
    normal = np.cross(first.axis, second.axis)
    if not (first.is_round and second.is_round) or np.linalg.norm(normal) < 0.2:
        return None
    between = second.middle - first.middle
    # middle₁ + s axis₁ + g normal = middle₂ + t axis₂
    s, t, gap = np.linalg.solve(np.stack([first.axis, -second.axis, normal], axis=-1), between)
    if abs(gap) * np.linalg.norm(normal) > 0.1 * max(first.size, second.size):
        return None
    return first.axis * (1.0 if s > 0 else -1.0), second.axis * (1.0 if t > 0 else -1.0)


def _shape(vertices: Array, triangles: Indices) -> Shape:
    """A body's axis from its surface: where two principal second moments agree, the third axis; else +z."""
    corners = vertices[triangles]
    points = corners.mean(axis=1)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    weights = np.linalg.norm(normals, axis=-1)
    weights = weights / (float(weights.sum()) or 1.0)
    middle = weights @ points
    points = points - middle
    second, axes = np.linalg.eigh((points * weights[:, None]).T @ points)
    size = float(np.sqrt(second.sum()))
    low, high = second[1] - second[0], second[2] - second[1]
    if min(low, high) > 0.02 * second[2]:
        return Shape(middle=middle, axis=np.array([0.0, 0.0, 1.0]), is_round=False, size=size)
    axis = axes[:, 2] if low < high else axes[:, 0]
    return Shape(middle=middle, axis=axis * _up_sign(points, normals, axis), is_round=True, size=size)


def _up_sign(points: Array, normals: Array, axis: Array) -> float:
    """Which way along its axis a round body's teeth face: +1 or −1; that of the larger component if neither.

    points (t, 3) from the middle, normals (t, 3) of twice the faces' areas. Teeth that face one way are wider at the
    other: width correlates with height. Surfaces of revolution have no normal component around the axis, flanks have;
    only they count, unless there are none.
    """
    along = points @ axis
    outward = points - along[:, None] * axis
    widths = np.linalg.norm(outward, axis=-1)
    around = np.abs(np.sum(normals * np.cross(axis, outward), axis=-1)) / np.maximum(
        widths, 1e-12 + 1e-9 * widths.max()
    )
    areas = np.linalg.norm(normals, axis=-1)
    weights = around if around.sum() > 0.02 * areas.sum() else areas
    weights = weights / (float(weights.sum()) or 1.0)
    along, widths = along - weights @ along, widths - weights @ widths
    scale = float(np.sqrt((weights @ along**2) * (weights @ widths**2))) or 1.0
    taper = float(weights @ (along * widths)) / scale
    if abs(taper) > 0.25:
        return -1.0 if taper > 0 else 1.0
    return 1.0 if axis[int(np.argmax(np.abs(axis)))] > 0 else -1.0


def _vector(array: Array) -> Vector:
    x, y, z = (float(value) for value in array)
    return x, y, z
