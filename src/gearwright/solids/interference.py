"""Whether two bodies overlap or touch otherwise than with the plane faces along which they are glued."""

from __future__ import annotations

from ..boundary.boundary import Boundary
from ..boundary.joining import joined


def united(first: Boundary, second: Boundary) -> Boundary:
    whole, _ = joined(first, second)
    return whole
