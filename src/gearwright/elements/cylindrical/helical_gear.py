"""Helical gears."""

from __future__ import annotations

from dataclasses import dataclass

from ...motions.extrusion import Extrusion
from ...motions.motion import Motion
from ...motions.straight import Straight
from .twisted_gear import TwistedGear


@dataclass(frozen=True, kw_only=True)
class HelicalGear(TwistedGear):
    """An external gear with helical teeth.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0. Raises ParameterError with
    every problem found. Source: ISO 21771; Al-Daccak 1989, ch. 5.5.
    """

    @property
    def motion(self) -> Motion:
        return Extrusion(length=self.face_width, twist=self.twist) if self.twist else Straight()
