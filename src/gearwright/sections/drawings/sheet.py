"""What a drawing's file holds before its curves are joined: the same for every format."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ...arrays import Array
from ...curves.curve import Curve, points_along
from ...errors import FileError

MOST_CURVES = 200_000
"""What nested copies of copies may come to; a drawing of a section has some thousands at the most."""


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """The curves of a drawing, in no order and no sense.

    passed_over   how many things of each kind are no outline: texts, dimensions, points
    length_unit   of the coordinates, such as "mm"; None where the file states none
    layers        names of the layers that hold curves
    """

    curves: tuple[Curve, ...]
    passed_over: Mapping[str, int]
    length_unit: str | None = None
    layers: tuple[str, ...] = ()


@dataclass(kw_only=True)
class Tally:
    """Curves and passed-over things as they are met, for one layer or, where it is None, for all.

    Raises FileError beyond `MOST_CURVES`, naming the file `source`.
    """

    source: str
    layer: str | None = None
    curves: list[Curve] = field(default_factory=list)
    passed_over: Counter[str] = field(default_factory=Counter)
    layers: dict[str, None] = field(default_factory=dict)
    steps: int = 0

    def wants(self, layer: str) -> bool:
        """Whether curves of this layer are asked for; letters' case does not matter."""
        self.layers.setdefault(layer)
        return self.layer is None or layer.casefold() == self.layer.casefold()

    def add(self, curves: list[Curve]) -> None:
        self.curves.extend(curves)
        self.step()

    def step(self) -> None:
        """Counts one more thing read, which may be a copy without any curve."""
        self.steps += 1
        if max(len(self.curves), self.steps) > MOST_CURVES:
            raise FileError(
                f"{self.source}: more than {MOST_CURVES} curves, counting every copy of a block or symbol; "
                "this is no drawing of a section; export the outline alone"
            )

    def sheet(self, length_unit: str | None) -> Sheet:
        """All that was met. Raises FileError where the layer asked for does not exist."""
        known = [name.casefold() for name in self.layers]
        if self.layer is not None and self.layer.casefold() not in known:
            names = ", ".join(map(repr, self.layers)) or "none"
            raise FileError(f"{self.source}: there is no layer {self.layer!r} with curves; layers with some: {names}")
        return Sheet(
            curves=tuple(self.curves),
            passed_over=dict(self.passed_over),
            length_unit=length_unit,
            layers=tuple(self.layers),
        )


LARGEST_COORDINATE = 1e50
"""Beyond it the moments of third order would overflow; what is written so large is damaged."""


def samples(curves: tuple[Curve, ...], fractions: Array) -> Array:
    """Points (n, m, 2) of n curves at fractions (m,). Raises ValueError where some are out of all range."""
    with np.errstate(all="ignore"):
        points = points_along(curves, fractions)
    if not np.all(np.abs(points) <= LARGEST_COORDINATE):
        raise ValueError(f"it has coordinates that are no numbers or beyond {LARGEST_COORDINATE:g}")
    return points
