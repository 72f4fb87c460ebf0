"""Laws of moments: affine maps, sectors that sum to the gear, spirals that change nothing, mirror images."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

from gearwright.curves.curve import mapped, turn
from gearwright.curves.line import Line
from gearwright.curves.meridian import Meridian
from gearwright.moments.body import about_centroid
from gearwright.moments.matrix import shifted, transformed
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.sections.sphere import SphericalSection
from gearwright.solids.swept import Swept

from ..examples import BEVEL_PARTS, PARTS, built, every_part, polyhedron, size

MAPS = {
    "sheared, stretched and moved": ([[1.3, 0.4, -0.2], [0.1, 0.8, 0.3], [-0.5, 0.2, 1.1]], [3.0, -70.0, 12.0]),
    "mirrored": ([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 0.0]),
    "small and far away": ([[0.01, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.01]], [10.0, 20.0, -10.0]),
}


@pytest.mark.parametrize("name", MAPS)
@every_part
def test_affine_law(part, name):
    """(M1): the moments of the mapped polyhedron are the mapped moments."""
    linear, translation = MAPS[name]
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, translation
    body = polyhedron(part, 1e-3)
    found = body.transformed(matrix).properties()
    own = body.properties()
    central = transformed(shifted(own.moments, -own.centroid), linear)
    np.testing.assert_allclose(found.volume, central[0, 0], rtol=1e-12)
    np.testing.assert_allclose(found.centroid, linear @ own.centroid + translation, rtol=1e-12, atol=1e-12 * size(part))
    scale = np.abs(central[1:, 1:]).max()
    np.testing.assert_allclose(found.central_second, central[1:, 1:], rtol=0.0, atol=1e-11 * scale)


def _one_tooth(section):
    """The sector of one period of a full section, closed to the axis; copies = 1."""
    outline = section.loops[0]
    first, last = outline.curves[0].start, outline.curves[-1].end
    if first.size == 2:
        inward = Line(first=tuple(last), last=(0.0, 0.0))
        outward = Line(first=(0.0, 0.0), last=tuple(first))
        return Section(loops=(Loop(curves=(*outline.curves, inward, outward)),))
    inward = Meridian(azimuth=float(np.arctan2(last[1], last[0])), interval=(float(np.arccos(last[2])), 0.0))
    outward = Meridian(azimuth=float(np.arctan2(first[1], first[0])), interval=(0.0, float(np.arccos(first[2]))))
    return SphericalSection(loops=(Loop(curves=(*outline.curves, inward, outward)),))


def _periods(part):
    """How many equal sectors a part's one outline consists of."""
    section = getattr(built(part).solid, "section", None)
    whole = section is not None and len(section.loops) == 1 and not section.varies  # else a sector's sides would turn
    return section.loops[0].copies if whole else 1


@pytest.mark.parametrize("part", [p for p in PARTS if _periods(p) > 1], ids=str)
def test_sectors_sum_to_the_gear(part):
    gear = built(part)
    solid = gear.solid
    assert _periods(part) == gear.teeth
    sector = Swept(section=_one_tooth(solid.section), motion=solid.motion, ends=solid.ends).moments
    about_origin = shifted(sector.matrix, sector.origin)
    turned = [transformed(about_origin, turn(2.0 * np.pi * k / gear.teeth, 3)) for k in range(gear.teeth)]
    total = about_centroid(np.sum(turned, axis=0), "exact", 0.0)
    whole = solid.moments
    assert gear.teeth * sector.volume == pytest.approx(whole.volume, rel=1e-12)
    assert total.volume == pytest.approx(whole.volume, rel=1e-12)
    np.testing.assert_allclose(total.centroid, whole.centroid, rtol=0.0, atol=1e-12 * size(part))
    scale = np.linalg.norm(whole.central_second)
    np.testing.assert_allclose(total.central_second, whole.central_second, rtol=0.0, atol=1e-11 * scale)
    own_axial = gear.teeth * (about_origin[1, 1] + about_origin[2, 2])
    assert own_axial == pytest.approx(gear.properties().inertia[2, 2], rel=1e-12)


def _varies(solid):
    return getattr(getattr(solid, "section", None), "varies", False)


def _turns_into_itself(part):
    """Whether faces of a part are repeated three times or more around z."""
    return max(patch.pattern.order for patch in built(part).boundary.patches) >= 3


@pytest.mark.parametrize("part", [p for p in PARTS if _turns_into_itself(p)], ids=str)
def test_a_gear_is_symmetric_about_its_axis(part):
    found = built(part).properties()
    scale = np.abs(found.inertia).max()
    assert np.array_equal(found.centroid[:2], [0.0, 0.0])
    rounded = 1e-15 * scale if _varies(built(part).solid) else 0.0  # by integrals along the axis
    np.testing.assert_allclose(found.products, [0.0, 0.0, 0.0], rtol=0.0, atol=rounded)
    assert abs(found.inertia[0, 0] - found.inertia[1, 1]) <= 1e-15 * scale


STRAIGHT = {"trace": "straight", "spiral_angle": 0.0, "cutter_radius": None, "blade_groups": None}
every_bevel = pytest.mark.parametrize("part", BEVEL_PARTS, ids=str)


@every_bevel
def test_a_spiral_changes_nothing(part):
    gear = replace(built(part), **STRAIGHT)
    straight = gear.properties()
    mean = gear.mean_distance
    shallow = {"spiral_angle": 10.0, "cutter_radius": 1.3 * mean}
    for hand, trace in (
        ("right", {"trace": "logarithmic", "spiral_angle": 10.0}),
        ("left", {"trace": "logarithmic", "spiral_angle": 35.0}),
        ("right", {"trace": "logarithmic", "spiral_angle": 60.0}),
        ("right", {"trace": "skew", "spiral_angle": 10.0}),
        ("left", {"trace": "involute", "spiral_angle": 74.0}),
        ("right", {"trace": "circular", **shallow}),
        ("left", {"trace": "circular", **shallow}),
        ("left", {"trace": "epicycloid", **shallow, "blade_groups": 3}),
    ):
        spiral = replace(gear, hand=hand, **trace).properties()
        np.testing.assert_allclose(spiral.volume, straight.volume, rtol=1e-13)
        np.testing.assert_allclose(spiral.centroid, straight.centroid, rtol=1e-13)
        np.testing.assert_allclose(spiral.second_moment, straight.second_moment, rtol=1e-13)


@every_bevel
def test_hands_are_mirror_images(part):
    """y → −y, which turns each outline round: the surfaces coincide, and so do the polyhedra's corners on them."""
    gear = replace(built(part), **STRAIGHT, bore=None)
    gear = replace(gear, trace="logarithmic", spiral_angle=30.0)
    right, left = (replace(gear, hand=hand) for hand in ("right", "left"))
    u, v = (a.ravel() for a in np.meshgrid(np.linspace(0.0, 1.0, 7), np.linspace(0.0, 1.0, 5)))
    clouds = []
    for one in (right, left):
        patches = one.boundary.patches
        clouds.append(np.concatenate([patch.pattern.images(patch.point(u, v)).reshape(-1, 3) for patch in patches]))
    distance, _ = cKDTree(clouds[1]).query(clouds[0] * [1.0, -1.0, 1.0])
    assert distance.max() < 1e-12 * size(part)
    distance, _ = cKDTree(clouds[1]).query(clouds[0])
    assert distance.max() > 1e-3 * size(part)


def test_a_mirrored_section_runs_the_other_way():
    outline = built(BEVEL_PARTS[0]).solid.section.loops[0]
    mirror = turn(0.0, 3, mirrored=True)
    curves = tuple(mapped(curve, mirror).reversed() for curve in reversed(outline.curves))
    again = SphericalSection(loops=(Loop(curves=curves, copies=outline.copies),))
    np.testing.assert_allclose(again.moments, built(BEVEL_PARTS[0]).solid.section.moments, rtol=1e-13, atol=1e-15)
