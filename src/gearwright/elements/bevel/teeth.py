"""The teeth of a bevel gear in numbers: what changes along the face, and the section that varies with it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from ...sections.loop import Loop
from ...sections.sphere import SphericalSection
from .depth_line import DepthLine
from .spherical_flank import Form
from .tooth import BevelTooth, with_hole
from .tooth_ends import ToothEnds
from .tooth_flank import Relief
from .varying_section import varying_loop

_PLACES = {"inner": 0.0, "mean": 0.5, "outer": 1.0}


@dataclass(frozen=True, kw_only=True)
class BevelTeeth:
    """Teeth between two ends. Lengths at the outer end, in the length unit; angles in radians.

    pitch_angle, pressure_angle   γ and the transverse a
    tips, roots                   lines of the axial plane
    thickness                     angular, at the pitch cone, about the axis; the same all along but for crowning
    tip_radius                    ρ of the crown gear's tip; None: radial roots. Elsewhere it goes with the dedendum
    relief, relief_height         amount along the normal and the part of the addendum it takes; both go with depth and
                                  cone distance
    relief_power                  1 linear, 2 parabolic
    profile_crowning              C_α by which each flank is lower at its foot and its tip than on the pitch cone; it
                                  goes with the cone distance, a turn into the tooth by up to C_α/(R_e sin γ cos a)
    crowning                      C_β by which each flank is lower at its ends than at mid-face, along its normal in the
                                  transverse section: it turns into the tooth by C_β (2(s − R_m)/b)²/(s sin γ cos a)
    """

    teeth: int
    pitch_angle: float
    pressure_angle: float
    form: Form
    ends: ToothEnds
    tips: DepthLine
    roots: DepthLine
    thickness: float
    tip_radius: float | None = None
    relief: float = 0.0
    relief_height: float = 0.0
    relief_power: Literal[1, 2] = 1
    profile_crowning: float = 0.0
    crowning: float = 0.0

    def level(self, place: str) -> float:
        """Parameter v of the inner, the mean or the outer end (see `Radial`)."""
        inner, outer = self.ends.inner, self.ends.outer
        return self.ends.parameter(inner + _PLACES[place] * (outer - inner))

    def tooth(self, v: float) -> BevelTooth:
        """The tooth on the level of a parameter, as it looks from the apex."""
        face, root = self.tips.polar_angle(self.ends, v), self.roots.polar_angle(self.ends, v)
        return BevelTooth(
            teeth=self.teeth,
            pitch_angle=self.pitch_angle,
            pressure_angle=self.pressure_angle,
            face_angle=face,
            root_angle=root,
            thickness=self.thickness - 2.0 * self._crown(v),
            form=self.form,
            tip_radius=None if self.tip_radius is None else self.tip_radius / self.tip_radius_scale(root),
            relief=self._relief(face) if self.relief else None,
            profile_crowning=self.profile_crowning / (self.ends.outer * self._lever),
        )

    def _relief(self, face: float) -> Relief:
        part = self.relief_height / self.tips.height
        begin = face - part * (face - self.pitch_angle)
        return Relief(amount=self.relief / self.ends.outer, begin=begin, power=self.relief_power)

    def _crown(self, v: float) -> float:
        """Angle by which each flank is turned into the tooth, about the axis."""
        s = self.ends.pitch_distance(v)
        inner, outer = self.ends.inner, self.ends.outer
        lowered = self.crowning * (2.0 * (s - (inner + outer) / 2.0) / (outer - inner)) ** 2
        return float(lowered / (s * self._lever))

    @property
    def most_crowning(self) -> float:
        """Lead crowning that leaves nothing of a tooth on the pitch cone at its inner end, length."""
        return self.thickness / 2.0 * self.ends.inner * self._lever

    @property
    def _lever(self) -> float:
        """sin γ cos a: what a flank is moved by along its normal as it turns about the axis, on the unit sphere."""
        return float(np.sin(self.pitch_angle) * np.cos(self.pressure_angle))

    @property
    def varies(self) -> bool:
        """Whether the tooth looks different from level to level."""
        return bool(self.crowning or self.tips.offset or self.roots.offset)

    @cached_property
    def outer(self) -> BevelTooth:
        return self.tooth(self.level("outer"))

    @cached_property
    def mean(self) -> BevelTooth:
        return self.tooth(self.level("mean"))

    @cached_property
    def inner(self) -> BevelTooth:
        return self.tooth(self.level("inner"))

    @property
    def largest_tip_radius(self) -> float:
        """Largest ρ at the outer end, length, that fits everywhere between the teeth; not positive where none does."""
        return min(
            tooth.largest_tip_radius * self.tip_radius_scale(tooth.root_angle) for tooth in self.looked_at.values()
        )

    def tip_radius_scale(self, root: float) -> float:
        """ρ at the outer end, length, over the angular ρ where the roots have a polar angle."""
        whole = self.pitch_angle - self.roots.polar_angle(self.ends, self.level("outer"))
        return self.ends.outer * whole / (self.pitch_angle - root)

    def on_spheres(self) -> BevelTeeth:
        """The same teeth, whose levels are spheres about the apex, on which mates meet."""
        return replace(self, ends=replace(self.ends, kind="spherical"))

    @property
    def looked_at(self) -> dict[str, BevelTooth]:
        """The teeth to be looked at for what is wrong with them, by where they are."""
        if not self.varies:
            return {"outer": self.outer}
        return {"outer": self.outer, "mean": self.mean, "inner": self.inner}

    @property
    def undercut(self) -> bool:
        """Whether the generating crown gear cuts away some of the flanks somewhere."""
        return any(tooth.fillet is not None and tooth.fillet.undercuts for tooth in self.looked_at.values())

    @property
    def least_root_angle(self) -> float:
        """Least polar angle of the roots."""
        return min(tooth.root_angle for tooth in self.looked_at.values())

    @cached_property
    def outline(self) -> Loop:
        """All teeth, by one of them; it varies where they do.

        Raises GeometryError where they change their kind, or not evenly, between the ends.
        """
        if not self.varies:
            return self.outer.outline()
        return varying_loop(lambda v: self.tooth(v).outline(), self.level("inner"), self.level("outer"))

    def section(self, hole_angle: float | None = None) -> SphericalSection:
        """The gear's section, full or to a hole of a polar angle; it varies where the teeth do."""
        return with_hole(self.outline, hole_angle)
