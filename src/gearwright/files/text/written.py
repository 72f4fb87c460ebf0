"""Text out: rows of numbers, and names that every format can hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...arrays import Array, Indices

_BLOCK = 1 << 15
"""Rows at a time: one formatting of many numbers is several times faster than many of one."""


def rows(template: str, table: Array | Indices) -> Iterator[bytes]:
    """The rows of a table (n, k), each by a template such as "%r %r %r\\n", a block of rows at a time.

    %r of float64 gives the fewest digits that stand for the same number.
    """
    for start in range(0, len(table), _BLOCK):
        block = table[start : start + _BLOCK]
        yield (template * len(block) % tuple(block.reshape(-1).tolist())).encode("ascii")


def one_line(name: str) -> str:
    """A name without line ends, control characters and backslashes, which join lines; "?" stands for each."""
    visible = "".join(c if c.isprintable() and c != "\\" else " " if c.isspace() else "?" for c in name)
    return " ".join(visible.split())


def distinct_lines(names: Iterable[str]) -> list[str]:
    """Names of one line each, made different by a number where several would be one."""
    found: dict[str, None] = {}
    for name in names:
        line, number = one_line(name), 1
        while (numbered := line if number == 1 else f"{line} ({number})") in found:
            number += 1
        found[numbered] = None
    return list(found)
