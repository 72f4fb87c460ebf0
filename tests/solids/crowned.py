"""A gear whose teeth grow thinner along its axis, and what is known of it in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from gearwright.curves.arc import Arc
from gearwright.curves.curve import Curve, mapped, turn
from gearwright.curves.involute import Involute, involute_function, involute_of_roll
from gearwright.curves.line import Line
from gearwright.curves.polynomial import Polynomial
from gearwright.curves.turning import TurnedArc, turned
from gearwright.motions.ends import between
from gearwright.motions.extrusion import Extrusion
from gearwright.motions.straight import Straight
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.solids.swept import Swept

FACE_WIDTH = 20.0
PRESSURE_ANGLE = np.radians(20.0)


@dataclass(frozen=True)
class CrownedGear:
    """Standard teeth of a module with a round bore; `thinning` is the angle each flank turns into the tooth by."""

    thinning: Polynomial
    teeth: int = 24
    module: float = 3.0
    bore: float = 10.0

    @property
    def radii(self) -> tuple[float, float]:
        """Of root and tip."""
        pitch = self.teeth * self.module / 2.0
        return pitch - 1.25 * self.module, pitch + self.module

    @cached_property
    def section(self) -> Section:
        (root, tip), step = self.radii, 2.0 * np.pi / self.teeth
        base = self.teeth * self.module / 2.0 * np.cos(PRESSURE_ANGLE)
        half = step / 4.0 + float(involute_function(PRESSURE_ANGLE))
        rolls = [float(np.sqrt(max(r / base, 1.0) ** 2 - 1.0)) for r in (root, tip)]
        low, high = (half - float(involute_of_roll(roll)) for roll in rolls)
        involute = Involute(base_radius=base, interval=(rolls[0], rolls[1]))
        rising: list[Curve] = [mapped(involute, turn(-half, 2))]
        if root < base:
            down = np.array([np.cos(low), -np.sin(low)])
            rising.insert(0, Line(first=tuple(root * down), last=tuple(base * down)))
        rising = [turned(curve, self.thinning) for curve in rising]
        falling = [mapped(curve, turn(0.0, 2, mirrored=True)).reversed() for curve in reversed(rising)]
        top = TurnedArc(radius=tip, azimuths=(-high, high), turnings=(self.thinning, -self.thinning))
        space = TurnedArc(radius=root, azimuths=(low, step - low), turnings=(-self.thinning, self.thinning))
        outline = Loop(curves=(*rising, top, *falling, space), copies=self.teeth)
        hole = Loop(curves=(Arc(radius=self.bore, interval=(0.0, -step)),), copies=self.teeth)
        return Section(loops=(outline, hole))

    def solid(self, twist: float = 0.0) -> Swept:
        """Straight, or helical with so much twist (radians)."""
        motion = Extrusion(length=FACE_WIDTH, twist=twist) if twist else Straight()
        return Swept(section=self.section, motion=motion, ends=between(0.0, FACE_WIDTH))
