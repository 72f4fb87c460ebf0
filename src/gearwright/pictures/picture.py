"""Bodies to a PNG file: shaded image, title, callouts, axes and a scale."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..arrays import Array, Indices
from ..colours import STEEL, Colour
from ..disk import written_whole
from ..errors import FileError
from .camera import Camera, View, camera, suitable_view

_BACKGROUND = np.array([1.0, 1.0, 1.0])


@dataclass(frozen=True, kw_only=True)
class Body:
    """One body of a picture, where it is to be drawn.

    vertices   (n, 3)  points
    triangles  (t, 3)  indices, counter-clockwise seen from outside; together they cover the surface once
    colour             sRGB, 0…1
    label              what the callout says; empty for none, a line break for a second, quieter line
    """

    vertices: Array
    triangles: Indices
    colour: Colour = STEEL
    label: str = ""

    def __post_init__(self) -> None:
        vertices, triangles = np.asarray(self.vertices), np.asarray(self.triangles)
        name = f"body {self.label.splitlines()[0]!r}" if self.label else "a body"
        if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all():
            raise ValueError(f"{name}: vertices must be (n, 3) finite numbers")
        if triangles.ndim != 2 or triangles.shape[1] != 3 or not len(triangles):
            raise ValueError(f"{name}: triangles must be (t, 3) indices, at least one")
        if triangles.min() < 0 or triangles.max() >= len(vertices):
            raise ValueError(f"{name}: triangles must refer to vertices 0 to {len(vertices) - 1}")
        if np.shape(self.colour) != (3,) or not all(0.0 <= value <= 1.0 for value in self.colour):
            raise ValueError(f"{name}: colour must be three numbers from 0 to 1")


def picture(
    bodies: Sequence[Body],
    path: str | os.PathLike[str],
    title: str = "",
    view: View | None = None,
    size: tuple[int, int] = (1600, 1000),
    length_unit: str = "mm",
) -> None:
    """Draw bodies into a PNG file of size (width, height) pixels, from a suitable view unless one is given.

    The file appears complete or not at all: an old one stays if drawing or writing fails. The scale holds at the
    middle of the bodies, in length_unit.
    Raises FileError if path is no .png or has no folder, MachineError if the disk refuses, ValueError without bodies
    or for a size that is no picture.
    """
    path = Path(path)
    if path.suffix.lower() != ".png":
        raise FileError(f"{path}: pictures are written as PNG; end the name in .png")
    if not path.parent.is_dir():
        raise FileError(f"{path}: there is no folder {path.parent}; make it first")
    data = drawn(bodies, title, view, size, length_unit)
    with written_whole(path) as stream:
        stream.write(data)


def drawn(
    bodies: Sequence[Body], title: str, view: View | None, size: tuple[int, int], length_unit: str = "mm"
) -> bytes:
    """The bytes of a PNG file of bodies, as `picture` writes it.

    Raises ValueError without bodies or for a size that is no picture.
    """
    if not bodies:
        raise ValueError("a picture needs at least one body")
    if min(size) < 200 or max(size) > 8000:
        raise ValueError(f"picture size = {size}: 200 to 8000 pixels each way are possible")
    # numba and matplotlib load here, when a picture is really drawn
    from .annotations import Callout, annotated
    from .image import image

    shapes = [_shape(body) for body in bodies]
    view = suitable_view(shapes) if view is None else view
    points = np.concatenate([vertices for vertices, _ in shapes])
    eye = camera(points, view, _frame(size, title, any(body.label for body in bodies)))
    colours = np.array([body.colour for body in bodies], dtype=float)
    rendered = image(shapes, colours, eye, size, _BACKGROUND)
    callouts = [
        Callout(text=body.label, colour=body.colour, mask=rendered.owners == index)
        for index, body in enumerate(bodies)
        if body.label
    ]
    return annotated(rendered.colours, title, callouts, _axes(eye), _units_a_pixel(eye), length_unit)


def _shape(body: Body) -> tuple[Array, Indices]:
    """Its vertices, without those that no triangle uses, and triangles."""
    used, inverse = np.unique(np.asarray(body.triangles, dtype=np.int64), return_inverse=True)
    return np.asarray(body.vertices, dtype=float)[used], inverse.reshape(-1, 3)


def _frame(size: tuple[int, int], title: str, labelled: bool) -> tuple[float, float, float, float]:
    """Where the bodies go: room above for the title, below for axes and scale, beside for callouts."""
    width, height = size
    side = width * (0.17 if labelled else 0.07)
    return side, height * (0.12 if title else 0.06), width - side, height * 0.92


def _axes(eye: Camera) -> Array:
    """The x, y and z axes as drawn, (3, 3): right, up and towards the eye, of unit length."""
    return eye.rotation.T


def _units_a_pixel(eye: Camera) -> float:
    return eye.radius / eye.pixels
