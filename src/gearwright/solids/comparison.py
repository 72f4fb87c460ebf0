"""Whether a polyhedron is a solid to within a length: surface, volume, centroid and inertia."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Array
from ..boundary.extent import rough_diagonal
from ..boundary.nearness import Skin
from ..errors import GeometryError
from ..files.contents import SmoothProperties
from ..moments.matrix import inertia_tensor
from .deviation import Deviation, deviation, surface_points
from .polyhedron import Polyhedron
from .rigid_shift import Lie, RigidShift, in_brackets, rigid_shift
from .saving import Shape
from .solid import DEFAULT_TOLERANCE

_SAG = 1e-6  # of the diagonal: chords of the borders of end faces
_SAMPLES = 200  # points by which it is told which of several solids a body is


@dataclass(frozen=True, kw_only=True, eq=False)
class Given:
    """A body to compare. smooth: properties of the smooth body it stands for, on which its vertices lie."""

    polyhedron: Polyhedron
    smooth: SmoothProperties | None = None

    def moved(self, matrix: Array) -> Given:
        """Mapped by a homogeneous matrix (4, 4), r → A r + t."""
        smooth = self.smooth and self.smooth.mapped(matrix[:3, :3], matrix[:3, 3])
        return Given(polyhedron=self.polyhedron.transformed(matrix), smooth=smooth)

    @cached_property
    def lie(self) -> Lie | None:
        """Volume, centroid and second moment; None where the faces bound no solid."""
        if self.smooth is not None:
            return Lie(volume=self.smooth.volume, centroid=self.smooth.centroid, second=self.smooth.second_moment)
        try:
            found = self.polyhedron.properties()
        except GeometryError:
            return None
        return Lie(volume=found.volume, centroid=found.centroid, second=found.central_second)

    @property
    def chord(self) -> float:
        """How far (length) its triangles may be off the smooth body they stand for; 0 where they are meant so."""
        if self.smooth is None:
            return 0.0
        return DEFAULT_TOLERANCE * float(np.linalg.norm(np.ptp(self.polyhedron.vertices, axis=0)))


@dataclass(frozen=True, kw_only=True, eq=False)
class Wanted:
    """A solid to compare with, and what is found of it once."""

    solid: Shape

    @cached_property
    def skin(self) -> Skin:
        return Skin.of(self.solid.boundary)

    @cached_property
    def diagonal(self) -> float:
        return rough_diagonal(self.solid.boundary)

    @property
    def sag(self) -> float:
        return _SAG * self.diagonal

    @cached_property
    def area(self) -> float:
        return float(self.solid.properties().area or 0.0)

    @cached_property
    def lie(self) -> Lie:
        found = self.solid.properties()
        return Lie(volume=found.volume, centroid=found.centroid, second=found.central_second)

    def unlikeness(self, body: Given) -> float:
        """Root mean square distance of some vertices of a body from the solid's surface, and of the surface from them.

        Relative to the solid's diagonal; it tells which of several solids, or places, a body is meant for.
        """
        used = body.polyhedron.vertices[np.unique(body.polyhedron.indices)]
        some = used[np.unique(np.linspace(0, len(used) - 1, _SAMPLES).astype(int))]
        apart = np.ptp(used, axis=0) - np.ptp(self.skin.points, axis=0)
        square = np.mean(self.skin.signed_distance(some, 10.0 * self.sag) ** 2) + apart @ apart
        return float(np.sqrt(square)) / self.diagonal


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """How a body differs from a solid; differences are body − solid. Lengths in the solid's unit.

    within         (length) by how much the surfaces may differ, and lacking_within the solid's from the body's
    volume         of the body, None where its faces bound no solid; exact_volume of the solid, area of its surface
    centroid_difference   (3,)
    inertia_difference    (3, 3), of the central inertia tensors at density 1
    inertia_scale  the largest entry of the solid's
    shift          by what the solid was moved as a whole, where the body is it but for that
    """

    within: float
    lacking_within: float
    deviation: Deviation
    volume: float | None
    exact_volume: float
    area: float
    centroid_difference: Array | None
    inertia_difference: Array | None
    inertia_scale: float
    size: float
    shift: RigidShift | None = None
    faces: tuple[str, ...] = field(default=(), repr=False)

    @property
    def passed(self) -> bool:
        return not self.problems("")

    def moved(self, placement: Array) -> Comparison:
        """With its points where a rigid motion (4, 4) of body and solid puts them."""
        rotation, shift = placement[:3, :3], placement[:3, 3]
        own = self.shift and self.shift.seen_from(rotation, shift)
        return replace(self, deviation=self.deviation.moved(rotation, shift), shift=own)

    def problems(self, unit: str) -> list[str]:
        """What is beyond the limits, in words; lengths in a unit."""
        found = []
        for extreme, words in ((self.deviation.outward, "outside"), (self.deviation.inward, "inside")):
            if not abs(extreme.distance) <= self.within:
                size = f"{abs(extreme.distance):.4g} {unit}".rstrip()
                found.append(f"the surface is {size} {words} the design's at {in_brackets(extreme.point)}")
                found[-1] += f", on its {self.faces[extreme.face]}"
        lacking = self.deviation.lacking
        if not lacking.distance <= self.lacking_within:
            size = f"{lacking.distance:.4g} {unit}".rstrip()
            found.append(f"the design's {self.faces[lacking.face]} at {in_brackets(lacking.point)} is {size} away")
            found[-1] += " from everything in the file"
        if self.volume is None:
            found.append("the faces bound no solid, so its volume cannot be compared")
        elif not abs(self.volume - self.exact_volume) <= self.within * self.area:
            cubed = f" {unit}³" if unit else ""
            found.append(
                f"the volume is {self.volume:.9g}{cubed}, the design's {self.exact_volume:.9g}{cubed}: a difference of"
                f" {self.volume / self.exact_volume - 1.0:+.3g}, where a layer of {self.within:.3g} {unit} makes"
                f" {self.within * self.area / self.exact_volume:.3g}"
            )
        if found and self.shift is not None:
            words = self.shift.words(unit, self.size, self.within)
            if self.shift.mirrored:
                found.insert(0, f"it is the mirror image of the design, as of the other hand: {words}")
            else:
                found.insert(0, f"it is the design, but elsewhere: {words}; put it back, or take the file as it was")
        return found

    def to_dict(self) -> dict[str, Any]:
        """Plain values by name."""
        extremes = {
            name: {"distance": one.distance, "point": one.point, "face": self.faces[one.face]}
            for name, one in (
                ("outward", self.deviation.outward),
                ("inward", self.deviation.inward),
                ("lacking", self.deviation.lacking),
            )
        }
        volumes = {"volume": self.volume, "exact_volume": self.exact_volume}
        limits = {"within": self.within, "lacking_within": self.lacking_within}
        differences = {
            "centroid_difference": self.centroid_difference,
            "central_inertia_difference": self.inertia_difference,
        }
        shift = {"shift": None if self.shift is None else self.shift.to_dict()}
        return {**limits, **extremes, **self.deviation.to_dict(), **volumes, **differences, **shift}


def compared(body: Given, wanted: Wanted, within: float | None, faces: tuple[str, ...]) -> Comparison:
    """How a body differs from a solid, both in the solid's frame and unit.

    within   (length) the largest deviation that passes; by default that of polyhedra, 1e-4 × bounding diagonal, and how
             far the body's coordinates are rounded
    faces    what the solid's faces are called, patches before caps

    Raises GeometryError if a face of the body cannot be cut into triangles.
    """
    limit = DEFAULT_TOLERANCE * wanted.diagonal + body.polyhedron.rounding if within is None else within
    smooth = body.smooth is not None
    found = deviation(body.polyhedron, wanted.skin, wanted.sag, smooth=smooth)
    lie, own = body.lie, wanted.lie
    result = Comparison(
        within=limit,
        lacking_within=limit + body.chord,
        deviation=found,
        volume=None if lie is None else lie.volume,
        exact_volume=own.volume,
        area=wanted.area,
        centroid_difference=None if lie is None else lie.centroid - own.centroid,
        inertia_difference=None if lie is None else inertia_tensor(lie.second) - inertia_tensor(own.second),
        inertia_scale=float(np.max(np.abs(inertia_tensor(own.second)))),
        size=wanted.diagonal,
        faces=faces,
    )
    if lie is None or result.passed:
        return result
    points, _ = surface_points(body.polyhedron.vertices, body.polyhedron.simple_triangles(), inside=not smooth)
    layer = limit * wanted.area / own.volume
    return replace(result, shift=rigid_shift(points, lie, wanted.skin, own, within=limit, layer=layer))
