"""Transverse profiles of gears and racks, alone and in mesh, as charts."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ...pictures.chart import Chart, Line
from ..outline_chart import circle, drawing_axes, outline
from .gear_pair import GearPair
from .mesh import Mesh
from .rack import Rack

_EQUAL = 1e-9  # of a radius: circles closer than that are one
_SHOWN = 1.7  # pitches to each side of the pitch point


def profile(element: Any) -> Chart:
    """Outlines with their pitch, base, tip and root circles; of a pair in mesh with the path of contact."""
    axes = drawing_axes(element.length_unit)
    if not isinstance(element, GearPair):
        lines = _member("", element, np.eye(4))
        return Chart(title=f"Transverse profile, {element.description}", **axes, lines=lines, notes=_notes(element))
    placements = element.placements()
    mesh = element.mesh
    members = {"pinion": element.pinion, "gear" if element.kind != "rack" else "rack": element.gear}
    lines = [
        line
        for (name, member), placement in zip(members.items(), placements, strict=True)
        for line in _member(name, member, placement, _working_radius(mesh, name))
    ]
    return Chart(
        title=f"Transverse profile in mesh, {element.description}",
        **axes,
        lines=[*lines, path_of_contact(mesh)],
        window=_around_the_pitch_point(mesh),
        notes=[_contact_note(mesh, element.length_unit), *_notes(element.pinion)],
    )


def _around_the_pitch_point(mesh: Mesh) -> tuple[float, float, float, float]:
    """Some three teeth of both members where they mesh."""
    pitch, middle = mesh.pinion.toothing.circular_pitch, mesh.working_radius
    return middle - _SHOWN * pitch, middle + _SHOWN * pitch, -_SHOWN * pitch, _SHOWN * pitch


def _contact_note(mesh: Mesh, length_unit: str) -> str:
    length = max(0.0, mesh.path[1] - mesh.path[0])
    return (
        f"path of contact {length:.5g} {length_unit} long, transverse contact ratio {mesh.contact_ratio:.4g},"
        " for a pinion that turns counter-clockwise"
    )


def _working_radius(mesh: Mesh, name: str) -> float | None:
    """Radius of a member's working pitch circle."""
    if name == "pinion":
        return mesh.working_radius
    gear = getattr(mesh, "gear", None)
    return None if gear is None else float(gear.toothing.base_radius / np.cos(mesh.working_pressure_angle))


def path_of_contact(mesh: Mesh) -> Line:
    """The part of the line of action where flanks touch, the pinion's axis at the origin and its mate's on x.

    From where the line touches the base circle, at r_b (cos α, −sin α), contact goes along (sin α, cos α).
    """
    angle, base = mesh.working_pressure_angle, mesh.pinion.toothing.base_radius
    sine, cosine = np.sin(angle), np.cos(angle)
    start, direction = base * np.array([cosine, -sine]), np.array([sine, cosine])
    ends = np.array(mesh.path if mesh.path[1] > mesh.path[0] else (mesh.path[0], mesh.path[0]))
    return Line.through("path of contact", start + ends[:, None] * direction)


def _member(name: str, member: Any, placement: Array, working_radius: float | None = None) -> list[Line]:
    """The outline of a member and its circles, or a rack's lines."""
    of = f", {name}" if name else ""
    body = outline(name or "profile", member.profile, placement)
    if isinstance(member, Rack):
        return [body, *_levels(member, placement, of)]
    toothing, centre = member.toothing, placement[:2, 3]
    radii = {
        "pitch circle d": toothing.pitch_radius,
        "working pitch circle d_w": working_radius,
        "base circle d_b": toothing.base_radius,
        "tip circle d_a": toothing.tip_radius,
        "root circle d_f": toothing.root_radius,
    }
    pitch = toothing.pitch_radius
    if working_radius is not None and abs(working_radius - pitch) <= _EQUAL * pitch:
        del radii["working pitch circle d_w"]
    return [body, *(circle(label + of, radius, centre) for label, radius in radii.items() if radius is not None)]


def _levels(rack: Rack, placement: Array, of: str) -> list[Line]:
    """Pitch, tip and root line of a rack."""
    tooth = rack.tooth
    ends = np.array([-0.5, rack.teeth - 0.5]) * tooth.circular_pitch
    heights = {"pitch line": 0.0, "tip line": tooth.addendum, "root line": -tooth.dedendum}
    return [
        Line.through(
            label + of,
            np.stack([np.full(2, height), ends], axis=-1) @ placement[:2, :2].T + placement[:2, 3],
            "dashed",
        )
        for label, height in heights.items()
    ]


def _notes(member: Any) -> list[str]:
    """Of what the section is."""
    if not member.helix.angle:
        return []
    return [f"transverse section at z = 0; helix angle {np.degrees(member.helix.angle):.4g}°"]
