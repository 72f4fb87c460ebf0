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
    "9/12 circular": {
        "teeth": (9, 12),
        "module": 4.0,
        "face_width": 9.0,
        "trace": "circular",
        "spiral_angle": 35.0,
        "cutter_radius": 30.0,
    },
    "9/12 epicycloid": {
        "teeth": (9, 12),
        "module": 4.0,
        "face_width": 9.0,
        "trace": "epicycloid",
        "spiral_angle": 30.0,
        "cutter_radius": 40.0,
        "blade_groups": 3,
        "hand": "left",
    },
    "9/12 involute": {"teeth": (9, 12), "module": 4.0, "face_width": 7.0, "trace": "involute", "spiral_angle": 45.0},
    "9/12 skew": {"teeth": (9, 12), "module": 4.0, "face_width": 9.0, "trace": "skew", "spiral_angle": 30.0},
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
    assert coarse <= 0.02 * tolerances[0] * _flank_area(pair.pinion)
    assert fine <= 0.02 * tolerances[1] * _flank_area(pair.pinion)
    assert fine <= coarse / 10.0


def test_thick_teeth_would_overlap_more():
    """The bound above tells: teeth too thick by four tolerances exceed it many times."""
    pair = BevelPair(**PAIRS["straight"])
    tolerance = 1e-3 * pair.pinion.cone_distance
    thick = replace(pair.gear, circular_thickness=pair.gear.outer_thickness + 4.0 * tolerance)
    assert _overlap(pair, thick, tolerance) > 0.05 * tolerance * _flank_area(pair.pinion)


def test_backlash_keeps_them_apart():
    spiral = BevelPair(**{**PAIRS["spiral"], "backlash": 0.3})
    assert _overlap(spiral, spiral.gear, 0.02) == 0.0
