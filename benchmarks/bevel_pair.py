"""Bevel pairs from nothing to exact properties, and to triangles, beside py-gearworks in the same run.

A 16/20 pair, module 12.7 mm, 38.1 mm wide, straight and spiral, with conical ends and generated fillets. py-gearworks
builds OpenCASCADE solids of a similar one: spherical ends, which it approximates, and a spiral of which it says that it
is not dimensionally accurate; its properties are OpenCASCADE's of those solids, its triangles OpenCASCADE's
tessellation of them to the same tolerance, which puts fewer on its splines. Pairs by a standard, whose teeth change
along the face, it does not have: two of them by us alone, and of the 13/44 teeth of one how many stand at the peer's
tips when they are spiral.

All times are CPU seconds. What limits us: where teeth are alike all along, half is checks of how mates run; where they
vary, proving members sound at nine places, and quadratures of their moments; in polyhedra, the triangulation of the
conical end faces. What limits the peer: splines fitted and sewn.

    python benchmarks/bevel_pair.py [PYTHON]

PYTHON is an interpreter that has py-gearworks, where this one has not.
"""

from __future__ import annotations

import math
import time
from functools import partial
from itertools import pairwise
from typing import Any

from timing import median_seconds, of_peer

SIZES = {"teeth": (16, 20), "module": 12.7, "face_width": 38.1}
SPIRAL = {"spiral_angle": 35.0, "cutter_radius": 75.0, "trace": "circular", "module": 5.0, "face_width": 28.0}
ALIKE = {
    "16/20 straight": SIZES,
    "16/20 spiral 35°": {**SIZES, "trace": "logarithmic", "spiral_angle": 35.0},
}
VARYING = {
    "14/40 Gleason spiral": {**SPIRAL, "teeth": (14, 40), "standard": "gleason-spiral"},
    "13/44 ISO 23509": {**SPIRAL, "teeth": (13, 44), "standard": "iso-23509"},
}
TOLERANCES = dict(zip((*ALIKE, *VARYING), (0.015, 0.035, 0.015, 0.015), strict=True))  # mm: more than 100 000 triangles
RUNS, PEER_RUNS = 15, 3
cpu = partial(median_seconds, clock=time.process_time)


def exact_properties(sizes: dict[str, Any]) -> None:
    """Both members' properties, from nothing."""
    from gearwright import BevelPair

    pair = BevelPair(**sizes)
    pair.pinion.properties()
    pair.gear.properties()


def triangles(sizes: dict[str, Any], tolerance: float) -> int:
    """How many triangles both members' polyhedra have, from nothing."""
    from gearwright import BevelPair

    pair = BevelPair(**sizes)
    return sum(len(member.polyhedron(tolerance).triangles()) for member in (pair.pinion, pair.gear))


def peer_parts(sizes: dict[str, Any]) -> list[Any]:
    """py-gearworks' solids of both members."""
    import py_gearworks

    spiral = math.radians(sizes.get("spiral_angle", 0.0))
    first, second = sizes["teeth"]
    gears = [
        py_gearworks.BevelGear(
            number_of_teeth=teeth,
            module=sizes["module"],
            height=sizes["face_width"],
            cone_angle=2.0 * math.atan2(teeth, mate),
            helix_angle=sense * spiral,
            dedendum_coefficient=1.25,
            tip_truncation=0.0,
        )
        for teeth, mate, sense in ((first, second, 1.0), (second, first, -1.0))
    ]
    return [gear.build_part() for gear in gears]


def peer_properties(sizes: dict[str, Any]) -> None:
    """Volume and inertia of both."""
    for part in peer_parts(sizes):
        _ = part.volume, part.matrix_of_inertia


def peer_triangles(sizes: dict[str, Any], tolerance: float) -> int:
    """How many triangles both have."""
    return sum(len(part.tessellate(tolerance, 0.5)[1]) for part in peer_parts(sizes))


def teeth_at_the_tip(part: Any, teeth: int) -> int:
    """Groups of a mesh's corners near its greatest radius, apart by half a pitch or more."""
    corners = [(corner.X, corner.Y) for corner in part.tessellate(0.01, 0.2)[0]]
    most = max(math.hypot(*corner) for corner in corners)
    angles = sorted(math.atan2(y, x) for x, y in corners if math.hypot(x, y) > 0.98 * most)
    around = [*angles, angles[0] + math.tau]
    return sum(after - before > math.pi / teeth * 0.8 for before, after in pairwise(around))


def peer() -> dict[str, Any]:
    """Median seconds of properties and triangles, and how many of these; teeth of the 13/44 pair."""
    found: dict[str, Any] = {}
    for name, sizes in ALIKE.items():
        tolerance = TOLERANCES[name]
        found[name] = (
            cpu(lambda sizes=sizes: peer_properties(sizes), PEER_RUNS),
            cpu(lambda sizes=sizes, tolerance=tolerance: peer_triangles(sizes, tolerance), PEER_RUNS, 0),
            peer_triangles(sizes, tolerance),
        )
    sizes = VARYING["13/44 ISO 23509"]
    found["teeth"] = [
        teeth_at_the_tip(part, teeth) for part, teeth in zip(peer_parts(sizes), sizes["teeth"], strict=True)
    ]
    return found


def main() -> None:
    """Prints medians and ratios."""
    found = of_peer(__file__, peer)
    print(f"{'both members':<36}{'Gearwright':>14}{'py-gearworks':>14}{'ratio':>8}")
    for name, sizes in {**ALIKE, **VARYING}.items():
        tolerance = TOLERANCES[name]
        count = triangles(sizes, tolerance)
        exact = cpu(lambda sizes=sizes: exact_properties(sizes), RUNS)
        meshed = cpu(lambda sizes=sizes, tolerance=tolerance: triangles(sizes, tolerance), RUNS // 3)
        slow, slow_meshed, theirs = found.get(name, (None, None, 0))
        _row(f"{name}, properties", exact, slow)
        _row(f"{name}, {count} triangles", meshed, slow_meshed)
        if theirs:
            print(f"    the peer's are {theirs} triangles")
    print(f"the peer's 13/44 pair with 35° spiral has {found['teeth']} teeth at its tips")


def _row(label: str, ours: float, theirs: float | None) -> None:
    beside = "" if theirs is None else f"{theirs * 1e3:>11.0f} ms{theirs / ours:>7.0f}×"
    print(f"{label:<36}{ours * 1e3:>11.1f} ms{beside}")


if __name__ == "__main__":
    main()
