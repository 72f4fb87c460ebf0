"""Why parameters that have no cam are refused."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...parameters import rounded_down, rounded_up
from .profile import Extreme

WITH_MINIMISE = 'applies to a synthesis; ask for one with minimise "area", or leave it out'
VALUES_WITHOUT_SPLINE = 'applies to law "spline"; choose that, or leave it out'
FREE_WITHOUT_SPLINE = 'applies to law "spline"; choose that, or leave it out: another law has no free values'
VALUES_WITH_MINIMISE = "the synthesis finds them; leave them out, or leave out minimise"
SPLINE_WITHOUT_VALUES = 'its values are needed: a design file or Python gives them, or let minimise "area" find them'
NOTHING_FREE = 'nothing is left to choose: leave out some of the dimensions, or take law "spline"'
CROSSING = "undercut: the profile crosses itself, the roller would cut away what it has rolled on"


def at(angle: float) -> str:
    """Where, in words, for a cam angle in radians."""
    return f"at cam angle {np.degrees(angle) % 360.0:.4g}°"


def not_of_this_follower(follower: str, owners: Sequence[str]) -> str:
    """For a parameter of other followers."""
    return f"does not apply to the follower {follower}, but to {' and '.join(owners)}; leave it out"


def needed_for(follower: str, meaning: str, free: bool) -> str:
    """For a dimension that is not given."""
    way_out = '; or let minimise "area" choose it' if free else ""
    return f"is needed for the follower {follower}: {meaning}{way_out}"


def one_of(name: str, other: str) -> str:
    """For two parameters of which one follows from the other."""
    return f"{other} follows from it; give only one of {name} and {other}"


def wrong_count(count: int, moves: int) -> str:
    """For control values that cannot be shared among the moves."""
    return f"{count} cannot be shared by {moves} moves; give as many for each of them, move after move"


def falling_values(move: int, value: float) -> str:
    """For control values that would lead the follower back within a move."""
    return f"in move {move}, {value:g} breaks the order: values ascend from 0 to 1, else the follower turns back"


def no_base_circle(radius: float, unit: str, least: float | None) -> str:
    """For a base circle without a radius; least is what the dimension must exceed."""
    way_out = "" if least is None else f"; it must be greater than {least:.4g} {unit}"
    return (
        f"the base circle would have a radius of {radius:.4g} {unit}, and the cam's axis lie outside the disk{way_out}"
    )


def face_beyond(least: float, most: float) -> str:
    """For a face that would turn to or past a right angle."""
    return (
        "the face would turn past the perpendicular to the line of pivot and axis, where nothing moves it; "
        f"greater than {least:g}° and less than {most:g}° is possible with this swing"
    )


def arm_beyond(most: float) -> str:
    """For an arm that would turn past the line of pivot and axis."""
    return f"the arm would pass the line of pivot and axis; greater than 0° and less than {most:g}° is possible"


def out_of_reach(least: float, most: float, unit: str) -> str:
    """For a base circle that the roller of an arm cannot touch."""
    return (
        f"the roller's arm cannot reach this base circle; greater than {rounded_up(max(least, 0.0))} and at most "
        f"{rounded_down(most)} {unit} is possible with this arm, pivot distance and swing"
    )


def stem_beyond(most: float, unit: str) -> str:
    """For a stem that does not meet the pitch circle."""
    return f"the stem passes outside the roller's circle; less than {rounded_down(most)} {unit} either way is possible"


def face_too_slow(turning: Extreme, peak: float, change: float) -> str:
    """For a move in which a face would turn as fast as the cam, or faster; peak of s′ for a law, change in degrees."""
    return (
        f"{at(turning.angle)} the face would turn faster than the cam, which no cam can make it; "
        f"this law needs more than {rounded_up(peak * abs(change))}° of the cam for a move of {abs(change):.4g}°, "
        "or a follower that turns in the other sense"
    )


def undercut(radius: float, angle: float, least: float | None, unit: str, name: str) -> str:
    """For a profile with a cusp; least is what the named dimension must exceed, None if nothing was found."""
    way_out = (
        "slower moves, a smoother law or less lift are needed"
        if least is None
        else f"{name} greater than {rounded_up(least) if least > 0.0 else f'{least:.4g}'} {unit} would do, "
        "or slower moves, or another law"
    )
    return (
        f"undercut: {at(angle)} the profile has a cusp, its radius of curvature is {radius:.4g} {unit}; it must be "
        f"greater than 0; {way_out}"
    )


def no_cam(missed: str, shortfall: float, unit: str, law: str) -> str:
    """For a synthesis that found no cam; the shortfall is in radians for a pressure angle, else a length."""
    amount = f"{np.degrees(shortfall):.3g}°" if missed == "pressure angle" else f"{shortfall:.3g} {unit}"
    return (
        f'no cam with law "{law}" was found that keeps all limits; the nearest one misses the {missed} limit by '
        f"{amount}. Slower moves, looser limits, fewer given dimensions or more free values may do"
    )


def bore_too_wide(limit: float, unit: str) -> str:
    """For a bore that reaches the base circle."""
    return f"reaches the profile; less than the base circle's diameter, {rounded_down(limit)} {unit}"
