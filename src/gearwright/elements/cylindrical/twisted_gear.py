"""What external gears with helical teeth have in common."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...parameters import Problems, declared
from .. import declarations as d
from .external_gear import ExternalGear
from .helix import HELIX_NUMBERS, normal_module, require_one_module


@dataclass(frozen=True, kw_only=True)
class TwistedGear(ExternalGear):
    """An external gear whose transverse section turns on its way from z = 0 to the face width."""

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
