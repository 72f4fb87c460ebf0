"""Views of a cylindrical gear: cut through its axis, and along it. Source: ISO 2203 (how gears are shown)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ...sections.drawings.contours import Contour
from ...sections.drawings.primitives import Primitive, Round
from ...sheets.line_kinds import CENTRE, THIN, VISIBLE
from ...sheets.marks import Stroke, arc, circle, line, polyline
from ...sheets.numbers import length
from ...sheets.views import Leader, Span, View
from ..blanks.blank import Blank
from ..blanks.pieces import Zone
from ..drafting import axis, box, cut, drawn, mirrored, outlines, united

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from .cylindrical_gear import CylindricalGear
    from .external_gear import ExternalGear
    from .internal_gear import InternalGear

_UP = np.pi / 2.0
_FEW = 8  # teeth, up to which all are drawn
_SAME = 1e-9


def external_views(gear: ExternalGear) -> tuple[View, ...]:
    """The section through axis and keyway, and the view along the axis with a few teeth."""
    return _external_section(gear), _external_front(gear), tooth_detail(gear, outlines(gear.profile, _UP)[0])


def _external_section(gear: ExternalGear) -> View:
    root, tip, pitch, b = gear.root_radius, gear.tip_radius, gear.pitch_radius, gear.face_width
    zones = gear.blank.zones(root, b)
    strokes, hatches = cut(body_region(zones, gear.blank))
    low, high = min(zone.low for zone in zones), max(zone.high for zone in zones)
    teeth = [polyline([(0.0, s * root), (0.0, s * tip), (b, s * tip), (b, s * root)], VISIBLE) for s in (1.0, -1.0)]
    pitches = [axis(0.0, b, at=s * pitch) for s in (1.0, -1.0)]
    dimensions = [
        Span(start=(b, -tip), end=(b, tip), side="right", prefix="Ø"),
        Span(start=(0.0, tip), end=(b, tip), side="above"),
        *body_dimensions(zones, gear.blank),
    ]
    if low < 0.0:
        dimensions.append(Span(start=(low, -zones[-1].outer), end=(0.0, -tip), side="below"))
    return View(
        title="Section through the axis",
        strokes=(*strokes, *teeth, *pitches, *bore_edges(zones, gear.blank), axis(low, high)),
        hatches=hatches,
        dimensions=tuple(dimensions),
    )


def body_region(zones: Sequence[Zone], blank: Blank) -> BaseGeometry:
    """What is cut of a body of revolution, (z, ρ): holes of the web on both sides, the keyway above."""
    return both_halves(united([box(zone.low, zone.inner, zone.high, zone.outer) for zone in zones]), blank)


def both_halves(upper: BaseGeometry, blank: Blank) -> BaseGeometry:
    """A half-section without holes and keyway (z, ρ), and its mirror image, with them."""
    low, high = upper.bounds[0], upper.bounds[2]
    if blank.hole_circle is not None and blank.has_web:
        upper = upper.difference(box(low, blank.hole_circle.innermost, high, blank.hole_circle.outermost))
    lower = mirrored(upper)
    if blank.keyed_bore is not None:
        upper = upper.difference(box(low, 0.0, high, blank.keyed_bore.radius + blank.keyed_bore.depth))
    return united([upper, lower])


def bore_edges(zones: Sequence[Zone], blank: Blank) -> list[Stroke]:
    """Edges that are seen behind the cut: of steps, of holes, the ends of the bore, the sides of the keyway."""
    inner = zones[-1]
    steps = _step_edges(zones) + _hole_edges(zones, blank)
    if blank.bore is None:
        return steps
    r, keyed = blank.bore / 2.0, blank.keyed_bore
    top = r if keyed is None else keyed.radius + keyed.depth
    edges = [*steps, *(line((z, -r), (z, top), VISIBLE) for z in (inner.low, inner.high))]
    if keyed is not None:
        side = float(np.sqrt(r**2 - (keyed.width / 2.0) ** 2))
        edges.append(line((inner.low, side), (inner.high, side), VISIBLE))
    return edges


def _step_edges(zones: Sequence[Zone]) -> list[Stroke]:
    """Edges of rings that stand out beyond what is inside them."""
    found = []
    for k, zone in enumerate(zones[:-1]):
        within = zones[k + 1 :]
        for z, stands_out in ((zone.low, zone.low < within[0].low), (zone.high, zone.high > within[0].high)):
            if stands_out:
                ahead = next((one.outer for one in within if one.low <= z <= one.high), 0.0)
                found += [line((z, s * ahead), (z, s * zone.inner), VISIBLE) for s in (1.0, -1.0)]
    return found


def _hole_edges(zones: Sequence[Zone], blank: Blank) -> list[Stroke]:
    """Edges of the web's holes."""
    holes = blank.hole_circle
    if holes is None or not blank.has_web:
        return []
    web = next(zone for zone in zones if zone.inner <= holes.innermost)
    ends = [(z, s) for z in (web.low, web.high) for s in (1.0, -1.0)]
    middle = [axis(web.low, web.high, at=s * holes.circle) for s in (1.0, -1.0)]
    return [*(line((z, s * holes.innermost), (z, s * holes.outermost), VISIBLE) for z, s in ends), *middle]


def body_dimensions(zones: Sequence[Zone], blank: Blank) -> list[Span]:
    """Bore and keyway, hub, rim, web and the circle of its holes, and the whole length."""
    inner, found = zones[-1], []
    low, high = min(zone.low for zone in zones), max(zone.high for zone in zones)

    def diameter(at: float, radius: float) -> Span:
        return Span(start=(at, -radius), end=(at, radius), side="left", prefix="Ø")

    if blank.bore is not None:
        found.append(diameter(inner.low, blank.bore / 2.0))
    if blank.keyed_bore is not None:
        keyed = blank.keyed_bore
        found.append(Span(start=(inner.low, -keyed.radius), end=(inner.low, keyed.radius + keyed.depth), side="left"))
    if blank.hub_diameter is not None and len(zones) > 1:  # as wide as the teeth, it does not show
        found.append(diameter(inner.low, blank.hub_diameter / 2.0))
    if blank.has_web and blank.rim_diameter is not None:
        found.append(diameter(zones[0].low, blank.rim_diameter / 2.0))
        web = next(zone for zone in zones if zone.outer == blank.rim_diameter / 2.0)
        middle = -(web.inner + web.outer) / 2.0
        found.append(Span(start=(web.low, middle), end=(web.high, middle), side="below"))
        if blank.hole_circle is not None:
            found.append(diameter(web.low, blank.hole_circle.circle))
    teeth = zones[0]
    if (inner.low, inner.high) != (teeth.low, teeth.high) and blank.hub_diameter is not None:
        found.append(Span(start=(inner.low, -inner.outer), end=(inner.high, -inner.outer), side="below"))
    if (low, high) != (inner.low, inner.high) and (low, high) != (teeth.low, teeth.high):
        found.append(Span(start=(low, -inner.outer), end=(high, -inner.outer), side="below"))
    return found


def _external_front(gear: ExternalGear) -> View:
    chains = outlines(gear.profile, _UP)
    teeth = shown_teeth(chains[0], gear.teeth, gear.tip_radius, gear.root_radius)
    zones = gear.blank.zones(gear.root_radius, gear.face_width)
    steps = [a.inner for a, b in pairwise(zones) if a.low != b.low]
    return View(
        title="Seen from z = 0",
        strokes=(
            *teeth,
            *drawn(chains[1:]),
            *(circle(radius, VISIBLE) for radius in steps),
            circle(gear.pitch_radius, CENTRE),
            *hole_centres(gear.blank),
            *cross(gear.tip_radius),
        ),
        dimensions=tuple(body_notes(gear.blank)),
    )


def hole_centres(blank: Blank) -> list[Stroke]:
    """The circle on which the holes of a web lie."""
    return [circle(blank.hole_circle.circle, CENTRE)] if blank.has_web and blank.hole_circle is not None else []


def body_notes(blank: Blank) -> list[Leader]:
    """What the view along the axis says of keyway and holes."""
    found = []
    if blank.keyed_bore is not None:
        keyed = blank.keyed_bore
        point = (keyed.width / 2.0, keyed.radius + 0.5 * keyed.depth)
        found.append(Leader(point=point, text=f"keyway, {length(keyed.width, blank.length_unit)} wide"))
    if blank.has_web and blank.hole_circle is not None:
        holes = blank.hole_circle
        angle = _UP - 2.0 * np.pi / holes.count * max(1, round(holes.count / 6.0))
        x, y = holes.circle * np.cos(angle) + 0.7 * holes.radius, holes.circle * np.sin(angle) + 0.7 * holes.radius
        found.append(
            Leader(point=(float(x), float(y)), text=f"{holes.count} × Ø{length(2.0 * holes.radius, blank.length_unit)}")
        )
    return found


def cross(radius: float) -> list[Stroke]:
    """Centre lines of a circle."""
    return [axis(-radius, radius), axis(-radius, radius, vertical=True)]


def shown_teeth(chain: Contour, teeth: int, tip: float, root: float) -> list[Stroke]:
    """Three teeth about +y on their true outline; tips elsewhere as a thick circle, roots as a thin one.

    Where there are but a few, all are drawn.
    """
    if teeth <= _FEW:
        return [Stroke(chain=chain, kind=VISIBLE, closed=True)]
    pitch = 2.0 * np.pi / teeth
    kept = []
    for one in chain:
        angle = _aside(one)
        is_tip = isinstance(one, Round) and one.circular and not one.centre.any() and _near(one.major[0], tip)
        if abs(angle) < (1.75 if is_tip else 2.0) * pitch:
            kept.append((angle, one))
    shown = [one for _, one in sorted(kept, key=lambda pair: pair[0])]
    ends = [_angle_from_top(p) for one in shown for p in (one.start, one.end)]
    low, high = min(ends), max(ends)
    return [
        *(Stroke(chain=(one,), kind=VISIBLE) for one in shown),
        arc(tip, _UP + high, _UP + low + 2.0 * np.pi, VISIBLE),
        arc(root, _UP + high, _UP + low + 2.0 * np.pi, THIN),
    ]


def tooth_detail(gear: CylindricalGear, chain: Contour) -> View:
    """One tooth and the spaces beside it, true to shape, with the lines of pitch and roots."""
    pitch = 2.0 * np.pi / gear.teeth
    tip, root, reference = gear.tip_radius, gear.root_radius, gear.pitch_radius
    shown = [one for one in chain if abs(_aside(one)) < 0.75 * pitch]
    reach = max(abs(_angle_from_top(p)) for one in shown for p in (one.start, one.end))
    return View(
        title="Tooth in the transverse section",
        strokes=(
            *(Stroke(chain=(one,), kind=VISIBLE) for one in shown),
            *(arc(radius, _UP - reach, _UP + reach, kind) for radius, kind in ((reference, CENTRE), (root, THIN))),
        ),
        dimensions=(
            Span(start=(0.0, root), end=(0.0, tip), side="left"),
            Span(start=(0.0, reference), end=(0.0, tip), side="right"),
        ),
        detail=True,
    )


def _near(radius: float, other: float) -> bool:
    return abs(radius - other) <= _SAME * other


def _aside(one: Primitive) -> float:
    """Angle (−π to π) of the middle of a primitive from +y, about the origin."""
    return _angle_from_top(one.point(one.first + one.sweep / 2.0) if isinstance(one, Round) else (one.start + one.end))


def _angle_from_top(point: np.ndarray) -> float:
    return float(np.arctan2(-point[0], point[1]))


def internal_views(gear: InternalGear) -> tuple[View, ...]:
    """The section through the axis, and the view along it with a few teeth."""
    root, tip, pitch, b, outer = (
        gear.root_radius,
        gear.tip_radius,
        gear.pitch_radius,
        gear.face_width,
        gear.outer_radius,
    )
    upper = box(0.0, root, b, outer)
    strokes, hatches = cut(united([upper, mirrored(upper)]))
    teeth = [polyline([(0.0, s * root), (0.0, s * tip), (b, s * tip), (b, s * root)], VISIBLE) for s in (1.0, -1.0)]
    ends = [line((z, -tip), (z, tip), VISIBLE) for z in (0.0, b)]
    section = View(
        title="Section through the axis",
        strokes=(*strokes, *teeth, *ends, *(axis(0.0, b, at=s * pitch) for s in (1.0, -1.0)), axis(0.0, b)),
        hatches=hatches,
        dimensions=(
            Span(start=(0.0, outer), end=(b, outer), side="above"),
            Span(start=(0.0, -outer), end=(0.0, outer), side="left", prefix="Ø"),
            Span(start=(b, -tip), end=(b, tip), side="right", prefix="Ø"),
        ),
    )
    chains = outlines(gear.profile, _UP)
    front = View(
        title="Seen from z = 0",
        strokes=(
            *drawn(chains[:1]),
            *shown_teeth(chains[1], gear.teeth, tip, root),
            circle(pitch, CENTRE),
            *cross(outer),
        ),
    )
    return section, front, tooth_detail(gear, chains[1])
