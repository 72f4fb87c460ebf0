"""Bevel gears after ISO 23509, with intersecting axes: sized in the middle of the face, then taken to its outer end."""

from __future__ import annotations

from typing import Literal

import numpy as np

from ....errors import ParameterError, Problem
from .depth_data import DepthData, depth_data_of
from .design import BevelDesign
from .proportions import DepthTaper, Pair, Proportions
from .tapers import dedendum_angles

Method = Literal[0, 1, 2, 3]
_CONTINUOUS_ONLY = 2  # method 2 is that of a face hobbing system


def iso_23509(
    design: BevelDesign, *, method: Method = 0, taper: DepthTaper | None = None, depths: DepthData | None = None
) -> Pair:
    """h_am = (k_hap ± x_hm) m_mn, h_fm = (k_hfp ∓ x_hm) m_mn, then h_e = h_m + (b/2) tan θ. Raises ParameterError.

    method   0 for bevel gears; 1, 2 and 3 for hypoid gears as three makers of machines cut them. Without hypoid
             offset all have the same pitch cones, the middle of the face is the calculation point, and they differ
             only in what is taken for `taper` and `depths` where these are not given
    taper    without: "uniform" with method 2 and with a face hobbing cutter, "uniform" for the spiral teeth of
             method 3, "tilted" for the spiral teeth of methods 0 and 1 where a cutter radius is given, else "standard"
    depths   without: usual_depth_data for methods 0 and 1; DepthData() for methods 2 and 3
    θ_a1 = θ_f2 and θ_a2 = θ_f1: tip cones are parallel to the mates' root cones, the clearance is (k_hfp − k_hap) m_mn.
    s_mn = (π/2 ± 2x_hm tan α_n ± 2x_smn) m_mn, and s_e = s_mn R_e/(R_m cos β_m): teeth of one angular thickness.
    Source: ISO 23509:2016, tooth depth (data of types I and II), angles of the blank, mean normal thickness. Which
    defaults belong to a method are suggestions of its annexes and of ANSI/AGMA 2005-D03, not requirements.
    """
    taper = _usual_taper(design, method) if taper is None else taper
    _require_method(design, method, taper)
    if depths is None:
        depths = depth_data_of(method, design)
    module, shift = design.mean_normal_module, depths.profile_shift
    addenda = ((depths.addendum + shift) * module, (depths.addendum - shift) * module)
    dedenda = ((depths.dedendum - shift) * module, (depths.dedendum + shift) * module)
    _require_heights(addenda, dedenda)
    angles = dedendum_angles(design, taper, addenda, dedenda)
    wider = 2.0 * (shift * np.tan(design.pressure_angle) + depths.thickness_modification)
    outwards = design.cone_distance / design.mean_cone_distance / np.cos(design.spiral_angle)
    half = design.face_width / 2.0
    first, second = (
        Proportions(
            addendum=float(addenda[member] + half * np.tan(angles[1 - member])),
            dedendum=float(dedenda[member] + half * np.tan(angles[member])),
            addendum_angle=angles[1 - member],
            dedendum_angle=angles[member],
            thickness=float((np.pi / 2.0 + (1.0, -1.0)[member] * wider) * module * outwards),
        )
        for member in (0, 1)
    )
    return first, second


def _usual_taper(design: BevelDesign, method: Method) -> DepthTaper:
    if method == _CONTINUOUS_ONLY or design.blade_groups is not None:
        return "uniform"
    if design.spiral_angle == 0.0:
        return "standard"
    if method == 3:
        return "uniform"
    return "standard" if design.cutter_radius is None else "tilted"


def _require_method(design: BevelDesign, method: Method, taper: DepthTaper) -> None:
    problems = []
    if method == _CONTINUOUS_ONLY and design.spiral_angle == 0.0:
        problems.append(Problem("method = 2", "face hobbing cuts spiral teeth; straight ones are of method 0, 1 or 3"))
    if taper != "uniform" and (method == _CONTINUOUS_ONLY or design.blade_groups is not None):
        hobbed = "method = 2" if method == _CONTINUOUS_ONLY else f"blade_groups = {design.blade_groups}"
        problems.append(Problem(f'taper = "{taper}"', f'with {hobbed}, face hobbing, only "uniform" can be cut'))
    if problems:
        raise ParameterError("iso_23509", problems)


def _require_heights(addenda: tuple[float, float], dedenda: tuple[float, float]) -> None:
    if min(*addenda, *dedenda) <= 0.0:
        raise ParameterError(
            "iso_23509",
            [Problem("depths", "leave a member without addendum or dedendum; take a profile shift nearer to 0")],
        )
