"""Which sizes of bore, keyway, hub and web allow a body, and in which words others are refused."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...parameters import MILLIMETRES, rounded_down, rounded_up
from .. import refusals
from ..standards.din_6885 import LEAST_BORE, MOST_BORE
from .blank import Blank

Found = Iterator[tuple[str, str]]

_STANDARD = "din-6885"
_LEAST_HOLE = 1e-9  # of the diameter around it: a smaller one would lose half of its digits


def blank_problems(blank: Blank, root_diameter: float, face_width: float) -> list[tuple[str, str]]:
    """Names of parameters and what is wrong with them: first those that lack others, then the sizes of the rest."""
    return [
        *lacking(blank),
        *keyway_problems(blank),
        *_walls(blank, root_diameter),
        *_levels(blank, face_width),
        *hole_problems(blank, root_diameter),
    ]


def lacking(blank: Blank) -> Found:
    """What was given without something it needs, or with something that it does not go with."""
    own = [name for name in ("keyway_width", "keyway_depth") if getattr(blank, name) is not None]
    if blank.bore is None:
        asked = [*(["keyway"] if blank.keyway == _STANDARD else []), *own]
        yield from ((name, "a keyway needs a bore; give its diameter, bore") for name in asked)
    if blank.keyway is not None:
        words = "has the standard's size" if blank.keyway == _STANDARD else "is left out"
        yield from ((name, f'does not go with keyway "{blank.keyway}", which {words}; give only one') for name in own)
    elif len(own) == 1:
        other = "keyway_depth" if own == ["keyway_width"] else "keyway_width"
        yield own[0], f"goes with {other}; give both for a keyway of that size"
    if blank.hub_diameter is None:
        of_hub = [("hub_length", blank.hub_length is not None), ("hub_offset", blank.hub_offset != 0.0)]
        yield from ((name, "a hub needs its diameter; give hub_diameter") for name, given in of_hub if given)
    if blank.rim_diameter is not None and blank.web_thickness is None:
        yield "rim_diameter", "the rim is bounded by a web; give its web_thickness"
    if blank.web_thickness is not None and blank.rim_diameter is None:
        yield "web_thickness", "a web reaches out to a rim; give its inner diameter, rim_diameter"
    yield from _lacking_for_holes(blank)


def _lacking_for_holes(blank: Blank) -> Found:
    names = ("web_holes", "web_hole_diameter", "web_hole_circle")
    given = [name for name in names if getattr(blank, name) is not None]
    if given and blank.rim_diameter is None and blank.web_thickness is None:
        yield from ((name, "holes need a web; give rim_diameter and web_thickness") for name in given)
        return
    missing = [name for name in names[:2] if name not in given]
    if given and missing:
        yield given[0], f"goes with {' and '.join(missing)}; holes have a number and a diameter"


def keyway_problems(blank: Blank) -> Found:
    """A keyway that the standard does not have, or that is wider than the bore."""
    if blank.bore is None:
        return
    if blank.keyway == _STANDARD and blank.keyed_bore is None:
        least, most = (bore / MILLIMETRES[blank.length_unit] for bore in (LEAST_BORE, MOST_BORE))
        unit = blank.length_unit
        range_of_bores = f"over {rounded_up(least)} and up to {rounded_down(most)} {unit}"
        yield "keyway", f"DIN 6885 has keys for bores {range_of_bores}; give keyway_width and keyway_depth instead"
    elif blank.keyway is None and blank.keyway_width is not None and blank.keyway_width >= blank.bore:
        yield "keyway_width", f"wider than the bore; less than {rounded_down(blank.bore)} {blank.length_unit}"


def _walls(blank: Blank, root_diameter: float) -> Found:
    """Each cylinder must leave a wall inside the next larger one: bore, hub, rim, roots."""
    unit, core = blank.length_unit, 2.0 * blank.core_radius
    if blank.bore is not None and blank.bore >= root_diameter:
        yield "bore", refusals.bore_in_roots("root diameter", root_diameter, unit)
    elif blank.bore is not None and blank.bore < _LEAST_HOLE * root_diameter:
        yield "bore", refusals.lost_hole(_LEAST_HOLE * root_diameter, unit)
    elif core >= root_diameter:
        yield name_of_keyway(blank), refusals.keyway_in_roots(core, root_diameter, unit)
    if blank.hub_diameter is not None:
        if blank.hub_diameter <= core:
            yield "hub_diameter", refusals.no_wall("bore" if blank.keyed_bore is None else "keyway", core, unit)
        elif blank.hub_diameter >= root_diameter:
            yield "hub_diameter", refusals.in_roots("hub", root_diameter, unit)
    if blank.rim_diameter is not None:
        if blank.rim_diameter >= root_diameter:
            yield "rim_diameter", refusals.in_roots("rim's inside", root_diameter, unit)
        elif blank.hub_diameter is not None and blank.rim_diameter <= blank.hub_diameter:
            yield "rim_diameter", refusals.no_web("hub_diameter", blank.hub_diameter, unit)
        elif blank.rim_diameter <= core:
            yield "rim_diameter", refusals.no_web("the circle around the bore", core, unit)


def name_of_keyway(blank: Blank) -> str:
    """The parameter that gives the keyway its depth."""
    return "keyway" if blank.keyway == _STANDARD else "keyway_depth"


def _levels(blank: Blank, face_width: float) -> Found:
    """The web must lie within the face width, and the hub reach through it."""
    unit = blank.length_unit
    if blank.has_web and blank.web_thickness is not None and blank.web_thickness > face_width:
        yield (
            "web_thickness",
            f"thicker than the teeth are long; at most the face width, {rounded_down(face_width)} {unit}",
        )
        return
    if blank.hub_diameter is None:
        return
    (low, high), (start, end) = blank.web_levels(face_width), blank.hub_levels(face_width)
    what = "web" if blank.has_web else "body"
    if start > low:
        yield "hub_offset", f"the hub would begin inside the {what}; at least {_least(-low)} {unit}"
    if end < high:
        needed = f"the hub would end inside the {what}; at least {rounded_up(high + blank.hub_offset)} {unit}"
        given = blank.hub_length is not None
        yield ("hub_length", needed) if given else ("hub_offset", f"{needed} of hub_length is needed for it")


def _least(value: float) -> str:
    """A least value that may be negative, never below it."""
    return f"-{rounded_down(-value)}" if value < 0.0 else rounded_up(value)


def hole_problems(blank: Blank, root_diameter: float) -> Found:
    """Holes must leave walls to the rim, to the hub or bore, and to each other."""
    holes, unit = blank.hole_circle, blank.length_unit
    if holes is None or blank.rim_diameter is None or blank.web_thickness is None:
        return
    inner = 2.0 * blank.core_radius if blank.hub_diameter is None else blank.hub_diameter
    outer = blank.rim_diameter
    if not inner < outer < root_diameter:
        return  # refused already
    within = "hub" if blank.hub_diameter is not None else "bore" if blank.bore is not None else "axis"
    circle = 2.0 * holes.circle
    if not inner < circle < outer:
        least, most = (f"{rounded_up(inner)} {unit} ({within})", f"{rounded_down(outer)} {unit} (rim)")
        yield "web_hole_circle", f"its holes lie outside the web; more than {least} and less than {most}"
        return
    limits = {"rim": outer - circle, within: circle - inner}
    if holes.count > 1:
        limits["next hole"] = circle * float(np.sin(np.pi / holes.count))
    nearest = min(limits, key=lambda name: limits[name])
    if 2.0 * holes.radius < _LEAST_HOLE * circle:
        yield "web_hole_diameter", refusals.lost_hole(_LEAST_HOLE * circle, unit)
    elif 2.0 * holes.radius >= limits[nearest]:
        limit = f"{rounded_down(limits[nearest])} {unit} for {holes.count} on a circle of {circle:.4g} {unit}"
        yield "web_hole_diameter", f"the holes would run into the {nearest}; less than {limit}"
