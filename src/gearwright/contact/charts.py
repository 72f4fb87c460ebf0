"""How a bevel pair runs, as charts: what its diagram shows, one thing at a time."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from ..pictures.chart import Axis, Chart, Line, Style
from .diagram import contact_notes, flank_of
from .mesh import mesh_of
from .running import ROUNDING, SHAFT_ANGLE_ERROR, errors_of, lines_over_a_pitch
from .transmission import TransmissionError

_MICRO = 1e6
_TURN = Axis(label="turn of the pinion", unit="pitches")


def errors(pair: BevelPair) -> Chart:
    """Transmission error over two pitches, as designed and with axes askew. Raises GeometryError."""
    found, pitch = errors_of(pair), mesh_of(pair).pitch
    curves: dict[str, tuple[TransmissionError, Style]] = {
        "as designed": (found.designed, "solid"),
        f"shaft angle {SHAFT_ANGLE_ERROR:+g}°": (found.tilted, "dashed"),
        f"axes {found.offset:g} {pair.length_unit} apart": (found.apart, "solid"),
    }
    return Chart(
        title=f"Transmission error, {pair.description}",
        x=_TURN,
        y=Axis(label="error of the driven gear", unit="µrad"),
        lines=[_error(label, error, pitch, style) for label, (error, style) in curves.items()],
        notes=["errors of true flanks without load, about their mean: the play is left out"],
    )


def _error(label: str, found: TransmissionError, pitch: float, style: Style) -> Line:
    """The error over two pitches, named with its range."""
    none = found.peak_to_peak <= ROUNDING
    values = np.zeros_like(found.error) if none else _MICRO * found.error
    said = "none" if none else f"{_MICRO * found.peak_to_peak:.4g} µrad peak to peak"
    turns = found.pinion_turn / pitch
    return Line(
        name=f"{label}: {said}",
        x=np.concatenate([turns, turns + 1.0, turns[:1] + 2.0]),
        y=np.concatenate([values, values, values[:1]]),
        style=style,
    )


def lengths(pair: BevelPair) -> Chart:
    """Length of all lines of contact together over two pitches, axes as designed. Raises GeometryError."""
    found = lines_over_a_pitch(pair)
    least, most = int(found.counts.min()), int(found.counts.max())
    return Chart(
        title=f"Length of the lines of contact, {pair.description}",
        x=_TURN,
        y=Axis(label="length of all lines together", unit=pair.length_unit),
        lines=[
            Line(
                name="all lines of contact",
                x=np.concatenate([found.turns, found.turns + 1.0]),
                y=np.concatenate([found.lengths, found.lengths]),
            )
        ],
        notes=[
            f"{least} to {most} teeth touch" if most > least else f"{most} teeth touch",
            *_notes(pair, found.lengths),
        ],
    )


def contact_lines(pair: BevelPair) -> Chart:
    """The pinion's driving flank developed, with lines of contact a quarter of a pitch apart. Raises GeometryError."""
    found, unit = errors_of(pair), pair.length_unit
    flank = flank_of(mesh_of(pair), found.apart, f"touched with axes {found.offset:g} {unit} apart")
    gap = np.full((1, 2), np.nan)
    touching = np.concatenate([part for line in flank.lines for part in (line, gap)][:-1])
    lines = [
        Line.through("flank", flank.outline),
        Line.through("pitch line", flank.pitch, "dashed"),
        Line.through("lines of contact, a quarter of a pitch apart", touching),
        Line.through(flank.touched_label, flank.touched, "points"),
    ]
    if flank.active is not None:
        lines.insert(2, Line.through("end of the active flank", flank.active, "dashed"))
    return Chart(
        title=f"Lines of contact on the pinion's driving flank, {pair.description}",
        x=Axis(label="cone distance", unit=unit),
        y=Axis(label="height above pitch cone", unit=unit),
        equal=True,
        lines=lines,
        notes=_notes(pair, lines_over_a_pitch(pair).lengths),
    )


def _notes(pair: BevelPair, lengths: Array) -> list[str]:
    """The notes of the diagram but for the last one, on errors; each in one line."""
    return [note.replace("\n", " ") for note in contact_notes(pair, lengths)[:-1]]
