"""Dimensions laid out on paper: lines, arrow heads, numbers. Source: ISO 129-1."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array
from . import numbers
from .line_kinds import THIN
from .marks import Dimension, Filled, Mark, Stroke, Text, arc, line
from .views import Angle, Leader, Point, Side, Slant, Span, View

TEXT = 2.5
_FIRST, _NEXT = 9.0, 7.0  # from the part to the first dimension line, and on to the next
_ARROW, _HALF = 2.5, 0.45
_GAP, _OVER = 0.8, 1.5  # of extension lines: free of the part, beyond the dimension line
_ABOVE = 0.8  # of a number above its line
_OUTSIDE = 5.0  # of a line beyond arrow heads that point inwards
_UNIT: Mapping[Side, tuple[float, float]] = {
    "left": (-1.0, 0.0),
    "right": (1.0, 0.0),
    "above": (0.0, 1.0),
    "below": (0.0, -1.0),
}


@dataclass(frozen=True, kw_only=True)
class Drafting:
    """How a view comes to paper: times a factor, then shifted (2,); dimensions are in a length unit."""

    factor: float
    shift: tuple[float, float]
    length_unit: str

    def point(self, p: Point) -> Array:
        return self.factor * np.array(p) + np.array(self.shift)

    def marks(self, view: View) -> list[Mark]:
        """The view and its dimensions."""
        shift = np.array(self.shift)
        marks: list[Mark] = [hatch.placed(self.factor, shift) for hatch in view.hatches]
        marks += [stroke.placed(self.factor, shift) for stroke in view.strokes]
        box = self.factor * view.box() + shift
        spans = [one for one in view.dimensions if isinstance(one, Span)]
        for side in _UNIT:
            marks += self._stacked([one for one in spans if one.side == side], box, side)
        marks += [self._slant(one) for one in view.dimensions if isinstance(one, Slant)]
        marks += self._angles([one for one in view.dimensions if isinstance(one, Angle)])
        return marks + self._leaders([one for one in view.dimensions if isinstance(one, Leader)], box)

    def _text(self, value: float, prefix: str) -> str:
        return prefix + numbers.length(value, self.length_unit)

    def _stacked(self, spans: Sequence[Span], box: Array, side: Side) -> list[Dimension]:
        """Dimensions on one side of a view: the shorter one nearer to it where they lie beside each other."""
        outward = np.array(_UNIT[side])
        edge = box[1] if outward.sum() > 0.0 else box[0]
        along = np.abs(outward[::-1])
        taken: list[tuple[float, float, int]] = []
        found = []
        for span in sorted(spans, key=lambda one: one.value):
            first, last = sorted(float(self.point(p) @ along) for p in (span.start, span.end))
            text = self._text(span.value, span.prefix)
            low, high = _reach(first, last, Text(text=text, at=np.zeros(2), height=TEXT).width)
            row = max((r + 1 for a, b, r in taken if a < high and low < b), default=0)
            taken.append((low, high, row))
            base = edge + (_FIRST + row * _NEXT) * outward
            found.append(self._linear((span.start, span.end), along, base, span.value, text))
        return found

    def _slant(self, one: Slant) -> Dimension:
        start, end = self.point(one.start), self.point(one.end)
        along = (end - start) / np.hypot(*(end - start))
        outward = np.array([along[1], -along[0]])
        base = start + (one.clear * self.factor + _FIRST + one.row * _NEXT) * outward
        if along[0] < 0.0 or (along[0] == 0.0 and along[1] < 0.0):
            along = -along
        return self._linear((one.start, one.end), along, base, one.value, self._text(one.value, one.prefix))

    def _linear(self, ends: tuple[Point, Point], along: Array, base: Array, value: float, text: str) -> Dimension:
        first, second = map(self.point, ends)
        return replace(linear(first, second, along, base, value, text), factor=self.factor)

    def _angles(self, angles: Sequence[Angle]) -> list[Dimension]:
        """The first one always, others where their arcs are clear of it and long enough for their numbers."""
        found: list[Dimension] = []
        radii: list[float] = []
        for one in angles:
            radius = one.radius * self.factor
            dimension, inside = self._angle(one)
            if not found or (inside and min(abs(radius - other) for other in radii) >= 2.0 * TEXT):
                found.append(dimension)
                radii.append(radius)
        return found

    def _angle(self, one: Angle) -> tuple[Dimension, bool]:
        """The dimension, and whether its number is between its arrow heads; if not, it is beyond the last one."""
        vertex, radius = self.point(one.vertex), one.radius * self.factor
        first, last = math.radians(one.first), math.radians(one.last)
        text = one.prefix + numbers.of_unit(one.value, "angle", self.length_unit)
        room = radius * (last - first)
        needed = Text(text=text, at=np.zeros(2), height=TEXT).width
        inside = room > needed + 1.6 * _ARROW
        beyond = 0.0 if inside else _OUTSIDE / radius
        middle = (first + last) / 2.0 if inside else last + (_OUTSIDE + needed / 2.0) / radius
        after = 0.0 if inside else beyond + needed / radius
        marks: list[Stroke | Filled] = [arc(radius, first - beyond, last + after, THIN, vertex)]
        for angle, sense in ((first, 1.0), (last, -1.0)):
            tip = vertex + radius * np.array([math.cos(angle), math.sin(angle)])
            turn = sense if inside else -sense
            chord = angle + turn * _ARROW / 2.0 / radius
            marks.append(_arrow(tip, turn * np.array([-math.sin(chord), math.cos(chord)])))
        ends = [vertex + radius * np.array([math.cos(a), math.sin(a)]) for a in (first, last)]
        radial = np.array([math.cos(middle), math.sin(middle)])
        at = vertex + (radius + _ABOVE) * radial
        label = Text(text=text, at=at, height=TEXT, align="centre", angle=math.degrees(middle) - 90.0)
        points = (*ends, vertex + radius * radial, vertex)
        found = Dimension(
            kind="angular", points=points, value=one.value, text=label, marks=tuple(marks), factor=self.factor
        )
        return found, inside

    def _leaders(self, leaders: Sequence[Leader], box: Array) -> list[Mark]:
        """Notes above the right half of a view, that of the leftmost point on top."""
        marks: list[Mark] = []
        width = box[1, 0] - box[0, 0]
        ordered = sorted(leaders, key=lambda leader: leader.point[0])
        for k, one in enumerate(ordered):
            tip = self.point(one.point)
            knee = np.array([box[0, 0] + 0.65 * width, box[1, 1] + 3.0 + 2.4 * TEXT * (len(ordered) - 1 - k)])
            label = Text(text=one.text, at=knee + np.array([1.0, _ABOVE]), height=TEXT)
            end = knee + np.array([label.width + 2.0, 0.0])
            way = (knee - tip) / np.hypot(*(knee - tip))
            marks += [line(tip, knee, THIN), line(knee, end, THIN), _arrow(tip, way), label]
        return marks


def _reach(low: float, high: float, width: float) -> tuple[float, float]:
    """From where to where a dimension reaches along its line, its number included."""
    if high - low >= width + 2.0 * _ARROW:
        return low, high
    return low - _OUTSIDE, high + _OUTSIDE + width + 1.0


def linear(first: Array, second: Array, along: Array, base: Array, value: float, text: str) -> Dimension:
    """The distance of two points along a direction (unit vector), on the line through a point base."""
    if (second - first) @ along < 0.0:
        first, second = second, first
    ends = [base + ((p - base) @ along) * along for p in (first, second)]
    above = np.array([-along[1], along[0]])
    label = Text(text=text, at=base, height=TEXT, align="centre", angle=math.degrees(math.atan2(along[1], along[0])))
    room = float((ends[1] - ends[0]) @ along)
    inside = room >= label.width + 2.0 * _ARROW
    start, stop = ends
    middle = (start + stop) / 2.0
    if not inside:
        middle = stop + (_OUTSIDE + label.width / 2.0) * along
        start, stop = start - _OUTSIDE * along, stop + (_OUTSIDE + label.width + 0.5) * along
    label = Text(text=text, at=middle + _ABOVE * above, height=TEXT, align="centre", angle=label.angle)
    turn = 1.0 if inside else -1.0
    marks: list[Stroke | Filled] = [
        line(start, stop, THIN),
        _arrow(ends[0], turn * along),
        _arrow(ends[1], -turn * along),
    ]
    for p, end in zip((first, second), ends, strict=True):
        far = float(np.hypot(*(end - p)))
        if far > _GAP:
            away = (end - p) / far
            marks.append(line(p + _GAP * away, end + _OVER * away, THIN))
    return Dimension(
        kind="linear",
        points=(first, second, ends[1]),
        value=value,
        text=label,
        marks=tuple(marks),
        angle=label.angle,
    )


def _arrow(tip: Array, along: Array) -> Filled:
    """A head at its tip; along (unit vector) from the tip to the shaft."""
    side = np.array([-along[1], along[0]]) * _HALF
    foot = tip + _ARROW * along
    return Filled(corners=np.array([tip, foot + side, foot - side]))
