"""Which sizes allow a body that carries bevel teeth, and in which words others are refused."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...parameters import rounded_down, rounded_up
from .. import refusals
from ..blanks.limits import hole_problems, keyway_problems, lacking, name_of_keyway
from .body import BevelBody

Found = Iterator[tuple[str, str]]

_LEAST_BORE = 1e-5  # of the root diameter: around a smaller one end faces would need millions of triangles
_CLOSE = 1e-9  # of the mounting distance: as near as levels that were meant to be one
_BESIDE_THE_BORE = (
    "keyway",
    "keyway_width",
    "keyway_depth",
    "hub_diameter",
    "hub_length",
    "rim_diameter",
    "web_thickness",
    "web_holes",
    "web_hole_diameter",
    "web_hole_circle",
)


def body_problems(body: BevelBody, unit: str) -> list[tuple[str, str]]:
    """Names of parameters and what is wrong with them."""
    if body.ends.kind == "spherical":
        given = [name for name in _BESIDE_THE_BORE if getattr(body.blank, name) not in (None, "none")]
        given += ["mounting_distance"] if body.mounting_distance is not None else []
        bodies = [(name, 'needs plane faces; choose ends = "conical" or "flat", or leave it out') for name in given]
        return [*bodies, *_core(body, unit)]
    found = [*lacking(body.blank), *keyway_problems(body.blank), *_core(body, unit)]
    if found:
        return found
    found = [*_mounting(body, unit), *_hub(body, unit)]
    return found or [*_web(body, unit), *hole_problems(body.blank, 2.0 * body.room)]


def _core(body: BevelBody, unit: str) -> Found:
    """Bore and keyway must stay inside the roots at the small end."""
    blank = body.blank
    limit = 2.0 * body.ends.point(body.root_angle, body.ends.inner)[0]
    if blank.bore is not None and blank.bore >= limit:
        yield "bore", refusals.bore_in_roots("root diameter at the small end", limit, unit)
    elif blank.bore is not None and blank.bore < _LEAST_BORE * limit:
        yield "bore", refusals.lost_hole(_LEAST_BORE * limit, unit)
    elif 2.0 * blank.core_radius >= limit:
        yield name_of_keyway(blank), refusals.keyway_in_roots(2.0 * blank.core_radius, limit, unit)


def _mounting(body: BevelBody, unit: str) -> Found:
    """The mounting face must lie on the body."""
    given = body.mounting_distance
    if given is None:
        return
    ends, roots = body.ends, body.ends.point(body.root_angle, body.ends.outer)
    if body.blank.hub_diameter is not None:
        own = body.back_edge[1]
        if given < own * (1.0 - _CLOSE):
            yield "mounting_distance", f"the hub would end inside the body; at least {rounded_up(own)} {unit}"
        return
    if ends.kind == "flat":
        if abs(given - roots[1]) > _CLOSE * roots[1]:
            yield (
                "mounting_distance",
                f'flat ends have their back at {roots[1]:.6g} {unit}; give a hub_diameter, or choose ends = "conical"',
            )
        return
    least = max(roots[1], body.front)
    cosine, sine = np.cos(ends.pitch_angle), np.sin(ends.pitch_angle)
    most = (ends.outer - body.blank.core_radius * sine) / max(cosine, 1e-9)
    if given <= least:
        yield "mounting_distance", f"the back face would cut the teeth; more than {rounded_up(least)} {unit}"
    elif given >= most:
        inside = "bore" if body.blank.bore is not None else "axis"
        limit = f"less than {rounded_down(most)} {unit}, or give a hub_diameter for what stands out"
        yield "mounting_distance", f"beyond where the back cone meets the {inside}; {limit}"


def _hub(body: BevelBody, unit: str) -> Found:
    """The hub must have a wall around the bore, stand on the back face, and reach back into the body."""
    blank, core = body.blank, 2.0 * body.blank.core_radius
    if blank.hub_diameter is None:
        return
    if blank.hub_diameter <= core:
        yield "hub_diameter", refusals.no_wall("bore" if blank.keyed_bore is None else "keyway", core, unit)
    elif blank.hub_diameter >= 2.0 * body.back_edge[0]:
        limit = rounded_down(2.0 * body.back_edge[0])
        yield "hub_diameter", f"wider than the back face that it stands on; less than {limit} {unit}"
    elif blank.hub_length is not None:
        yield from _hub_length(body, blank.hub_length, unit)


def _hub_length(body: BevelBody, length: float, unit: str) -> Found:
    low, high = body.web_levels
    wide = body.hub_is_wide
    reached = high if wide else low
    if body.mounting_distance is None and body.back < high * (1.0 - _CLOSE):
        yield (
            "hub_length",
            f"the hub would end inside the body; at least {rounded_up(length + high - body.back)} {unit}",
        )
    elif body.hub_start > reached + _CLOSE * abs(body.back):
        most = rounded_down(reached + length)
        what = "web" if body.blank.has_web else "body"
        given = "mounting_distance" if body.mounting_distance is not None else "hub_length"
        least = rounded_up(body.back - reached)
        ways = f"a mounting_distance of at most {most} {unit}, or a hub_length of at least {least} {unit}, joins them"
        yield given, f"beyond the hub: {length:.6g} {unit} long, it would begin behind the {what}; {ways}"
    elif wide and body.hub_start < body.front - _CLOSE * abs(body.back):
        limit = rounded_down(body.back - body.front)
        yield "hub_length", f"a hub wider than the front face cannot stand out of it; at most {limit} {unit}"


def _web(body: BevelBody, unit: str) -> Found:
    blank = body.blank
    if blank.rim_diameter is None or blank.web_thickness is None:
        return
    core, room = 2.0 * blank.core_radius, 2.0 * body.room
    if blank.rim_diameter >= room:
        yield (
            "rim_diameter",
            f"leaves no rim inside the front and the back cone; less than {rounded_down(room)} {unit}",
        )
    elif blank.hub_diameter is not None and blank.rim_diameter <= blank.hub_diameter:
        yield "rim_diameter", refusals.no_web("hub_diameter", blank.hub_diameter, unit)
    elif blank.rim_diameter <= core:
        yield "rim_diameter", refusals.no_web("the circle around the bore", core, unit)
    height = body.back_edge[1] - body.front
    if blank.web_thickness > height * (1.0 + _CLOSE):
        yield "web_thickness", f"thicker than the body between its faces; at most {rounded_down(height)} {unit}"
