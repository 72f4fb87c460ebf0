"""The profile of a cam: a follower led through a displacement; its curves, its section and its extremes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.arc import Arc
from ...curves.curve import Curve
from ...curves.envelope import Envelope, Tangents
from ...curves.smooth import lowest
from ...sections.loop import Loop
from .followers import Contact, FlatFace, Follower
from .programme import Displacement, Segment

_SAMPLES = 361  # of each analytic piece: dips between neighbours are single ones


@dataclass(frozen=True, kw_only=True)
class Extreme:
    """A greatest or least value and the cam angle (radians) where it is."""

    value: float
    angle: float


@dataclass(frozen=True, kw_only=True)
class _Led:
    """A follower led through one segment, as the tangents of the profile."""

    follower: Follower
    segment: Segment

    def __call__(self, angle: Array) -> Tangents:
        contact = self.follower.contact(self.segment.derivatives(angle))
        normal = contact.normal * np.exp(1j * angle)
        return Tangents(
            normal=np.stack([normal.real, normal.imag], axis=-1),
            support=contact.support,
            along=contact.along,
            speed=contact.speed,
        )


@dataclass(frozen=True, kw_only=True)
class Profile:
    """The envelope of a follower that is led through a displacement, in the cam's frame, counter-clockwise.

    It is a curve without cusps where `slowest` is positive; followers and displacements of others are taken too, so
    that it can be asked what is wrong with them.
    """

    follower: Follower
    displacement: Displacement

    def contact(self, angle: ArrayLike) -> Contact:
        """Contact at cam angles (...), radians, in the follower's frame."""
        return self.follower.contact(self.displacement.derivatives(angle))

    def points(self, angle: ArrayLike) -> Array:
        """Points (..., 2) of the profile that are touched at cam angles (...), radians."""
        contact = self.contact(angle)
        found = (contact.support + 1j * contact.along) * contact.normal * np.exp(1j * np.asarray(angle, float))
        return np.stack([found.real, found.imag], axis=-1)

    @cached_property
    def curves(self) -> tuple[Curve, ...]:
        """One for each analytic piece of the displacement; dwells are arcs about the axis."""
        found: list[Curve] = []
        for segment in self.displacement.segments:
            if segment.law is None:
                found.append(self._arc(segment))
                continue
            led = _Led(follower=self.follower, segment=segment)
            found += [Envelope(tangents=led, interval=cut) for cut in pairwise(segment.cuts)]
        return tuple(found)

    def _arc(self, segment: Segment) -> Arc:
        contact = self.follower.contact(segment.derivatives(segment.start))
        turned = float(np.angle(contact.normal))
        return Arc(radius=float(contact.support), interval=(segment.start + turned, segment.end + turned))

    @property
    def loop(self) -> Loop:
        return Loop(curves=self.curves)

    def lowest(self, value: Callable[[Contact], Array]) -> Extreme:
        """The least value of a function of the contact over the turn: from samples, then refined."""
        found = []
        for segment in self.displacement.segments:
            of = partial(self._value, value, segment)
            if segment.law is None:
                found.append(Extreme(value=float(of(segment.start)), angle=segment.start))
                continue
            for start, end in pairwise(segment.cuts):
                angles = np.linspace(start, end, _SAMPLES)
                at = lowest(lambda angle, of=of: float(of(angle)), angles, of(angles))  # type: ignore[misc]
                found.append(Extreme(value=float(of(at)), angle=at))
        return min(found, key=lambda extreme: extreme.value)

    def _value(self, value: Callable[[Contact], Array], segment: Segment, angle: ArrayLike) -> Array:
        """A function of the contact at cam angles (...) of one segment."""
        return value(self.follower.contact(segment.derivatives(angle)))

    def largest(self, value: Callable[[Contact], Array]) -> Extreme:
        """The greatest value, likewise."""
        least = self.lowest(lambda contact: -value(contact))
        return Extreme(value=-least.value, angle=least.angle)

    @cached_property
    def slowest(self) -> Extreme:
        """The least ds/dψ along the profile: not positive where it has a cusp, or goes backwards."""
        return self.lowest(lambda contact: contact.speed)

    @cached_property
    def least_turning(self) -> Extreme:
        """The least dν/dψ: not positive for a flat face that would have to turn faster than the cam."""
        return self.lowest(lambda contact: contact.turning)

    @cached_property
    def sharpest(self) -> Extreme:
        """The least radius of curvature where the profile is convex."""
        greatest = self.largest(lambda contact: contact.turning / contact.speed)
        return Extreme(value=1.0 / greatest.value, angle=greatest.angle)

    @cached_property
    def hollow(self) -> Extreme | None:
        """The least radius of curvature where it is concave, which no grinding wheel may exceed; None if nowhere."""
        least = self.lowest(lambda contact: contact.turning / contact.speed)
        return Extreme(value=-1.0 / least.value, angle=least.angle) if least.value < 0.0 else None

    @cached_property
    def eccentricity(self) -> Extreme:
        """The greatest |q|."""
        return self.largest(lambda contact: np.abs(contact.along))

    @cached_property
    def pressure_angle(self) -> Extreme:
        """The greatest pressure angle, radians."""
        return self.largest(lambda contact: np.arctan(np.abs(contact.pressure)))

    @cached_property
    def face(self) -> tuple[float, float] | None:
        """Between which places of a flat face it is touched; None for rollers."""
        if not isinstance(self.follower, FlatFace):
            return None
        return self.lowest(lambda contact: contact.reach).value, self.largest(lambda contact: contact.reach).value
