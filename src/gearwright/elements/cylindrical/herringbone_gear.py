"""Herringbone gears."""

from __future__ import annotations

from dataclasses import dataclass

from ...motions.herringbone import Herringbone
from ...motions.motion import Motion
from ...motions.straight import Straight
from ...parameters import declared
from .. import declarations as d
from .external_gear import ExternalGear


@dataclass(frozen=True, kw_only=True, repr=False)
class HerringboneGear(ExternalGear):
    """An external gear with helical teeth of both hands, which meet without a gap at mid-face.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0, where the hand is the one
    given. Raises ParameterError with every problem found. Source: ISO 21771 for either half.
    """

    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None)
    helix_angle: float = declared(d.HELIX_ANGLE)
    hand: str = declared(d.HELIX_HAND, default="right")

    @property
    def flank_width(self) -> float:
        """Half the face width: teeth bend in the middle."""
        return self.face_width / 2.0

    @property
    def motion(self) -> Motion:
        return Herringbone(length=self.face_width, twist=self.twist / 2.0) if self.twist else Straight()
