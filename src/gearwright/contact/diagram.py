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
_POINTS = 65  # of an edge of a flank
_NO_HEIGHT = 1e-6  # radians: what cannot be told apart in a picture


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
        flank=flank_of(mesh, errors.apart, f"touched with {apart}"),
        errors=[_curve(label, mesh, found) for label, found in curves.items()],
        turns=lines.turns,
        lengths=lines.lengths,
        counts=lines.counts,
        notes=contact_notes(pair, lines.lengths),
    )
    contact_diagram(diagram, path)


def _curve(label: str, mesh: Mesh, found: TransmissionError) -> ErrorCurve:
    return ErrorCurve(label=label, turns=found.pinion_turn / mesh.pitch, error=found.error)


def flank_of(mesh: Mesh, askew: TransmissionError, touched_label: str) -> Flank:
    """The pinion's driving flank developed, with lines of contact and where it is touched when the axes are askew."""
    path, pinion = ContactPath(mesh=mesh), mesh.pinion
    lines, turns = [], []
    for step in range(_LINES):
        for line in lines_at(path, step / _LINES * mesh.pitch):
            lines.append(_developed(pinion, line.distance, line.polar))
            turns.append(line.tooth + step / _LINES)
    return Flank(
        outline=_outline(pinion),
        active=_lowest_touched(path),
        pitch=_developed(pinion, pinion.pitch_ends, np.full(2, pinion.pitch_angle)),
        lines=lines,
        turns=turns,
        touched=_developed(pinion, askew.distance, askew.polar),
        touched_label=touched_label,
    )


def _outline(member: Member) -> Array:
    """The flank developed (n, 2): along the foot, up the outer end, back along the tip, down the inner end."""
    along, up = np.linspace(member.inner, member.outer, _POINTS), np.linspace(0.0, 1.0, _POINTS)
    level = np.concatenate([along, np.full(_POINTS, member.outer), along[::-1], np.full(_POINTS, member.inner)])
    share = np.concatenate([np.zeros(_POINTS), up, np.ones(_POINTS), up[::-1]])
    form, face = member.flank.form_angle(level), member.flank.face_angle(level)
    polar = form + share * (face - form)
    return _developed(member, member.distance(polar, level), polar)


def _lowest_touched(path: ContactPath) -> Array | None:
    """The line (n, 2) below which the mate does not reach, unless that is the foot of the flank."""
    pinion = path.mesh.pinion
    distance = np.linspace(*pinion.reach, _POINTS)
    lowest, _ = path.active(distance)
    level = pinion.level(lowest, distance)
    there = (level >= pinion.inner) & (level <= pinion.outer)
    if not np.any(lowest[there] > pinion.flank.form_angle(level[there]) + _NO_HEIGHT):
        return None
    return _developed(pinion, distance[there], lowest[there])


def _developed(member: Member, distance: Array, polar: Array) -> Array:
    """Points (n, 2): cone distance, and height r (δ − γ) along the sphere above the pitch cone."""
    return np.stack([distance, distance * (polar - member.pitch_angle)], axis=-1)


def contact_notes(pair: BevelPair, lengths: Array) -> list[str]:
    """Contact ratios and lengths (n,) of the lines in words, and what the errors are of."""
    ratios, unit = contact_ratios(pair), pair.length_unit
    said = f"contact ratio {ratios.transverse:.4g} at mid-face"
    if ratios.overlap:
        said += f", overlap {ratios.overlap:.4g}, in all {ratios.total:.4g}"
    return [
        said,
        f"lines of contact together {lengths.min():.4g} to {lengths.max():.4g} {unit} long{_of_the_forms(pair)}",
        "errors of true flanks without load, about their mean: the play is left out",
    ]


def _of_the_forms(pair: BevelPair) -> str:
    """What is to be said of the lines where the teeth are not conjugate as they are."""
    gears = (pair.pinion, pair.gear)
    if pair.pinion.tooth_form != pair.gear.tooth_form:
        return ",\nwere the gear's teeth of the pinion's form"
    if any(gear.tip_relief or gear.crowning for gear in gears):
        return ",\nwere there no relief or crowning"
    return ""
