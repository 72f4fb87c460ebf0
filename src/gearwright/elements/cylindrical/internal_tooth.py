"""The tooth of an internal cylindrical gear in its transverse plane, and the section it makes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.arc import Arc
from ...curves.curve import Curve, mapped, turn
from ...curves.polynomial import Polynomial
from ...sections.loop import Loop
from ...sections.plane import Section
from ..gear_loop import NEXT_TO_NOTHING, gear_loop
from .crowning import crowned, crowned_arc
from .flank import Flank, Relief
from .toothing import Toothing


@dataclass(frozen=True, kw_only=True)
class InternalTooth:
    """A tooth that points to the axis, centred on +x; its spaces are bounded by involutes of one origin.

    fillet_radius     ρ of the arc, in the transverse plane, between flank and root circle; 0 for a sharp corner
    relief, chamfer   see `Flank`

    No rack generates an internal gear, and the fillet of a shaper cutter depends on the cutter; a circular arc
    tangent to the flank and to the root circle stands for it. Source: ISO 21771.
    """

    toothing: Toothing
    fillet_radius: float = 0.0
    relief: Relief | None = None
    chamfer: float = 0.0

    @property
    def form_radius(self) -> float:
        """Radius at which the involute ends, below the fillet."""
        return float(np.hypot(self.toothing.base_radius, self._end_string(self.fillet_radius)))

    def _end_string(self, fillet_radius: float) -> float:
        """Length of the base tangent to the end of the flank: ρ + √((r_f − ρ)² − r_b²)."""
        to_centre = self.toothing.root_radius - fillet_radius
        return fillet_radius + float(np.sqrt(max(0.0, to_centre**2 - self.toothing.base_radius**2)))

    def _root_half(self, fillet_radius: float) -> float:
        """Half the angle of the root circle between the fillets of a space."""
        end, base = self._end_string(fillet_radius), self.toothing.base_radius
        return self.toothing.half_at_base - (end / base - float(np.arctan((end - fillet_radius) / base)))

    @property
    def root_half(self) -> float:
        """Half the angle of the root circle in a space."""
        return self._root_half(self.fillet_radius)

    @cached_property
    def largest_fillet_radius(self) -> float:
        """ρ at which the two fillets of a space meet; negative where the flanks do so below the root circle."""
        from scipy.optimize import brentq

        most = self.toothing.root_radius - self.toothing.base_radius
        if self._root_half(0.0) <= 0.0:
            return -1.0
        if self._root_half(most) >= 0.0:
            return most
        return float(brentq(self._root_half, 0.0, most, xtol=1e-15 * most))

    @cached_property
    def flank(self) -> Flank:
        return Flank(toothing=self.toothing, form_radius=self.form_radius, relief=self.relief, chamfer=self.chamfer)

    @property
    def tip_half(self) -> float:
        """Half the angle of the tooth at its tip."""
        return np.pi / self.toothing.teeth - self.flank.tip_half

    def half_angle(self, radius: ArrayLike) -> Array:
        """Half the angle (...) of the tooth at radii (...) from tip to root, without relief and chamfer."""
        r = np.asarray(radius, float)
        space = self.toothing.enclosed_half(np.minimum(r, self.form_radius))
        if self.fillet_radius:
            space = np.where(r > self.form_radius, self._fillet_half(np.maximum(r, self.form_radius)), space)
        return np.pi / self.toothing.teeth - space

    def _fillet_half(self, radius: Array) -> Array:
        """Half the angle (...) of a space at radii (...) of its fillets."""
        to_centre, rho = self.toothing.root_radius - self.fillet_radius, self.fillet_radius
        cosine = (radius**2 + to_centre**2 - rho**2) / (2.0 * radius * to_centre)
        return self.root_half + np.arccos(np.minimum(cosine, 1.0))

    def section(self, outer_radius: float, crowning: Polynomial | None = None) -> Section:
        """The ring's section, inside a circle; flanks turn into the teeth by a crowning, radians."""
        pitch = 2.0 * np.pi / self.toothing.teeth
        rim = Loop(curves=(Arc(radius=outer_radius, interval=(0.0, pitch)),), copies=self.toothing.teeth)
        return Section(loops=(rim, self.outline(crowning)))

    def outline(self, crowning: Polynomial | None = None) -> Loop:
        """The loop of all teeth, clockwise as a hole."""
        toothing, root, space = self.toothing, self.root_half, self.flank.tip_half
        pitch = 2.0 * np.pi / toothing.teeth
        into_space = None if crowning is None else -crowning
        flank = [curve.reversed() for curve in reversed(self.flank.curves())]
        spaces = gear_loop(
            rising=crowned([*flank, *self._fillet()], into_space),
            tip=crowned_arc(toothing.root_radius, (-root, root), into_space) if root > NEXT_TO_NOTHING else None,
            root=crowned_arc(toothing.tip_radius, (pitch - space, space), into_space).reversed(),
            teeth=toothing.teeth,
        )
        half_turn = turn(pitch / 2.0, 2)
        clockwise = tuple(mapped(curve.reversed(), half_turn) for curve in reversed(spaces.curves))
        return Loop(curves=clockwise, copies=toothing.teeth)

    def _fillet(self) -> list[Curve]:
        """The arc on the clockwise side of a space about +x, from flank to root circle."""
        rho, base = self.fillet_radius, self.toothing.base_radius
        if not rho:
            return []
        end = self._end_string(rho)
        leaving = end / base - self.toothing.half_at_base  # azimuth of the base tangent's foot
        middle = leaving - float(np.arctan((end - rho) / base))
        to_centre = self.toothing.root_radius - rho
        centre = (float(to_centre * np.cos(middle)), float(to_centre * np.sin(middle)))
        return [Arc(radius=rho, centre=centre, interval=(leaving - np.pi / 2.0, middle))]
