"""The loops of sections as closed chains of primitives, where they stand on the sheet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ..loop import Loop
from .primitives import Free, Primitive, Round, Straight
from .strokes import Hand, stroke

if TYPE_CHECKING:
    from ..plane import Section

Contour = tuple[Primitive, ...]

_ROUNDING = 1e-13
"""Lines and arcs that differ by less, relative to the section's size, are one; far below any tolerance."""


@dataclass(frozen=True, kw_only=True)
class Profile:
    """A section where it stands on a sheet: turned by an angle about its origin (radians), then shifted (x, y).

    layer   the name of the layer that its outline and its holes are drawn on
    """

    section: Section
    layer: str = "profile"
    turn: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)


def contours(profile: Profile, tolerance: float, hand: Hand) -> tuple[Contour, ...]:
    """A closed chain of primitives for each loop: what is one line or circle is drawn once, and each primitive starts
    in the very point where the one before it ends, but an arc after an arc, which do so to rounding.

    tolerance   largest distance (a length) of splines from curves that the format does not hold
    """
    size = profile.section.size + float(np.max(np.abs(profile.section.middle)))
    return tuple(
        _closed(_united(_all(loop, profile, tolerance, hand), _ROUNDING * size)) for loop in profile.section.loops
    )


def _all(loop: Loop, profile: Profile, tolerance: float, hand: Hand) -> list[Primitive]:
    """The primitives of all periods: those of the first one, turned."""
    period = [stroke(curve, tolerance, hand) for curve in loop.curves]
    step = loop.sense * 2.0 * np.pi / loop.copies
    shift = np.array(profile.shift, float)
    return [one.moved(profile.turn + k * step, shift) for k in range(loop.copies) for one in period]


def _united(chain: Sequence[Primitive], rounding: float) -> list[Primitive]:
    """The closed chain with neighbours that go on as one made one."""
    found: list[Primitive] = []
    for one in chain:
        whole = _one(found[-1], one, rounding) if found else None
        if whole is None:
            found.append(one)
        else:
            found[-1] = whole
    while len(found) > 1 and (whole := _one(found[-1], found[0], rounding)) is not None:
        found = [whole, *found[1:-1]]
    return found


def _one(first: Primitive, second: Primitive, rounding: float) -> Primitive | None:
    """Two neighbours as one, where the second goes on as the first did."""
    match first, second:
        case Straight(), Straight():
            return _one_line(first, second, rounding)
        case Round(), Round():
            far = max(np.abs(first.centre - second.centre).max(), np.abs(first.major - second.major).max())
            same = far <= rounding and abs(first.ratio - second.ratio) * np.hypot(*first.major) <= rounding
            if same and first.sweep * second.sweep > 0.0:
                return replace(first, sweep=first.sweep + second.sweep)
        case Free(), Free():
            if _smooth(first, second, rounding):
                control = np.concatenate([first.control, second.control])
                control[len(first.control), 0] = first.end
                return Free(control=control)
    return None


def _one_line(first: Straight, second: Straight, rounding: float) -> Straight | None:
    a, b = first.end - first.start, second.end - second.start
    whole = second.end - first.start
    aside = abs(float(a[0] * whole[1] - a[1] * whole[0])) / max(float(np.hypot(*whole)), np.finfo(float).tiny)
    if aside <= rounding and float(a @ b) > 0.0:
        return Straight(start=first.start, end=second.end)
    return None


def _smooth(first: Free, second: Free, rounding: float) -> bool:
    """Whether two chains of polynomials of one degree join without a corner: their joint lies between their handles."""
    if first.degree != second.degree or first.weights is not None or second.weights is not None:
        return False
    before, after = first.end - first.control[-1, -2], second.control[0, 1] - second.start
    lengths = float(np.hypot(*before)), float(np.hypot(*after))
    if min(lengths) <= 1e-3 * max(lengths):
        return False
    along = before / lengths[0]
    aside = abs(float(along[0] * after[1] - along[1] * after[0])) * min(lengths) / lengths[1]
    return aside <= rounding and float(before @ after) > 0.0


def _closed(chain: Sequence[Primitive]) -> Contour:
    """The chain with the ends of lines and splines in the very points where their neighbours, arcs first, end."""
    nodes = [_node(one, after) for one, after in zip(chain, [*chain[1:], chain[0]], strict=True)]
    return tuple(one.between(nodes[i - 1], nodes[i]) for i, one in enumerate(chain))


def _node(before: Primitive, after: Primitive) -> Array:
    return after.start if isinstance(after, Round) and not isinstance(before, Round) else before.end
