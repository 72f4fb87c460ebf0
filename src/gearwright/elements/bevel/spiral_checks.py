"""What the parameters of a bevel gear's tooth trace must be, with the limits where they are not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...parameters import Problems, rounded_down, rounded_up
from . import spiral_refusals as refusals
from .spiral import HOBBED, MILLED, STEEPEST, Spiral

if TYPE_CHECKING:
    from .bevel_gear import BevelGear
    from .bevel_pair import BevelPair

_UNUSED_AT_0 = ("skew", "logarithmic", "involute")  # without a spiral angle these are straight, or nothing
_CLOSE = 1e-9  # relative: where bisection for a limit ends


def require_reach(problems: Problems, spiral: Spiral, unit: str) -> None:
    """Adds a problem where a cutter's radius is missing, or the trace does not reach over the face; with the limits.

    To be called once cone and face width are sound.
    """
    names = ("trace", "spiral_angle", "cutter_radius", "blade_groups", "face_width")
    if not problems.sound(*names) or (spiral.trace in _UNUSED_AT_0 and not spiral.spiral_angle):
        return
    if spiral.trace in MILLED and spiral.cutter_radius is None:
        usual = (1.1 * spiral.mean_distance, 1.4 * spiral.mean_distance)
        problems.add("cutter_radius", refusals.no_cutter(usual, unit))
    elif spiral.trace in HOBBED and spiral.blade_groups is None:
        problems.add("blade_groups", refusals.NO_BLADES)
    elif not spiral.fits:
        own = "cutter_radius" if spiral.trace in MILLED else "spiral_angle"
        remedies = [*_remedies(spiral, own, unit), *_remedies(spiral, "face_width", unit)]
        problems.add(own, refusals.out_of_reach(spiral, np.degrees(STEEPEST), remedies, unit))


def require_spiral(problems: Problems, element: BevelGear | BevelPair) -> None:
    """Adds a problem where a trace lacks what it needs, or is straight and has a spiral angle.

    To be called last: what is known of the cutter's radius by then is said with figures.
    """
    trace = element.trace
    if trace == "straight" and element.spiral_angle and problems.sound("spiral_angle"):
        problems.add("spiral_angle", refusals.STRAIGHT_WITH_ANGLE)
    if trace in _UNUSED_AT_0 and element.spiral_angle == 0 and problems.sound("spiral_angle"):
        problems.add("spiral_angle", refusals.needs_angle(trace))
    if trace in MILLED and element.cutter_radius is None and problems.sound("cutter_radius"):
        problems.add("cutter_radius", refusals.no_cutter(None, ""))
    if trace in HOBBED and element.blade_groups is None and problems.sound("blade_groups"):
        problems.add("blade_groups", refusals.NO_BLADES)


def _remedies(spiral: Spiral, name: str, unit: str) -> list[str]:
    """The nearest value of a parameter with which the trace fits, in words; none where none is found."""
    given = float(getattr(spiral, name))

    def fits(value: float) -> bool:
        return _with(spiral, name, value).fits

    found = next((value for value in _tried(name, given) if fits(value)), None)
    if found is None:
        return []
    limit = _bisected(fits, given, found)
    side, words = ("at least", rounded_up(limit)) if limit > given else ("at most", rounded_down(limit))
    # where only a narrow range fits, the rounded limit may be beyond it
    return [f"{name} {side} {words}{'°' if name == 'spiral_angle' else f' {unit}'}"] if fits(float(words)) else []


def _with(spiral: Spiral, name: str, value: float) -> Spiral:
    if name == "cutter_radius":
        return replace(spiral, cutter_radius=value)
    return replace(spiral, spiral_angle=value) if name == "spiral_angle" else replace(spiral, face_width=value)


def _tried(name: str, given: float) -> list[float]:
    """Values of a parameter in the order in which they are tried, nearest first."""
    if name == "cutter_radius":
        return [given * 2.0 ** (way * k / 8.0) for k in range(1, 161) for way in (1.0, -1.0)]
    if name == "spiral_angle":
        return sorted((0.25 * k for k in range(1, 301)), key=lambda angle: abs(angle - given))
    return [given * 0.95**k for k in range(1, 200)]


def _bisected(fits: Callable[[float], bool], refused: float, accepted: float) -> float:
    """The accepted value next to the refused ones."""
    while abs(accepted - refused) > _CLOSE * abs(accepted):
        middle = (accepted + refused) / 2.0
        refused, accepted = (refused, middle) if fits(middle) else (middle, accepted)
    return accepted
