"""Charts as plain values, for whoever draws them: knows arrays, not elements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from ..arrays import Array

Style = Literal["solid", "dashed", "points"]


@dataclass(frozen=True, kw_only=True)
class Axis:
    """What is along an axis, and its unit as a person reads it, "" for a number."""

    label: str
    unit: str = ""

    def to_dict(self) -> dict[str, str]:
        """Both by name."""
        return {"label": self.label, "unit": self.unit}


@dataclass(frozen=True, kw_only=True)
class Line:
    """A line through points x (n,), y (n,), with a gap where a value is not finite; or marks at them."""

    name: str
    x: Array
    y: Array
    style: Style = "solid"

    @classmethod
    def through(cls, name: str, points: Array, style: Style = "solid") -> Line:
        """The line through points (n, 2)."""
        return cls(name=name, x=points[:, 0], y=points[:, 1], style=style)

    def to_dict(self) -> dict[str, Any]:
        """All by name; what is not finite is None."""
        return {"name": self.name, "x": _plain(self.x), "y": _plain(self.y), "style": self.style}


@dataclass(frozen=True, kw_only=True)
class Chart:
    """Lines over two axes.

    equal   whether both axes have the same scale, as in drawings
    log     "both" where both axes are logarithmic
    notes   what a reader has to know
    window  (least x, greatest x, least y, greatest y) of what is looked at first; None for all
    """

    title: str
    x: Axis
    y: Axis
    lines: Sequence[Line]
    equal: bool = False
    log: Literal["none", "both"] = "none"
    notes: Sequence[str] = ()
    window: tuple[float, float, float, float] | None = None

    def to_dict(self) -> dict[str, Any]:
        """All by name as plain values."""
        return {
            "title": self.title,
            "x": self.x.to_dict(),
            "y": self.y.to_dict(),
            "equal": self.equal,
            "lines": [line.to_dict() for line in self.lines],
            "log": self.log,
            "notes": list(self.notes),
            "window": None if self.window is None else list(self.window),
        }


def _plain(values: Array) -> list[float | None]:
    finite = np.isfinite(values)
    return [float(value) if good else None for value, good in zip(values, finite, strict=True)]
