"""Spur gears."""

from __future__ import annotations

from dataclasses import dataclass

from .external_gear import ExternalGear


@dataclass(frozen=True, kw_only=True, repr=False)
class SpurGear(ExternalGear):
    """An external gear with straight teeth.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x. Raises ParameterError with every
    problem found. Source: ISO 21771; Al-Daccak 1989, ch. 4.5.2.
    """
