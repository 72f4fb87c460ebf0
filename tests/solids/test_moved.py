"""Solids put elsewhere."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.placed import written_out
from gearwright.boundary.sampling import sampling
from gearwright.boundary.tessellation import tessellate
from gearwright.solids.solid import flux_moments

from ..boundary.shapes import HALF_DISC, circle, polygon
from ..laws.topology import edges_pair_up, fans_at_vertices

LEANING = ([[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]], (3.0, -7.0, 11.0))
PLACES = {
    "leaning": LEANING,
    "raised": (np.eye(3), (0.0, 0.0, 5.0)),
    "turned over": (np.diag([1.0, -1.0, -1.0]), (0.0, 0.0, 5.0)),
    "aside": (np.eye(3), (30.0, 0.0, 0.0)),
    "pole to the origin": (np.eye(3), (0.0, 0.0, -1.0)),
}
SHAPE = {"teeth": 20, "module": 4.0, "pitch_angle": 45.0, "face_width": 15.0, "root": "radial", "ends": "spherical"}
SOLIDS = {
    "spur gear": gw.SpurGear(teeth=16, module=8, face_width=50, root="radial", bore=30).solid,
    "spiral bevel gear": gw.BevelGear(**SHAPE, trace="logarithmic", spiral_angle=35.0).solid,
    "bored bevel gear": gw.BevelGear(**SHAPE, bore=20.0).solid,
    "ball": gw.revolve(gw.Section(loops=(HALF_DISC,))),
    "part of a cone": gw.revolve(gw.Section(loops=(polygon((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)),)), 100.0),
    "twisted bar": gw.extrude(gw.Section(loops=(circle(2.0, pieces=5),)), 7.0, twist=50.0, skew=(1.0, 0.0)),
}


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
class TestEveryMovedSolid:
    def test_its_properties_are_moved(self, solid, place):
        expected, found = solid.properties().moved(*place), solid.moved(*place).properties()
        size = np.cbrt(expected.volume)
        assert found.volume == pytest.approx(expected.volume, rel=1e-14)
        np.testing.assert_allclose(found.centroid, expected.centroid, atol=1e-14 * (size + np.linalg.norm(place[1])))
        norm = np.linalg.norm(expected.central_second)
        np.testing.assert_allclose(found.central_second, expected.central_second, atol=1e-14 * norm)
        assert (found.method, found.error_bound) == (expected.method, expected.error_bound)
        assert found.area == pytest.approx(solid.properties().area, rel=1e-12)

    def test_so_is_its_boundary(self, solid, place):
        moved = solid.moved(*place)
        flux, known = flux_moments(moved.boundary), moved.moments
        size = np.cbrt(known.volume)
        far = (1.0 + np.linalg.norm(flux.centroid) / size) ** 2  # flux is taken about the frame's origin
        assert flux.volume == pytest.approx(known.volume, rel=1e-12)
        np.testing.assert_allclose(flux.centroid, known.centroid, atol=1e-12 * size)
        norm = np.linalg.norm(known.central_second)
        np.testing.assert_allclose(flux.central_second, known.central_second, atol=2e-13 * far * norm)

    def test_and_its_polyhedron(self, solid, place):
        rotation, shift = place
        tolerance = 1e-3 * float(np.linalg.norm(np.ptp(solid.properties().bounding_box, axis=0)))
        moved = solid.moved(*place).polyhedron(tolerance)
        still = solid.polyhedron(tolerance)
        assert edges_pair_up(moved.triangles())
        assert set(fans_at_vertices(moved.triangles())) == {1}
        expected, found = still.properties().moved(rotation, shift), moved.properties()
        assert found.volume == pytest.approx(expected.volume, rel=1e-3)
        np.testing.assert_allclose(found.centroid, expected.centroid, atol=1e-3 * np.cbrt(expected.volume))
        box = solid.moved(*place).properties().bounding_box
        assert np.max(np.abs(box - found.bounding_box)) <= tolerance

    def test_written_out_it_is_the_same_body(self, solid, place):
        boundary = solid.moved(*place).boundary
        plain = written_out(boundary)
        assert {edge.pattern.order for edge in plain.edges} == {1}
        one, other = flux_moments(boundary), flux_moments(plain)
        assert other.volume == pytest.approx(one.volume, rel=1e-12)
        np.testing.assert_allclose(other.centroid, one.centroid, atol=1e-12 * np.cbrt(one.volume))
        assert len(plain.patches) == sum(patch.pattern.order for patch in boundary.patches)
        for loop in (loop for cap in plain.caps for loop in cap.loops):
            ends = [
                (use.edge.end, use.edge.start) if use.reverse else (use.edge.start, use.edge.end) for use in loop.uses
            ]
            assert all(end is start for (_, end), (start, _) in zip(ends, [*ends[1:], ends[0]], strict=True))
        _, triangles = tessellate(plain, sampling(plain, 0.01 * np.cbrt(one.volume)))
        assert edges_pair_up(triangles)
        assert set(fans_at_vertices(triangles)) == {1}


def test_a_gear_keeps_its_pattern_wherever_it_is():
    for place in PLACES.values():
        moved = SOLIDS["spur gear"].moved(*place).boundary
        assert {patch.pattern.order for patch in moved.patches} == {16}
    raised = SOLIDS["spur gear"].moved(*PLACES["raised"]).boundary
    assert {patch.pattern.placement for patch in raised.patches} == {None}


def test_moving_twice_is_moving_once():
    gear = SOLIDS["bored bevel gear"]
    twice = gear.moved(*LEANING).moved(*PLACES["aside"])
    once = gear.moved(LEANING[0], np.array(LEANING[1]) + PLACES["aside"][1])
    one, other = (flux_moments(solid.boundary) for solid in (twice, once))
    np.testing.assert_allclose(one.origin, other.origin, atol=1e-12)
    assert one.volume == pytest.approx(other.volume, rel=1e-13)


@pytest.mark.parametrize(
    ("rotation", "translation", "words"),
    [
        (np.diag([1.0, 1.0, -1.0]), (0.0, 0.0, 0.0), "to mirror or scale"),
        (1.1 * np.eye(3), (0.0, 0.0, 0.0), "orthonormal rows"),
        (np.eye(4), (0.0, 0.0, 0.0), r"shape \(4, 4\)"),
        (np.eye(3), (0.0, 0.0), "three finite lengths"),
        (np.eye(3), (0.0, np.inf, 0.0), "three finite lengths"),
    ],
)
def test_what_is_no_move(rotation, translation, words):
    with pytest.raises(gw.GeometryError, match=words):
        SOLIDS["ball"].moved(rotation, translation)
