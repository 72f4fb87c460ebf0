"""Why tooth traces of bevel gears are refused."""

from __future__ import annotations

from collections.abc import Sequence

from ...parameters import rounded_down, rounded_up
from .spiral import Spiral

STRAIGHT_WITH_ANGLE = (
    'a straight trace has none; choose another trace, such as "circular" or "logarithmic", or leave it out'
)

NO_BLADES = "is needed with an epicycloid trace: how many groups of blades the cutter has, such as 5"


def needs_angle(trace: str) -> str:
    """For a trace that is no spiral without an angle."""
    return f'trace "{trace}" needs one, such as 35; teeth without one are trace "straight", or "circular" (zerol)'


def no_cutter(usual: tuple[float, float] | None, unit: str) -> str:
    """For a trace that a cutter cuts, without its radius; what is usual, if that is known."""
    here = "" if usual is None else f", here {rounded_up(usual[0])} to {rounded_down(usual[1])} {unit}"
    return f"is needed with this trace; about 1.1 to 1.4 × the mean cone distance is usual{here}"


def out_of_reach(spiral: Spiral, steepest: float, remedies: Sequence[str], unit: str) -> str:
    """For a trace that ends, or becomes too steep, within the body; with what would do."""
    curve = {
        "skew": "straight lines at this distance from the apex do",
        "circular": "an arc of this cutter does",
        "involute": "an involute of this base circle, r_m cos β_m, does",
        "epicycloid": "an epicycloid of this cutter does",
    }[spiral.trace]
    inner, outer = spiral.ends
    face = f"over the face, {inner:.4g} to {outer:.4g} {unit} from the apex, at spiral angles of up to {steepest:.0f}°"
    own = (
        f"a cutter_radius of about {spiral.mean_distance:.3g} {unit}"
        if spiral.cutter_radius
        else "a spiral_angle of 35°"
    )
    ways = f"{' or '.join(remedies)} does" if remedies else f"take a narrower face and {own}"
    return f"{curve} not run {face}; {ways}"
