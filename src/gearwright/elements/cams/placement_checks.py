"""Whether a follower can stand and move as its dimensions say, whatever the law: problems by parameter."""

from __future__ import annotations

from math import cos, degrees, isnan, radians, sqrt

from . import refusals
from .followers import initial_angle_of
from .kinds import KINDS, Dimensions

Found = list[tuple[str, str]]
"""Names of parameters with what is wrong with them."""


def placement_problems(kind: str, given: Dimensions, amount: float, unit: str) -> Found:
    """For all dimensions of a follower; amount is its swing in degrees, or its lift."""
    return _CHECKS[kind](given, amount, unit)


def _flat_face_that_swings(given: Dimensions, swing: float, unit: str) -> Found:
    initial = given["initial_angle"]
    if not -90.0 < initial < 90.0 - swing:
        return [("initial_angle", refusals.face_beyond(-90.0, 90.0 - swing))]
    follower = KINDS["oscillating-flat-face"].make(given, 1)
    if follower.base_radius > 0.0:
        return []
    least = given["face_offset"] - follower.base_radius
    return [("face_offset", refusals.no_base_circle(follower.base_radius, unit, least))]


def _flat_face_that_goes_straight(given: Dimensions, lift: float, unit: str) -> Found:
    del given, lift, unit
    return []


def _roller_that_goes_straight(given: Dimensions, lift: float, unit: str) -> Found:
    del lift
    reach = given["base_radius"] + given["roller_radius"]
    return [] if abs(given["offset"]) < reach else [("offset", refusals.stem_beyond(reach, unit))]


def _roller_that_swings(given: Dimensions, swing: float, unit: str) -> Found:
    name = "base_radius" if "base_radius" in given else "initial_angle"
    pivot, arm, roller = (given[one] for one in ("pivot_distance", "arm_length", "roller_radius"))
    if name == "base_radius":
        initial = degrees(initial_angle_of(given["base_radius"], roller, pivot, arm))
        if isnan(initial) or not 0.0 < initial < 180.0 - swing:
            farthest = sqrt(pivot**2 + arm**2 + 2.0 * pivot * arm * cos(radians(swing)))  # before the swing
            return [(name, refusals.out_of_reach(abs(pivot - arm) - roller, farthest - roller, unit))]
    else:
        initial = given["initial_angle"]
    if not 0.0 < initial < 180.0 - swing:
        return [(name, refusals.arm_beyond(180.0 - swing))]
    follower = KINDS["oscillating-roller"].make(given, 1)
    if follower.base_radius > 0.0:
        return []
    return [(name, refusals.no_base_circle(follower.base_radius, unit, None))]


_CHECKS = {
    "oscillating-flat-face": _flat_face_that_swings,
    "translating-flat-face": _flat_face_that_goes_straight,
    "translating-roller": _roller_that_goes_straight,
    "oscillating-roller": _roller_that_swings,
}
