"""Sizes of a bevel gear, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...parameters import Size
from ..cylindrical.sizes import in_unit
from ..standards.bevels.blank_sizes import blank_sizes
from ..standards.bevels.tooth_sizes import tooth_sizes
from .spiral import spiral_of

if TYPE_CHECKING:
    from .bevel_gear import BevelGear


def bevel_sizes(gear: BevelGear) -> dict[str, Size]:
    """What sizing systems list, and what the gear's own shape makes of its tips, roots, ends and body."""
    return {
        **blank_sizes(gear.member),
        **tooth_sizes(gear.member),
        **in_unit(_own_lengths(gear), "length"),
        **in_unit(_own_angles(gear), "angle"),
        **gear.blank.sizes(),
    }


def outer_tip_thickness(gear: BevelGear) -> float:
    """s_ae, circular, at the tip of the outer end."""
    tooth, ends = gear.bevel_teeth.outer, gear.tooth_ends
    return 2.0 * tooth.tip_half * ends.point(tooth.face_angle, ends.outer)[0]


def _own_lengths(gear: BevelGear) -> dict[str, tuple[float, str, str]]:
    ends, teeth = gear.tooth_ends, gear.bevel_teeth
    outer, inner, crown = (
        ends.point(polar, at)
        for polar, at in (
            (teeth.outer.face_angle, ends.outer),
            (teeth.inner.face_angle, ends.inner),
            (teeth.outer.root_angle, ends.outer),
        )
    )
    widest = (
        outer[0] if teeth.outer.face_angle <= np.pi / 2.0 else max(outer[0], ends.point(np.pi / 2.0, ends.outer)[0])
    )
    rows = {
        "outside_diameter": (2.0 * widest, "d_ae", "largest diameter of the body"),
        "root_diameter": (2.0 * crown[0], "d_fe", "outer root diameter"),
        "inner_tip_diameter": (2.0 * inner[0], "d_ai", "tip diameter at the inner end"),
        "crown_to_apex": (outer[1], "X", "along the axis from the apex to the outer tips"),
        "axial_face_width": (outer[1] - inner[1], "X_b", "along the axis from the inner to the outer tips"),
        "circular_thickness": (gear.outer_thickness, "s_e", "outer circular thickness, backlash taken off"),
        "tip_thickness": (outer_tip_thickness(gear), "s_ae", "outer circular thickness at the tip"),
    }
    if not gear.body.plain and gear.ends != "spherical":
        back = gear.body.back
        rows["mounting_distance"] = (back, "A", "from the apex to the mounting face")
        rows["crown_to_back"] = (back - outer[1], "A − X", "along the axis from the outer tips to the mounting face")
    if gear.root == "fillet":
        radius = gear.generating_tip_radius
        rows["crown_tip_radius"] = (radius, "ρ", "outer radius at the tips of the generating crown gear")
    return rows


def _own_angles(gear: BevelGear) -> dict[str, tuple[float, str, str]]:
    return {
        "base_angle": (gear.tooth.base_cone_angle, "δ_b", "half-angle of the involute's base cone"),
        "transverse_pressure_angle": (gear.transverse_pressure_angle, "α_t", "transverse pressure angle"),
        "normal_pressure_angle": (gear.normal_pressure_angle, "α_n", "pressure angle in the normal section, mid-face"),
        **spiral_of(gear).sizes(),
    }
