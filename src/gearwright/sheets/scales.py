"""Scales of drawings. Source: ISO 5455: 1, 2 and 5 times powers of ten, enlarging or reducing."""

from __future__ import annotations

from collections.abc import Iterator

from ..parameters import MILLIMETRES

_POWERS = range(6, -9, -1)


def scales() -> Iterator[float]:
    """All of them, the largest first."""
    for power in _POWERS:
        for step in (5.0, 2.0, 1.0):
            yield step * 10.0**power if power >= 0 else 1.0 / round(10.0**-power / step)


def in_words(scale: float) -> str:
    """As a title block has it: "2:1", "1:5"."""
    return f"{scale:.6g}:1" if scale >= 1.0 else f"1:{1.0 / scale:.6g}"


def on_paper(scale: float, length_unit: str) -> float:
    """Millimetres on paper for each length unit of the part."""
    return scale * MILLIMETRES[length_unit]
