"""Views of a bevel gear: cut through its axis, with the cones, and from the apex. Source: ISO 2203, ISO 23509."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ...sections.plane import Section
from ...sheets.line_kinds import CENTRE, THIN, VISIBLE
from ...sheets.marks import Stroke, circle, line, polyline
from ...sheets.views import Angle, Slant, Span, View
from ..blanks.pieces import Zone
from ..blanks.pieces import circle as ring
from ..cylindrical.gear_views import body_notes, bore_edges, both_halves, cross, hole_centres
from ..drafting import axis, box, cut, drawn, mirrored, outlines, polygon, united

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from .bevel_gear import BevelGear

Point = tuple[float, float]
_ROUND = 24  # chords of the arc of a spherical end
_LEAST_ANGLE = 15.0  # degrees of the pitch cone: the apex of a more pointed one is too far away to be shown


def bevel_views(gear: BevelGear) -> tuple[View, ...]:
    """The section through the axis, apex to the left, and the view from the apex."""
    return _section(gear), _front(gear)


def _at(gear: BevelGear, polar: float, distance: float) -> Point:
    """(z, ρ) at a polar angle on the end at a distance."""
    rho, z = gear.tooth_ends.point(polar, distance)
    return z, rho


def _end(gear: BevelGear, first: float, last: float, distance: float) -> list[Point]:
    """(z, ρ) along an end from one polar angle to another."""
    count = _ROUND if gear.tooth_ends.kind == "spherical" else 1
    return [_at(gear, polar, distance) for polar in np.linspace(first, last, count + 1).tolist()]


def _region(gear: BevelGear) -> BaseGeometry:
    """What is cut: everything below the roots."""
    teeth, body = gear.bevel_teeth, gear.body
    inner, outer = gear.inner_distance, gear.cone_distance
    roots = teeth.inner.root_angle, teeth.outer.root_angle
    if body.plain:
        upper = polygon([*_end(gear, roots[0], 0.0, inner), *_end(gear, 0.0, roots[1], outer)])
        return united([upper, mirrored(upper)])
    ring = body.ring_angle
    parts = [polygon([*_end(gear, roots[0], ring, inner), *_end(gear, ring, roots[1], outer)]), _rim(gear)]
    parts += [box(zone.low, zone.inner, zone.high, zone.outer) for zone in _zones(gear)]
    return both_halves(united(parts), gear.blank)


def _zones(gear: BevelGear) -> tuple[Zone, ...]:
    return () if gear.ends == "spherical" else gear.body.zones


def _rim(gear: BevelGear) -> BaseGeometry:
    """The part of the body between the ring under the teeth and its cylinders."""
    body = gear.body
    bore = 0.0 if gear.blank.bore is None else gear.blank.bore / 2.0
    inner, outer, ring = gear.inner_distance, gear.cone_distance, body.ring_angle
    if gear.ends == "spherical":
        angles = [float(np.arcsin(bore / r)) for r in (inner, outer)]
        return polygon([*_end(gear, angles[0], ring, inner), *_end(gear, ring, angles[1], outer)])
    front, back = body.front_edge, body.back_edge
    radius = body.zones[0].inner
    corners = [_at(gear, ring, inner), _at(gear, ring, outer), back[::-1], (back[1], radius), (front[1], radius)]
    return polygon([*corners, front[::-1]])


def _section(gear: BevelGear) -> View:
    region = _region(gear)
    strokes, hatches = cut(region)
    low, _, high, _ = region.bounds
    teeth, inner, outer = gear.bevel_teeth, gear.inner_distance, gear.cone_distance
    tips, roots = (teeth.inner.face_angle, teeth.outer.face_angle), (teeth.inner.root_angle, teeth.outer.root_angle)
    shape = [*_end(gear, roots[0], tips[0], inner), *_end(gear, tips[1], roots[1], outer)]
    below = [(z, -rho) for z, rho in shape]
    apex = bool(np.degrees(gear.pitch_cone_angle) >= _LEAST_ANGLE)
    zones = _zones(gear)
    ends = zones or (Zone(outer=0.0, inner=0.0, low=low, high=high),)
    return View(
        title="Section through the axis",
        strokes=(
            *strokes,
            polyline(shape, VISIBLE),
            polyline(below, VISIBLE),
            *_cones(gear, apex=apex),
            *bore_edges(ends, gear.blank),
            axis(0.0 if apex else low, high),
        ),
        hatches=hatches,
        dimensions=tuple(_dimensions(gear, apex=apex, back=high)),
    )


def _cones(gear: BevelGear, *, apex: bool) -> list[Stroke]:
    """Pitch cones from the apex, or along the face alone; lines of tips and roots on to where they meet the axis."""
    gamma, inner, outer = gear.pitch_cone_angle, gear.inner_distance, gear.cone_distance
    way = np.array([np.cos(gamma), np.sin(gamma)])
    start = 0.0 if apex else inner - 0.1 * gear.face_width
    found = []
    for sense in (1.0, -1.0):
        turned = way * np.array([1.0, sense])
        found.append(line(start * turned, (outer + 0.1 * gear.face_width) * turned, CENTRE))
    if apex:
        teeth = gear.bevel_teeth
        for name, polar in (("face_apex", teeth.inner.face_angle), ("root_apex", teeth.inner.root_angle)):
            found.append(line((_cone_apex(gear, name), 0.0), _at(gear, polar, inner), THIN))
    return found


def _cone_apex(gear: BevelGear, name: str) -> float:
    """z of the apex of the tip or the root cone."""
    return -gear.sizes()[name].value


def _dimensions(gear: BevelGear, *, apex: bool, back: float) -> list[Span | Slant | Angle]:
    sizes = {name: size.value for name, size in gear.sizes().items()}
    gamma, inner, outer = gear.pitch_cone_angle, gear.inner_distance, gear.cone_distance
    teeth, blank = gear.bevel_teeth, gear.blank
    z, rho = _at(gear, teeth.outer.face_angle, outer)
    pitch = [(s * float(np.cos(gamma)), -s * float(np.sin(gamma))) for s in (inner, outer)]
    widest = sizes["outside_diameter"] / 2.0
    found: list[Span | Slant | Angle] = [
        Span(start=(z, -widest), end=(z, widest), side="right", prefix="Ø"),
        Slant(start=pitch[0], end=pitch[1], clear=gear.proportions.addendum),
    ]
    if "mounting_distance" in sizes:
        mount = gear.body.back
        foot = -max(zone.outer for zone in _zones(gear) if zone.high >= mount * (1.0 - 1e-9))
        found.append(Span(start=(z, rho), end=(mount, -foot), side="above"))
        if apex:
            found.append(Span(start=(0.0, 0.0), end=(mount, -foot), side="above"))
    if apex:
        found.append(Span(start=(0.0, 0.0), end=(z, rho), side="above"))
        found.append(Slant(start=(0.0, 0.0), end=pitch[1], clear=gear.proportions.addendum, row=1))
        found += _angles(gear)
    if blank.bore is not None:
        found.append(Span(start=(back, -blank.bore / 2.0), end=(back, blank.bore / 2.0), side="right", prefix="Ø"))
    if blank.keyed_bore is not None:
        keyed = blank.keyed_bore
        found.append(Span(start=(back, -keyed.radius), end=(back, keyed.radius + keyed.depth), side="right"))
    if blank.hub_diameter is not None and _zones(gear):
        found.append(
            Span(
                start=(back, -blank.hub_diameter / 2.0), end=(back, blank.hub_diameter / 2.0), side="right", prefix="Ø"
            )
        )
    if blank.has_web and blank.rim_diameter is not None:
        at = gear.body.web_levels[1]
        found.append(
            Span(start=(at, -blank.rim_diameter / 2.0), end=(at, blank.rim_diameter / 2.0), side="right", prefix="Ø")
        )
    return found


def _angles(gear: BevelGear) -> list[Angle]:
    """Angles of the pitch, the tip and the root cone at the apex of each; the largest one on the smallest arc."""
    sizes, inner = gear.sizes(), gear.inner_distance
    reach = _at(gear, gear.bevel_teeth.inner.face_angle, inner)
    nearest = float(np.hypot(*reach)) if gear.ends == "spherical" else min(gear.body.front, float(np.hypot(*reach)))
    found = []
    for name, apex, part in (
        ("pitch_angle", None, 0.80),
        ("face_angle", "face_apex", 0.66),
        ("root_angle", "root_apex", 0.94),
    ):
        z = 0.0 if apex is None else _cone_apex(gear, apex)
        found.append(Angle(vertex=(z, 0.0), first=0.0, last=sizes[name].value, radius=part * nearest - z))
    return found


def _front(gear: BevelGear) -> View:
    teeth, blank, zones = gear.bevel_teeth, gear.blank, _zones(gear)
    outer = _at(gear, teeth.outer.face_angle, gear.cone_distance)[1]
    inner = _at(gear, teeth.inner.face_angle, gear.inner_distance)[1]
    roots = (
        _at(gear, teeth.outer.root_angle, gear.cone_distance)[1],
        _at(gear, teeth.inner.root_angle, gear.inner_distance)[1],
    )
    loops = blank.holes()
    holes = outlines(Section(loops=(ring(outer, 1), *loops)), np.pi / 2.0)[1:] if loops else ()
    steps = [gear.body.front_edge[0]] if zones else []
    steps += [a.inner for a, b in pairwise(zones) if a.low != b.low]
    return View(
        title="Seen from the apex",
        strokes=(
            circle(outer, VISIBLE),
            circle(inner, VISIBLE),
            *(circle(radius, THIN) for radius in roots),
            *(circle(radius, VISIBLE) for radius in steps),
            circle(gear.pitch_radius, CENTRE),
            *drawn(holes),
            *hole_centres(blank),
            *cross(outer),
        ),
        dimensions=tuple(body_notes(blank)),
    )
