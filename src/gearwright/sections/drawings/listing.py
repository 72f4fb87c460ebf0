"""How places and long lists are written in refusals of drawings."""

from __future__ import annotations

from collections.abc import Sequence

from ...arrays import Array
from ...errors import Problem

_MOST = 12
"""Places named in one refusal: more would bury the first."""


def place(point: Array) -> str:
    """A point as (x, y), to nine digits: enough to be found in any drawing."""
    return f"({point[0] + 0.0:.9g}, {point[1] + 0.0:.9g})"


def first_few(problems: Sequence[Problem]) -> list[Problem]:
    """The problems, or the first of them and how many there are besides."""
    rest = len(problems) - _MOST
    if rest <= 0:
        return list(problems)
    return [*problems[:_MOST], Problem(f"{rest} more", "of the same kinds; mend these first")]
