"""The tooth of an external cylindrical gear in its transverse plane, and the section it makes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.arc import Arc
from ...curves.curve import Curve, mapped, turn
from ...curves.line import Line
from ...curves.polynomial import Polynomial
from ...sections.loop import Loop
from ...sections.plane import Section
from ..gear_loop import NEXT_TO_NOTHING, gear_loop
from .crowning import crowned, crowned_arc
from .flank import Flank, Relief
from .generated_fillet import GeneratedFillet
from .toothing import Toothing


@dataclass(frozen=True, kw_only=True)
class ExternalTooth:
    """An involute tooth centred on +x.

    rack_tip_radius   ρ of the rack that generates its fillets; None: below the base circle the flank carries
                      on as a radius, down to a sharp corner at the root circle
    relief, chamfer   see `Flank`

    Source: ISO 21771; Al-Daccak 1989, ch. 4.5.2.
    """

    toothing: Toothing
    rack_tip_radius: float | None = None
    relief: Relief | None = None
    chamfer: float = 0.0

    @cached_property
    def fillet(self) -> GeneratedFillet | None:
        if self.rack_tip_radius is None:
            return None
        return GeneratedFillet(toothing=self.toothing, tip_radius=self.rack_tip_radius)

    @cached_property
    def form_radius(self) -> float:
        """Radius at which the involute begins: above the fillet, else the base or the root circle."""
        if self.fillet is not None:
            return self.fillet.form_radius
        return max(self.toothing.root_radius, self.toothing.base_radius)

    @cached_property
    def flank(self) -> Flank:
        return Flank(toothing=self.toothing, form_radius=self.form_radius, relief=self.relief, chamfer=self.chamfer)

    @property
    def tip_half(self) -> float:
        """Half the angle of the tooth at its tip."""
        return self.flank.tip_half

    @property
    def root_space(self) -> float:
        """Angle of the root circle between two teeth; of the circle where involutes begin, for radial roots."""
        if self.fillet is not None:
            return 2.0 * self.fillet.rack_tip.land / self.toothing.pitch_radius
        return 2.0 * np.pi / self.toothing.teeth - self.toothing.thickness_at(self.form_radius)

    def half_angle(self, radius: ArrayLike) -> Array:
        """Half the angle (...) of the tooth at radii (...) from root to tip, without relief and chamfer."""
        r = np.asarray(radius, float)
        on_involute = self.toothing.enclosed_half(np.maximum(r, self.form_radius))
        if self.fillet is None:
            return on_involute
        return np.where(r < self.form_radius, self.fillet.half_angle(np.minimum(r, self.form_radius)), on_involute)

    def section(self, hole_radius: float | None = None, crowning: Polynomial | None = None) -> Section:
        """The gear's section, full or with a round hole; flanks turn into the teeth by a crowning, radians."""
        outline = self.outline(crowning)
        if hole_radius is None:
            return Section(loops=(outline,))
        pitch = 2.0 * np.pi / self.toothing.teeth
        hole = Loop(curves=(Arc(radius=hole_radius, interval=(0.0, -pitch)),), copies=self.toothing.teeth)
        return Section(loops=(outline, hole))

    def outline(self, crowning: Polynomial | None = None) -> Loop:
        """The loop of all teeth."""
        toothing = self.toothing
        middle, tip, gap = np.pi / toothing.teeth, self.flank.tip_half, self.root_space / 2.0
        has_land = gap > NEXT_TO_NOTHING
        return gear_loop(
            rising=crowned([*self._foot(), *self.flank.curves()], crowning),
            tip=crowned_arc(toothing.tip_radius, (-tip, tip), crowning),
            root=crowned_arc(toothing.root_radius, (middle + gap, middle - gap), crowning).reversed()
            if has_land
            else None,
            teeth=toothing.teeth,
        )

    def _foot(self) -> list[Curve]:
        """Curves of the clockwise side from the root circle to the involute."""
        toothing = self.toothing
        if self.fillet is not None:
            cut = replace(self.fillet.trochoid, interval=(np.pi / 2.0, self.fillet.join))
            return [mapped(cut, turn(-np.pi / toothing.teeth, 2))]
        if toothing.root_radius >= toothing.base_radius * (1.0 - NEXT_TO_NOTHING):
            return []
        foot = toothing.thickness_at(self.form_radius) / 2.0
        direction = np.array([np.cos(foot), -np.sin(foot)])
        return [Line(first=tuple(toothing.root_radius * direction), last=tuple(toothing.base_radius * direction))]
