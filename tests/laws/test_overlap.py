"""Placed polyhedra of a pair touch, and overlap by no more than their chords."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.curves.curve import gauss_legendre
from gearwright.elements.bevel.bevel_pair import BevelPair

from .contact import involute_patches
from .manifolds import manifold

PAIRS = {
    "straight": {"teeth": (16, 20), "module": 4.0, "face_width": 15.0},
    "spiral": {"teeth": (16, 20), "module": 4.0, "face_width": 15.0, "trace": "logarithmic", "spiral_angle": 35.0},
    "13/44 spiral": {
        "teeth": (13, 44),
        "module": 3.0,
        "face_width": 18.0,
        "gear_addendum": 2.4,
        "trace": "logarithmic",
        "spiral_angle": 35.0,
    },
    **{
        f"16/20 {trace}": {"teeth": (16, 20), "module": 4.0, "face_width": 15.0, "trace": trace, **more}
        for trace, more in {
            "skew": {"spiral_angle": 30.0},
            "circular": {"spiral_angle": 35.0, "cutter_radius": 50.0},
            "involute": {"spiral_angle": 45.0},
            "epicycloid": {"spiral_angle": 30.0, "cutter_radius": 40.0, "blade_groups": 3, "hand": "left"},
        }.items()
    },
    "Σ 60°": {"teeth": (16, 20), "module": 4.0, "face_width": 15.0, "shaft_angle": 60.0},
}
CYCLE = (np.arange(3) + 0.2) / 3.0


def _overlap(pair, gear, tolerance):
    """The largest volume that pinion and gear share over a tooth cycle."""
    bodies = pair.pinion.polyhedron(tolerance), gear.polyhedron(tolerance)
    return max(
        (manifold(bodies[0], a) ^ manifold(bodies[1], b)).volume()
        for a, b in (pair.placements(float(turn) * 360.0 / pair.pinion.teeth) for turn in CYCLE)
    )


def _flank_area(gear):
    """Of the two flanks of one tooth."""
    x, w = gauss_legendre(12)
    u, v = (a.ravel() for a in np.meshgrid((x + 1.0) / 2.0, (x + 1.0) / 2.0))
    weights = np.outer(w, w).ravel() / 4.0
    return sum(float(np.linalg.norm(p.area_vector(u, v), axis=1) @ weights) for p in involute_patches(gear))


@pytest.mark.parametrize("name", PAIRS)
def test_placed_polyhedra_overlap_by_no_more_than_their_chords(name):
    """Far less than tolerance × flank area: contact is along lines, and only a spiral's flanks are concave."""
    pair = BevelPair(**PAIRS[name])
    tolerances = [relative * pair.pinion.cone_distance for relative in (1e-3, 1e-4)]
    coarse, fine = (_overlap(pair, pair.gear, tolerance) for tolerance in tolerances)
    bounds = [0.02 * tolerance * _flank_area(pair.pinion) for tolerance in tolerances]
    assert coarse <= bounds[0]
    assert fine <= bounds[1]
    # a fiftieth of the bound is left to chance: which chords happen to meet at these three turns
    assert fine <= max(coarse / 10.0, bounds[1] / 50.0)


def test_thick_teeth_would_overlap_more():
    """The bound above tells: teeth too thick by four tolerances exceed it many times."""
    pair = BevelPair(**PAIRS["straight"])
    tolerance = 1e-3 * pair.pinion.cone_distance
    thick = replace(pair.gear, circular_thickness=pair.gear.outer_thickness + 4.0 * tolerance)
    assert _overlap(pair, thick, tolerance) > 0.05 * tolerance * _flank_area(pair.pinion)


def test_zerol_teeth_of_one_hand_would_overlap():
    """They have no spiral angle at the mean cone distance, but bend one way."""
    zerol = {**PAIRS["16/20 circular"], "spiral_angle": 0.0, "cutter_radius": 20.0}
    pair = BevelPair(**zerol)
    tolerance = 1e-3 * pair.pinion.cone_distance
    bound = 0.02 * tolerance * _flank_area(pair.pinion)
    assert _overlap(pair, pair.gear, tolerance) <= bound
    assert _overlap(pair, replace(pair.gear, hand=pair.pinion.hand), tolerance) > 5.0 * bound


def test_backlash_keeps_them_apart():
    spiral = BevelPair(**{**PAIRS["spiral"], "backlash": 0.3})
    assert _overlap(spiral, spiral.gear, 0.02) == 0.0
