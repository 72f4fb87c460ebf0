"""Sizes of a bevel pair, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...parameters import Size
from ..standards.bevels.pair_sizes import pair_sizes
from .meshing import contact_ratio, interference_limit, overlap_ratio

if TYPE_CHECKING:
    from .bevel_pair import BevelPair


def bevel_pair_sizes(pair: BevelPair) -> dict[str, Size]:
    """Sizes of the pair; contact ratios of the true teeth at mid-face, and of the virtual gears beside them."""
    pinion, gear = pair.pinion, pair.gear
    teeth = pair.teeth_on_sphere(pinion.mean_distance)
    limits = [float(np.degrees(interference_limit(a, b))) for a, b in (teeth, teeth[::-1])]
    transverse = contact_ratio(*teeth)
    overlap = overlap_ratio(pinion.tooth_trace, pinion.inner_distance, pinion.cone_distance, pinion.teeth)
    virtual = pair_sizes(pinion.member, gear.member)
    renamed = {("virtual_" + name if "contact" in name else name): size for name, size in virtual.items()}
    return {
        **renamed,
        "shaft_angle": Size(pair.shaft_angle, "angle", "Σ", "angle between the axes"),
        "gear_ratio": Size(pair.teeth[1] / pair.teeth[0], "", "u", "teeth of the gear over teeth of the pinion"),
        "outer_module": Size(pinion.outer_module, "length", "m_et", "transverse module at the outer end"),
        "cone_distance": Size(pinion.cone_distance, "length", "R_e", "outer cone distance"),
        "working_depth": Size(pair.outer_working_depth, "length", "h_wk", "sum of the addenda, outer"),
        "whole_depth": Size(pair.outer_whole_depth, "length", "h_e", "addendum and dedendum of a member, outer"),
        "clearance": Size(
            pair.outer_whole_depth - pair.outer_working_depth, "length", "c", "from tip to mate's root, outer"
        ),
        "contact_ratio": Size(transverse, "", "ε_α", "transverse contact ratio"),
        "overlap_ratio": Size(overlap, "", "ε_β", "turn of the trace along the face in pitches"),
        "total_contact_ratio": Size(transverse + overlap, "", "ε_γ", "transverse and overlap"),
        "pinion_face_angle_limit": Size(limits[0], "angle", "δ_a1max", "face angle at which interference begins"),
        "gear_face_angle_limit": Size(limits[1], "angle", "δ_a2max", "face angle at which interference begins"),
    }
