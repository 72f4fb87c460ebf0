"""Solids glued from pieces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..boundary.boundary import Boundary
from ..boundary.gluing import Joint, glued
from ..moments.body import BodyMoments, Method, about_centroid
from ..moments.matrix import shifted
from .solid import Solid


@dataclass(frozen=True, kw_only=True)
class Composite(Solid):
    """Pieces that meet along joints and nowhere else. Moments add; glued faces vanish."""

    pieces: tuple[Solid, ...]
    joints: tuple[Joint, ...]

    @cached_property
    def boundary(self) -> Boundary:
        return glued([piece.boundary for piece in self.pieces], self.joints)

    @cached_property
    def moments(self) -> BodyMoments:
        parts = [piece.moments for piece in self.pieces]
        origin = parts[0].origin
        matrix = np.sum([shifted(part.matrix, part.origin - origin) for part in parts], axis=0)
        method: Method = "exact" if all(part.method == "exact" for part in parts) else "quadrature"
        return about_centroid(matrix, method, max(part.error_bound for part in parts), origin)
