"""Sizes of a bevel gear's blank: its cones, where their apexes are, and where its corners are."""

from __future__ import annotations

import numpy as np

from ....parameters import Size
from ...cylindrical.sizes import in_unit
from .member import BevelMember

_ROUNDING = 1e-12  # of the cone distance


def blank_sizes(member: BevelMember) -> dict[str, Size]:
    """Angles of the cones, diameters and axial sizes, by name. Source: KHK, Gear Technical Reference; ISO 23509."""
    shape = member.proportions
    angles = {
        "pitch_angle": (member.pitch_angle, "δ", "half-angle of the pitch cone"),
        "face_angle": (member.face_angle, "δ_a", "half-angle of the tip cone"),
        "root_angle": (member.root_angle, "δ_f", "half-angle of the root cone"),
        "addendum_angle": (shape.addendum_angle, "θ_a", "from pitch to tip cone"),
        "dedendum_angle": (shape.dedendum_angle, "θ_f", "from root to pitch cone"),
    }
    return {**in_unit(angles, "angle"), **in_unit({**_cone_rows(member), **_corner_rows(member)}, "length")}


def _cone_rows(member: BevelMember) -> dict[str, tuple[float, str, str]]:
    return {
        "cone_distance": (member.cone_distance, "R_e", "outer cone distance"),
        "mean_cone_distance": (member.mean_cone_distance, "R_m", "mean cone distance"),
        "inner_cone_distance": (member.cone_distance - member.face_width, "R_i", "inner cone distance"),
        "face_apex": (face_apex(member), "t_zF", "from the pitch apex to the tip cone's, away from the gear"),
        "root_apex": (root_apex(member), "t_zR", "from the pitch apex to the root cone's, away from the gear"),
    }


def _corner_rows(member: BevelMember) -> dict[str, tuple[float, str, str]]:
    outer, inner = tip(member, 0.0), tip(member, member.face_width)
    root = member.pitch_diameter - 2.0 * member.proportions.dedendum * member.back_curvature
    return {
        "pitch_diameter": (member.pitch_diameter, "d_e", "outer pitch diameter"),
        "mean_pitch_diameter": (member.pitch_diameter * member.mean_ratio, "d_m", "pitch diameter at mid-face"),
        "outside_diameter": (2.0 * outer[0], "d_ae", "tip diameter at the outer end"),
        "root_diameter": (root, "d_fe", "root diameter at the outer end"),
        "inner_tip_diameter": (2.0 * inner[0], "d_ai", "tip diameter at the inner end"),
        "crown_to_apex": (outer[1], "X", "along the axis from the pitch apex to the outer tips"),
        "axial_face_width": (outer[1] - inner[1], "X_b", "along the axis from the inner to the outer tips"),
    }


def tip(member: BevelMember, inwards: float) -> tuple[float, float]:
    """Distances from the axis, and along it from the pitch apex, of the tips so far inwards along the pitch cone.

    (R sin δ + h_a cos δ, R cos δ − h_a sin δ), so that d_ae = d_e + 2h_ae cos δ, X = R_e cos δ − h_ae sin δ and
    X_b = b cos δ_a/cos θ_a.
    """
    along, up = member.cone_distance - inwards, member.addendum(inwards)
    sine, cosine = np.sin(member.pitch_angle), member.back_curvature
    return float(along * sine + up * cosine), float(along * cosine - up * sine)


def face_apex(member: BevelMember) -> float:
    """t_zF = (h_ae cos θ_a − R_e sin θ_a)/sin δ_a, from the pitch apex along the axis, positive away from the gear."""
    shape = member.proportions
    beside = shape.addendum * np.cos(shape.addendum_angle) - member.cone_distance * np.sin(shape.addendum_angle)
    return _settled(float(beside / np.sin(member.face_angle)), member)


def root_apex(member: BevelMember) -> float:
    """t_zR = (R_e sin θ_f − h_fe cos θ_f)/sin δ_f, from the pitch apex along the axis, positive away from the gear."""
    shape = member.proportions
    beside = member.cone_distance * np.sin(shape.dedendum_angle) - shape.dedendum * np.cos(shape.dedendum_angle)
    return _settled(float(beside / np.sin(member.root_angle)), member)


def _settled(offset: float, member: BevelMember) -> float:
    """An apex's distance, or 0 where only rounding keeps it from the pitch apex."""
    return 0.0 if abs(offset) <= _ROUNDING * member.cone_distance else offset
