"""What is written to a file: parts where they stand, either with polygon faces or with the smooth ones they have."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, Protocol, TypeVar

import numpy as np

from ..arrays import Array, Indices
from ..boundary.boundary import Boundary
from ..colours import Colour
from ..errors import FileError
from ..parameters import LENGTH_UNITS

Shape_co = TypeVar("Shape_co", covariant=True)


class Faceted(Protocol):
    """A body bounded by polygons: vertices (n, 3), and faces as in `moments.faces`."""

    @property
    def vertices(self) -> Array: ...
    @property
    def indices(self) -> Indices: ...
    @property
    def offsets(self) -> Indices: ...
    def simple_triangles(self) -> Indices:
        """The faces cut into triangles (t, 3) that do not overlap. Raises GeometryError where one cannot be cut."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Smooth:
    """A body bounded by smooth faces, and how far (length) a file's faces may lie from them."""

    boundary: Boundary
    tolerance: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Part(Generic[Shape_co]):
    """A body in its own frame.

    name        as a person reads it
    placement   (4, 4) rigid motion that puts it in its place
    colour      None where there is no preference
    """

    name: str
    shape: Shape_co
    placement: Array = field(default_factory=lambda: np.eye(4))
    colour: Colour | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Assembly(Generic[Shape_co]):
    """Parts by names of their own, at least one. length_unit   a key of LENGTH_UNITS; None where nobody knows it

    Raises FileError for a unit that is none.
    """

    name: str
    parts: tuple[Part[Shape_co], ...]
    length_unit: str | None = "mm"

    def __post_init__(self) -> None:
        if self.length_unit is not None and self.length_unit not in LENGTH_UNITS:
            raise FileError(f"length_unit = {self.length_unit!r}: choose one of {', '.join(LENGTH_UNITS)}")


def placed_vertices(part: Part[Faceted]) -> Array:
    """The vertices (n, 3) where the part stands."""
    if np.array_equal(part.placement, np.eye(4)):
        return part.shape.vertices
    return np.asarray(part.shape.vertices @ part.placement[:3, :3].T + part.placement[:3, 3])
