"""Helical gears."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...motions.extrusion import Extrusion
from ...motions.motion import Motion
from ...motions.straight import Straight
from ...parameters import Problems, declared
from .. import declarations as d
from .external_gear import ExternalGear
from .helix import HELIX_NUMBERS, normal_module, require_one_module


@dataclass(frozen=True, kw_only=True)
class HelicalGear(ExternalGear):
    """An external gear with helical teeth.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0. Raises ParameterError with
    every problem found. Source: ISO 21771; Al-Daccak 1989, ch. 5.5.
    """

    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None)
    helix_angle: float = declared(d.HELIX_ANGLE)
    hand: str = declared(d.HELIX_HAND, default="right")

    def _require_pitch(self, problems: Problems) -> None:
        require_one_module(problems, self.module, self.diametral_pitch, self.transverse_module)

    @property
    def _more_numbers(self) -> tuple[str, ...]:
        return (*super()._more_numbers, *HELIX_NUMBERS)

    @property
    def helix(self) -> float:
        return float(np.radians(self.helix_angle))

    @property
    def hand_sense(self) -> int:
        return 1 if self.hand == "right" else -1

    @cached_property
    def normal_module(self) -> float:
        return normal_module(self.length_unit, self.module, self.diametral_pitch, self.transverse_module, self.helix)

    @property
    def motion(self) -> Motion:
        return Extrusion(length=self.face_width, twist=self.twist) if self.twist else Straight()
