"""The teeth of a cylindrical gear in numbers: what its shape, its sizes and its mate follow from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.involute import inverse_involute_function, involute_function, involute_of_roll, involute_roll

_STRAIGHT = 1e-200  # tan β below which a lead is no number


@dataclass(frozen=True, kw_only=True)
class Toothing:
    """Involute teeth about an axis. Lengths in one unit, angles in radians.

    module           m_n, in the normal section
    pressure_angle   α_n, in the normal section
    helix_angle      β on the pitch cylinder, 0 ≤ β < π/2, of either hand
    profile_shift    x, in normal modules; positive makes the teeth thicker, of an internal gear, too (ISO 21771)
    addendum         h_a of the teeth beyond the pitch circle; dedendum h_f behind it
    thickness        s_t, the transverse arc of a tooth on the pitch circle, backlash taken off
    internal         whether the teeth point to the axis

    Source: ISO 21771, ch. 4 and 5.
    """

    teeth: int
    module: float
    pressure_angle: float
    helix_angle: float
    profile_shift: float
    addendum: float
    dedendum: float
    thickness: float
    internal: bool = False

    @classmethod
    def basic(
        cls, teeth: int, module: float, pressure_angle: float, helix_angle: float, *, internal: bool = False
    ) -> Self:
        """Teeth without profile shift, one module high and deep, half a pitch thick."""
        half = float(np.pi * module / np.cos(helix_angle) / 2.0)
        return cls(
            teeth=teeth,
            module=module,
            pressure_angle=pressure_angle,
            helix_angle=helix_angle,
            profile_shift=0.0,
            addendum=module,
            dedendum=module,
            thickness=half,
            internal=internal,
        )

    def shifted(self, profile_shift: float) -> Self:
        """The same teeth under another profile shift, for what depends on nothing else."""
        return replace(self, profile_shift=profile_shift)

    @property
    def outward(self) -> int:
        """+1 where the tips are farther from the axis than the roots, −1 in an internal gear."""
        return -1 if self.internal else 1

    @property
    def transverse_module(self) -> float:
        """m_t = m_n/cos β."""
        return float(self.module / np.cos(self.helix_angle))

    @cached_property
    def transverse_pressure_angle(self) -> float:
        """α_t, tan α_t = tan α_n/cos β."""
        return float(np.arctan(np.tan(self.pressure_angle) / np.cos(self.helix_angle)))

    @property
    def base_helix_angle(self) -> float:
        """β_b, sin β_b = sin β cos α_n."""
        return float(np.arcsin(np.sin(self.helix_angle) * np.cos(self.pressure_angle)))

    @property
    def pitch_radius(self) -> float:
        return self.teeth * self.transverse_module / 2.0

    @cached_property
    def base_radius(self) -> float:
        """r_b = r cos α_t."""
        return float(self.pitch_radius * np.cos(self.transverse_pressure_angle))

    @property
    def tip_radius(self) -> float:
        return self.pitch_radius + self.outward * self.addendum

    @property
    def root_radius(self) -> float:
        return self.pitch_radius - self.outward * self.dedendum

    @property
    def circular_pitch(self) -> float:
        """p_t = π m_t."""
        return float(np.pi * self.transverse_module)

    @property
    def base_pitch(self) -> float:
        """p_bt = p_t cos α_t."""
        return float(self.circular_pitch * np.cos(self.transverse_pressure_angle))

    @property
    def lead(self) -> float:
        """p_z = 2πr/tan β, the height of one turn of a tooth; infinite for straight teeth, or all but straight ones."""
        slope = float(np.tan(self.helix_angle))
        return 2.0 * np.pi * self.pitch_radius / slope if slope > _STRAIGHT else np.inf

    @cached_property
    def half_at_base(self) -> float:
        """Half the angle, on the base circle, of what the two involutes of one origin enclose.

        That is a tooth of an external gear and a space of an internal one.
        """
        enclosed = self.circular_pitch - self.thickness if self.internal else self.thickness
        return float(enclosed / (2.0 * self.pitch_radius) + involute_function(self.transverse_pressure_angle))

    def roll(self, radius: ArrayLike) -> Array:
        """Roll angle t (...) of the involute at radii (...) from the base circle on."""
        return involute_roll(radius, self.base_radius)

    def enclosed_half(self, radius: ArrayLike) -> Array:
        """Half the angle (...) between the two involutes at radii (...): of a tooth, internally of a space."""
        return np.asarray(self.half_at_base - involute_of_roll(self.roll(radius)))

    def thickness_at(self, radius: float) -> float:
        """Angular thickness of a tooth at a radius on its involutes."""
        enclosed = 2.0 * float(self.enclosed_half(radius))
        return 2.0 * np.pi / self.teeth - enclosed if self.internal else enclosed

    @property
    def pointed_radius(self) -> float:
        """Radius at which the two involutes meet."""
        return self.base_radius / float(np.cos(inverse_involute_function(self.half_at_base)))
