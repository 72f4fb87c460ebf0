"""Heights and thicknesses of a bevel gear's teeth, and those of the virtual cylindrical gear that stands for them."""

from __future__ import annotations

import numpy as np

from ....curves.involute import involute_function
from ....parameters import Size
from ...cylindrical.sizes import in_unit
from .member import BevelMember

_NEARLY_A_RACK = 1e-8  # of cos δ: nearer to a rack the involute's formula loses more digits than a straight flank does


def tooth_sizes(member: BevelMember) -> dict[str, Size]:
    """Heights, thicknesses, chordal sizes and numbers of virtual teeth, by name.

    z_v = z/cos δ and z_vn = z/(cos δ cos³β_m) are left out of crown gears, whose virtual gear is a rack.
    Source: ISO 23509; Tredgold's approximation for virtual teeth and tip thickness.
    """
    half, normal = member.face_width / 2.0, np.cos(member.spiral_angle)
    shape, thickness = member.proportions, member.proportions.thickness
    chord, above = outer_chordal(member)
    mean_chord, mean_above = mean_chordal(member)
    lengths = {
        "addendum": (shape.addendum, "h_ae", "outer addendum"),
        "dedendum": (shape.dedendum, "h_fe", "outer dedendum"),
        "tooth_depth": (shape.depth, "h_e", "outer whole depth"),
        "mean_addendum": (member.addendum(half), "h_am", "addendum at mid-face"),
        "mean_dedendum": (member.dedendum(half), "h_fm", "dedendum at mid-face"),
        "circular_thickness": (thickness, "s_e", "outer transverse circular thickness"),
        "mean_thickness": (thickness * member.mean_ratio, "s_mt", "transverse circular thickness at mid-face"),
        "mean_normal_thickness": (member.mean_normal_thickness, "s_mn", "normal circular thickness at mid-face"),
        "chordal_thickness": (chord, "s̄_e", "chord of the outer transverse circular thickness"),
        "chordal_height": (above, "h̄_ae", "height of the outer tip above that chord, along the back cone"),
        "mean_chordal_thickness": (mean_chord, "s̄_mn", "chord of the normal circular thickness at mid-face"),
        "mean_chordal_height": (mean_above, "h̄_am", "height of the tip above that chord"),
        "tip_thickness": (tip_thickness(member), "s_ae", "outer transverse thickness at the tip, of the virtual gear"),
        "mean_normal_module": (member.mean_normal_module, "m_mn", "normal module at mid-face"),
    }
    angles = {"transverse_pressure_angle": (member.transverse_pressure_angle, "α_t", "transverse, at mid-face")}
    sizes = {**in_unit(lengths, "length"), **in_unit(angles, "angle")}
    if member.back_curvature < _NEARLY_A_RACK:
        return sizes
    virtual = member.teeth / member.back_curvature
    teeth = {
        "virtual_teeth": (virtual, "z_v", "teeth of the virtual spur gear"),
        "normal_virtual_teeth": (virtual / normal**3, "z_vn", "its teeth in the normal section"),
    }
    return {**sizes, **in_unit(teeth, "")}


def outer_chordal(member: BevelMember) -> tuple[float, float]:
    """Thickness s̄ = d_e sin(s_e/d_e), height h̄ = h_ae + cos δ d_e/2 (1 − cos(s_e/d_e)): transverse, outer end.

    Both ends of the chord are on the pitch circle; the tip's height stands on the pitch cone, which is what cos δ is
    for. KHK has the first terms, s − s³/(6d²) and h_a + s² cos δ/(4d). Source: KHK, Gear Technical Reference, chordal
    thickness of bevel gears.
    """
    return _chordal(member, member.pitch_diameter, member.proportions.thickness, member.proportions.addendum)


def mean_chordal(member: BevelMember) -> tuple[float, float]:
    """The same in the normal section at mid-face, where the pitch circle has the diameter of curvature d_m/cos²β_m."""
    diameter = float(member.pitch_diameter * member.mean_ratio / np.cos(member.spiral_angle) ** 2)
    return _chordal(member, diameter, member.mean_normal_thickness, member.addendum(member.face_width / 2.0))


def _chordal(member: BevelMember, diameter: float, thickness: float, addendum: float) -> tuple[float, float]:
    angle = thickness / diameter
    rise = diameter * np.sin(angle / 2.0) ** 2
    return float(diameter * np.sin(angle)), float(addendum + member.back_curvature * rise)


def tip_thickness(member: BevelMember) -> float:
    """s_ae = d_va (s_e/d_v + inv α_t − inv α_at), d_v = d_e/cos δ, d_va = d_v + 2h_ae, cos α_at = d_v cos α_t/d_va.

    Of a crown gear, whose flanks are straight, s_e − 2h_ae tan α_t. Negative where the flanks meet below the tip.
    """
    shape, angle = member.proportions, member.transverse_pressure_angle
    if member.back_curvature < _NEARLY_A_RACK:
        return float(shape.thickness - 2.0 * shape.addendum * np.tan(angle))
    diameter = member.pitch_diameter / member.back_curvature
    growth = 1.0 + 2.0 * shape.addendum / diameter
    at_tip = np.arccos(np.cos(angle) / growth)
    inner = float(involute_function(angle)) - float(involute_function(at_tip))
    return float(growth * (shape.thickness + diameter * inner))
