"""Why two members do not run together, with the limits that could be kept."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...curves.involute import inverse_involute_function
from ...parameters import rounded_down, rounded_up
from .. import refusals
from .mesh import GearMesh, Mesh
from .tip_paths import cut_depths
from .tooth_checks import Found

_ROUNDING = 1e-9  # modules by which teeth of no backlash may seem to jam
_TOUCHING = 1e-5  # modules by which a tip on the flank may seem to cut: the radii of basic racks are rounded to that

_DIGITS = 6  # of distances that people follow
_EXACT = 1e-12  # of a distance: what is nearer to a round number is that number


def check_mesh(mesh: Mesh, unit: str) -> list[Found]:
    """What is wrong with a pair; the first kind of trouble only."""
    return list(_fit(mesh, unit)) or list(_clearances(mesh, unit)) or list(_cuts(mesh, unit))


def _fit(mesh: Mesh, unit: str) -> Iterator[Found]:
    module = mesh.pinion.toothing.module
    if mesh.backlash < -_ROUNDING * module:
        yield "centre_distance", refusals.jammed(-mesh.backlash, _free_distance(mesh), unit)
    elif mesh.contact_ratio <= 0.0:
        yield "centre_distance", refusals.out_of_reach(mesh.centre_distance, mesh.reference_distance, unit)


def _free_distance(mesh: Mesh) -> str:
    """The distance at which there is no backlash, with the side on which there is some; "" where there is none."""
    if not isinstance(mesh, GearMesh):
        over = mesh.centre_distance - mesh.backlash / 2.0 / np.tan(mesh.working_pressure_angle)
        return f"at least {_least(over)}"
    one, other = mesh.pinion.toothing, mesh.gear.toothing
    sign = other.outward
    filled = one.teeth * one.half_at_base + sign * other.teeth * other.half_at_base - (np.pi if sign > 0 else 0.0)
    target = filled / (one.teeth + sign * other.teeth)
    if target <= 0.0:
        return ""
    bases = other.base_radius + sign * one.base_radius
    distance = float(bases / np.cos(float(inverse_involute_function(target))))
    if sign > 0:
        return f"at least {_least(distance)}"
    return f"at most {rounded_down(distance * (1.0 + _EXACT), _DIGITS)}"


def _least(distance: float) -> str:
    return rounded_up(distance * (1.0 - _EXACT), _DIGITS)


def _clearances(mesh: Mesh, unit: str) -> Iterator[Found]:
    for clearance, (tips, roots) in zip(mesh.clearances, _SIDES, strict=True):
        if clearance <= 0.0:
            yield "addendum", refusals.no_clearance(tips, roots, abs(clearance), unit)


_SIDES = (("pinion", "gear"), ("gear", "pinion"))


def _cuts(mesh: Mesh, unit: str) -> Iterator[Found]:
    into_pinion, into_gear = cut_depths(mesh)
    for depth, (tips, teeth) in zip((into_gear, into_pinion), _SIDES, strict=True):
        if depth > _TOUCHING * mesh.pinion.toothing.module:
            internal = isinstance(mesh, GearMesh) and mesh.gear.toothing.internal
            yield "teeth", refusals.cutting_tips(tips, teeth, rounded_down(depth), unit, internal=internal)
