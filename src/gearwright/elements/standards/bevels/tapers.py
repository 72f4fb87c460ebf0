"""Dedendum angles from the taper of the depth along the face."""

from __future__ import annotations

import numpy as np

from ....errors import ParameterError, Problem
from ....parameters import rounded_up
from .design import BevelDesign
from .proportions import DepthTaper

_STEEPEST_TILT = 1.3  # of the standard taper, so that the inner ends do not grow too shallow


def dedendum_angles(
    design: BevelDesign, taper: DepthTaper, addenda: tuple[float, float], dedenda: tuple[float, float]
) -> tuple[float, float]:
    """θ_f1, θ_f2 from the heights at the mean point. Raises ParameterError.

    standard    tan θ_f = h_fm/R_m
    uniform     0
    otherwise   the sum of both angles is shared as the mates' addenda are: θ_f1 = Σθ_f h_am2/(h_am1 + h_am2)
    Source: ISO 23509, sum of dedendum angles and its shares.
    """
    straight = [float(np.arctan2(dedendum, design.mean_cone_distance)) for dedendum in dedenda]
    if taper == "uniform":
        return 0.0, 0.0
    if taper == "standard":
        return straight[0], straight[1]
    whole = duplex_sum(design)
    if taper == "tilted":
        whole = min(whole, _STEEPEST_TILT * sum(straight))
    working = sum(addenda)
    return whole * addenda[1] / working, whole * addenda[0] / working


def duplex_sum(design: BevelDesign) -> float:
    """Σθ_f = π m_et/(2 R_e tan α_n cos β_m) · (1 − R_m sin β_m/r_c0), radians. Raises ParameterError.

    So much the depths must fall along the face that both members' slots keep their width at the root: there
    d(p_n)/dR = 2 tan α_n Σθ_f, and the normal pitch p_n of circular tooth traces changes by
    2π/(z_p cos β_m) · (1 − R_m sin β_m/r_c0), z_p the teeth of the crown gear. Source: ISO 23509, duplex taper.
    """
    slope = np.pi * design.module / (2.0 * design.cone_distance * np.tan(design.pressure_angle))
    if design.spiral_angle == 0.0 and design.cutter_radius is None:
        return float(slope)
    along = design.mean_cone_distance * np.sin(design.spiral_angle)
    if design.cutter_radius is None or design.cutter_radius < along:
        given = "not given" if design.cutter_radius is None else f"= {design.cutter_radius:.6g}"
        raise ParameterError(
            "duplex or tilted taper",
            [
                Problem(
                    f"cutter_radius {given}",
                    f"at least R_m sin β_m, {rounded_up(along)}, for slots of one width; with less, teeth would grow "
                    'deeper inwards: take taper "standard" or "uniform"',
                )
            ],
        )
    return float(slope / np.cos(design.spiral_angle) * (1.0 - along / design.cutter_radius))
