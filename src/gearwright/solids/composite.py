"""Solids glued from pieces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, reduce

from ..boundary.boundary import Boundary
from ..boundary.gluing import Joint, glued
from ..moments.body import BodyMoments, summed
from .interference import united
from .solid import Solid


@dataclass(frozen=True, kw_only=True, repr=False)
class Composite(Solid):
    """Pieces that meet along joints and nowhere else. Moments add; glued faces vanish.

    joints   None: wherever plane faces of the pieces lie on one another, as found piece after piece

    Raises GeometryError where the pieces overlap, or meet otherwise than the joints say.
    """

    pieces: tuple[Solid, ...]
    joints: tuple[Joint, ...] | None = None

    def __post_init__(self) -> None:
        if self.joints is None:
            _ = self.boundary

    def __repr__(self) -> str:
        return f"<Composite of {', '.join(map(repr, self.pieces))}>"

    @cached_property
    def boundary(self) -> Boundary:
        boundaries = [piece.boundary for piece in self.pieces]
        return reduce(united, boundaries) if self.joints is None else glued(boundaries, self.joints)

    @cached_property
    def moments(self) -> BodyMoments:
        return summed([piece.moments for piece in self.pieces])
