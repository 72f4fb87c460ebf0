"""Whether a profile is one: no cusp, no face faster than the cam, no crossing; else the limit that would do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...errors import GeometryError
from ...sections.plane import Section
from . import refusals
from .followers import FlatFace
from .kinds import KINDS, SENSES, Dimensions
from .placement_checks import Found, placement_problems
from .profile import Profile
from .programme import Displacement

_FARTHEST = 1e4  # × the present base radius: where the search for one that would do ends
_TRIALS = 60


def profile_problems(
    kind: str, given: Dimensions, sense: str, displacement: Displacement, amount: float, unit: str
) -> Found:
    """What keeps the follower, led so, from having a cam."""
    profile = profile_of(kind, given, sense, displacement)
    if isinstance(profile.follower, FlatFace) and profile.least_turning.value <= 0.0:
        return [("programme", _too_fast(profile))]
    if profile.slowest.value <= 0.0:
        return [_cusp(kind, given, sense, profile, amount, unit)]
    if not isinstance(profile.follower, FlatFace):
        try:
            Section(loops=(profile.loop,)).require_simple()
        except GeometryError:
            return [("roller_radius", refusals.CROSSING)]
    return []


def profile_of(kind: str, given: Dimensions, sense: str, displacement: Displacement) -> Profile:
    """The profile of a follower with these dimensions."""
    return Profile(follower=KINDS[kind].make(given, SENSES[sense]), displacement=displacement)


def _too_fast(profile: Profile) -> str:
    slowest = profile.least_turning
    move = next(m for m in profile.displacement.moves if m.start <= slowest.angle <= m.end)
    width = move.end - move.start
    peak = abs(float(move.derivatives(slowest.angle)[1]) * width / move.change)
    return refusals.face_too_slow(slowest, peak, float(np.degrees(move.change)))


def _cusp(
    kind: str, given: Dimensions, sense: str, profile: Profile, amount: float, unit: str
) -> tuple[str, str]:  # fmt: skip
    """The parameter that a cusp is blamed on, and the least value of it that has none."""
    if isinstance(profile.follower, FlatFace):
        name = "face_offset" if KINDS[kind].swings else "base_radius"
        worst = profile.lowest(lambda contact: contact.speed / contact.turning)
        least = given[name] - worst.value  # the radius of curvature grows as the face moves outwards
        return name, refusals.undercut(worst.value, worst.angle, least, unit, name)
    worst = profile.slowest
    contact = profile.contact(worst.angle)
    radius = float(contact.speed / contact.turning)

    def built(base_radius: float) -> Profile | None:
        trial = {**{k: v for k, v in given.items() if k != "initial_angle"}, "base_radius": base_radius}
        sound = not placement_problems(kind, trial, amount, unit)
        return profile_of(kind, trial, sense, profile.displacement) if sound else None

    enough = _least_base_radius(profile.follower.base_radius, built)
    name = "base_radius" if "base_radius" in given else "initial_angle"
    return name, refusals.undercut(-abs(radius), worst.angle, enough, unit, "a base_radius")


def _least_base_radius(present: float, built: Callable[[float], Profile | None]) -> float | None:
    """The least base radius above the present one without a cusp, to 1e-4; None where none was found."""

    def good(radius: float) -> bool:
        profile = built(radius)
        return profile is not None and profile.slowest.value > 0.0

    radii = np.geomspace(present, _FARTHEST * present, 4 * _TRIALS)[1:]
    if built(2.0 * present) is not None or built(radii[0]) is not None:
        above = next((i for i, radius in enumerate(radii[:_TRIALS]) if good(radius)), None)
        if above is None:
            return None
        low, high = float(radii[above - 1]) if above else present, float(radii[above])
        while high - low > 1e-5 * high:
            middle = (low + high) / 2.0
            low, high = (low, middle) if good(middle) else (middle, high)
        return float(high)
    return None
