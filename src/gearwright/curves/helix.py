"""Helices, the paths of springs and screws."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, numbers_in
from ..errors import ParameterError, Problem
from .path import Path, path_of

_MOST = 1e12
_TOLERANCE = 1e-14
_ROUNDINGS = 8.0 * float(np.finfo(float).eps)


def helix(radius: float, pitch: float, turns: float = 1.0, hand: str = "right") -> Path:
    """The helix about z from (radius, 0, 0) upwards, for `sweep_along`; a circle where the pitch is 0 and turns 1.

    radius   of the centre line, a length
    pitch    rise of each turn, a length; 0 for a circle or an arc of one
    turns    number of turns, greater than 0
    hand     "right" or "left"

    Raises ParameterError with every problem found.
    """
    given: dict[str, object] = {"radius": radius, "pitch": pitch, "turns": turns}
    problems = [
        Problem(f"{name} = {value!r}", f"a finite number of at most {_MOST:g} is needed")
        for name, value in given.items()
        if not (numbers_in(value, most=_MOST) is not None)
    ]
    if not problems:
        limits = {"radius": radius > 0.0, "pitch": pitch >= 0.0, "turns": turns > 0.0}
        problems = [
            Problem(f"{name} = {given[name]}", "must be greater than 0" if name != "pitch" else "at least 0")
            for name, good in limits.items()
            if not good
        ]
        if pitch == 0.0 and turns > 1.0:
            problems.append(
                Problem(f"turns = {turns:g}", "at pitch 0 the second turn would run into the first; give a pitch")
            )
    if hand not in ("right", "left"):
        problems.append(Problem(f"hand = {hand!r}", "choose right or left"))
    if problems:
        raise ParameterError("helix", problems)
    angle = 2.0 * np.pi * turns * (1.0 if hand == "right" else -1.0)

    def point(u: Array) -> Array:
        return np.stack([radius * np.cos(angle * u), radius * np.sin(angle * u), pitch * turns * u], axis=-1)

    # the cosine of a large angle is known to the rounding of that angle
    return path_of(point, max(_TOLERANCE, _ROUNDINGS * abs(angle)))
