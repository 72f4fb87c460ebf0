"""Plots as PNG or SVG files, in one look."""

from __future__ import annotations

import os
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..disk import written_whole
from ..errors import FileError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SUFFIXES = (".png", ".svg")

INK, QUIET, GRID = "#20262d", "#66707b", "#d9dee3"
"""Colours of text and lines, of what is less important, and of grids."""

_LOOK: dict[Any, Any] = {
    "font.size": 12.0,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.titleweight": "bold",
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "svg.fonttype": "path",
    "svg.hashsalt": "gearwright",  # the same drawing gives the same file
}


def write_plot(path: str | os.PathLike[str], draw: Callable[[], Figure]) -> None:
    """Writes what is drawn, in the common look, into a PNG or SVG file, which appears complete or not at all.

    Raises FileError if the suffix is another or there is no folder, MachineError if the disk refuses.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FileError(f"{path}: plots are written as PNG or SVG; end the name in {' or '.join(SUFFIXES)}")
    if not path.parent.is_dir():
        raise FileError(f"{path}: there is no folder {path.parent}; make it first")
    drawn = _file(draw, suffix[1:])
    with written_whole(path) as stream:
        stream.write(drawn)


def _file(draw: Callable[[], Figure], kind: str) -> bytes:
    """The file. matplotlib loads here, when something is really drawn."""
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    with mpl.rc_context(_LOOK):
        figure = draw()
        FigureCanvasAgg(figure)
        file = BytesIO()
        metadata = {"Software": None} if kind == "png" else {"Date": None, "Creator": None}
        figure.savefig(file, format=kind, metadata=metadata)
    return file.getvalue()
