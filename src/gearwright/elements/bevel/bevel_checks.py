"""What is wrong with the parameters of a bevel gear, in the order in which it can be told."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...parameters import Problems, declarations, rounded_down
from .. import refusals
from .body_checks import body_problems
from .pitch_cone import require_cone
from .sizing import giving_depths, require_standard
from .spiral import spiral_of
from .spiral_checks import require_reach
from .tooth_checks import tooth_problems

if TYPE_CHECKING:
    from .bevel_gear import BevelGear

_OF_THE_CONE = ("teeth", "module", "diametral_pitch", "mate_teeth", "shaft_angle", "pitch_angle", "length_unit")
_OF_THE_SIZES = (
    *("standard", "taper", "iso_method", "profile_shift", "thickness_modification", "mate_teeth"),
    *("addendum", "dedendum", "addendum_angle", "dedendum_angle", "pressure_angle", "circular_thickness"),
)
_LEAST_INNER = 1e-6  # of the cone distance: nearer to the apex there is only rounding
_NO_SUCH_TEETH = (
    "teeth of these depths have no form all along this face: their tips or roots leave the ends, or the flanks, on the"
    ' way; a narrower face, depths nearer to the usual ones, or ends = "conical" has such teeth'
)
_FLATTEST_PITCH = np.radians(87.0)
_FLATTEST = np.radians(89.0)  # polar angle beyond which a plane across the axis runs along the teeth


def check_cone(problems: Problems, gear: BevelGear) -> None:
    """The pitch cone must be given once, and be a cone."""
    if (gear.pitch_angle is None) == (gear.mate_teeth is None):
        problems.add("pitch_angle", "give either the pitch angle, or mate_teeth (and a shaft angle if it is not 90°)")
    elif gear.pitch_angle is not None and gear.shaft_angle is not None:
        problems.add("shaft_angle", "goes with mate_teeth; a pitch angle alone settles the cone")
    elif problems.computable(*_OF_THE_CONE) and problems.sound("module"):
        require_cone(problems, gear.pitch_cone_angle)


def check_given(problems: Problems, gear: BevelGear) -> None:
    """What goes together with what."""
    if gear.standard != "explicit" and gear.mate_teeth is None and problems.sound("standard"):
        problems.add("standard", "sizes a gear for its mate; give mate_teeth (and a shaft angle if it is not 90°)")
    require_standard(problems, gear.standard, gear.spiral_angle, gear.taper)
    if gear.normal_backlash is not None and gear.backlash:
        problems.add("backlash", refusals.said_twice(["normal_backlash"]))
    if problems.sound("tip_relief") and not gear.tip_relief and gear.tip_relief_height is not None:
        problems.add("tip_relief_height", "goes with tip_relief; give that, too, or leave this out")
    if gear.taper is not None:
        for name in ("addendum_angle", "dedendum_angle"):
            if getattr(gear, name) is not None:
                problems.add(name, refusals.said_twice(["taper"]))


def check_face(problems: Problems, gear: BevelGear) -> bool:
    """Whether the teeth can be sized: the face must end before the apex, and a trace that sizes them run along it."""
    if not (
        problems.computable(*_OF_THE_CONE, "face_width") and problems.sound("module", "pitch_angle", "shaft_angle")
    ):
        return False
    if gear.inner_distance <= _LEAST_INNER * gear.cone_distance:
        problems.add("face_width", refusals.wide_face(gear.cone_distance, gear.length_unit))
        return False
    names = [one.name for one in declarations(type(gear))]
    if not problems.computable(*names):
        return False
    if gear.standard != "explicit" or gear.normal_backlash is not None:  # sized by the trace; else `check_reach` does
        require_reach(problems, spiral_of(gear), gear.length_unit)
    of_the_trace = ("trace", "spiral_angle", "cutter_radius", "blade_groups", "face_width")
    return problems.sound(*_OF_THE_SIZES, *of_the_trace)


def check_shape(problems: Problems, gear: BevelGear) -> None:
    """Teeth, body and the reach of the trace; sizes at which a formula has no value are refused as a whole."""
    if gear.ends == "flat" and gear.pitch_cone_angle >= _FLATTEST_PITCH:
        angle = np.degrees(gear.pitch_cone_angle)
        problems.add(
            "ends", f"planes across the axis run along the teeth of a pitch cone of {angle:.4g}°; choose conical"
        )
        return
    try:
        with np.errstate(invalid="ignore", divide="ignore"):
            check_teeth(problems, gear)
            check_body(problems, gear)
            check_reach(problems, gear)
    except (ValueError, ZeroDivisionError):
        problems.add("face_width", _NO_SUCH_TEETH)


def check_teeth(problems: Problems, gear: BevelGear) -> None:
    """The teeth between their tips and roots."""
    unit, teeth = gear.length_unit, gear.bevel_teeth
    if min(gear.proportions.addendum, gear.proportions.dedendum) <= 0.0:
        problems.add("profile_shift", "leaves no addendum or no dedendum; take one nearer to 0")
        return
    if teeth.least_root_angle <= 0.0:
        # the axis is met at the outer end by cones about the apex, at the inner end by flatter ones
        sloping = gear.face_width * np.tan(gear.proportions.dedendum_angle)
        flatter = gear.inner_distance * np.tan(gear.pitch_cone_angle) + sloping
        limit = flatter if teeth.roots.offset else gear.cone_distance * np.tan(gear.pitch_cone_angle)
        _add(problems, gear, "dedendum", f"the root cone would pass the axis; less than {rounded_down(limit)} {unit}")
        return
    for name, message in tooth_problems(teeth, gear.proportions.thickness, unit):
        _add(problems, gear, name, message)


def _add(problems: Problems, gear: BevelGear, name: str, message: str) -> None:
    """Adds a problem of a tooth's size to the parameter that gives it; where that is another size, it says so."""
    given = _given_as(name, gear)
    if given != name and name in ("addendum", "dedendum"):
        size = getattr(gear.proportions, name)
        message = f"it makes {name} = {size:.4g} {gear.length_unit}: {message}"
    problems.add(given, message)


def _given_as(name: str, gear: BevelGear) -> str:
    """The parameter by which a size of the tooth was given."""
    if name in ("addendum", "dedendum") and gear.standard != "explicit":
        return giving_depths(gear)
    if name == "backlash" and gear.normal_backlash is not None:
        return "normal_backlash"
    return name


def check_body(problems: Problems, gear: BevelGear) -> None:
    """The body inside the teeth."""
    if gear.bevel_teeth.least_root_angle <= 0.0:
        return
    ends = gear.tooth_ends
    faces = [tooth.face_angle for tooth in gear.bevel_teeth.looked_at.values()]
    if ends.kind == "flat" and max(faces) >= _FLATTEST:
        problems.add(
            "ends", f"planes across the axis do not end a face cone of {np.degrees(max(faces)):.4g}°; choose conical"
        )
        return
    for name, message in body_problems(gear.body, gear.length_unit):
        problems.add(name, message)


def check_reach(problems: Problems, gear: BevelGear) -> None:
    """Whether the trace reaches as far as a sound body does, beyond the pitch line's ends too."""
    stretch = _stretch(gear) if problems.sound() and not gear.body.plain else (1.0, 1.0)
    require_reach(problems, spiral_of(gear, stretch), gear.length_unit)


def _stretch(gear: BevelGear) -> tuple[float, float]:
    """How far the toothed ring goes beyond inner and outer cone distance, as factors of them."""
    ends = gear.tooth_ends
    faces = [tooth.face_angle for tooth in gear.bevel_teeth.looked_at.values()]
    polars = (gear.body.ring_angle, gear.pitch_cone_angle, *faces)
    inner = min(ends.distance(polar, ends.inner) for polar in polars) / ends.inner
    outer = max(ends.distance(polar, ends.outer) for polar in polars) / ends.outer
    return inner, outer
