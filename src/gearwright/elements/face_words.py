"""What the faces of a part are called: by the boundary's names, and in words as far as their curves tell."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..boundary.boundary import Boundary
from ..boundary.faces import Patch
from ..curves.curve import Curve
from ..curves.involute import Involute
from ..curves.relieved_involute import RelievedInvolute
from ..curves.rolled import RolledCurve
from ..curves.spherical_involute import SphericalInvolute
from ..curves.spherical_trochoid import SphericalTrochoid
from ..curves.trochoid import Trochoid

_FILLETS = (Trochoid, SphericalTrochoid)
_FLANKS = (Involute, RelievedInvolute, SphericalInvolute, RolledCurve)
_ALONG = np.array([0.1, 0.5, 0.9])
_CONCENTRIC = 1e-9  # of the radius


def face_names(boundary: Boundary) -> tuple[str, ...]:
    """Names of all patches, then all caps: "loop 1.2 (flank)", "start (end face)"."""
    words = [_by_curve(patch) for patch in boundary.patches]
    named = [patch.name for patch in boundary.patches]
    radii = {
        _loop(patch): float(np.hypot(*_middle(patch)[1, :2]))
        for patch, word in zip(boundary.patches, words, strict=True)
        if word == "flank"
    }
    words = [word or _round(patch, radii) for patch, word in zip(boundary.patches, words, strict=True)]
    patches = [f"{name} ({word})" if word else name for name, word in zip(named, words, strict=True)]
    return (*patches, *(f"{cap.name} (end face)" for cap in boundary.caps))


def _by_curve(patch: Patch) -> str:
    curve = _innermost(patch.curve)
    if isinstance(curve, _FILLETS):
        return "fillet"
    return "flank" if isinstance(curve, _FLANKS) else ""


def _innermost(curve: Curve) -> Curve:
    """The curve that others map, turn, or go through."""
    while True:
        inner = getattr(curve, "curve", None) or next(iter(getattr(curve, "members", ())), None)
        if not isinstance(inner, Curve):
            return curve
        curve = inner


def _round(patch: Patch, flanks: dict[tuple[str, int], float]) -> str:
    """Of a face about the axis: tip or root where the loop has flanks, else bore or outside."""
    points = _middle(patch)
    radii = np.hypot(points[:, 0], points[:, 1])
    height = np.ptp(points[:, 2])
    if np.ptp(radii) > _CONCENTRIC * radii.max() or (height > _CONCENTRIC * radii.max() and patch.pattern.order > 1):
        return ""
    outward = float(patch.area_vector(*np.full((2, 1), 0.5))[0] @ [*points[1, :2], 0.0]) > 0.0
    flank = flanks.get(_loop(patch))
    if flank is None:
        return "outside" if outward else "bore"
    return "tip" if (radii[1] > flank) == outward else "root"


def _loop(patch: Patch) -> tuple[str, int]:
    return patch.name.rpartition(".")[0], patch.pattern.order


def _middle(patch: Patch) -> Array:
    """Points (3, 3) along the curve, midway between the ends."""
    return patch.point(_ALONG, np.full(3, 0.5))
