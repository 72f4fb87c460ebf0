"""A bevel pair's contact as arrays for its diagram."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from ..parameters import MILLIMETRES
from ..pictures.contact_diagram import ContactDiagram, ErrorCurve, Flank, contact_diagram
from .lines import contact_ratios, lines_at
from .mesh import Member, Mesh, mesh_of
from .path import ContactPath
from .transmission import TransmissionError, transmission_error

SHAFT_ANGLE_ERROR = 0.1
"""Degrees added to the shaft angle in the diagram."""

OFFSET_ERROR = 0.01
"""Distance of the axes in the diagram, in outer modules, to two digits."""

_SAMPLES = 48  # turns over a pitch for errors
_LINES = 4  # lines of one tooth a pitch
_COUNTED = 120  # turns over a pitch for lengths


def draw(pair: BevelPair, path: Path) -> None:
    """Lines of contact on the pinion's flank, and the transmission error as designed and with axes askew.

    Raises FileError, MachineError; GeometryError where the pair does not run.
    """
    mesh, unit = mesh_of(pair), pair.length_unit
    offset = float(f"{OFFSET_ERROR * pair.pinion.outer_module:.1g}")
    askew = transmission_error(pair, offset_error=offset, samples=_SAMPLES)
    errors = {
        "as designed": transmission_error(pair, samples=_SAMPLES),
        f"shaft angle {SHAFT_ANGLE_ERROR:+g}°": transmission_error(
            pair, shaft_angle_error=SHAFT_ANGLE_ERROR, samples=_SAMPLES
        ),
        f"axes {offset:g} {unit} apart": askew,
    }
    turns = (np.arange(_COUNTED) + 0.5) / _COUNTED
    lengths, counts = _lines_over_a_pitch(ContactPath(mesh=mesh), turns)
    diagram = ContactDiagram(
        title=f"Contact of a bevel pair, {pair.description}",
        length_unit=unit,
        micrometres=1e3 * MILLIMETRES[unit],
        radius=pair.gear.pitch_radius,
        flank=_flank(mesh, askew, f"touched with axes {offset:g} {unit} apart"),
        errors=[_curve(label, mesh, found) for label, found in errors.items()],
        turns=turns,
        lengths=lengths,
        counts=counts,
        notes=_notes(pair, lengths),
    )
    contact_diagram(diagram, path)


def _curve(label: str, mesh: Mesh, found: TransmissionError) -> ErrorCurve:
    return ErrorCurve(label=label, turns=found.pinion_turn / mesh.pitch, error=found.error)


def _lines_over_a_pitch(path: ContactPath, turns: Array) -> tuple[Array, Array]:
    """Length of all lines together, and how many teeth touch, at turns in pitches."""
    found = [lines_at(path, turn * path.mesh.pitch, samples=9) for turn in turns]
    lengths = np.array([sum(line.length for line in lines) for lines in found])
    return lengths, np.array([len({line.tooth for line in lines}) for lines in found])


def _flank(mesh: Mesh, askew: TransmissionError, touched_label: str) -> Flank:
    path, pinion = ContactPath(mesh=mesh), mesh.pinion
    form, tip = pinion.flank.form_angle, pinion.flank.face_angle
    ends = np.array([pinion.inner, pinion.outer])
    corners = _developed(pinion, ends[[0, 1, 1, 0, 0]], np.array([form, form, tip, tip, form]))
    lowest = path.active[0]
    lines, turns = [], []
    for step in range(_LINES):
        for line in lines_at(path, step / _LINES * mesh.pitch):
            lines.append(_developed(pinion, line.distance, line.polar))
            turns.append(line.tooth + step / _LINES)
    return Flank(
        outline=corners,
        active=_developed(pinion, ends, np.full(2, lowest)) if lowest > form + 1e-6 else None,
        pitch=_developed(pinion, ends, np.full(2, pinion.pitch_angle)),
        lines=lines,
        turns=turns,
        touched=_developed(pinion, askew.distance, askew.polar),
        touched_label=touched_label,
    )


def _developed(member: Member, distance: Array, polar: Array) -> Array:
    """Points (n, 2): cone distance, and height r (δ − γ) along the sphere above the pitch cone."""
    return np.stack([distance, distance * (polar - member.pitch_angle)], axis=-1)


def _notes(pair: BevelPair, lengths: Array) -> list[str]:
    ratios, unit = contact_ratios(pair), pair.length_unit
    said = f"contact ratio {ratios.transverse:.4g}"
    if ratios.overlap:
        said += f" on a sphere, overlap {ratios.overlap:.4g}, in all {ratios.total:.4g}"
    return [
        said,
        f"lines of contact together {lengths.min():.4g} to {lengths.max():.4g} {unit} long",
        "errors of true flanks without load, about their mean: the play is left out",
    ]
