"""The search for a cam of least area with one law, within limits that hold at every cam angle."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array
from .followers import Contact, Follower
from .kinds import KINDS, SENSES
from .led import Led, Movement, area_nodes, led
from .optimum import Active, Optimum, Task
from .programme import Segment
from .spline_law import even_values

_PLACES = 41  # of each segment where limits are asked for at first
_LOOKS = 2001  # of each move where they are looked at afterwards
_CHECKED = 10_000  # cam angles at which, besides the worst ones, the result must keep its limits
_ROUNDS = 12  # of adding places where limits were missed between the others
_MARGINS = (1e-6, 1e-5, 1e-4)  # by which limits are kept there, one after another until none is missed between
_HOPELESS = 1e-3  # a limit missed by more at the places themselves cannot be kept from there
_ACTIVE = 1e-4  # a limit kept by less is one that the optimum rests on


@dataclass(frozen=True, kw_only=True)
class Search:
    """A search with one law: variables are the free dimensions, then the free values of the spline."""

    task: Task
    law: str
    movement: Movement

    @cached_property
    def _area_nodes(self) -> Led:
        return area_nodes(self.movement)

    @cached_property
    def _segments(self) -> tuple[Segment, ...]:
        return self.movement.even().segments

    @cached_property
    def _looks(self) -> list[Array]:
        return [np.linspace(s.start, s.end, _LOOKS if s.law else 1) for s in self._segments]

    @cached_property
    def _seen(self) -> Led:
        return led(self.movement, self._looks)

    @property
    def _dimensions(self) -> int:
        return len(self.task.freedom.variables)

    @property
    def values(self) -> Array:
        """Free values to begin from: an even rise."""
        return np.tile(even_values(self.movement.count), self.movement.values // max(self.movement.count, 1))

    def variables(self, dimensions: Mapping[str, float]) -> Array:
        """The variables at given dimensions."""
        reach = dimensions.get("base_radius", 0.0) + dimensions.get("roller_radius", 0.0)
        return np.array(
            [
                dimensions[v.name] / (reach if v.name == "offset" else v.unit)
                for v in self.task.freedom.variables
            ]
        )  # fmt: skip

    def follower(self, x: Array) -> Follower:
        kind = self.task.freedom.kind
        dimensions = self.task.freedom.dimensions(x[: self._dimensions])
        return KINDS[kind].make(dimensions, SENSES[self.task.sense])

    def contact(self, x: Array, at: Led) -> Contact:
        return self.follower(x).contact(at.at(x[self._dimensions :]))

    def area(self, x: Array) -> float:
        """½∮ p ds, in units of the size squared."""
        contact = self.contact(x, self._area_nodes)
        return float(self._area_nodes.weights @ (contact.support * contact.speed)) / 2.0 / self.task.freedom.size**2

    def margins(self, x: Array, at: Led) -> dict[str, Array]:
        return self.task.limits.margins(self.follower(x), self.contact(x, at), self.task.freedom.size)

    def ascent(self, x: Array) -> Array:
        """By how much each control value of the splines exceeds the one before it."""
        values = x[self._dimensions :].reshape(-1, max(self.movement.count, 1))
        return np.diff(values, prepend=0.0, append=1.0, axis=1).ravel() if values.size else np.empty(0)

    def run(self, start: Array) -> Optimum:
        """From a start to an optimum that keeps the limits everywhere, if there is one."""
        x, found = start, None
        for margin in _MARGINS:
            x, hopeless = self._settled(x, margin)
            found = self._optimum(x)
            if found.keeps_limits or hopeless:
                break
        return found or self._optimum(x)

    def _settled(self, start: Array, margin: float) -> tuple[Array, bool]:
        """Variables that keep the limits by a margin; where they are missed between places, those are added.

        Also whether there seem to be none.
        """
        places = [np.linspace(s.start, s.end, _PLACES if s.law else 1) for s in self._segments]
        x = start
        for _ in range(_ROUNDS):
            at = led(self.movement, places)
            x = self._solved(x, at, margin)
            with np.errstate(all="ignore"):
                if not min(float(np.min(one)) for one in self.margins(x, at).values()) > -_HOPELESS:
                    return x, True
            worse = self._worst(x, margin / 2.0)
            if not any(len(one) for one in worse):
                break
            places = [np.union1d(p, one) for p, one in zip(places, worse, strict=True)]
        return x, False

    def _worst(self, x: Array, least: float) -> list[Array]:
        """For each segment the cam angles where a limit is kept by less than that, but by more nearby."""
        with np.errstate(all="ignore"):
            dips = [_dips(margin, self._looks, least) for margin in self.margins(x, self._seen).values()]
        return [np.concatenate(one) for one in zip(*dips, strict=True)]

    def _solved(self, start: Array, at: Led, margin: float) -> Array:
        from scipy.optimize import minimize

        def kept(x: Array) -> Array:
            margins = np.concatenate([*self.margins(x, at).values()]) - margin
            return np.nan_to_num(np.concatenate([margins, self.ascent(x)]), nan=-1e3, posinf=1e3, neginf=-1e3)

        bounds = [(v.low, v.high) for v in self.task.freedom.variables] + [(0.0, 1.0)] * self.movement.values
        if not bounds:
            return start
        low, high = np.array(bounds).T
        with np.errstate(all="ignore"), warnings.catch_warnings():  # steps on the way may leave what can be built
            warnings.simplefilter("ignore")
            found = minimize(
                self.area,
                np.clip(start, low, high),
                method="SLSQP",
                bounds=bounds,
                constraints={"type": "ineq", "fun": kept},
                options={"ftol": 1e-10, "maxiter": 200},
            )
        return self._ascending(np.clip(found.x, low, high))

    def _ascending(self, x: Array) -> Array:
        """The variables with the splines' values put in order, which rounding may have left a little out of it."""
        if not self.movement.values:
            return x
        values = np.maximum.accumulate(x[self._dimensions :].reshape(-1, self.movement.count), axis=1)
        return np.concatenate([x[: self._dimensions], values.ravel()])

    def _optimum(self, x: Array) -> Optimum:
        displacement = self.movement.displacement(x[self._dimensions :])
        even = 2.0 * np.pi * np.arange(_CHECKED) / _CHECKED
        angles = np.union1d(even, np.concatenate(self._worst(x, _ACTIVE)))
        with np.errstate(all="ignore"):
            follower = self.follower(x)
            contact = follower.contact(displacement.derivatives(angles))
            margins = self.task.limits.margins(follower, contact, self.task.freedom.size)
            area = self.area(x) * self.task.freedom.size**2
        worst = {name: float(np.min(np.nan_to_num(margin, nan=-1e3))) for name, margin in margins.items()}
        missed = min(worst, key=lambda name: worst[name])
        return Optimum(
            law=self.law,
            dimensions=self.task.freedom.dimensions(x[: self._dimensions]),
            values=tuple(x[self._dimensions :].tolist()),
            displacement=displacement,
            area=area,
            shortfall=-worst[missed],
            missed=missed,
            active=(*self._active(margins, np.degrees(angles)), *self._at_bounds(x)),
        )

    def _active(self, margins: Mapping[str, Array], angles: Array) -> list[Active]:
        """The limits that are kept by next to nothing, each with the middles of the ranges where."""
        found = []
        for name, margin in margins.items():
            tight = np.flatnonzero(margin < _ACTIVE)
            if len(tight) == len(margin):
                found.append(Active(name=name, angles=()))
            elif len(tight):
                runs = np.split(tight, np.flatnonzero(np.diff(tight) > 1) + 1)
                found.append(Active(name=name, angles=tuple(float(angles[run].mean()) for run in runs)))
        return found

    def _at_bounds(self, x: Array) -> list[Active]:
        return [
            Active(name=f"{'greatest' if value > v.low + _ACTIVE else 'least'} {v.name}", angles=())
            for v, value in zip(self.task.freedom.variables, x, strict=False)
            if not v.low + _ACTIVE < value < v.high - _ACTIVE
        ]


def _dips(margin: Array, looks: Sequence[Array], least: float) -> list[Array]:
    """For each segment the places, between the looks, at which a margin has a low that is below the least.

    Each is the vertex of the parabola through the lowest look and its neighbours.
    """
    if len(margin) == 1:
        return [np.empty(0)] * len(looks)
    found, first = [], 0
    for angles in looks:
        values = margin[first : first + len(angles)]
        first += len(angles)
        if len(angles) < 3:
            found.append(np.empty(0))
            continue
        before, middle, after = values[:-2], values[1:-1], values[2:]
        i = np.flatnonzero((middle < before) & (middle <= after))
        bend = before[i] - 2.0 * middle[i] + after[i]
        shift = np.clip((before[i] - after[i]) / (2.0 * bend), -1.0, 1.0)
        low = middle[i] - bend * shift**2 / 2.0
        places = angles[i + 1] + (angles[1] - angles[0]) * shift
        found.append(places[low < least])
    return found
