"""A cam as arrays for its diagram."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...pictures.cam_diagram import Curve, Diagram, Disk, cam_diagram
from .findings import best_fixed, gain
from .followers import Contact, OscillatingFlatFace, OscillatingRoller, Roller
from .kinds import KINDS
from .profile import Profile
from .profile_checks import profile_of

if TYPE_CHECKING:
    from .cam import Cam

_POINTS = 2880  # over the turn
_SPARE = 0.12  # of the face's touched length that it is drawn longer, at each end


def draw(cam: Cam, path: Path) -> None:
    """The disk with its follower, and displacement, velocity, acceleration and pressure angle over the turn."""
    best, other, moment = best_fixed(cam), compared_profile(cam), shown_moment(cam)
    diagram = Diagram(
        title=f"Cam, {cam.description}",
        length_unit=cam.length_unit,
        disk=disk_of(cam, other, moment),
        angle=np.linspace(0.0, 360.0, _POINTS + 1),
        curves=_curves(cam, other),
        spans=[
            (float(np.degrees(segment.start)), float(np.degrees(segment.end)), step.kind)
            for segment, step in zip(cam.displacement.segments, cam.steps, strict=True)
        ],
        moment=float(np.degrees(moment)),
        other="" if best is None else f"least with a fixed law, {best.law}",
        notes=cam_notes(cam),
    )
    cam_diagram(diagram, path)


def compared_profile(cam: Cam) -> Profile | None:
    """The profile of the best cam with a fixed law, which a synthesis is compared with; None without one."""
    best = best_fixed(cam)
    if best is None:
        return None
    return profile_of(cam.follower, best.dimensions, cam.sense or "opposite", best.displacement)


def shown_moment(cam: Cam) -> float:
    """The cam angle (radians) at which the follower is drawn: the middle of its first move."""
    move = cam.displacement.moves[0]
    return (move.start + move.end) / 2.0


def _angles() -> Array:
    return np.linspace(0.0, 2.0 * np.pi, _POINTS + 1)


def _plane(points: NDArray[Any]) -> Array:
    """Complex numbers as points (..., 2)."""
    return np.stack([np.real(points), np.imag(points)], axis=-1)


def disk_of(cam: Cam, other: Profile | None, moment: float) -> Disk:
    """The disk, another one beside it if there is one, and the follower at a cam angle (radians)."""
    profile, follower = cam.traced, cam.traced.follower
    s, turned = profile.displacement.derivatives(moment), np.exp(1j * moment)
    contact = follower.contact(s)
    touched = (contact.support + 1j * contact.along) * contact.normal * turned
    pitch = None
    parts: dict[str, Any] = {}
    if isinstance(follower, Roller):
        angles = _angles()
        pitch = _plane(follower.centre(profile.displacement.derivatives(angles))[0] * np.exp(1j * angles))
        centre = complex(follower.centre(s)[0]) * turned
        end = (
            follower.pivot_distance * turned
            if isinstance(follower, OscillatingRoller)
            else centre + _stem(cam) * turned
        )
        parts = {"rollers": [(_plane(centre), follower.roller_radius)], "links": [_plane(np.array([centre, end]))]}
    else:
        parts = _face(cam, contact, turned)
    if KINDS[cam.follower].swings:
        parts["pivot"] = _plane(np.array(cam.dimensions["pivot_distance"] * turned))
    return Disk(
        outline=profile.points(_angles()),
        circles={"base circle": follower.base_radius},
        contact=_plane(touched),
        normal=_plane(contact.normal * turned),
        other=None if other is None else other.points(_angles()),
        pitch=pitch,
        bore=(cam.bore or 0.0) / 2.0,
        **parts,
    )


def _stem(cam: Cam) -> float:
    """How long a translating follower's stem is drawn."""
    return float(0.5 * np.abs(cam.traced.points(_angles())).max())


def _face(cam: Cam, contact: Contact, turned: complex) -> dict[str, Any]:
    """The face, the part of it that is touched, and what holds it."""
    follower = cam.traced.follower
    least, most = cam.traced.face or (0.0, 0.0)
    spare = _SPARE * (most - least)
    normal = complex(contact.normal) * turned
    if isinstance(follower, OscillatingFlatFace):
        pivot = follower.pivot_distance * turned
        origin, along = pivot + follower.offset * normal, -follower.sign * 1j * normal
        links = [np.array([pivot, origin]), np.array([origin, origin + least * along])]
        start = least - spare
    else:
        origin, along = float(contact.support) * normal, 1j * normal
        links = [np.array([origin, origin + _stem(cam) * normal])]
        start = least - spare
    return {
        "face": _plane(np.array([origin + start * along, origin + (most + spare) * along])),
        "used": _plane(np.array([origin + least * along, origin + most * along])),
        "links": [_plane(link) for link in links],
    }


def _curves(cam: Cam, other: Profile | None) -> list[Curve]:
    swings = KINDS[cam.follower].swings
    unit = "degrees" if swings else cam.length_unit
    rows = [(f"displacement\n{unit}", 0), ("velocity s′\n" + ("rad/rad" if swings else f"{unit}/rad"), 1)]
    rows.append(("acceleration s″\n" + ("rad/rad²" if swings else f"{unit}/rad²"), 2))
    scales = (np.degrees(1.0) if swings else 1.0, 1.0, 1.0)
    own = cam.displacement.derivatives(_inside())
    others = None if other is None else other.displacement.derivatives(_inside())
    found = [
        Curve(label=label, values=own[i] * scales[i], other=None if others is None else others[i] * scales[i])
        for label, i in rows
    ]
    limit = None if cam.optimum is None else cam.task.limits.pressure_angle
    return [
        *found,
        Curve(
            label="pressure angle\ndegrees",
            values=_pressure(cam.traced),
            other=None if other is None else _pressure(other),
            limit=None if limit is None else float(np.degrees(limit)),
        ),
    ]


def _inside() -> Array:
    """The angles with the last one just inside the turn."""
    return np.minimum(_angles(), np.nextafter(2.0 * np.pi, 0.0))


def _pressure(profile: Profile) -> Array:
    return np.degrees(np.arctan(np.abs(profile.contact(_inside()).pressure)))


def cam_notes(cam: Cam) -> list[str]:
    """Area, radii and eccentricity in words."""
    sizes, unit = cam.sizes(), cam.length_unit
    base, eccentricity = sizes["base_radius"].value, sizes["largest_eccentricity"].value
    lines = [
        f"area {sizes['disk_area'].value:.6g} {unit}²",
        f"base radius {base:.5g} {unit}",
        f"least radius of curvature {sizes['least_curvature_radius'].value:.4g} {unit}",
        f"largest eccentricity {eccentricity:.4g} {unit}, {eccentricity / base:.3g} × base radius",
    ]
    if "face_length" in sizes:
        lines.append(f"face touched over {sizes['face_length'].value:.4g} {unit}")
    saved = gain(cam)
    if saved is not None:
        lines[0] += f", {100.0 * saved:.1f} % less than with a fixed law"
    return lines
