"""Herringbone gears."""

from __future__ import annotations

from dataclasses import dataclass

from ...motions.herringbone import Herringbone
from ...motions.motion import Motion
from ...motions.straight import Straight
from .twisted_gear import TwistedGear


@dataclass(frozen=True, kw_only=True)
class HerringboneGear(TwistedGear):
    """An external gear with helical teeth of both hands, which meet without a gap at mid-face.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0, where the hand is the one
    given. Raises ParameterError with every problem found. Source: ISO 21771 for either half.
    """

    @property
    def motion(self) -> Motion:
        return Herringbone(length=self.face_width, twist=self.twist / 2.0) if self.twist else Straight()
