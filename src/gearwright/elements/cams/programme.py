"""Motion programmes: "dwell 36, rise 72, dwell 144, return 108", read and made into a displacement."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate

import numpy as np

from ...arrays import Array, ArrayLike
from ...parameters import did_you_mean
from .laws import Law

_FULL = 360.0
_ROUNDING = 1e-9  # by which angles may miss the full turn, and amounts the swing: decimals cannot say a third
_KINDS = ("dwell", "rise", "return")


@dataclass(frozen=True, kw_only=True)
class Step:
    """One part of a programme: over an angle (degrees) the follower's position changes by so much (0 for a dwell)."""

    kind: str
    angle: float
    start: float
    change: float


def moves_of(steps: Sequence[Step]) -> int:
    """How many of the steps are moves."""
    return sum(1 for step in steps if step.change)


def read_programme(text: str, total: float, unit: str) -> tuple[tuple[Step, ...], list[str]]:
    """The steps of a programme, and what is wrong with it, each problem with its place.

    total   the follower's swing or lift, in the unit (for messages)

    A rise without an amount goes up by what is left of the total, a return down to the start.
    """
    places = [f'part {number}, "{part.strip()}"' for number, part in enumerate(text.split(","), 1)]
    parts = [_part(part) for part in text.split(",")]
    problems = [f"{place}: {part}" for place, part in zip(places, parts, strict=True) if isinstance(part, str)]
    steps: list[Step] = []
    if not problems:
        for place, part in zip(places, parts, strict=True):
            position = steps[-1].start + steps[-1].change if steps else 0.0
            step = part if isinstance(part, str) else _step(part, position, total, unit)
            if isinstance(step, str):
                return (), [f"{place}: {step}"]
            steps.append(step)
        problems = _as_a_whole(steps, total, unit)
    return tuple(steps), problems


_LEAST_ANGLE = 1e-3  # degrees

_Part = tuple[str, float, float | None]


def _part(text: str) -> _Part | str:
    """Kind, angle and amount of a part as it is written; or why it cannot be read."""
    words = text.split()
    if not words or words[0].lower() not in _KINDS:
        hint = did_you_mean(words[0].lower(), _KINDS) if words else ""
        return f"it begins with none of {', '.join(_KINDS)}{hint}"
    kind = words[0].lower()
    if not 2 <= len(words) <= (2 if kind == "dwell" else 3):
        amount = "" if kind == "dwell" else " and, if it does not go all the way, an amount"
        return f"a {kind} has an angle in degrees{amount}, separated by blanks; parts are separated by commas"
    numbers = [_number(word) for word in words[1:]]
    for word, number in zip(words[1:], numbers, strict=True):
        if number is None:
            return f'"{word}" is not a number greater than 0'
    if (numbers[0] or 0.0) < _LEAST_ANGLE:
        return f"{words[1]}° is no angle that a cam can be cut to; at least {_LEAST_ANGLE:g}°"
    return kind, numbers[0] or 0.0, numbers[1] if len(numbers) == 2 else None


def _step(part: _Part, position: float, total: float, unit: str) -> Step | str:
    """The step a part makes from a position, or why it cannot."""
    kind, angle, given = part
    if kind == "dwell":
        return Step(kind=kind, angle=angle, start=position, change=0.0)
    slack = _ROUNDING * total
    room = total - position if kind == "rise" else position
    if room <= slack:
        return f"the follower is at the {'top' if kind == 'rise' else 'start'} already, at {position:.6g} {unit}"
    amount = room if given is None or abs(given - room) <= slack else given
    if amount > room:
        return f"only {room:.6g} {unit} are left to go from {position:.6g} {unit}"
    return Step(kind=kind, angle=angle, start=position, change=amount if kind == "rise" else -amount)


def _number(word: str) -> float | None:
    if not re.fullmatch(r"\+?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?°?", word):
        return None
    number = float(word.rstrip("°"))
    return number if 0.0 < number < math.inf else None


def _as_a_whole(steps: Sequence[Step], total: float, unit: str) -> list[str]:
    """Whether the parts make one turn, move, come back, and reach what they should."""
    problems = []
    angle = math.fsum(step.angle for step in steps)
    if abs(angle - _FULL) > _ROUNDING * _FULL:
        over = f"{abs(angle - _FULL):.6g}° too {'many' if angle > _FULL else 'few'}"
        problems.append(f"its angles make {angle:.6g}°, {over}; a turn of the cam is 360°")
    tops = [step.start + step.change for step in steps]
    end = tops[-1]
    if not any(step.change for step in steps):
        problems.append("nothing moves; a rise and a return are needed")
    elif end > _ROUNDING * total:
        problems.append(f"it ends {end:.6g} {unit} above its start; end it with a return")
    elif max(tops) < (1.0 - _ROUNDING) * total:
        problems.append(f"it reaches {max(tops):.6g} of {total:.6g} {unit}; let a rise reach the top")
    return problems


@dataclass(frozen=True, kw_only=True)
class Segment:
    """A step over [start, end] (cam angle, radians) by a law; low is the position it starts from, change its move."""

    start: float
    end: float
    low: float
    change: float
    law: Law | None = None

    def derivatives(self, angle: ArrayLike) -> Array:
        """s, s′, s″, s‴ (4, ...) by the cam angle (...), radians."""
        angle = np.asarray(angle, float)
        if self.law is None:
            found = np.zeros((4, *angle.shape))
        else:
            width = self.end - self.start
            powers = (self.change / width ** np.arange(4.0)).reshape(4, *[1] * angle.ndim)
            found = powers * self.law.derivatives((angle - self.start) / width)
        found[0] += self.low
        return found

    @property
    def cuts(self) -> tuple[float, ...]:
        """Cam angles from its start to its end between which it is analytic."""
        inside = () if self.law is None else self.law.breaks
        width = self.end - self.start
        return (self.start, *(self.start + width * x for x in inside), self.end)


@dataclass(frozen=True, kw_only=True)
class Displacement:
    """The follower's position over one turn of the cam: segments one after another, the first from cam angle 0."""

    segments: tuple[Segment, ...]

    @cached_property
    def _starts(self) -> Array:
        return np.array([segment.start for segment in self.segments])

    def derivatives(self, angle: ArrayLike) -> Array:
        """s, s′, s″, s‴ (4, ...) at cam angles (...), radians, any turn."""
        angle = np.asarray(angle, float) % (2.0 * np.pi)
        which = np.clip(np.searchsorted(self._starts, angle, side="right") - 1, 0, len(self.segments) - 1)
        found = np.empty((4, *angle.shape))
        for number, segment in enumerate(self.segments):
            here = which == number
            found[:, here] = segment.derivatives(angle[here])
        return found

    @property
    def moves(self) -> tuple[Segment, ...]:
        return tuple(segment for segment in self.segments if segment.law is not None)


def displacement(steps: Sequence[Step], laws: Sequence[Law], unit: float) -> Displacement:
    """The displacement of a programme, a law to each of its moves; `unit` is what one of its amounts is."""
    ends = [np.radians(end) for end in accumulate(step.angle for step in steps)]
    ends[-1] = 2.0 * np.pi
    waiting = iter(laws)
    segments = [
        Segment(
            start=float(start),
            end=float(end),
            low=step.start * unit,
            change=step.change * unit,
            law=next(waiting) if step.change else None,
        )
        for start, end, step in zip([0.0, *ends[:-1]], ends, steps, strict=True)
    ]
    return Displacement(segments=tuple(segments))
