"""Tables for a person, in one style: how they are written, and numbers and units in them."""

from __future__ import annotations

import os
import shutil
import sys

from rich import box
from rich.console import Console, RenderableType
from rich.table import Table

WIDTH = 100
"""Columns of text that is not written to a terminal."""

_POWERS = {2: "²", 3: "³", 4: "⁴", 5: "⁵"}


def show(*renderables: RenderableType) -> None:
    """Writes tables and texts to stdout."""
    sys.stdout.write(shown(*renderables))


def shown(*renderables: RenderableType) -> str:
    """Tables and texts as they are written to stdout."""
    terminal = sys.stdout.isatty()
    console = Console(
        width=shutil.get_terminal_size((WIDTH, 24)).columns if terminal else WIDTH,
        highlight=False,
        no_color="NO_COLOR" in os.environ or not terminal,
    )
    # captured, so that a reader who leaves early is seen by the caller and not by rich
    with console.capture() as text:
        for renderable in renderables:
            console.print(renderable)
    return "\n".join(line.rstrip() for line in text.get().splitlines()) + "\n"


def plain_table(title: str) -> Table:
    """An empty table in the common style."""
    return Table(title=title, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD, pad_edge=False)


def number(value: float, digits: int = 10) -> str:
    """A number to so many significant digits."""
    return f"{value:.{digits}g}"


def power(unit: str, exponent: int) -> str:
    """A unit to a power: "mm³"."""
    return unit + _POWERS[exponent]
