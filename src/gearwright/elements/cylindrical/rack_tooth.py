"""The teeth of a rack in its transverse plane, and the section they make."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.curve import Curve, mapped
from ...curves.elliptic_arc import EllipticArc
from ...curves.line import Line, lines_through
from ...sections.loop import Loop
from ...sections.plane import Section
from .rack_tip import RackTip


@dataclass(frozen=True, kw_only=True)
class RackTooth:
    """Straight-sided teeth along +y, their pitch line x = 0, the first one centred on +x.

    module, pressure_angle, helix_angle   m_n, α_n, β as for `Toothing`
    addendum, dedendum                    above and below the pitch line
    thickness                             transverse, on the pitch line
    fillet_radius                         ρ at the root, in the normal section

    Source: ISO 53.
    """

    module: float
    pressure_angle: float
    helix_angle: float
    addendum: float
    dedendum: float
    thickness: float
    fillet_radius: float

    @property
    def circular_pitch(self) -> float:
        """p_t = π m_n/cos β."""
        return float(np.pi * self.module / np.cos(self.helix_angle))

    @cached_property
    def transverse_pressure_angle(self) -> float:
        """α_t, tan α_t = tan α_n/cos β."""
        return float(np.arctan(np.tan(self.pressure_angle) / np.cos(self.helix_angle)))

    @cached_property
    def space(self) -> RackTip:
        """The bottom of a space."""
        return RackTip(
            half_width=(self.circular_pitch - self.thickness) / 2.0,
            depth=self.dedendum,
            pressure_angle=self.transverse_pressure_angle,
            stretch=float(1.0 / np.cos(self.helix_angle)),
            radius=self.fillet_radius,
        )

    def with_fillet(self, radius: float) -> RackTooth:
        """The same teeth with another radius at the root."""
        return replace(self, fillet_radius=radius)

    @property
    def tip_half(self) -> float:
        """Half the thickness at the tip."""
        return self.half_thickness(self.addendum)

    def half_thickness(self, height: float) -> float:
        """Half the thickness of a tooth at a height above the pitch line, on its straight sides."""
        return float(self.thickness / 2.0 - height * np.tan(self.transverse_pressure_angle))

    def half_at(self, height: ArrayLike) -> Array:
        """Half the thickness (...) of a tooth at heights (...) from root to tip, fillets included."""
        h = np.asarray(height, float)
        straight = self.thickness / 2.0 - h * np.tan(self.transverse_pressure_angle)
        if not self.fillet_radius:
            return straight
        along, across = self.space.half_axes
        down = np.clip((self.fillet_radius - self.dedendum - h) / across, 0.0, 1.0)
        rounded = self.circular_pitch / 2.0 - self.space.land - along * np.sqrt(1.0 - down**2)
        return np.where(h < -self.space.side_end[1], rounded, straight)

    def section(self, teeth: int, height: float) -> Section:
        """So many teeth and a back `height` below the pitch line, its ends in the middle of spaces."""
        pitch = self.circular_pitch
        curves = [mapped(c, np.eye(2), (0.0, k * pitch)) for k in range(teeth) for c in self._one()]
        ends = [
            curves[-1].end.tolist(),
            (-height, (teeth - 0.5) * pitch),
            (-height, -0.5 * pitch),
            curves[0].start.tolist(),
        ]
        return Section(loops=(Loop(curves=(*curves, *lines_through(np.array(ends)))),))

    def _one(self) -> list[Curve]:
        """One tooth from the middle of the space before it to the middle of the one behind."""
        mirror = np.diag([1.0, -1.0])
        rising = self._rising()
        tip = Line(first=(self.addendum, -self.tip_half), last=(self.addendum, self.tip_half))
        return [*rising, tip, *(mapped(curve, mirror).reversed() for curve in reversed(rising))]

    def _rising(self) -> list[Curve]:
        """From the middle of the space before the tooth to its tip."""
        space, middle = self.space, -self.circular_pitch / 2.0
        beside, below = space.side_end
        side = Line(first=(-below, middle + beside), last=(self.addendum, -self.tip_half))
        found: list[Curve] = []
        if space.land:
            found.append(Line(first=(-self.dedendum, middle), last=(-self.dedendum, middle + space.land)))
        if self.fillet_radius:
            along, across = space.half_axes
            angle = self.transverse_pressure_angle
            until = float(np.arctan2(across * np.sin(angle), along * np.cos(angle)))
            found.append(
                EllipticArc(
                    centre=(self.fillet_radius - self.dedendum, middle + space.land),
                    a=(0.0, along),
                    b=(-across, 0.0),
                    interval=(np.pi / 2.0, until),
                )
            )
        return [*found, side]
