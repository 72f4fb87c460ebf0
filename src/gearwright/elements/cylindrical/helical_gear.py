"""Helical gears."""

from __future__ import annotations

from dataclasses import dataclass

from ...parameters import declared
from .. import declarations as d
from .external_gear import ExternalGear


@dataclass(frozen=True, kw_only=True, repr=False)
class HelicalGear(ExternalGear):
    """An external gear with helical teeth.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0. Raises ParameterError with
    every problem found. Source: ISO 21771; Al-Daccak 1989, ch. 5.5.
    """

    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None)
    helix_angle: float = declared(d.HELIX_ANGLE)
    hand: str = declared(d.HELIX_HAND, default="right")
