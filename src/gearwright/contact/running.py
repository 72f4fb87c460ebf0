"""How a bevel pair runs, in a few numbers: transmission error as designed and with the axes askew, lines of contact."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from ..parameters import Size
from .lines import lines_at
from .mesh import mesh_of
from .path import ContactPath
from .transmission import TransmissionError, transmission_error

SHAFT_ANGLE_ERROR = 0.1
"""By how much the shaft angle is taken to be larger than designed, degrees."""

OFFSET_ERROR = 0.01
"""How far apart the axes are taken to pass, in outer modules, to one digit of the length unit."""

ROUNDING = 1e-12
"""Radians: transmission errors below are none."""

_COUNTED = 120  # turns over a pitch at which lines of contact are measured
_MICRO = 1e6


@dataclass(frozen=True, kw_only=True)
class Errors:
    """Transmission errors as designed, at a larger shaft angle, and with axes that pass at a distance (length)."""

    designed: TransmissionError
    tilted: TransmissionError
    apart: TransmissionError
    offset: float


def errors_of(pair: BevelPair, samples: int = 48) -> Errors:
    """Of the driving side. Raises GeometryError where the pair does not run so."""
    offset = float(f"{OFFSET_ERROR * pair.pinion.outer_module:.1g}")
    return Errors(
        designed=transmission_error(pair, samples=samples),
        tilted=transmission_error(pair, shaft_angle_error=SHAFT_ANGLE_ERROR, samples=samples),
        apart=transmission_error(pair, offset_error=offset, samples=samples),
        offset=offset,
    )


@dataclass(frozen=True, kw_only=True)
class LineCount:
    """Length (n,) of all lines of contact together and how many teeth touch (n,), at turns (n,) in pitches."""

    turns: Array
    lengths: Array
    counts: Array


def lines_over_a_pitch(pair: BevelPair) -> LineCount:
    """Of the driving side, axes as designed."""
    path = ContactPath(mesh=mesh_of(pair))
    turns = (np.arange(_COUNTED) + 0.5) / _COUNTED
    found = [lines_at(path, turn * path.mesh.pitch, samples=9) for turn in turns]
    return LineCount(
        turns=turns,
        lengths=np.array([sum(line.length for line in lines) for lines in found]),
        counts=np.array([len({line.tooth for line in lines}) for lines in found], float),
    )


def running(pair: BevelPair) -> dict[str, Size]:
    """Sizes of a pair that come of its running; contact ratios are among its own. Raises GeometryError."""
    errors, lines = errors_of(pair), lines_over_a_pitch(pair)
    return {
        "transmission_error": _angle(errors.designed, "TE", "peak to peak, as designed"),
        "shaft_angle_error": Size(SHAFT_ANGLE_ERROR, "angle", "ΔΣ", "by which the shaft angle is larger"),
        "transmission_error_at_shaft_angle_error": _angle(errors.tilted, "TE_ΔΣ", "peak to peak"),
        "offset_error": Size(errors.offset, "length", "E", "distance of the axes"),
        "transmission_error_at_offset_error": _angle(errors.apart, "TE_E", "peak to peak"),
        "least_contact_length": Size(float(lines.lengths.min()), "length", "l_min", "of all lines of contact"),
        "greatest_contact_length": Size(float(lines.lengths.max()), "length", "l_max", "of all lines of contact"),
    }


def _angle(error: TransmissionError, symbol: str, meaning: str) -> Size:
    value = error.peak_to_peak if error.peak_to_peak > ROUNDING else 0.0
    return Size(_MICRO * value, "microradian", symbol, f"transmission error of the gear, {meaning}")
