"""The tooth trace of a bevel gear from its parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...curves.traces.circular import CircularTrace
from ...curves.traces.epicycloid import EpicycloidTrace
from ...curves.traces.involute import InvoluteTrace
from ...curves.traces.logarithmic import LogarithmicTrace
from ...curves.traces.skew import SkewTrace
from ...curves.traces.straight import StraightTrace
from ...curves.traces.trace import SpiralTrace, Trace

if TYPE_CHECKING:
    from .bevel_gear import BevelGear

MILLED = ("circular", "epicycloid")
"""Traces that a cutter of some radius cuts."""

HOBBED = ("epicycloid",)
"""Traces that a cutter with groups of blades cuts."""

STEEPEST = np.radians(80.0)
"""Spiral angle beyond which nothing is left of a tooth: its normal thickness goes with the cosine."""

_PLAIN: dict[str, type[SpiralTrace]] = {
    "skew": SkewTrace,
    "logarithmic": LogarithmicTrace,
    "involute": InvoluteTrace,
}


@dataclass(frozen=True, kw_only=True)
class Spiral:
    """The trace of one bevel gear's teeth, and the spiral angles along its face.

    spiral_angle   at the mean cone distance, degrees
    pitch_angle    γ, radians
    stretch        how far the body goes beyond inner and outer cone distance, as factors of them
    """

    trace: str
    spiral_angle: float
    hand: str
    cutter_radius: float | None
    blade_groups: int | None
    teeth: int
    pitch_angle: float
    cone_distance: float
    face_width: float
    stretch: tuple[float, float] = (1.0, 1.0)

    @property
    def mean_distance(self) -> float:
        return self.cone_distance - self.face_width / 2.0

    @property
    def tooth_trace(self) -> Trace:
        """The turn of the section along the face. Raises ValueError where the parameters give no such curve."""
        if self.trace == "straight":
            return StraightTrace()
        ratio = (1.0 if self.hand == "right" else -1.0) / float(np.sin(self.pitch_angle))
        mean, angle = self.mean_distance, float(np.radians(self.spiral_angle))
        if self.trace not in MILLED:
            return _PLAIN[self.trace](ratio=ratio, mean_distance=mean, mean_spiral_angle=angle)
        radius = self.cutter_radius
        if radius is None:
            raise ValueError(f"a trace that is {self.trace} needs the radius of its cutter")
        if self.trace not in HOBBED:
            return CircularTrace(ratio=ratio, mean_distance=mean, mean_spiral_angle=angle, cutter_radius=radius)
        if self.blade_groups is None:
            raise ValueError(f"a trace that is {self.trace} needs the number of its cutter's blade groups")
        return EpicycloidTrace(
            ratio=ratio,
            mean_distance=mean,
            mean_spiral_angle=angle,
            cutter_radius=radius,
            blade_groups=self.blade_groups,
            crown_teeth=self.teeth * abs(ratio),
        )

    @property
    def fits(self) -> bool:
        """Whether the trace reaches over the whole body, nowhere steeper than teeth can be."""
        inner, outer = self.ends
        if not 0.0 < inner < self.mean_distance:
            return False
        try:
            trace = self.tooth_trace
        except ValueError:
            return False
        least, greatest = trace.reach
        # |β| is greatest at one of the ends: tan β has a single turning point, or none, in every trace
        return bool(least <= inner and outer <= greatest and np.all(np.abs(trace.spiral_angle(self.ends)) <= STEEPEST))

    @property
    def ends(self) -> tuple[float, float]:
        """The cone distances between which the body lies."""
        return (self.cone_distance - self.face_width) * self.stretch[0], self.cone_distance * self.stretch[1]

    def sizes(self) -> dict[str, tuple[float, str, str]]:
        """Spiral angles (radians, symbol, meaning) of toe, mean cone distance and heel; none for straight teeth."""
        if self.trace == "straight":
            return {}
        places = (self.cone_distance - self.face_width, self.mean_distance, self.cone_distance)
        inner, mean, outer = (float(angle) for angle in self.tooth_trace.spiral_angle(places))
        return {
            "inner_spiral_angle": (inner, "β_i", "spiral angle at the inner end, the toe"),
            "mean_spiral_angle": (mean, "β_m", "spiral angle at the mean cone distance"),
            "outer_spiral_angle": (outer, "β_e", "spiral angle at the outer end, the heel"),
        }


def spiral_of(gear: BevelGear, stretch: tuple[float, float] = (1.0, 1.0)) -> Spiral:
    """The spiral of a gear whose body goes beyond inner and outer cone distance by the factors of `stretch`."""
    return Spiral(
        trace=gear.trace,
        spiral_angle=gear.spiral_angle,
        hand=gear.hand,
        cutter_radius=gear.cutter_radius,
        blade_groups=gear.blade_groups,
        teeth=gear.teeth,
        pitch_angle=gear.pitch_cone_angle,
        cone_distance=gear.cone_distance,
        face_width=gear.face_width,
        stretch=stretch,
    )
