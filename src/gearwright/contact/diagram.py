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
from .running import SHAFT_ANGLE_ERROR, errors_of, lines_over_a_pitch
from .transmission import TransmissionError

_LINES = 4  # lines of one tooth a pitch


def draw(pair: BevelPair, path: Path) -> None:
    """Lines of contact on the pinion's flank, and the transmission error as designed and with axes askew.

    Raises FileError, MachineError; GeometryError where the pair does not run.
    """
    mesh, unit = mesh_of(pair), pair.length_unit
    errors, lines = errors_of(pair), lines_over_a_pitch(pair)
    apart = f"axes {errors.offset:g} {unit} apart"
    curves = {
        "as designed": errors.designed,
        f"shaft angle {SHAFT_ANGLE_ERROR:+g}°": errors.tilted,
        apart: errors.apart,
    }
    diagram = ContactDiagram(
        title=f"Contact of a bevel pair, {pair.description}",
        length_unit=unit,
        micrometres=1e3 * MILLIMETRES[unit],
        radius=pair.gear.pitch_radius,
        flank=_flank(mesh, errors.apart, f"touched with {apart}"),
        errors=[_curve(label, mesh, found) for label, found in curves.items()],
        turns=lines.turns,
        lengths=lines.lengths,
        counts=lines.counts,
        notes=_notes(pair, lines.lengths),
    )
    contact_diagram(diagram, path)


def _curve(label: str, mesh: Mesh, found: TransmissionError) -> ErrorCurve:
    return ErrorCurve(label=label, turns=found.pinion_turn / mesh.pitch, error=found.error)


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
