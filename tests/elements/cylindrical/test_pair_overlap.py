"""Sections and polyhedra of placed pairs touch, and overlap by no more than their chords; interference is found."""

import numpy as np
import pytest

from gearwright.curves.curve import gauss_legendre
from gearwright.elements.cylindrical import gear_pair
from gearwright.elements.cylindrical.gear_pair import GearPair
from gearwright.elements.cylindrical.tip_paths import cut_depths
from gearwright.errors import ParameterError

from ...laws.manifolds import manifold
from .running import flank_patches, placed, region, shared

PAIRS = {
    "spur": {"teeth": (16, 24), "module": 2.0, "face_width": 8.0, "profile_shift": (0.4, 0.1)},
    "helical": {"kind": "helical", "teeth": (15, 24), "module": 2.0, "face_width": 12.0, "helix_angle": 25.0},
    "herringbone": {"kind": "herringbone", "teeth": (15, 22), "module": 2.0, "face_width": 16.0, "helix_angle": 25.0},
    "internal": {"kind": "internal", "teeth": (20, 52), "module": 2.0, "face_width": 8.0},
    "internal, helical": {
        "kind": "internal",
        "teeth": (20, 44),
        "module": 2.0,
        "face_width": 10.0,
        "helix_angle": 18.0,
        "hand": "left",
    },
    "rack": {"kind": "rack", "teeth": (14, 6), "module": 2.0, "face_width": 8.0, "profile_shift": 0.3},
    "rack, helical": {"kind": "rack", "teeth": (14, 6), "module": 2.0, "face_width": 8.0, "helix_angle": 20.0},
}
CYCLE = (np.arange(3) + 0.2) / 3.0


def _bodies(pair, tolerance):
    return pair.pinion.polyhedron(tolerance), pair.gear.polyhedron(tolerance)


def _overlaps(pair, bodies, cycle=CYCLE):
    """Volumes that pinion and gear share over a tooth cycle."""
    for turn in cycle:
        seats = pair.placements(float(turn) * 360.0 / pair.teeth[0])
        yield (manifold(bodies[0], seats[0]) ^ manifold(bodies[1], seats[1])).volume()


def _flank_area(pair):
    """Of the two flanks of one tooth of the pinion."""
    x, w = gauss_legendre(12)
    u, v = (a.ravel() for a in np.meshgrid((x + 1.0) / 2.0, (x + 1.0) / 2.0))
    weights = np.outer(w, w).ravel() / 4.0
    return sum(float(np.linalg.norm(p.area_vector(u, v), axis=1) @ weights) for p in flank_patches(pair.pinion))


@pytest.mark.parametrize("name", PAIRS)
def test_placed_polyhedra_overlap_by_no_more_than_their_chords(name):
    """Where flanks are convex chords lie inside; an internal gear's and twisted ones stand out by a tolerance."""
    pair = GearPair(**PAIRS[name])
    area, tolerances = _flank_area(pair), (0.02, 0.002)
    coarse, fine = (max(_overlaps(pair, _bodies(pair, tolerance))) for tolerance in tolerances)
    assert coarse <= 0.1 * tolerances[0] * area
    assert fine <= 0.1 * tolerances[1] * area


@pytest.mark.parametrize("name", PAIRS)
def test_thick_teeth_would_overlap_more(name, monkeypatch):
    """The bound above tells: teeth too thick by four tolerances exceed it."""
    monkeypatch.setattr(gear_pair, "check_mesh", lambda mesh, unit: [])
    pair, tolerance = GearPair(**PAIRS[name]), 0.02
    thickness = tuple(one.sizes()["circular_thickness"].value + 2.0 * tolerance for one in (pair.pinion, pair.gear))
    thick = GearPair(**PAIRS[name], circular_thickness=thickness)
    assert max(_overlaps(thick, _bodies(thick, tolerance))) > 0.2 * tolerance * _flank_area(pair)


@pytest.mark.parametrize("name", PAIRS)
def test_backlash_keeps_them_apart_and_no_more(name):
    """With backlash nothing is shared; turned by a little more than half of it, something is."""
    pair = GearPair(**PAIRS[name], backlash=0.2)
    bodies = _bodies(pair, 0.005)
    assert max(_overlaps(pair, bodies)) == 0.0
    seats = pair.placements(0.0)
    more = np.array(seats[1])
    if pair.kind == "rack":
        more[1, 3] += 0.14
    else:
        angle = 0.14 / pair.gear.pitch_radius
        c, s = np.cos(angle), np.sin(angle)
        more[:2, :2] = np.array([[c, -s], [s, c]]) @ more[:2, :2]
    assert (manifold(bodies[0], seats[0]) ^ manifold(bodies[1], more)).volume() > 1e-3


@pytest.mark.parametrize("name", PAIRS)
def test_sections_touch_but_share_next_to_nothing(name):
    pair = GearPair(**PAIRS[name])
    for turn in (np.arange(4) + 0.1) / 4.0:
        assert shared(pair, turn, 32) < 2e-5 * pair.pinion.normal_module**2
        assert _distance(pair, turn) < 1e-4


def _distance(pair, turn):
    seats = pair.placements(turn * 360.0 / pair.teeth[0])
    own, other = (placed(region(m, 100), s) for m, s in zip((pair.pinion, pair.gear), seats, strict=True))
    return own.distance(other)


@pytest.mark.parametrize("name", PAIRS)
def test_clearances_are_between_the_boundaries(name):
    """Radii of the outlines on both sides of the line of centres."""
    pair = GearPair(**PAIRS[name], addendum_coefficient=(0.9, 0.95))
    sizes, distance = pair.sizes(), pair.sizes()["centre_distance"].value
    own = np.linalg.norm(np.array(region(pair.pinion).exterior.coords), axis=1)
    if pair.kind == "rack":
        heights = np.array(region(pair.gear).exterior.coords)[:, 0]
        tip, root = max(heights), sorted(set(np.round(heights, 9)))[1]
        expected = distance - root - max(own), distance - tip - min(own)
    elif pair.kind == "internal":
        other = np.linalg.norm(np.array(region(pair.gear).interiors[0].coords), axis=1)
        expected = max(other) - distance - max(own), min(other) - distance - min(own)
    else:
        other = np.linalg.norm(np.array(region(pair.gear).exterior.coords), axis=1)
        expected = distance - min(other) - max(own), distance - max(other) - min(own)
    found = sizes["pinion_tip_clearance"].value, sizes["gear_tip_clearance"].value
    assert found == pytest.approx(expected, abs=1e-9)


INTERFERENCE = {
    "long pinion teeth in a ring": {"kind": "internal", "teeth": (20, 60), "addendum_coefficient": (1.2, 0.8)},
    "long pinion teeth in a rack": {
        "kind": "rack",
        "teeth": (80, 8),
        "addendum_coefficient": (1.22, 0.9),
    },
    "52/60, unshortened": {"kind": "internal", "teeth": (52, 60), "tip_shortening": "none"},
    "53/60": {"kind": "internal", "teeth": (53, 60)},
    "54/60": {"kind": "internal", "teeth": (54, 60)},
    "55/60": {"kind": "internal", "teeth": (55, 60)},
    "57/60, short": {"kind": "internal", "teeth": (57, 60), "addendum_coefficient": 0.8},
    "20/60, unshortened": {"kind": "internal", "teeth": (20, 60), "tip_shortening": "none"},
    "8/60, radial roots": {"teeth": (8, 60), "root": "radial"},
    "60/8, radial roots": {"teeth": (60, 8), "root": "radial"},
    "10 on a rack, radial roots": {"kind": "rack", "teeth": (10, 12), "root": "radial"},
    "8/60, short rack tips": {
        "teeth": (8, 60),
        "dedendum_coefficient": (1.02, 1.25),
        "addendum_coefficient": (1.0, 1.0),
    },
    "14 on a rack with long teeth": {
        "kind": "rack",
        "teeth": (14, 8),
        "addendum_coefficient": (1.0, 1.15),
        "dedendum_coefficient": 1.25,
        "rack_tip_coefficient": 0.45,
    },
}
FREE = {
    "40/60": {"kind": "internal", "teeth": (40, 60)},
    "51/60": {"kind": "internal", "teeth": (51, 60)},
    "52/60": {"kind": "internal", "teeth": (52, 60)},
    "12/60": {"teeth": (12, 60)},
    "8/60": {"teeth": (8, 60)},
    "10 on a rack": {"kind": "rack", "teeth": (10, 12)},
    "55/60, 30°, stub": {"kind": "internal", "teeth": (55, 60), "pressure_angle": 30.0, "addendum_coefficient": 0.6},
}


def _most_shared(pair):
    """The most that sections share while the pinion turns by a pitch, and how deep: what, taken off, leaves none."""
    best, depth = 0.0, 0.0
    regions = region(pair.pinion, 60), region(pair.gear, 60)
    for turn in (np.arange(25) + 0.5) / 25.0:
        seats = pair.placements(turn * 360.0 / pair.teeth[0])
        own, other = (placed(one, seat) for one, seat in zip(regions, seats, strict=True))
        common = own.intersection(other)
        best = max(best, common.area)
        for piece in getattr(common, "geoms", [common]):
            if piece.area > 1e-6:
                box = piece.minimum_rotated_rectangle.exterior.coords
                sides = np.linalg.norm(np.diff(np.array(box), axis=0), axis=1)
                depth = max(depth, float(min(sides)))
    return best, depth


@pytest.mark.parametrize("name", [*INTERFERENCE, *FREE])
def test_interference_is_what_polygons_share(name, monkeypatch):
    """Teeth cut by tips, and only these, are refused; the depth told is that of the sections, along the circle."""
    values = {**INTERFERENCE, **FREE}[name] | {"module": 2.0, "face_width": 10.0}
    refused = ""
    try:
        GearPair(**values)
    except ParameterError as error:
        refused = str(error)
    monkeypatch.setattr(gear_pair, "check_mesh", lambda mesh, unit: [])
    pair = GearPair(**values)
    area, depth = _most_shared(pair)
    told = max(cut_depths(pair.mesh))
    if name in FREE:
        assert not refused
        assert area < 1e-4
        return
    assert "interference" in refused
    assert area > 1e-4
    assert 0.3 * told < depth < 1.5 * told
