"""Why parameters that have no gear are refused, in words that several elements share."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..parameters import rounded_down

ONE_PITCH = "give one of module (mm) and diametral_pitch (per inch)"
LOGARITHMIC_WITHOUT_ANGLE = 'a logarithmic trace needs one, such as 35; teeth without one are trace "straight"'
STRAIGHT_WITH_ANGLE = 'a straight trace has none; choose trace "logarithmic", or leave it out'

NO_PROFILE = "it has no plane section, which is what is drawn; `picture` shows it, and `save` writes its polyhedron"


def pointed_tooth(limit: float, unit: str) -> str:
    """The addendum at which the flanks meet is exceeded."""
    return (
        f"the tooth comes to a point before its tip; less than {rounded_down(limit)} {unit} "
        "(a smaller pressure angle or a thicker tooth allows more)"
    )


def meeting_teeth(limit: float, unit: str) -> str:
    """The thickness at which neighbouring flanks meet is exceeded."""
    if limit <= 0.0:
        return "neighbouring teeth meet above the root, however thin; take a smaller pressure angle or dedendum"
    return f"neighbouring teeth meet above the root; less than {rounded_down(limit)} {unit}, usually half the pitch"


def no_tooth_left(limit: float, unit: str) -> str:
    """Backlash takes the whole tooth."""
    return f"leaves no tooth; less than {rounded_down(limit)} {unit}"


def bore_in_roots(diameter: str, limit: float, unit: str) -> str:
    """The bore reaches the root diameter."""
    return f"cuts into the tooth roots; less than the {diameter}, {rounded_down(limit)} {unit}"


def no_involute(what: str) -> str:
    """The involute would begin above the pitch line."""
    return f"leaves no involute below the pitch {what}; a larger one does"


def nearly_cylindrical(angle: float) -> str:
    """A pitch angle (radians) too small for a cone."""
    return f"makes a pitch cone of {np.degrees(angle):.2g}°, less than 0.01°: a spur gear, and to be built as one"


def internal_bevel(angle: float) -> str:
    """A pitch angle (radians) beyond 90°."""
    return (
        f"makes a pitch cone of {np.degrees(angle):.4g}°, an internal bevel gear, which no cutter makes; "
        "take a smaller shaft angle, or teeth numbers closer to each other"
    )


TRANSFORM_WITH_TWIST = "takes the place of twist, scale and skew; leave those out, or write them into it"

TWIST_ALONG = "at most 18000° along a path, 50 turns, can be computed; sweep the path in parts"


def one_way(given: Sequence[str]) -> str:
    """For a sweep that is moved in none or several of its ways."""
    ways = "length (straight along z), path (along a curve in space) or angle (about the section's y axis)"
    if not given:
        return f"how the section moves is not said; give one of {ways}"
    return f"not together with {' and '.join(given[1:])}; give only one of {ways}"


def not_of_this_way(way: str, owners: Sequence[str]) -> str:
    """For what does not apply to a sweep moved in this way."""
    return f"does not apply to a sweep with {way}, but to one with {' or '.join(owners)}; leave it out"


NO_DRAWING = "applies to a section from a drawing; this one is given by a table"
