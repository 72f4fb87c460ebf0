"""Plane sections."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi
from pathlib import Path
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike, numbers_in
from ..curves.arc import Arc
from ..curves.curve import Curve
from ..errors import GeometryError, Problem
from ..moments.boundary_integral import plane_moments
from ..moments.plane import PlaneMoments
from ..moments.quadrature import converged
from .loop import Loop
from .outlines import LARGEST, SMALLEST, curve_loop, polygon_loop, spline_loop
from .properties import SectionProperties
from .section import LoopedSection
from .support import Support, support

_LOST = 1e-9  # of the distance from the origin: a section smaller than that has lost half of its digits
_COORDINATES = float(np.finfo(float).eps)


@dataclass(frozen=True, kw_only=True, repr=False)
class Section(LoopedSection):
    """A region of the plane bounded by loops of curves (d = 2).

    The named constructors take outlines of either sense, and refuse with the place those that do not close, enclose
    nothing, cross or touch themselves or each other. From loops of one's own, the class itself checks their closure
    and sense; whether they cross is checked before a sweep.
    """

    @classmethod
    def polygon(cls, points: ArrayLike, holes: Sequence[ArrayLike] = ()) -> Self:
        """The region inside a polygon (n, 2) and outside of polygons that are holes in it. Raises GeometryError."""
        loops = [polygon_loop(points, "the outline", 1)]
        loops += [polygon_loop(hole, f"hole {i + 1}", -1) for i, hole in enumerate(holes)]
        return cls._simple(loops)

    @classmethod
    def spline(cls, points: ArrayLike, holes: Sequence[ArrayLike] = ()) -> Self:
        """The region inside the periodic cubic spline through points (n, 2), and outside of such splines as holes.

        The parameter grows by the distance between the points. Moments are those of the splines themselves.
        Raises GeometryError.
        """
        loops = [spline_loop(points, "the outline", 1)]
        loops += [spline_loop(hole, f"hole {i + 1}", -1) for i, hole in enumerate(holes)]
        return cls._simple(loops)

    @classmethod
    def outline(cls, curves: Sequence[Curve], holes: Sequence[Sequence[Curve]] = ()) -> Self:
        """The region inside a closed chain of curves, each starting where the one before it ends, and outside of such
        chains as holes. Raises GeometryError."""
        loops = [curve_loop(curves, "the outline", 1)]
        loops += [curve_loop(hole, f"hole {i + 1}", -1) for i, hole in enumerate(holes)]
        return cls._simple(loops)

    @classmethod
    def circle(cls, radius: float, centre: tuple[float, float] = (0.0, 0.0)) -> Self:
        """A disc. Raises GeometryError for a radius that is not positive."""
        _require({"radius": radius}, centre)
        arc = Arc(radius=float(radius), centre=(float(centre[0]), float(centre[1])), interval=(0.0, 2.0 * pi))
        return cls(loops=(Loop(curves=(arc,)),))

    @classmethod
    def rectangle(cls, width: float, height: float, centre: tuple[float, float] = (0.0, 0.0)) -> Self:
        """A rectangle along the axes about its centre. Raises GeometryError for sides that are not positive."""
        _require({"width": width, "height": height}, centre)
        signs = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        return cls.polygon(np.array(centre, float) + signs * np.array([width, height], float) / 2.0)

    @classmethod
    def _simple(cls, loops: Sequence[Loop]) -> Self:
        section = cls(loops=tuple(loops))
        section.require_simple()
        return section

    @property
    def _flat_loops(self) -> tuple[Loop, ...]:
        return self.loops

    def properties(self) -> SectionProperties:
        """Area, centroid, second moments and moments to order 3, on the true curves."""
        return SectionProperties(local=self.local_moments, perimeter=self._perimeter, error_bound=self.moments_error)

    @cached_property
    def _perimeter(self) -> float:
        def length(nodes: int) -> Array:
            tangents = (loop.copies * np.linalg.norm(loop.quadrature(nodes)[1], axis=1).sum() for loop in self.loops)
            return np.array(sum(tangents))

        return float(converged(length)[0])

    @cached_property
    def support(self) -> Support:
        """How far the section reaches in every direction."""
        return support(self.loops[0].with_copies(1).curves)

    @classmethod
    def load(cls, path: str | Path, *, layer: str | None = None, around: ArrayLike | None = None) -> Self:
        """The section that a DXF, SVG or CSV drawing shows, on its true curves; docs/drawings.md.

        layer    the one layer to read; None reads all that are not hidden
        around   a point (x, y) in the wanted region, where the drawing holds several

        Coordinates are the drawing's own; in SVG, of the unit its width states, and y points up.
        Raises FileError where the file cannot be read; GeometryError naming every place where its curves
        bound no region; MachineError where the reader is not installed: pip install 'gearwright[drawing]'.
        """
        from .drawings import read

        return cls._simple(read(path, layer=layer).region(around))

    def save(self, path: str | Path, *, length_unit: str = "mm", tolerance: float | None = None) -> None:
        """Writes the section as a DXF or SVG drawing, as the suffix says, for `load` and other programs.

        length_unit   of the coordinates; the file states mm or inches, to which others are converted
        tolerance     largest distance (a length) of splines from involutes and other curves that drawings do not
                      hold; default 1e-7 × the section's size. Lines, arcs, ellipses and splines are written as they are

        Raises FileError where the name is not such a file's; GeometryError for a section that crosses itself;
        MachineError where the disk does not take it or the writer is not installed: pip install 'gearwright[drawing]'.
        """
        from .drawings import Profile, write

        write(path, [Profile(section=self)], length_unit=length_unit, tolerance=tolerance)

    def _repr_svg_(self) -> str:
        from .drawings.svg_picture import svg_picture

        return svg_picture(self)

    @cached_property
    def _frame(self) -> tuple[Array, float]:
        """A point in the middle of the section (where it has symmetry, the origin), and its size from there."""
        points = np.concatenate([self._own(loop).quadrature(8)[0] for loop in self.loops])
        middle = np.zeros(2) if self.order > 1 else (points.min(axis=0) + points.max(axis=0)) / 2.0
        return middle, float(np.max(np.abs(points - middle))) or 1.0

    @property
    def moments_error(self) -> float:
        """Relative error of the moments about the section's own middle, the rounding of far coordinates included."""
        return super().moments_error + _COORDINATES * float(np.max(np.abs(self.middle))) / self.size

    @property
    def middle(self) -> Array:
        """A point (2,) in the middle of the section."""
        return self._frame[0]

    @property
    def size(self) -> float:
        """How far, about, the section reaches from there along x or y."""
        return self._frame[1]

    def _own(self, loop: Loop) -> Loop:
        """A loop as periods about the origin, or, where the section has no symmetry, as a whole."""
        return loop if self.order > 1 else loop.with_copies(1)

    def _integral(self, loops: tuple[Loop, ...], nodes: int) -> Array:
        """In the section's own frame, its size as the unit."""
        middle, size = self._frame
        parts = []
        for loop in map(self._own, loops):
            points, tangents = loop.quadrature(nodes)
            parts.append(plane_moments((points - middle) / size, tangents / size, order=loop.copies))
        return sum(parts[1:], start=parts[0])

    @cached_property
    def local_moments(self) -> PlaneMoments:
        """Moments to order 3 on the true curves, about a point near the section."""
        middle, size = self._frame
        values, _ = self._converged
        powers = np.add.outer(np.arange(len(values)), np.arange(len(values)))
        return PlaneMoments(origin=middle, values=values * size ** (2.0 + powers))

    @property
    def moments(self) -> Array:
        """m[a, b] = ∫ x^a y^b dA (4, 4) for a + b ≤ 3, about the section's origin."""
        return self.local_moments.about((0.0, 0.0))


def _require(lengths: dict[str, float], centre: tuple[float, float]) -> None:
    """Raises GeometryError for lengths that are not positive, or lost in the distance of the centre."""
    sizes = {name: numbers_in(value, most=LARGEST) for name, value in lengths.items()}
    middle = numbers_in(centre, 2, LARGEST)
    least = max(SMALLEST, _LOST * max(map(abs, middle or [0.0])))
    problems = [
        Problem(f"{name} = {lengths[name]}", f"a length greater than 0 is needed, here from {least:.2g} to {LARGEST:g}")
        for name, size in sizes.items()
        if size is None or size[0] < least
    ]
    if middle is None:
        problems.append(Problem(f"centre = {centre}", f"a point (x, y) is needed, coordinates up to {LARGEST:g}"))
    if problems:
        raise GeometryError("This is not a section", problems)
