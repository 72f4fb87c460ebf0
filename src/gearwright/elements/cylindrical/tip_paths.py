"""How deep the tips of one member cut into the other while they run: interference of every kind."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from .external_tooth import ExternalTooth
from .flank import Flank
from .internal_tooth import InternalTooth
from .mesh import GearMesh, Mesh, RackMesh

_BEYOND = 5  # points of a relieved part or a chamfer that are followed
_SAMPLES = 2001  # positions of a tip while it is inside the other's teeth


def cut_depths(mesh: Mesh) -> tuple[float, float]:
    """Depth (length) to which the mate's tips cut into the pinion, and the pinion's into the mate; ≤ 0 is none.

    The corners of one member's tips are followed through the other's teeth, on the whole way that they are within
    its tip circle, not along the line of action only: that covers contact below the involute's beginning, tips
    that cut into fillets, and tips of internal pairs that meet outside the path of contact.
    """
    if isinstance(mesh, RackMesh):
        return _rack_into_pinion(mesh), _pinion_into_rack(mesh)
    if not isinstance(mesh, GearMesh):
        raise TypeError(f"no way of tips is known in a {type(mesh).__name__}")
    one, other, distance = mesh.pinion, mesh.gear, mesh.centre_distance
    if isinstance(other, InternalTooth):
        return _into(one, other.flank, -distance, 1), _into(other, one.flank, distance, 1)
    return _into(one, other.flank, distance, -1), _into(other, one.flank, distance, -1)


def _into(member: ExternalTooth | InternalTooth, mate: Flank, distance: float, sense: int) -> float:
    """Depth to which a mate's tips cut into a member on the origin.

    distance   to the mate's axis, along +x
    sense      of the mate's turning when the member turns counter-clockwise
    """
    own, other = member.toothing, mate.toothing
    facing = np.pi if sense < 0 else 0.0
    deepest = -np.inf
    for radius, half in _corners(mate):
        ways = _ways(distance * np.cos(facing), radius, own.tip_radius)
        azimuth = facing + ways
        place = np.stack([distance + radius * np.cos(azimuth), radius * np.sin(azimuth)], axis=-1)
        tooth = ways - half  # the mate's tooth, from where it points at the middle of a space
        turned = sense * tooth * other.teeth / own.teeth + np.pi / own.teeth
        deepest = max(deepest, _depth_in_gear(member, place, turned))
    return deepest


def _corners(flank: Flank) -> list[tuple[float, float]]:
    """Radii and half angles of where the involute ends on one side of a tooth, and of the relief and chamfer beyond.

    The other side is their mirror image.
    """
    toothing, (involute, *beyond) = flank.toothing, flank.curves()
    fractions = np.linspace(0.0, 1.0, _BEYOND)
    points = np.array([involute.end, *(p for curve in beyond for p in curve.point(curve.parameter(fractions)))])
    radii, halves = np.hypot(points[:, 0], points[:, 1]), -np.arctan2(points[:, 1], points[:, 0])
    if toothing.internal:
        halves = np.pi / toothing.teeth - halves
    return list(zip(radii.tolist(), halves.tolist(), strict=True))


def _ways(distance: float, radius: float, tip: float) -> Array:
    """Angles of a corner about its own axis, from where it faces the other member, while it is inside its tip circle.

    distance   from the corner's axis to the member's, away from where they face each other if negative
    tip        the member's tip radius; an internal gear's teeth are outside it
    """
    cosine = (tip**2 - distance**2 - radius**2) / (2.0 * distance * radius)
    most = float(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return np.linspace(-most, most, _SAMPLES)


def _depth_in_gear(member: ExternalTooth | InternalTooth, place: Array, turned: Array) -> float:
    """Greatest depth of places (n, 2) in a tooth, the member turned by angles (n,)."""
    toothing = member.toothing
    radius = np.hypot(place[:, 0], place[:, 1])
    low, high = sorted((toothing.root_radius, toothing.tip_radius))
    inside = (radius >= low) & (radius <= high)
    if not inside.any():
        return -np.inf
    pitch = 2.0 * np.pi / toothing.teeth
    off = np.arctan2(place[inside, 1], place[inside, 0]) - turned[inside]
    off = np.abs(off - pitch * np.round(off / pitch))
    return float(np.max((member.half_angle(radius[inside]) - off) * radius[inside]))


def _rack_into_pinion(mesh: RackMesh) -> float:
    """The rack's corners in the pinion: the rack moves along +y as the pinion turns."""
    toothing, rack = mesh.pinion.toothing, mesh.rack
    level = mesh.centre_distance - rack.addendum
    most = float(np.sqrt(max(0.0, toothing.tip_radius**2 - level**2)))
    height = np.linspace(-most, most, _SAMPLES)
    place = np.stack([np.full(_SAMPLES, level), height], axis=-1)
    turned = (height - rack.tip_half) / toothing.pitch_radius + np.pi / toothing.teeth
    return _depth_in_gear(mesh.pinion, place, turned)


def _pinion_into_rack(mesh: RackMesh) -> float:
    """The pinion's corners in the rack."""
    toothing, rack = mesh.pinion.toothing, mesh.rack
    deepest = -np.inf
    for radius, half in _corners(mesh.pinion.flank):
        nearest = (mesh.centre_distance - rack.addendum) / radius
        most = float(np.arccos(np.clip(nearest, -1.0, 1.0)))
        azimuth = np.linspace(-most, most, _SAMPLES)
        above = mesh.centre_distance - radius * np.cos(azimuth)
        inside = (above >= -rack.dedendum) & (above <= rack.addendum)
        space = toothing.pitch_radius * (azimuth - half)  # the rack's space that faces the pinion's tooth
        off = radius * np.sin(azimuth) - space - rack.circular_pitch / 2.0
        off = np.abs(off - rack.circular_pitch * np.round(off / rack.circular_pitch))
        deeper = (rack.half_at(above) - off)[inside]
        deepest = max(deepest, float(np.max(deeper, initial=-np.inf)))
    return deepest
