"""The tooth of a parallel-axis gear in its transverse plane, and the section it makes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..curves.arc import Arc
from ..curves.curve import Curve, mapped, turn
from ..curves.involute import Involute, inverse_involute_function, involute_function, involute_of_roll, involute_roll
from ..curves.line import Line
from ..sections.loop import Loop
from ..sections.plane import Section
from .gear_loop import NEXT_TO_NOTHING, gear_loop


@dataclass(frozen=True, kw_only=True)
class SpurTooth:
    """An involute tooth centred on +x, one of `teeth` about the origin.

    pitch_radius, pressure_angle   r and the transverse pressure angle a (radians) there: r_b = r cos a
    tip_radius, root_radius        of the tip and root arcs
    thickness                      angular thickness at the pitch circle, radians

    Below the base circle the flank carries on as a radius (root="radial").
    Source: ISO 21771; Al-Daccak 1989, ch. 4.5.2.
    """

    teeth: int
    pitch_radius: float
    pressure_angle: float
    tip_radius: float
    root_radius: float
    thickness: float

    @property
    def base_radius(self) -> float:
        return float(self.pitch_radius * np.cos(self.pressure_angle))

    @property
    def flank_start(self) -> float:
        """Radius at which the involute begins: the base circle, or the root circle above it."""
        return max(self.root_radius, self.base_radius)

    @cached_property
    def _half_at_base(self) -> float:
        return self.thickness / 2.0 + float(involute_function(self.pressure_angle))

    def thickness_at(self, radius: float) -> float:
        """Angular thickness at a radius on the involute, s/r − 2(inv α − inv a)."""
        roll = float(involute_roll(radius, self.base_radius))
        return 2.0 * (self._half_at_base - float(involute_of_roll(roll)))

    @property
    def pointed_radius(self) -> float:
        """Radius at which the flanks meet."""
        return self.base_radius / float(np.cos(inverse_involute_function(self._half_at_base)))

    @property
    def root_space(self) -> float:
        """Angular width of the tooth space at the foot of the involute."""
        return 2.0 * np.pi / self.teeth - self.thickness_at(self.flank_start)

    def section(self, bore_radius: float | None = None) -> Section:
        """The gear's section, full or with a round bore."""
        tip = self.thickness_at(self.tip_radius) / 2.0
        foot = self.thickness_at(self.flank_start) / 2.0
        pitch = 2.0 * np.pi / self.teeth
        outline = gear_loop(
            rising=self._rising_flank(foot),
            tip=Arc(radius=self.tip_radius, interval=(-tip, tip)),
            root=Arc(radius=self.root_radius, interval=(foot, pitch - foot)),
            teeth=self.teeth,
        )
        if bore_radius is None:
            return Section(loops=(outline,))
        bore = Loop(curves=(Arc(radius=bore_radius, interval=(0.0, -pitch)),), copies=self.teeth)
        return Section(loops=(outline, bore))

    def _rising_flank(self, foot: float) -> list[Curve]:
        """Curves from root to tip on the clockwise side of the tooth."""
        rolls = involute_roll([self.flank_start, self.tip_radius], self.base_radius)
        involute = Involute(base_radius=self.base_radius, interval=(float(rolls[0]), float(rolls[1])))
        flank: list[Curve] = [mapped(involute, turn(-self._half_at_base, 2))]
        if self.root_radius < self.base_radius * (1.0 - NEXT_TO_NOTHING):
            direction = np.array([np.cos(foot), -np.sin(foot)])
            line = Line(first=tuple(self.root_radius * direction), last=tuple(self.base_radius * direction))
            flank.insert(0, line)
        return flank
