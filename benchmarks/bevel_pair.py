"""A 16/20 bevel pair: exact properties, and as triangles, beside py-gearworks in the same run.

py-gearworks builds an OpenCASCADE solid of a similar pair (spherical involutes, spiral approximate); its
properties are OpenCASCADE's volume of that solid, its triangles OpenCASCADE's tessellation.
"""

from __future__ import annotations

import math

from timing import median_seconds

from gearwright import BevelPair

PARAMETERS = {
    "teeth": (16, 20),
    "module": 12.7,
    "face_width": 38.1,
    "working_depth": 20.32,
    "whole_depth": 21.59,
    "gear_addendum": 10.16,
    "root": "radial",
    "ends": "spherical",
}
TRACES = {"straight": {}, "spiral 35°": {"trace": "logarithmic", "spiral_angle": 35}}
TOLERANCE = 0.023  # mm: more than 100 000 triangles for the spiral pair


def exact_properties(trace: dict) -> None:
    """Both members' properties, from nothing."""
    pair = BevelPair(**PARAMETERS, **trace)
    pair.pinion.properties()
    pair.gear.properties()


def triangles(trace: dict) -> int:
    """Both members as polyhedra, from nothing."""
    pair = BevelPair(**PARAMETERS, **trace)
    return sum(len(member.polyhedron(TOLERANCE).triangles()) for member in (pair.pinion, pair.gear))


def peer_solids(spiral_angle: float) -> list:
    """py-gearworks' solids of both members."""
    import py_gearworks

    members = []
    for teeth, mate, sense in ((16, 20, 1), (20, 16, -1)):
        gear = py_gearworks.BevelGear(
            number_of_teeth=teeth,
            module=12.7,
            height=38.1,
            cone_angle=2.0 * math.atan2(teeth, mate),
            helix_angle=sense * math.radians(spiral_angle),
        )
        members.append(gear.build_part())
    return members


def main() -> None:
    """Prints medians and ratios."""
    print(f"{'16/20 bevel pair':<24}{'Gearwright':>28}{'py-gearworks':>28}{'ratio':>12}")
    for name, trace in TRACES.items():
        ours = median_seconds(lambda trace=trace: exact_properties(trace), 25)
        count = triangles(trace)
        ours_triangles = median_seconds(lambda trace=trace: triangles(trace), 9)
        spiral = float(trace.get("spiral_angle", 0.0))
        theirs = median_seconds(lambda spiral=spiral: [part.volume for part in peer_solids(spiral)], 1, warm_up=0)
        tessellated = median_seconds(
            lambda spiral=spiral: [part.tessellate(TOLERANCE, 0.5) for part in peer_solids(spiral)], 1, warm_up=0
        )
        _row(f"{name}, properties", ours, theirs)
        _row(f"{name}, {count} tri.", ours_triangles, tessellated)


def _row(label: str, ours: float, theirs: float) -> None:
    print(f"{label:<24}{ours * 1e3:>25.1f} ms{theirs * 1e3:>25.0f} ms{theirs / ours:>11.0f}×")


if __name__ == "__main__":
    main()
