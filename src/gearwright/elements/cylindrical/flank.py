"""The involute flank of a cylindrical gear, with relief towards its tip and a chamfer on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...curves.curve import Curve, mapped, turn
from ...curves.involute import Involute
from ...curves.line import Line
from ...curves.relieved_involute import RelievedInvolute
from .toothing import Toothing


@dataclass(frozen=True, kw_only=True)
class Relief:
    """Tip relief: `amount` along the flank's normal at the end of the flank, growing from radius `begin` on.

    power   1: evenly with the roll angle; 2: parabolically
    """

    amount: float
    begin: float
    power: int


@dataclass(frozen=True, kw_only=True)
class Flank:
    """The flank on the clockwise side of what two involutes enclose about +x (see `Toothing.half_at_base`).

    form_radius   where the involute begins, at the root
    relief        at the tip, if any
    chamfer       height at the tip that is taken off under 45° to the radius halfway between its ends
    """

    toothing: Toothing
    form_radius: float
    relief: Relief | None = None
    chamfer: float = 0.0

    @property
    def usable_tip_radius(self) -> float:
        """r_Na, at which the flank ends: the tip circle, or where the chamfer begins."""
        return self.toothing.tip_radius - self.toothing.outward * self.chamfer

    @property
    def involute_tip_radius(self) -> float:
        """Radius at which the involute itself ends: where relief begins, else where the flank ends."""
        return self.usable_tip_radius if self.relief is None else self.relief.begin

    @property
    def end_roll(self) -> float:
        """Roll angle at which the flank ends: r_b t − c = √(r_Na² − r_b²), with the sign of the relief c."""
        return float(self.toothing.roll(self.usable_tip_radius)) + self._relief / self.toothing.base_radius

    @property
    def _relief(self) -> float:
        """What the string is shortened by at the end; an internal gear's is made longer."""
        return self.toothing.outward * self.relief.amount if self.relief else 0.0

    @property
    def end_half(self) -> float:
        """Half the enclosed angle where the flank ends."""
        string = float(self.toothing.roll(self.usable_tip_radius))
        return self.toothing.half_at_base - (self.end_roll - float(np.arctan(string)))

    @property
    def tip_half(self) -> float:
        """Half the enclosed angle on the tip circle, beyond relief and chamfer."""
        both = self.usable_tip_radius + self.toothing.tip_radius
        return self.end_half - self.toothing.outward * 2.0 * float(np.arctan(self.chamfer / both))

    def curves(self) -> list[Curve]:
        """From the form radius to the tip circle."""
        toothing, base = self.toothing, self.toothing.base_radius
        first, last = float(toothing.roll(self.form_radius)), self.end_roll
        found: list[Curve] = []
        if self.relief is None:
            found.append(Involute(base_radius=base, interval=(first, last)))
        else:
            begin = float(toothing.roll(self.relief.begin))
            relieved = RelievedInvolute(
                base_radius=base,
                amount=self._relief,
                begin=begin,
                full=last,
                power=self.relief.power,
                interval=(begin, last),
            )
            found += [Involute(base_radius=base, interval=(first, begin)), relieved]
        found = [mapped(curve, turn(-toothing.half_at_base, 2)) for curve in found]
        if self.chamfer:
            corners = [(self.usable_tip_radius, -self.end_half), (toothing.tip_radius, -self.tip_half)]
            ends = [(float(r * np.cos(a)), float(r * np.sin(a))) for r, a in corners]
            found.append(Line(first=ends[0], last=ends[1]))
        return found
