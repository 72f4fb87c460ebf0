"""Bodies put together and taken apart: how good the result is, and whether there is one."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, Problem

_ROUNDOFF = 2.0**-53

_SLACK = 1e-9
"""How far a part may reach beyond the whole, relative to its size, for rounding."""


class Body(Protocol):
    """What of a body counts here."""

    @property
    def volume(self) -> float: ...
    @property
    def centroid(self) -> Array: ...
    @property
    def central_second(self) -> Array: ...
    @property
    def error_bound(self) -> float: ...


def require_within(whole: Array | None, part: Array | None) -> None:
    """Refuses a part whose box (2, 3) reaches beyond the whole's; a box not known passes. Raises GeometryError."""
    if whole is None or part is None:
        return
    slack = _SLACK * float(np.max(whole[1] - whole[0]))
    if np.any(part[0] < whole[0] - slack) or np.any(part[1] > whole[1] + slack):
        ranges = [" × ".join(f"{low:.6g}…{high:.6g}" for low, high in box.T) for box in (part, whole)]
        message = f"reaches beyond the body, {ranges[1]}: check the frames, the units and the order"
        raise GeometryError("The body taken away is no part of the other", [Problem(f"its box, {ranges[0]}", message)])


def combined_error(a: Body, b: Body, sign: float, volume: float, second: Array) -> float:
    """Bound for a sum or difference: absolute errors add, relative to what is left.

    The second moments' are those of the parts and of V_a V_b/V |arm|², whose arm is as good as the centroids' digits.
    """
    arm, reach = float(np.linalg.norm(b.centroid - a.centroid)), max(np.abs(a.centroid).max(), np.abs(b.centroid).max())
    reduced = abs(a.volume * b.volume / volume)
    volumes = (a.error_bound * abs(a.volume) + b.error_bound * abs(b.volume)) / abs(volume)
    spreads = [part.error_bound * abs(float(np.trace(part.central_second))) for part in (a, b)]
    either = max(a.error_bound, b.error_bound) if sign > 0.0 else a.error_bound + b.error_bound
    rounded = 4.0 * _ROUNDOFF * reach
    arms = reduced * (either * arm**2 + 2.0 * arm * rounded + rounded**2)
    left = abs(float(np.trace(second)))
    return float(max(volumes, (sum(spreads) + arms) / left if left else math.inf)) + 8.0 * _ROUNDOFF
