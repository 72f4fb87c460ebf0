"""Derived sizes of a pair on parallel axes, with the symbols of ISO 21771, and what is unusual about it."""

from __future__ import annotations

import numpy as np

from ...parameters import Size
from .. import remarks
from .mesh import GearMesh, Mesh
from .sizes import in_unit

_BOUNDLESS = 1e6  # specific sliding that is rounding away from a base circle, where it has no bounds


def mesh_sizes(mesh: Mesh, overlap: float, shifts: tuple[float, float]) -> dict[str, Size]:
    """Distances, angles, ratios, sliding, backlash and clearances.

    overlap     ε_β of the common face width
    shifts      x₁, x₂
    """
    toothing, apart = mesh.pinion.toothing, mesh.centre_distance - mesh.reference_distance
    lengths = {
        "centre_distance": (mesh.centre_distance, "a_w", "centre distance; from axis to pitch plane over a rack"),
        "reference_centre_distance": (mesh.reference_distance, "a_d", "the same without profile shift"),
        "pinion_working_diameter": (2.0 * mesh.working_radius, "d_w1", "working pitch diameter of the pinion"),
        "path_of_contact": (max(0.0, mesh.path[1] - mesh.path[0]), "g_α", "length of the path of contact"),
        "backlash": (mesh.backlash, "j_wt", "circumferential backlash on the working pitch circles"),
        "normal_backlash": (mesh.normal_backlash, "j_bn", "backlash along the line of action, normal to the flanks"),
        "pinion_tip_clearance": (mesh.clearances[0], "c_1", "from the pinion's tips to the mate's roots"),
        "gear_tip_clearance": (mesh.clearances[1], "c_2", "from the mate's tips to the pinion's roots"),
    }
    ratios = {
        "contact_ratio": (mesh.contact_ratio, "ε_α", "transverse contact ratio"),
        "overlap_ratio": (overlap, "ε_β", "overlap ratio of the common face width"),
        "total_contact_ratio": (mesh.contact_ratio + overlap, "ε_γ", "sum of both"),
        "sum_of_profile_shifts": (sum(shifts), "Σx", "profile shifts of both members in modules"),
        "centre_distance_modification": (apart / toothing.module, "y", "of the centre distance, in modules"),
        **_sliding(mesh),
    }
    if isinstance(mesh, GearMesh):
        ratio = mesh.gear.toothing.teeth / toothing.teeth
        ratios["gear_ratio"] = (ratio, "u", "teeth of the gear over teeth of the pinion")
        diameter = 2.0 * mesh.working_radius * ratio
        lengths["gear_working_diameter"] = (diameter, "d_w2", "working pitch diameter of the gear")
    else:
        travel = 2.0 * np.pi * toothing.pitch_radius
        lengths["travel"] = (travel, "2πr", "way of the rack for one turn of the pinion")
    angles = {"working_pressure_angle": (mesh.working_pressure_angle, "α_wt", "working transverse pressure angle")}
    return {**in_unit(lengths, "length"), **in_unit(angles, "angle"), **in_unit(ratios, "")}


def _sliding(mesh: Mesh) -> dict[str, tuple[float, str, str]]:
    """Specific sliding at the ends of the path; what grows beyond all bounds at the base circle is left out."""
    first, last = mesh.path
    rows = {}
    if first > 0.0:
        root = mesh.specific_sliding(first)[0]
        rows["pinion_specific_sliding"] = (root, "ζ_f1", "specific sliding of the pinion where contact begins")
    if last > first:
        root = mesh.specific_sliding(last)[1]
        rows["gear_specific_sliding"] = (root, "ζ_f2", "specific sliding of the mate where contact ends")
    return {name: row for name, row in rows.items() if abs(row[0]) < _BOUNDLESS}


def mesh_remarks(mesh: Mesh, overlap: float) -> list[str]:
    """What is unusual about the pair, though it runs."""
    found = remarks.low_contact_ratio(mesh.contact_ratio, overlap)
    if mesh.truncated:
        found.append(
            f"the mate's tips pass where the pinion's involute has not begun (d_Ff = "
            f"{2.0 * mesh.pinion.form_radius:.5g}): undercut or fillet shortens the path of contact"
        )
    return found
