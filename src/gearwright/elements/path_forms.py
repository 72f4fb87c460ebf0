"""Paths in space as parameters: the name of a file of points, the points themselves, or a table of a helix."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..curves.helix import helix
from ..curves.path import Path, path_through
from ..curves.path_file import path_from_file
from ..parameters import FileName, Parameter, Points, Table, entry

_HELIX = Table(
    entries=(
        entry("radius", Parameter(meaning="radius of the centre line", unit="length", above=0)),
        entry("pitch", Parameter(meaning="rise of each turn", unit="length", minimum=0)),
        entry("turns", Parameter(meaning="number of turns", above=0, maximum=100), default=1.0),
        entry(
            "hand", Parameter(meaning="hand of the helix", kind="choice", choices=("right", "left")), default="right"
        ),
    )
)

PATH = Parameter(
    meaning="path in space of the section's origin: a CSV file of points x, y, z",
    kind="form",
    symbol="c",
    forms=(
        FileName(suffixes=(".csv",)),
        Points(coordinates=("x", "y", "z"), least=2),
        Table(entries=(entry("helix", Parameter(meaning="a helix about z, upwards", kind="form", forms=(_HELIX,))),)),
    ),
)


def path_given(given: str | Sequence[Any] | Mapping[str, Any]) -> Path:
    """The path that a sound value of PATH gives. Raises ProblemsError, FileError, MachineError."""
    if isinstance(given, str):
        return path_from_file(given)
    if isinstance(given, Mapping):
        return helix(**given["helix"])
    return path_through(given)
