"""Sizes of two bevel gears in engagement, by way of their virtual cylindrical gears."""

from __future__ import annotations

import numpy as np

from ....parameters import Size
from ...cylindrical.sizes import in_unit
from .member import BevelMember


def pair_sizes(first: BevelMember, second: BevelMember) -> dict[str, Size]:
    """Depths, clearances and virtual contact ratios, by name."""
    width = first.face_width
    ends = {"outer": (0.0, "outer end"), "mean": (width / 2.0, "mid-face"), "inner": (width, "inner end")}
    lengths = {
        "working_depth": (first.proportions.addendum + second.proportions.addendum, "h_we", "sum of the outer addenda"),
    }
    for name, (inwards, where) in ends.items():
        for tips, roots, index in ((first, second, 1), (second, first, 2)):
            gap = roots.dedendum(inwards) - tips.addendum(inwards)
            meaning = f"from member {index}'s tip to its mate's root, {where}"
            lengths[f"{name}_clearance_{index}"] = (gap, f"c_{name[0]}{index}", meaning)
    transverse, overlap = transverse_contact_ratio(first, second), overlap_ratio(first)
    ratios = {
        "contact_ratio": (transverse, "ε_vα", "transverse contact ratio of the virtual gears"),
        "face_overlap": (overlap, "ε_vβ", "overlap ratio of the whole face"),
        "modified_contact_ratio": (float(np.hypot(transverse, overlap)), "ε_vγ", "both, as a path across the face"),
    }
    return {**in_unit(lengths, "length"), **in_unit(ratios, "")}


def transverse_contact_ratio(first: BevelMember, second: BevelMember) -> float:
    """ε_vα = g_vα cos β_m/(π m_mn cos α_t) of the virtual gears at mid-face, d_v = d_m/cos δ, while involutes last.

    g_vα is what both members have of the line of action between pitch point and tip circle.
    Source: ISO 10300-1:2014, annex A.
    """
    pitch = np.pi * first.module * first.mean_ratio * np.cos(first.transverse_pressure_angle)
    return (_beyond_pitch_point(first) + _beyond_pitch_point(second)) / float(pitch)


def _beyond_pitch_point(member: BevelMember) -> float:
    """√(r_va² − r_vb²) − r_v sin α_t, written so that a rack's is h_am/sin α_t."""
    up, sine = member.addendum(member.face_width / 2.0), np.sin(member.transverse_pressure_angle)
    curvature = 2.0 * member.back_curvature / (member.pitch_diameter * member.mean_ratio)
    grown = 2.0 + up * curvature
    return float(up * grown / (np.sqrt(sine**2 + up * curvature * grown) + sine))


def overlap_ratio(member: BevelMember) -> float:
    """ε_vβ = b sin β_m/(π m_mn). Source: ISO 10300-1:2014, annex A, of the whole face."""
    return float(member.face_width * np.sin(member.spiral_angle) / (np.pi * member.mean_normal_module))
