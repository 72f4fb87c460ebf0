"""The free dimensions of a cam as the variables of a synthesis: in the size of the follower, between bounds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...arrays import Array
from .kinds import KINDS, Dimensions

STEEPEST_FACE = 75.0
"""Degrees that a synthesis lets a swinging face turn, at most, from the line between the pivot and the cam's axis:
beyond them the point of contact nears the pivot, so that no force turns the follower."""
_MOST_OFFSET = 0.95  # of the distance at which a roller's stem would no longer meet its pitch circle
_SMALLEST, _LARGEST = 1e-3, 200.0  # radii, in lifts


@dataclass(frozen=True, kw_only=True)
class Variable:
    """A free dimension: value = unit × variable, the variable from low to high; starts are good places to begin."""

    name: str
    low: float
    high: float
    starts: tuple[float, ...]
    unit: float


@dataclass(frozen=True, kw_only=True)
class Freedom:
    """The free dimensions of a follower.

    given   the dimensions that are not free
    size    a length of the mechanism, the unit of its areas and radii
    """

    kind: str
    given: Dimensions
    size: float
    variables: tuple[Variable, ...]

    def dimensions(self, x: Sequence[float] | Array) -> dict[str, float]:
        """All dimensions for values of the variables."""
        found = {**self.given, **{v.name: float(v.unit * one) for v, one in zip(self.variables, x, strict=True)}}
        if any(v.name == "offset" for v in self.variables):
            found["offset"] *= found["base_radius"] + found["roller_radius"]  # the variable is their share
        return found

    def starts(self) -> list[Array]:
        """Values of the variables to begin from."""
        count = max((len(v.starts) for v in self.variables), default=1)
        return [
            np.array([np.clip(v.starts[i % len(v.starts)], v.low, v.high) for v in self.variables])
            for i in range(count)
        ]


def freedom(kind: str, given: Dimensions, amount: float) -> Freedom:
    """The freedom that is left by the dimensions given; amount is the swing (degrees) or the lift."""
    size = given["pivot_distance"] if KINDS[kind].swings else amount
    ranges = _RANGES[kind](given, amount, size)
    settled = {*given, *(name for other, name in KINDS[kind].instead.items() if other in given)}
    variables = tuple(ranges[name] for name in KINDS[kind].free if name not in settled)
    return Freedom(kind=kind, given=given, size=size, variables=variables)


def _angle(low: float, high: float, starts: tuple[float, ...]) -> Variable:
    degree = float(np.degrees(1.0))
    places = tuple(start / degree for start in starts)
    return Variable(name="initial_angle", low=low / degree, high=high / degree, starts=places, unit=degree)


def _length(name: str, low: float, high: float, starts: tuple[float, ...], unit: float) -> Variable:
    return Variable(name=name, low=low, high=high, starts=starts, unit=unit)


def _of_flat_faces_that_swing(given: Dimensions, swing: float, size: float) -> Mapping[str, Variable]:
    del given
    return {
        "face_offset": _length("face_offset", -5.0, 100.0, (2.0, 0.0, 4.0, 15.0, 50.0), size),
        "initial_angle": _angle(
            -STEEPEST_FACE, max(STEEPEST_FACE - swing, -STEEPEST_FACE), (15.0, 60.0, 40.0, 90.0, 90.0)
        ),
    }


def _of_flat_faces_that_go_straight(given: Dimensions, lift: float, size: float) -> Mapping[str, Variable]:
    del given, lift
    return {"base_radius": _length("base_radius", _SMALLEST, _LARGEST, (4.0,), size)}


def _of_rollers_that_go_straight(given: Dimensions, lift: float, size: float) -> Mapping[str, Variable]:
    del lift
    needed = abs(given.get("offset", 0.0)) / _MOST_OFFSET - given["roller_radius"]
    low = max(_SMALLEST, needed / size)
    return {
        "base_radius": _length("base_radius", low, low + _LARGEST, (4.0, 8.0), size),
        "offset": _length("offset", -_MOST_OFFSET, _MOST_OFFSET, (0.0, 0.2), 1.0),
    }


def _of_rollers_that_swing(given: Dimensions, swing: float, size: float) -> Mapping[str, Variable]:
    reach = (given["base_radius"] + given["roller_radius"]) / size if "base_radius" in given else None
    shortest, longest = (0.05, 5.0) if reach is None else (1.001 * abs(1.0 - reach) + 1e-3, 0.999 * (1.0 + reach))
    return {
        "arm_length": _length("arm_length", shortest, max(shortest, longest), (0.8, 1.0, 0.6), size),
        "initial_angle": _angle(1.0, 178.0 - swing, (35.0, 60.0, 20.0)),
    }


_RANGES = {
    "oscillating-flat-face": _of_flat_faces_that_swing,
    "translating-flat-face": _of_flat_faces_that_go_straight,
    "translating-roller": _of_rollers_that_go_straight,
    "oscillating-roller": _of_rollers_that_swing,
}
