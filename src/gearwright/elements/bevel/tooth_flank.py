"""The flank proper of a bevel gear's tooth, from the fillet to the tip, with relief."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.crowned_rolled import CrownedRolled
from ...curves.curve import Curve, mapped, turn
from ...curves.relieved_rolled import RelievedRolled
from .spherical_flank import SphericalFlank


@dataclass(frozen=True, kw_only=True)
class Relief:
    """Tip relief: `amount` along the normal great circle at the end of the flank, growing from a polar angle on.

    amount   radians on the unit sphere
    begin    polar angle, radians
    power    1: evenly with the turn of the crown gear; 2: parabolically
    """

    amount: float
    begin: float
    power: int


@dataclass(frozen=True, kw_only=True)
class ToothFlank:
    """The flank on the clockwise side of a tooth on azimuth 0; radians.

    form         the flank without relief
    thickness    angular, of the tooth at the pitch cone, about its axis
    form_angle   polar angle at which the flank begins, at the root
    face_angle   polar angle at which it ends
    relief       at the tip, if any
    crowning     of the profile: by how much the flank is turned into the tooth at both its ends, about the axis
    """

    form: SphericalFlank
    thickness: float
    form_angle: float
    face_angle: float
    relief: Relief | None = None
    crowning: float = 0.0

    @cached_property
    def relieved(self) -> RelievedRolled | None:
        """The part with relief, with the pitch cone crossed at azimuth 0.

        It ends where, with all of the relief, it is on the face cone. Raises ValueError where the form ends before.
        """
        from scipy.optimize import brentq

        relief = self.relief
        if relief is None:
            return None
        begin, face = (float(u) for u in self.form.parameter_at([relief.begin, self.face_angle]))
        last = self.form.greatest_turn
        end = float(brentq(lambda u: self._lowered(u, relief.amount) - self.face_angle, face, last, xtol=1e-15))
        return RelievedRolled(
            pitch_angle=self.form.pitch_angle,
            flank=self.form.rolled(begin, end),
            amount=relief.amount,
            begin=begin,
            full=end,
            power=relief.power,
            interval=(begin, end),
        )

    def _lowered(self, u: float, amount: float) -> float:
        """Polar angle of the point of the form at u, moved along its normal great circle by an amount."""
        at_once = RelievedRolled(
            pitch_angle=self.form.pitch_angle,
            flank=self.form.rolled(u, u),
            amount=amount,
            begin=u - 1.0,
            full=u,
            power=1,
            interval=(u, u),
        )
        return float(at_once.polar_angle(u))

    def half_angle(self, polar: ArrayLike) -> Array:
        """Half the angle (...) of the tooth about its axis at polar angles (...) of the flank."""
        delta = np.asarray(polar, float)
        if self.relief is None or self.relieved is None:
            plain = self.form.azimuth_at(delta)
            turned = self._crown(self.form.parameter_at(delta)) if self.crowning else 0.0
            return self.thickness / 2.0 - plain - turned
        lower = np.minimum(delta, self.relief.begin)
        azimuth = np.array(self.form.azimuth_at(lower) + self._crown(self.form.parameter_at(lower)))
        relieved = delta > self.relief.begin
        beyond = self.relieved.at_polar_angle(delta[relieved])
        azimuth[relieved] = self.relieved.azimuth(beyond) + self._crown(beyond)
        return self.thickness / 2.0 - azimuth

    @cached_property
    def _ends(self) -> tuple[float, float]:
        """Parameters u of the form at the form angle and at the face angle."""
        first, last = (float(u) for u in self.form.parameter_at([self.form_angle, self.face_angle]))
        return first, last

    def _crown(self, u: ArrayLike) -> Array:
        """Angle (...) by which the flank is turned at parameters (...), about the axis."""
        u = np.asarray(u, float)
        if not self.crowning:
            return np.zeros_like(u)
        first, last = self._ends
        return self.crowning * (u / np.where(u < 0.0, first, last)) ** 2

    @cached_property
    def tip_half(self) -> float:
        """Half the angle of the tooth at its tip."""
        end = self.relieved
        last = self._ends[1] if end is None else end.interval[1]
        azimuth = self.form.azimuth_at(self.face_angle) if end is None else end.azimuth(last)
        return float(self.thickness / 2.0 - azimuth - self._crown(last))

    def curves(self) -> list[Curve]:
        """From the form angle to the face cone."""
        last = self.face_angle if self.relief is None else self.relief.begin
        if self.crowning:
            found = self._crowned()
        else:
            found = [self.form.curve(self.form_angle, last), *([] if self.relieved is None else [self.relieved])]
        return [mapped(curve, turn(-self.thickness / 2.0, 3)) for curve in found]

    def _crowned(self) -> list[Curve]:
        """The parts below and above the pitch cone, and those with relief."""
        (first, face), relieved = self._ends, self.relieved
        end = face if relieved is None else relieved.interval[1]
        begin = end if relieved is None else relieved.begin
        found: list[Curve] = []
        for a, b in pairwise(sorted({first, 0.0, begin, end})):
            crowned = CrownedRolled(
                pitch_angle=self.form.pitch_angle,
                flank=self.form.rolled(a, b),
                amount=self.crowning,
                full=first if a < 0.0 else face,
                interval=(a, b),
            )
            found.append(
                crowned if relieved is None or a < begin else replace(relieved, flank=crowned, interval=(a, b))
            )
        return found
