"""A cam's disk and its follower's motion over one turn, as charts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...pictures.chart import Axis, Chart, Line
from ..outline_chart import circle, drawing_axes, outline
from .diagram import cam_notes, compared_profile, disk_of, shown_moment
from .followers import Contact
from .kinds import KINDS
from .profile import Profile

if TYPE_CHECKING:
    from .cam import Cam

_STEP = np.radians(0.25)
_FLAT = 5.0  # largest radii of the disk: what is flatter is drawn as a gap
_OTHER = "least with a fixed law"

Value = Callable[[Array, Contact], Array]
"""Of the displacement with its derivatives (4, n) and the contact, values (n,)."""


def profile(cam: Cam) -> Chart:
    """The disk with its base circle and pitch curve, and the follower in the middle of its first move."""
    other, moment = compared_profile(cam), shown_moment(cam)
    disk = disk_of(cam, other, moment)
    lines = [outline("profile", cam.profile), *(circle(name, radius) for name, radius in disk.circles.items())]
    if disk.pitch is not None:
        lines.append(Line.through("pitch curve", disk.pitch, "dashed"))
    if disk.other is not None:
        lines.append(Line.through(_OTHER, disk.other, "dashed"))
    gap = np.full((1, 2), np.nan)
    pieces = [*disk.links, *([] if disk.face is None else [disk.face])]
    rollers = [circle("follower", radius, centre, "solid") for centre, radius in disk.rollers]
    pieces += [np.stack([one.x, one.y], axis=-1) for one in rollers]
    lines.append(Line.through("follower", np.concatenate([part for piece in pieces for part in (piece, gap)][:-1])))
    lines.append(Line.through("contact", disk.contact[None], "points"))
    return Chart(
        title=f"Cam, {cam.description}",
        **drawing_axes(cam.length_unit),
        lines=lines,
        notes=[f"drawn at cam angle {np.degrees(moment):.4g}°", *cam_notes(cam)],
    )


def displacement(cam: Cam) -> Chart:
    """The follower's position over the cam angle."""
    scale = np.degrees(1.0) if KINDS[cam.follower].swings else 1.0
    return _over_turn(cam, "Displacement", Axis(label="displacement s", unit=_amount(cam)), lambda s, _: s[0] * scale)


def velocity(cam: Cam) -> Chart:
    """Its derivative by the cam angle in radians."""
    return _over_turn(cam, "Velocity", Axis(label="velocity s′", unit=f"{_in_radians(cam)}/rad"), lambda s, _: s[1])


def acceleration(cam: Cam) -> Chart:
    """Its second derivative by the cam angle in radians."""
    axis = Axis(label="acceleration s″", unit=f"{_in_radians(cam)}/rad²")
    return _over_turn(cam, "Acceleration", axis, lambda s, _: s[2])


def pressure_angle(cam: Cam) -> Chart:
    """Between the common normal and the way of the follower's point."""
    limit = None if cam.optimum is None else cam.task.limits.pressure_angle
    chart = _over_turn(
        cam,
        "Pressure angle",
        Axis(label="pressure angle", unit="°"),
        lambda _, contact: np.degrees(np.arctan(np.abs(contact.pressure))),
    )
    if limit is None:
        return chart
    line = Line(name="limit", x=np.array([0.0, 360.0]), y=np.full(2, np.degrees(limit)), style="dashed")
    return replace(chart, lines=[*chart.lines, line])


def curvature(cam: Cam) -> Chart:
    """Radius of curvature of the profile where it is touched; negative where it is hollow."""
    largest = _FLAT * cam.sizes()["largest_radius"].value

    def radius(_: Array, contact: Contact) -> Array:
        with np.errstate(divide="ignore"):
            found = contact.speed / contact.turning
        return np.where(np.abs(found) <= largest, found, np.nan)

    chart = _over_turn(cam, "Radius of curvature", Axis(label="radius of curvature ρ", unit=cam.length_unit), radius)
    note = f"negative where the profile is hollow; a gap where it is flatter than {largest:.3g} {cam.length_unit}"
    return replace(chart, notes=[note])


def _amount(cam: Cam) -> str:
    return "°" if KINDS[cam.follower].swings else cam.length_unit


def _in_radians(cam: Cam) -> str:
    return "rad" if KINDS[cam.follower].swings else cam.length_unit


def _over_turn(cam: Cam, title: str, axis: Axis, value: Value) -> Chart:
    other = compared_profile(cam)
    lines = [_line("this cam" if other else axis.label, cam.traced, value)]
    if other is not None:
        lines.append(replace(_line(_OTHER, other, value), style="dashed"))
    steps = [f"{step.kind} {step.angle:g}°" for step in cam.steps]
    return Chart(
        title=f"{title}, {cam.description}",
        x=Axis(label="cam angle ψ", unit="°"),
        y=axis,
        lines=lines,
        notes=["programme: " + ", ".join(steps)],
    )


def _line(name: str, traced: Profile, value: Value) -> Line:
    """Values over the turn, from both sides of where segments meet, so that steps are upright."""
    places, values = [], []
    for segment in traced.displacement.segments:
        for start, end in zip(segment.cuts, segment.cuts[1:], strict=False):
            angles = np.linspace(start, end, 2 + int((end - start) / _STEP))
            s = segment.derivatives(np.clip(angles, *_inside(start, end)))
            places.append(np.degrees(angles))
            values.append(value(s, traced.follower.contact(s)))
    return Line(name=name, x=np.concatenate(places), y=np.concatenate(values))


def _inside(start: float, end: float) -> tuple[float, float]:
    """The ends of a stretch, just inside it: laws that break there are taken from this side."""
    return float(np.nextafter(start, end)), float(np.nextafter(end, start))
