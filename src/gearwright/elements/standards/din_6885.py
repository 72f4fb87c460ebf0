"""Parallel keys of form A and their keyways by the diameter of the bore: DIN 6885-1, in millimetres."""

from __future__ import annotations

from dataclasses import dataclass

_TO_ROUNDING = 1e-9  # of a diameter: what was given in inches is not above a limit that it was meant to be


@dataclass(frozen=True, kw_only=True)
class ParallelKey:
    """Key and keyway for bores over one diameter, up to and including another; all in millimetres.

    width         b, of key and keyway
    height        h, of the key
    shaft_depth   t₁, of the keyway in the shaft
    hub_depth     t₂, of the keyway in the hub, from the bore to its floor
    """

    over: float
    up_to: float
    width: float
    height: float
    shaft_depth: float
    hub_depth: float


PARALLEL_KEYS = tuple(
    ParallelKey(over=over, up_to=up_to, width=b, height=h, shaft_depth=t1, hub_depth=t2)
    for over, up_to, b, h, t1, t2 in (
        (6, 8, 2, 2, 1.2, 1.0),
        (8, 10, 3, 3, 1.8, 1.4),
        (10, 12, 4, 4, 2.5, 1.8),
        (12, 17, 5, 5, 3.0, 2.3),
        (17, 22, 6, 6, 3.5, 2.8),
        (22, 30, 8, 7, 4.0, 3.3),
        (30, 38, 10, 8, 5.0, 3.3),
        (38, 44, 12, 8, 5.0, 3.3),
        (44, 50, 14, 9, 5.5, 3.8),
        (50, 58, 16, 10, 6.0, 4.3),
        (58, 65, 18, 11, 7.0, 4.4),
        (65, 75, 20, 12, 7.5, 4.9),
        (75, 85, 22, 14, 9.0, 5.4),
        (85, 95, 25, 14, 9.0, 5.4),
        (95, 110, 28, 16, 10.0, 6.4),
        (110, 130, 32, 18, 11.0, 7.4),
        (130, 150, 36, 20, 12.0, 8.4),
        (150, 170, 40, 22, 13.0, 9.4),
        (170, 200, 45, 25, 15.0, 10.4),
        (200, 230, 50, 28, 17.0, 11.4),
        (230, 260, 56, 32, 20.0, 12.4),
        (260, 290, 63, 32, 20.0, 12.4),
        (290, 330, 70, 36, 22.0, 14.4),
        (330, 380, 80, 40, 25.0, 15.4),
        (380, 440, 90, 45, 28.0, 17.4),
        (440, 500, 100, 50, 31.0, 19.5),
    )
)
LEAST_BORE, MOST_BORE = PARALLEL_KEYS[0].over, PARALLEL_KEYS[-1].up_to
"""Bores over the first, up to and including the second, have a key, mm."""


def parallel_key(bore: float) -> ParallelKey | None:
    """The key for a bore (mm); None where the standard has none. Source: DIN 6885-1."""
    if bore <= LEAST_BORE * (1.0 + _TO_ROUNDING):
        return None
    return next((key for key in PARALLEL_KEYS if bore <= key.up_to * (1.0 + _TO_ROUNDING)), None)
