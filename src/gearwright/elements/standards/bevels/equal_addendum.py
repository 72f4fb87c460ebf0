"""Bevel gears with the proportions of spur gears at their outer end."""

from __future__ import annotations

import numpy as np

from .design import BevelDesign
from .proportions import Pair, Proportions
from .thickness import thicknesses

_CLEARANCE = 0.25


def equal_addendum(design: BevelDesign, *, profile_shift: float = 0.0, thickness_modification: float = 0.0) -> Pair:
    """h_a = (1 ± x) m, h_f = (1.25 ∓ x) m, s = (π/2 ± 2x tan α_t ± 2x_s) m; every cone's apex is the pitch apex.

    profile_shift            x of the first member, in outer transverse modules, −x of the second: long and short teeth
    thickness_modification   x_s, likewise: the first member's teeth are thicker by 2x_s modules, the second's thinner
    tan θ_a = h_a/R_e and tan θ_f = h_f/R_e, so that the clearance shrinks towards the inner end.
    Source: KHK, Gear Technical Reference, standard straight bevel gears (x = x_s = 0).
    """
    distance, module = design.cone_distance, design.module
    widths = thicknesses(design, 2.0 * profile_shift * module, thickness_modification)

    def member(shift: float, thickness: float) -> Proportions:
        addendum, dedendum = (1.0 + shift) * module, (1.0 + _CLEARANCE - shift) * module
        return Proportions(
            addendum=addendum,
            dedendum=dedendum,
            addendum_angle=float(np.arctan2(addendum, distance)),
            dedendum_angle=float(np.arctan2(dedendum, distance)),
            thickness=thickness,
        )

    return member(profile_shift, widths[0]), member(-profile_shift, widths[1])
