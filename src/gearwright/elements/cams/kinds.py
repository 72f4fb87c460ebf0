"""The kinds of followers: which parameters say where each stands, and which of them a synthesis may choose."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from .followers import (
    Follower,
    OscillatingFlatFace,
    OscillatingRoller,
    TranslatingFlatFace,
    TranslatingRoller,
    initial_angle_of,
)

Dimensions = Mapping[str, float]
"""Values of parameters by name, angles in degrees."""


@dataclass(frozen=True, kw_only=True)
class Kind:
    """A kind of follower.

    dimensions   the parameters that say where it stands
    free         those of them that a synthesis may choose where they are not given
    defaults     those that need not be given without a synthesis
    instead      parameters that may be given in place of one of the dimensions
    make         the follower from its dimensions and the sign of an oscillating one
    """

    swings: bool
    dimensions: tuple[str, ...]
    free: tuple[str, ...]
    make: Callable[[Dimensions, int], Follower]
    defaults: Dimensions = field(default_factory=dict)
    instead: Mapping[str, str] = field(default_factory=dict)

    @property
    def parameters(self) -> tuple[str, ...]:
        """All that apply to it."""
        movement = ("swing", "sense") if self.swings else ("lift",)
        return (*movement, *self.dimensions, *self.instead)


def _oscillating_flat_face(given: Dimensions, sign: int) -> Follower:
    return OscillatingFlatFace(
        pivot_distance=given["pivot_distance"],
        offset=given["face_offset"],
        initial_angle=float(np.radians(given["initial_angle"])),
        sign=sign,
    )


def _translating_flat_face(given: Dimensions, sign: int) -> Follower:
    del sign
    return TranslatingFlatFace(radius=given["base_radius"])


def _translating_roller(given: Dimensions, sign: int) -> Follower:
    del sign
    return TranslatingRoller(
        radius=given["base_radius"], offset=given["offset"], roller_radius=given["roller_radius"]
    )  # fmt: skip


def _oscillating_roller(given: Dimensions, sign: int) -> Follower:
    pivot, arm, roller = (given[name] for name in ("pivot_distance", "arm_length", "roller_radius"))
    if "base_radius" in given:
        initial = initial_angle_of(given["base_radius"], roller, pivot, arm)
    else:
        initial = float(np.radians(given["initial_angle"]))
    return OscillatingRoller(
        pivot_distance=pivot, arm_length=arm, initial_angle=initial, roller_radius=roller, sign=sign
    )  # fmt: skip


KINDS: dict[str, Kind] = {
    "oscillating-flat-face": Kind(
        swings=True,
        dimensions=("pivot_distance", "face_offset", "initial_angle"),
        free=("face_offset", "initial_angle"),
        make=_oscillating_flat_face,
        defaults={"face_offset": 0.0},
    ),
    "translating-flat-face": Kind(
        swings=False, dimensions=("base_radius",), free=("base_radius",), make=_translating_flat_face
    ),
    "translating-roller": Kind(
        swings=False,
        dimensions=("base_radius", "roller_radius", "offset"),
        free=("base_radius", "offset"),
        make=_translating_roller,
        defaults={"offset": 0.0},
    ),
    "oscillating-roller": Kind(
        swings=True,
        dimensions=("pivot_distance", "arm_length", "roller_radius", "initial_angle"),
        free=("arm_length", "initial_angle"),
        make=_oscillating_roller,
        instead={"base_radius": "initial_angle"},
    ),
}
"""The kinds of followers by name."""

SENSES = {"opposite": 1, "same": -1}
"""Whether an oscillating follower that lifts turns against the cam or with it, and the sign σ of that."""
