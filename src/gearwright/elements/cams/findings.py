"""What there is to say about a cam besides its sizes: remarks for a person, findings for a program."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .kinds import KINDS
from .laws import FIXED_LAWS, SPLINE
from .optimum import Optimum

if TYPE_CHECKING:
    from .cam import Cam

_PRESSURE = {True: 45.0, False: 30.0}  # degrees: usual limits for oscillating and translating followers


def remarks_of(cam: Cam) -> list[str]:
    """What is unusual about a cam, and what a synthesis has found."""
    return [*_of_synthesis(cam), *_of_pressure(cam), *_of_law(cam), *_of_pivot(cam)]


def findings_of(cam: Cam) -> dict[str, Any]:
    """What a synthesis has found, as plain values."""
    if cam.optimum is None:
        return {}
    synthesis = {
        "area": cam.optimum.area,
        "law": cam.optimum.law,
        "dimensions": dict(cam.optimum.dimensions),
        "spline_values": list(cam.optimum.values),
        "active": [{"limit": one.name, "cam_angles": list(one.angles)} for one in cam.optimum.active],
        "fixed_laws": {name: one.area if one.keeps_limits else None for name, one in cam.compared.items()},
        "gain": gain(cam),
    }
    return {"synthesis": synthesis}


def best_fixed(cam: Cam) -> Optimum | None:
    """Of the fixed laws the one whose cam has the least area; None where none was compared or keeps the limits."""
    sound = [one for one in cam.compared.values() if one.keeps_limits]
    return min(sound, key=lambda one: one.area) if sound else None


def gain(cam: Cam) -> float | None:
    """The part of the area of the best fixed law's cam that is saved."""
    best = best_fixed(cam)
    return None if best is None or cam.optimum is None else 1.0 - cam.optimum.area / best.area


def _of_synthesis(cam: Cam) -> list[str]:
    found = cam.optimum
    if found is None:
        return []
    unit = f"{cam.length_unit}²"
    best, saved = best_fixed(cam), gain(cam)
    said = f"least area found: {found.area:.6g} {unit}"
    if best is not None and found.law == best.law and cam.law in (None, SPLINE):
        said += f", with the {best.law} law: no spline of so many values is better; allow more free_values"
    elif best is not None and saved is not None:
        said += f", {100.0 * saved:.1f} % less than with the best fixed law, {best.law} ({best.area:.6g} {unit})"
    rests = "; ".join(str(one) for one in found.active) or "no limit"
    return [said, f"the least area rests on these limits: {rests}"]


def _of_pressure(cam: Cam) -> list[str]:
    angle = float(np.degrees(cam.traced.pressure_angle.value))
    usual = _PRESSURE[KINDS[cam.follower].swings]
    if angle <= usual * (1.0 + 1e-6):
        return []
    return [f"the pressure angle reaches {angle:.3g}°; more than {usual:g}° is seldom of use"]


def _of_law(cam: Cam) -> list[str]:
    law = FIXED_LAWS.get(cam.law or "")
    following = [*cam.steps[1:], cam.steps[0]]
    mirrored = all((a.change, a.angle) == (-b.change, b.angle) for a, b in zip(cam.steps, following, strict=True))
    if law is None or law.starts_smoothly or mirrored:
        return []
    where = "where a dwell or an unlike move begins or ends"
    return [f"the acceleration of the {cam.law} law jumps {where}; the other laws start smoothly"]


def _of_pivot(cam: Cam) -> list[str]:
    if not KINDS[cam.follower].swings:
        return []
    radius = cam.traced.largest(lambda contact: np.hypot(contact.support, contact.along)).value
    if radius < cam.dimensions["pivot_distance"]:
        return []
    return ["the pivot goes about inside the disk's largest radius; its bearing must stand beside the disk"]
