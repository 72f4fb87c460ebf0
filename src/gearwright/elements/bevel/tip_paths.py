"""How deep the tips of one bevel gear cut into its mate while they run: interference of every kind."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from .meshing import seat
from .tooth import BevelTooth

_SAMPLES = 2001  # positions of a tip while it is inside the other's teeth


def cut_depth(member: BevelTooth, mate: BevelTooth, shaft_angle: float) -> float:
    """Depth (radians on the unit sphere) to which a mate's tips cut into a member; ≤ 0 is none.

    The ends of the mate's flank are followed through the member's teeth, fillets and roots included, on the whole way
    that they are within its face cone, not along the line of action only. Depths into flanks and fillets are along
    the circle about the member's axis. Flanks of two forms part from each other all the way to the tips, so that
    these cut deepest there too.
    """
    return max(_depth(member, mate, shaft_angle, polar, half) for polar, half in _corners(mate))


def _corners(tooth: BevelTooth) -> list[tuple[float, float]]:
    """Polar angles and half angles of the tip and, with relief, of where it begins; the other side mirrors them."""
    corners = [(tooth.face_angle, tooth.tip_half)]
    if tooth.relief is not None:
        corners.append((tooth.relief.begin, float(tooth.half_angle(tooth.relief.begin))))
    return corners


def _depth(member: BevelTooth, mate: BevelTooth, shaft_angle: float, polar: float, half: float) -> float:
    azimuth = _ways(shaft_angle, polar, member.face_angle)
    s, c = np.sin(polar), np.cos(polar)
    own = np.stack([s * np.cos(azimuth), s * np.sin(azimuth), np.full_like(azimuth, c)], axis=-1)
    place = own @ seat(shaft_angle).T
    tooth = azimuth - half  # the mate's tooth; where it is on +x a space of the member faces it
    turned = (np.pi / member.teeth) - tooth * mate.teeth / member.teeth
    theta = np.arctan2(np.hypot(place[:, 0], place[:, 1]), place[:, 2])
    inside = theta <= member.face_angle
    if not inside.any():
        return -np.inf
    pitch = 2.0 * np.pi / member.teeth
    off = np.arctan2(place[inside, 1], place[inside, 0]) - turned[inside]
    off = np.abs(off - pitch * np.round(off / pitch))
    theta = theta[inside]
    in_tooth = (member.profile_half(np.maximum(theta, member.root_angle)) - off) * np.sin(theta)
    return float(np.max(np.maximum(in_tooth, member.root_angle - theta)))


def _ways(shaft_angle: float, polar: float, face: float) -> Array:
    """Azimuths of a corner about its own axis, from where it faces the member, while it is inside its face cone."""
    cosine = (np.cos(face) - np.cos(polar) * np.cos(shaft_angle)) / (np.sin(polar) * np.sin(shaft_angle))
    most = float(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return np.linspace(-most, most, _SAMPLES)
