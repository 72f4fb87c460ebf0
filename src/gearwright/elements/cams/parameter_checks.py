"""Whether the parameters of a cam go together: those that its follower, its law and a synthesis need, and no others."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...parameters import Problems, declarations
from . import refusals
from .kinds import KINDS
from .laws import SPLINE
from .programme import moves_of

if TYPE_CHECKING:
    from .cam import Cam

_OF_SYNTHESIS = ("free_values", "eccentricity_limit", "curvature_limit", "pressure_angle_limit")
_OF_FOLLOWERS = tuple(dict.fromkeys(name for kind in KINDS.values() for name in kind.parameters))


def check_parameters(cam: Cam, problems: Problems) -> None:
    """Whether those that the follower needs are given, and no others."""
    kind = cam.kind
    for name in _OF_FOLLOWERS:
        owners = [other for other, one in KINDS.items() if name in one.parameters]
        if getattr(cam, name) is not None and name not in kind.parameters and problems.sound(name):
            problems.add(name, refusals.not_of_this_follower(cam.follower, owners))
    for name, other in kind.instead.items():
        if getattr(cam, name) is not None and getattr(cam, other) is not None:
            problems.add(name, refusals.one_of(name, other))
    _check_needed(cam, problems)
    for name in _OF_SYNTHESIS:
        if getattr(cam, name) is not None and not cam.minimise:
            problems.add(name, refusals.WITH_MINIMISE)


def _check_needed(cam: Cam, problems: Problems) -> None:
    kind = cam.kind
    meanings = {d.name: d.parameter.meaning for d in declarations(type(cam))}
    settled = {other for name, other in kind.instead.items() if getattr(cam, name) is not None}
    for name in ("swing" if kind.swings else "lift", *kind.dimensions):
        optional = name in kind.defaults or name in settled or (cam.minimise and name in kind.free)
        if getattr(cam, name) is None and not optional:
            problems.add(name, refusals.needed_for(cam.follower, meanings[name], name in kind.free))


def check_law(cam: Cam, problems: Problems) -> None:
    """Whether the law and the values of its spline go together, and with the synthesis."""
    if cam.free_values is not None and cam.minimise and cam.law not in (None, SPLINE):
        problems.add("free_values", refusals.FREE_WITHOUT_SPLINE)
    if cam.spline_values is None:
        if cam.law == SPLINE and not cam.minimise:
            problems.add("law", refusals.SPLINE_WITHOUT_VALUES)
        return
    if cam.minimise:
        problems.add("spline_values", refusals.VALUES_WITH_MINIMISE)
    elif cam.law != SPLINE:
        problems.add("spline_values", refusals.VALUES_WITHOUT_SPLINE)
    elif problems.sound("programme", "swing", "lift", "follower"):
        _check_values(cam, problems, np.array(cam.spline_values))


def _check_values(cam: Cam, problems: Problems, values: Array) -> None:
    """Whether they can be shared among the moves, and ascend in each."""
    moves = moves_of(cam.steps)
    if len(values) % moves:
        problems.add("spline_values", refusals.wrong_count(len(values), moves))
        return
    for number, one in enumerate(values.reshape(moves, -1), 1):
        falls = np.flatnonzero(np.diff(one, prepend=0.0, append=1.0) < 0.0)
        if len(falls):
            value = float(one[min(int(falls[0]), len(one) - 1)])
            problems.add("spline_values", refusals.falling_values(number, value))
