"""Tooth profiles and spiral angles of bevel gears, as charts.

A tooth's profile is shown as a drawing shows it: seen from the apex on the back cone through the mean cone distance,
which is developed into the plane. There the gear looks like a spur gear of z/cos δ teeth (Tredgold). At a polar angle
θ and an azimuth φ that is, for the pitch angle δ and the mean cone distance R,

    ρ = R tan δ + R tan(θ − δ),   angle φ cos δ about the developed cone's apex,

with the pitch point as origin and x up the tooth. A crown gear's cone has no apex; the formulas below keep their digits
there and beyond, since only ρ cos δ enters them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from ...arrays import Array
from ...pictures.chart import Axis, Chart, Line, Style
from ...sections.polylines import chords
from ..outline_chart import FINE
from .bevel_gear import BevelGear
from .bevel_pair import BevelPair

_PLACES = 129  # along a face, or of an arc
_MEMBER_TEETH = {False: (-1.0, 0.0, 1.0), True: (-1.5, -0.5, 0.5, 1.5)}
"""Teeth that are drawn, in pitches from the middle: of a pinion or single gear, and of its mate."""

_SEEN = """seen from the apex on the back cone at the mean cone distance, developed into the plane (Tredgold); \
heights from the pitch point"""
_HALF_TURN = -np.eye(2)


def profile(element: BevelGear | BevelPair) -> Chart:
    """Teeth on the developed back cone at the mean cone distance; of a pair in mesh, both cones touching."""
    members: dict[str, Any] = element.members if isinstance(element, BevelPair) else {"": element}
    unit = element.length_unit
    lines = [
        line for number, (name, gear) in enumerate(members.items()) for line in _member(name, gear, mate=number == 1)
    ]
    return Chart(
        title=f"Tooth profile on the mean back cone, {element.description}",
        x=Axis(label="across the tooth", unit=unit),
        y=Axis(label="height", unit=unit),
        equal=True,
        lines=lines,
        notes=[
            _SEEN,
            *(_virtual(name, gear) for name, gear in members.items()),
        ],
    )


def _virtual(name: str, gear: BevelGear) -> str:
    cosine = np.cos(gear.pitch_cone_angle)
    of = f"{name}: " if name else ""
    if abs(cosine) < 1e-9:
        return f"{of}a rack, since its pitch cone is flat"
    return f"{of}like a spur gear of {gear.teeth / cosine:.4g} teeth"


def _member(name: str, gear: BevelGear, *, mate: bool) -> list[Line]:
    """Some teeth of a gear, and its pitch, base, tip and root circles over them."""
    tooth, pitches = gear.bevel_teeth.mean, _MEMBER_TEETH[mate]
    step = 2.0 * np.pi / gear.teeth
    curves = tooth.outline().curves
    whole = [
        chords(curves, FINE * gear.mean_distance * 0.1, partial(_seen, gear, turned=place * step, mate=mate))
        for place in pitches
    ]
    reach = (pitches[0] - 0.5) * step, (pitches[-1] + 0.5) * step
    of = f", {name}" if name else ""
    angles = {
        "pitch circle": gear.pitch_cone_angle,
        "base circle": tooth.base_cone_angle if gear.tooth_form == "involute" else None,
        "tip circle": tooth.face_angle,
        "root circle": tooth.root_angle,
    }
    return [
        Line.through(name or "teeth", np.concatenate(whole)),
        *(
            _arc(label + of, gear, polar, reach, mate=mate)
            for label, polar in angles.items()
            if polar is not None and polar > 0.0
        ),
    ]


def _arc(
    label: str, gear: BevelGear, polar: float, reach: Sequence[float], *, mate: bool, style: Style = "dashed"
) -> Line:
    azimuth = np.linspace(reach[0], reach[1], _PLACES)
    return Line.through(label, developed(gear, np.full(_PLACES, polar), azimuth, mate=mate), style)


def _seen(gear: BevelGear, points: Array, turned: float, *, mate: bool) -> Array:
    """Points (n, 3) of the unit sphere, turned about the axis, as (n, 2) on the developed cone."""
    polar = np.arctan2(np.hypot(points[:, 0], points[:, 1]), points[:, 2])
    return developed(gear, polar, np.arctan2(points[:, 1], points[:, 0]) + turned, mate=mate)


def developed(gear: BevelGear, polar: Array, azimuth: Array, *, mate: bool = False) -> Array:
    """(n, 2) across the tooth and up it, of polar angles and azimuths (n,); those of a mate upside down."""
    distance, pitch = gear.mean_distance, gear.pitch_cone_angle
    cosine, up = float(np.cos(pitch)), distance * np.tan(polar - pitch)
    across = distance * np.sin(pitch) + up * cosine  # ρ cos δ
    half = azimuth * cosine / 2.0
    height = up - across * azimuth * np.sinc(half / np.pi) * np.sin(half)
    points = np.stack([across * azimuth * np.sinc(2.0 * half / np.pi), height], axis=-1)
    return points @ _HALF_TURN if mate else points


def spiral(element: BevelGear | BevelPair) -> Chart:
    """The spiral angle from toe to heel, and its values there and at the mean cone distance."""
    gear: Any = element.pinion if isinstance(element, BevelPair) else element
    places = np.array([gear.inner_distance, gear.mean_distance, gear.cone_distance])
    along = np.linspace(gear.inner_distance, gear.cone_distance, _PLACES)
    marks = np.degrees(gear.tooth_trace.spiral_angle(places))
    notes = ["straight teeth: no spiral angle anywhere"] if gear.trace == "straight" else [_hands(element)]
    return Chart(
        title=f"Spiral angle along the face, {element.description}",
        x=Axis(label="cone distance R", unit=element.length_unit),
        y=Axis(label="spiral angle β", unit="°"),
        lines=[
            Line(name=f"{gear.trace} trace", x=along, y=np.degrees(gear.tooth_trace.spiral_angle(along))),
            Line(name="toe, mean cone distance, heel", x=places, y=marks, style="points"),
        ],
        notes=[*notes, f"toe {marks[0]:.5g}°, mean cone distance {marks[1]:.5g}°, heel {marks[2]:.5g}°"],
    )


def _hands(element: BevelGear | BevelPair) -> str:
    if isinstance(element, BevelPair):
        return f"the pinion is {element.pinion.hand}-hand, the gear {element.gear.hand}-hand, with the same angles"
    return f"{element.hand}-hand"
