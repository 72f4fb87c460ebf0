"""The tooth of a bevel gear on the unit sphere, and the spherical section it makes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.curve import Curve
from ...curves.meridian import Meridian
from ...curves.parallel import Parallel
from ...sections.loop import Loop
from ...sections.sphere import SphericalSection
from ..gear_loop import NEXT_TO_NOTHING, gear_loop
from .spherical_fillet import SphericalFillet
from .spherical_flank import Form, InvoluteFlank, SphericalFlank, spherical_flank
from .tooth_flank import Relief, ToothFlank


@dataclass(frozen=True, kw_only=True)
class BevelTooth:
    """A tooth centred on azimuth 0, one of `teeth` about +z. Angles in radians.

    pitch_angle, pressure_angle   γ and a
    face_angle, root_angle        polar angles of the tip and the root arc
    thickness                     angular thickness θ_p of the tooth at the pitch cone, about z
    form                          "involute", of the base cone sin γ_b = sin γ cos a (eq. G2), or "octoid"
    tip_radius                    ρ, angular, of the crown gear's tip that generates the fillets; None: below its inner
                                  end the flank carries on as a meridian, down to a sharp corner at the root
    relief                        at the tip, see `Relief`
    profile_crowning              by how much flanks are turned into the tooth at root and tip, about the axis

    Source: Al-Daccak 1989, eqs. (3.15)–(3.19); there ψ_p is taken at φ = pressure angle, which is the
    angle at the point, not at the pole: it thins the tooth. Here ψ_p is the azimuth at the pitch cone.
    """

    teeth: int
    pitch_angle: float
    pressure_angle: float
    face_angle: float
    root_angle: float
    thickness: float
    form: Form = "involute"
    tip_radius: float | None = None
    relief: Relief | None = None
    profile_crowning: float = 0.0

    @cached_property
    def flank(self) -> SphericalFlank:
        """The flank without relief, crossing the pitch cone at azimuth 0."""
        return spherical_flank(self.form, self.pitch_angle, self.pressure_angle)

    @cached_property
    def base_cone_angle(self) -> float:
        """γ_b of the involute, sin γ_b = sin γ cos a (eq. G2); an octoid has no base cone, this is its involute's."""
        return InvoluteFlank(pitch_angle=self.pitch_angle, pressure_angle=self.pressure_angle).base_cone_angle

    @cached_property
    def pitch_azimuth(self) -> float:
        """ψ_p, azimuth of the flank at the pitch cone from its inner end."""
        return self.flank.pitch_azimuth

    @cached_property
    def fillet(self) -> SphericalFillet | None:
        if self.tip_radius is None:
            return None
        return self._fillet(self.tip_radius)

    def _fillet(self, tip_radius: float) -> SphericalFillet:
        return SphericalFillet(
            flank=self.flank,
            teeth=self.teeth,
            thickness=self.thickness - 2.0 * self.profile_crowning,  # as the foot of the flank is turned
            root_angle=self.root_angle,
            tip_radius=tip_radius,
        )

    @property
    def largest_tip_radius(self) -> float:
        """Largest ρ, angular, that the tip of the crown gear's tooth has room for; not positive where there is none."""
        return self._fillet(0.0).crown_tip.largest_radius

    @property
    def flank_start(self) -> float:
        """Polar angle at which a flank without fillet begins: its inner end, or the root cone above it."""
        return max(self.root_angle, self.flank.least_polar)

    @cached_property
    def form_angle(self) -> float:
        """Polar angle at which the flank proper begins: above the fillet, else its start."""
        return self.flank_start if self.fillet is None else self.fillet.form_angle

    @cached_property
    def tooth_flank(self) -> ToothFlank:
        """The flank proper, with its relief."""
        return ToothFlank(
            form=self.flank,
            thickness=self.thickness,
            form_angle=self.form_angle,
            face_angle=self.face_angle,
            relief=self.relief,
            crowning=self.profile_crowning,
        )

    def thickness_at(self, polar: float) -> float:
        """Angular thickness θ = θ_p − 2(ψ(δ) − ψ_p) at a polar angle on the flank, without relief and crowning."""
        return self.thickness - 2.0 * float(self.flank.azimuth_at(polar))

    def half_angle(self, polar: ArrayLike) -> Array:
        """Half the angular thickness (...) at polar angles (...) from the form angle to the face angle, with relief."""
        return self.tooth_flank.half_angle(polar)

    def profile_half(self, polar: ArrayLike) -> Array:
        """Half the angle (...) of the tooth at polar angles (...) from the root to the face, fillets included."""
        delta = np.asarray(polar, float)
        found = np.array(self.half_angle(np.maximum(delta, self.form_angle)))
        below = delta < self.form_angle
        if self.fillet is not None and below.any():
            found[below] = self.fillet.half_angle(np.maximum(delta[below], self.root_angle))
        return found

    @property
    def tip_half(self) -> float:
        """Half the angle of the tooth at its tip, with relief."""
        return self.tooth_flank.tip_half

    @cached_property
    def pointed_angle(self) -> float:
        """Polar angle at which the flanks, without relief, meet; where they end first, that of their ends."""
        return self.flank.polar_at_azimuth(self.thickness / 2.0)

    @property
    def root_space(self) -> float:
        """Angular width of the root arc between fillets; without them, of the space at the foot of the flanks."""
        if self.fillet is not None:
            return 2.0 * self.fillet.crown_tip.land / float(np.sin(self.pitch_angle))
        return 2.0 * np.pi / self.teeth - 2.0 * self._foot_half

    @property
    def _foot_half(self) -> float:
        """Half the angle of a tooth without fillets where its flanks begin."""
        return self.thickness_at(self.flank_start) / 2.0 - self.profile_crowning

    @property
    def waist(self) -> float:
        """Half the least angle of the tooth between root and flank."""
        return self._foot_half if self.fillet is None else self.fillet.waist

    def outline(self) -> Loop:
        """All teeth, by one of them.

        A flank is a fillet (with a tip radius), the form, and a relieved part (with relief), whatever the numbers; the
        root arc vanishes with the land of the crown gear's tip, and radial roots have a meridian only below the form.
        """
        tip, gap, middle = self.tip_half, self.root_space / 2.0, np.pi / self.teeth
        root = Parallel(polar_angle=self.root_angle, interval=(middle - gap, middle + gap))
        return gear_loop(
            rising=[*self._foot(), *self.tooth_flank.curves()],
            tip=Parallel(polar_angle=self.face_angle, interval=(-tip, tip)),
            root=root if gap > 0.0 else None,
            teeth=self.teeth,
        )

    def section(self, hole_angle: float | None = None) -> SphericalSection:
        """The gear's section: all teeth, full to the axis, or to a circular hole of a polar angle."""
        return with_hole(self.outline(), hole_angle)

    def _foot(self) -> list[Curve]:
        """Curves of the clockwise side from the root cone to the flank proper."""
        if self.fillet is not None:
            return [self.fillet.curve()]
        if self.root_angle >= self.flank.least_polar * (1.0 - NEXT_TO_NOTHING):
            return []
        return [Meridian(azimuth=-self._foot_half, interval=(self.root_angle, self.flank_start))]


def with_hole(outline: Loop, hole_angle: float | None) -> SphericalSection:
    """The section of an outline of teeth, full to the axis, or to a circular hole of a polar angle."""
    if hole_angle is None:
        return SphericalSection(loops=(outline,))
    hole = Parallel(polar_angle=hole_angle, interval=(0.0, -2.0 * np.pi / outline.copies))
    return SphericalSection(loops=(outline, Loop(curves=(hole,), copies=outline.copies)))
