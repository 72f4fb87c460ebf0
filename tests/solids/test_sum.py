"""Sums of solids: exact moments, one watertight boundary, and refusals of whatever is neither glued nor apart."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.boundary import Boundary
from gearwright.curves.arc import Arc
from gearwright.curves.line import Line
from gearwright.moments.body import BodyMoments
from gearwright.sections.loop import Loop
from gearwright.solids.solid import Solid, flux_moments

from ..boundary.shapes import HALF_DISC, circle, polygon
from ..laws.topology import components, edges_pair_up, fans_at_vertices, genus

EYE = np.eye(3)
UPRIGHT = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]  # z becomes x


def up(height):
    return (0.0, 0.0, height)


def turned(angle):
    c, s = np.cos(angle), np.sin(angle)
    return [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]


def bar(*loops, length):
    return gw.extrude(gw.Section(loops=loops), length)


def spun(*corners, angle=360.0):
    return gw.revolve(gw.Section(loops=(polygon(*corners),)), angle)


def hexagon(radius, copies=6):
    corners = [(radius * np.cos(k * np.pi / 3), radius * np.sin(k * np.pi / 3)) for k in range(7)]
    lines = [Line(first=a, last=b) for a, b in pairwise(corners)]
    return Loop(curves=tuple(lines[: 6 // copies]), copies=copies)


def box(width, depth, height):
    return bar(polygon((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)), length=height)


def disc_at(radius, x, y):
    return Loop(curves=(Arc(radius=radius, centre=(x, y), interval=(0.0, 2.0 * np.pi)),))


GEAR = gw.SpurGear(teeth=16, module=8, face_width=50, root="radial").solid
BORED = gw.SpurGear(teeth=16, module=8, face_width=50, root="radial", bore=30).solid
HEXAGON_AREA = 1.5 * np.sqrt(3.0)


@dataclass(frozen=True)
class Sum:
    """Solids to add one after the other; the area they are glued along, and the shape of the whole."""

    solids: tuple
    contact: float
    pieces: int = 1
    holes: int = 0

    @cached_property
    def whole(self):
        return sum(self.solids[1:], start=self.solids[0])


SUMS = {
    "a plate on the end of a shaft": Sum(
        (bar(circle(8.0), length=40.0), bar(hexagon(12.0), length=5.0).moved(EYE, up(40.0))), 64.0 * np.pi
    ),
    "a shaft on a plate": Sum(
        (bar(hexagon(12.0), length=5.0), bar(circle(8.0), length=40.0).moved(EYE, up(5.0))), 64.0 * np.pi
    ),
    "a plate under a shaft": Sum(
        (bar(circle(8.0), length=40.0), bar(hexagon(12.0), length=5.0).moved(EYE, up(-5.0))), 64.0 * np.pi
    ),
    "a stack of equal sections": Sum(
        (bar(hexagon(12.0), length=10.0), bar(hexagon(12.0), length=5.0).moved(EYE, up(10.0))), 144.0 * HEXAGON_AREA
    ),
    "a stack of equal sections with holes": Sum((BORED, BORED.moved(EYE, up(50.0))), BORED.moments.volume / 50.0, 1, 1),
    "a stack of sections whose patterns differ": Sum(
        (bar(hexagon(12.0), length=10.0), bar(hexagon(12.0, 3), length=5.0).moved(EYE, up(10.0))), 144.0 * HEXAGON_AREA
    ),
    "a stack a sector further on": Sum(
        (bar(hexagon(12.0), length=10.0), bar(hexagon(12.0), length=5.0).moved(turned(np.pi / 3), up(10.0))),
        144.0 * HEXAGON_AREA,
    ),
    "a stack upside down": Sum(
        (bar(hexagon(12.0), length=10.0), bar(hexagon(12.0), length=5.0).moved(np.diag([1.0, -1.0, -1.0]), up(15.0))),
        144.0 * HEXAGON_AREA,
    ),
    "discs that start elsewhere": Sum(
        (bar(circle(8.0), length=40.0), bar(circle(8.0, pieces=7), length=5.0).moved(turned(0.3), up(40.0))),
        64.0 * np.pi,
    ),
    "a hub on a gear": Sum((GEAR, bar(circle(20.0), length=30.0).moved(EYE, up(50.0))), 400.0 * np.pi),
    "a hub with the bore of its gear": Sum(
        (BORED, bar(circle(20.0), circle(15.0, sense=-1), length=30.0).moved(EYE, up(50.0))), 175.0 * np.pi, 1, 1
    ),
    "a revolved hub with the bore of its gear": Sum(
        (BORED, spun((15.0, 0.0), (22.0, 0.0), (18.0, 9.0), (15.0, 9.0)).moved(turned(0.2), up(50.0))),
        259.0 * np.pi,
        1,
        1,
    ),
    "a hub with a wider bore": Sum(
        (BORED, bar(circle(20.0), circle(16.0, sense=-1), length=30.0).moved(EYE, up(50.0))), 144.0 * np.pi, 1, 1
    ),
    "a ring on a plate": Sum(
        (box(30.0, 30.0, 5.0), bar(circle(6.0), circle(4.0, sense=-1), length=7.0).moved(EYE, (12.0, 13.0, 5.0))),
        20.0 * np.pi,
    ),
    "a ring on a plate and a pin in the ring": Sum(
        (
            box(30.0, 30.0, 5.0),
            bar(circle(6.0), circle(4.0, sense=-1), length=7.0).moved(EYE, (12.0, 13.0, 5.0)),
            bar(hexagon(2.0), length=9.0).moved(EYE, (12.0, 13.0, 5.0)),
        ),
        20.0 * np.pi + 4.0 * HEXAGON_AREA,
    ),
    "several pieces on one face": Sum(
        (
            box(30.0, 30.0, 5.0),
            bar(circle(2.0), length=7.0).moved(EYE, (6.0, 6.0, 5.0)),
            bar(hexagon(3.0), length=4.0).moved(turned(0.4), (20.0, 7.0, 5.0)),
            bar(circle(4.0), length=2.0).moved(EYE, (15.0, 20.0, 5.0)),
        ),
        20.0 * np.pi + 9.0 * HEXAGON_AREA,
    ),
    "pieces already added on another one": Sum(
        (
            bar(circle(8.0), length=4.0),
            (box(2.0, 2.0, 1.0) + box(1.0, 1.0, 1.0).moved(EYE, (0.5, 0.5, 1.0))).moved(EYE, up(4.0)),
        ),
        4.0,
    ),
    "a bridge between two posts": Sum(
        (
            box(40.0, 10.0, 3.0),
            bar(circle(2.0), length=7.0).moved(EYE, (6.0, 5.0, 3.0)),
            bar(circle(2.0), length=7.0).moved(EYE, (34.0, 5.0, 3.0)),
            box(40.0, 10.0, 3.0).moved(EYE, up(10.0)),
        ),
        16.0 * np.pi,
        1,
        1,
    ),
    "a cone on a revolved cylinder": Sum(
        (
            spun((0.0, 0.0), (5.0, 0.0), (5.0, 8.0), (0.0, 8.0)),
            spun((0.0, 0.0), (5.0, 0.0), (0.0, 6.0)).moved(EYE, up(8.0)),
        ),
        25.0 * np.pi,
    ),
    "a cone on an extruded cylinder": Sum(
        (bar(circle(5.0), length=8.0), spun((0.0, 0.0), (5.0, 0.0), (0.0, 6.0)).moved(turned(1.0), up(8.0))),
        25.0 * np.pi,
    ),
    "a box beside its like": Sum((box(1.0, 2.0, 3.0), box(1.0, 2.0, 3.0).moved(EYE, (1.0, 0.0, 0.0))), 6.0),
    "a rod on the side of a box": Sum(
        (box(9.0, 9.0, 9.0), bar(circle(2.0), length=5.0).moved(UPRIGHT, (9.0, 4.0, 5.0))), 4.0 * np.pi
    ),
    "a rod on one side of a hexagonal bar": Sum(
        (
            bar(hexagon(12.0), length=30.0).moved(turned(np.pi / 6)),
            bar(circle(2.0), length=5.0).moved(UPRIGHT, (12.0 * np.cos(np.pi / 6), 0.0, 10.0)),
        ),
        4.0 * np.pi,
    ),
    "half a ring on a plate": Sum(
        (
            box(30.0, 30.0, 5.0),
            spun((3.0, 0.0), (5.0, 0.0), (5.0, 2.0), (3.0, 2.0), angle=180.0).moved(EYE, (15.0, 14.0, 5.0)),
        ),
        8.0 * np.pi,
    ),
    "two halves of a ring": Sum(
        (
            spun((3.0, 0.0), (5.0, 0.0), (5.0, 2.0), (3.0, 2.0), angle=180.0),
            spun((3.0, 0.0), (5.0, 0.0), (5.0, 2.0), (3.0, 2.0), angle=180.0).moved(turned(np.pi)),
        ),
        8.0,
        1,
        1,
    ),
    "two quarters of a cone": Sum(
        (
            spun((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), angle=90.0),
            spun((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), angle=90.0).moved(turned(np.pi / 2)),
        ),
        0.5,
    ),
    "a lid on a cup, which leaves a void": Sum(
        (
            spun((0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (3.0, 5.0), (3.0, 2.0), (0.0, 2.0)),
            bar(circle(5.0), length=1.0).moved(turned(0.7), up(5.0)),
        ),
        16.0 * np.pi,
        2,
    ),
    "pins on a row of boxes": Sum(
        (
            box(4.0, 4.0, 3.0),
            box(4.0, 4.0, 3.0).moved(EYE, (4.0, 0.0, 0.0)),
            bar(circle(1.0), length=3.0).moved(EYE, (2.0, 2.0, 3.0)),
            bar(circle(1.0), length=3.0).moved(EYE, (6.0, 2.0, 3.0)),
        ),
        12.0 + 2.0 * np.pi,
    ),
    "rods on all sides of a box": Sum(
        (
            box(9.0, 9.0, 9.0),
            bar(circle(2.0), length=5.0).moved(UPRIGHT, (9.0, 4.0, 5.0)),
            bar(circle(2.0), length=5.0).moved(UPRIGHT, (-5.0, 4.0, 5.0)),
            bar(circle(2.0), length=5.0).moved([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]], (4.0, 9.0, 5.0)),
            bar(hexagon(2.0), length=5.0).moved([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]], (4.0, -5.0, 5.0)),
        ),
        12.0 * np.pi + 4.0 * HEXAGON_AREA,
    ),
    "three boxes in a row": Sum(
        (box(9.0, 9.0, 9.0), *(box(9.0, 9.0, 9.0).moved(EYE, (x, 0.0, 0.0)) for x in (9.0, -9.0))), 162.0
    ),
    "a small disc on a long plate": Sum(
        (box(100.0, 10.0, 1.0), bar(circle(0.5), length=1.0).moved(EYE, (73.0, 1.0, 1.0))), 0.25 * np.pi
    ),
    "two gears apart": Sum((GEAR, GEAR.moved(turned(0.1), (160.0, 0.0, 0.0))), 0.0, 2),
    "a ball in a hollow": Sum(
        (
            bar(circle(5.0), circle(3.0, sense=-1), length=9.0),
            gw.revolve(gw.Section(loops=(HALF_DISC,))).moved(EYE, (0.5, 0.0, 4.0)),
        ),
        0.0,
        2,
    ),
}
CASES = [pytest.param(case, id=name) for name, case in SUMS.items()]


@pytest.mark.parametrize("case", CASES)
class TestEverySum:
    def test_its_moments_are_those_of_the_parts_and_of_the_flux_through_its_boundary(self, case):
        whole, flux = case.whole.moments, flux_moments(case.whole.boundary)
        size = np.cbrt(flux.volume)
        assert whole.method == "exact"
        assert whole.volume == pytest.approx(flux.volume, rel=1e-12)
        np.testing.assert_allclose(whole.centroid, flux.centroid, atol=1e-12 * size)
        norm = np.linalg.norm(flux.central_second)
        np.testing.assert_allclose(whole.central_second, flux.central_second, atol=1e-12 * norm)
        assert 0.0 < whole.error_bound < 1e-12
        added = case.solids[0].properties()
        for part in case.solids[1:]:
            added = added + part.properties()
        np.testing.assert_allclose(case.whole.properties().central_second, added.central_second, atol=1e-13 * norm)

    def test_glued_faces_are_gone(self, case):
        parts = sum(solid.properties().area for solid in case.solids)
        assert case.whole.properties().area == pytest.approx(parts - 2.0 * case.contact, rel=1e-9)

    def test_its_polyhedron_is_a_watertight_manifold_near_it(self, case):
        tolerance = 3e-4 * float(np.linalg.norm(np.ptp(case.whole.properties().bounding_box, axis=0)))
        body = case.whole.polyhedron(tolerance)
        triangles = body.triangles()
        assert edges_pair_up(triangles)
        assert set(fans_at_vertices(triangles)) == {1}
        assert components(triangles) == case.pieces
        if case.pieces == 1:
            assert genus(triangles) == case.holes
        exact, found = case.whole.properties(), body.properties()
        assert abs(found.volume - exact.volume) <= tolerance * exact.area
        assert np.max(np.abs(found.bounding_box - exact.bounding_box)) <= tolerance
        assert abs(found.area - exact.area) <= 0.01 * exact.area

    def test_it_can_be_moved(self, case):
        rotation, shift = [[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]], (3.0, -7.0, 11.0)
        moved = case.whole.moved(rotation, shift)
        expected, found = case.whole.properties().moved(rotation, shift), moved.properties()
        assert found.volume == pytest.approx(expected.volume, rel=1e-14)
        np.testing.assert_allclose(found.centroid, expected.centroid, rtol=1e-14)
        np.testing.assert_allclose(
            found.central_second, expected.central_second, atol=1e-14 * np.linalg.norm(expected.central_second)
        )
        assert flux_moments(moved.boundary).volume == pytest.approx(found.volume, rel=1e-12)


def test_a_stack_of_cylinders_in_closed_form():
    """Radii 8, 5 and 3, lengths 40, 5 and 2."""
    whole = (
        bar(circle(8.0), length=40.0)
        + bar(circle(5.0), length=5.0).moved(EYE, up(40.0))
        + bar(circle(3.0), length=2.0).moved(EYE, up(45.0))
    ).properties(2.0)
    volumes, middles = np.pi * np.array([2560.0, 125.0, 18.0]), np.array([20.0, 42.5, 46.0])
    assert whole.mass == pytest.approx(2.0 * volumes.sum(), rel=1e-15)
    np.testing.assert_allclose(whole.centroid, [0.0, 0.0, volumes @ middles / volumes.sum()], atol=1e-14)
    assert whole.inertia[2, 2] == pytest.approx(volumes @ np.array([64.0, 25.0, 9.0]), rel=1e-14)
    across = volumes @ (np.array([64.0, 25.0, 9.0]) / 4.0 + np.array([1600.0, 25.0, 4.0]) / 12.0 + middles**2)
    assert whole.inertia[0, 0] == pytest.approx(2.0 * across, rel=1e-14)
    assert whole.area == pytest.approx(np.pi * (2 * 64 + 2 * 8 * 40 + 2 * 5 * 5 + 2 * 3 * 2), rel=1e-12)


def test_a_stack_of_equal_sections_is_the_longer_bar():
    section = gw.Section(loops=(hexagon(3.0), circle(1.0, pieces=6, sense=-1)))
    whole, long = gw.extrude(section, 10.0) + gw.extrude(section, 5.0).moved(EYE, up(10.0)), gw.extrude(section, 15.0)
    np.testing.assert_allclose(whole.properties().moments, long.properties().moments, rtol=1e-14, atol=1e-10)
    assert len(whole.boundary.caps) == len(long.boundary.caps) == 2
    assert {patch.pattern.order for patch in whole.boundary.patches} == {6}


def test_patterns_are_kept_where_they_go_with_the_gluing():
    hub = bar(circle(20.0), length=30.0).moved(turned(0.3), up(50.0))
    assert sorted({patch.pattern.order for patch in (GEAR + hub).boundary.patches}) == [1, 16]


def test_both_orders_of_a_sum_are_one_body():
    shaft, plate = bar(circle(8.0), length=40.0), bar(hexagon(12.0), length=5.0).moved(EYE, up(40.0))
    one, other = (shaft + plate).properties(), (plate + shaft).properties()
    np.testing.assert_allclose(one.moments, other.moments, rtol=1e-14, atol=1e-9)
    assert one.area == pytest.approx(other.area, rel=1e-12)


def test_the_volume_of_polyhedra_converges_with_the_tolerance():
    whole = SUMS["a hub with the bore of its gear"].whole
    errors = [
        whole.moments.volume - whole.polyhedron(tolerance).properties().volume for tolerance in (0.08, 0.02, 0.005)
    ]
    assert errors[0] > 2.5 * errors[1] > 6.25 * errors[2] > 0.0


def test_a_sum_is_written_and_read_again(tmp_path):
    whole = SUMS["a plate on the end of a shaft"].whole
    whole.save(tmp_path / "part.stl")
    assert gw.Polyhedron.load(tmp_path / "part.stl").properties().volume == pytest.approx(
        whole.moments.volume, rel=1e-3
    )


@dataclass(frozen=True, kw_only=True)
class ByFlux(Solid):
    """A solid whose moments nobody knows in closed form."""

    bounds: Boundary

    @property
    def boundary(self) -> Boundary:
        return self.bounds

    @property
    def moments(self) -> BodyMoments:
        return flux_moments(self.bounds)


def test_a_sum_is_as_exact_as_its_parts():
    shaft = bar(circle(8.0), length=40.0)
    plate = ByFlux(bounds=bar(hexagon(12.0), length=5.0).moved(EYE, up(40.0)).boundary)
    assert (shaft + plate).properties().method == "quadrature"
    assert (shaft + plate).properties().error_bound >= plate.moments.error_bound


class TestRefusals:
    shaft = bar(circle(8.0), length=40.0)

    def refusal(self, first, second):
        with pytest.raises(gw.GeometryError) as caught:
            first + second
        text = str(caught.value)
        assert text.startswith("The solids cannot be added:")
        return text

    def test_end_faces_that_overlap_in_part(self):
        text = self.refusal(self.shaft, bar(hexagon(12.0), length=5.0).moved(EYE, (9.0, 0.0, 40.0)))
        assert "face finish of the first and face start of the second" in text
        assert "cross or touch" in text
        x, y, z = (float(w) for w in text.split("near (")[1].split(")")[0].split(","))
        assert (np.hypot(x, y), z) == (pytest.approx(8.0, abs=0.1), 40.0)

    def test_loops_that_touch_from_inside(self):
        angle = 0.7
        off = (4.0 * np.cos(angle), 4.0 * np.sin(angle), 40.0)
        assert "cross or touch" in self.refusal(self.shaft, bar(circle(4.0), length=5.0).moved(EYE, off))

    def test_faces_that_are_flush_on_one_side(self):
        text = self.refusal(box(3.0, 3.0, 3.0), box(1.0, 1.0, 1.0).moved(EYE, (0.0, 1.0, 3.0)))
        assert "their borders are the same only in part" in text

    def test_an_end_that_only_fills_the_mouth_of_a_bore(self):
        tube = bar(circle(8.0), circle(4.0, sense=-1), length=40.0)
        text = self.refusal(tube, bar(circle(4.0), length=5.0).moved(EYE, up(40.0)))
        assert "touch along an edge" in text

    def test_a_shaft_as_thick_as_its_bore(self):
        tube = bar(circle(8.0), circle(4.0, sense=-1), length=40.0)
        assert "touches" in self.refusal(tube, bar(circle(4.0), length=60.0).moved(EYE, up(-10.0)))

    @pytest.mark.parametrize(
        ("gap", "word"), [(-1.0, "overlaps"), (-1e-3, "overlaps"), (0.0, "touches"), (1e-6, "touches"), (1e-3, None)]
    )
    def test_round_bars_side_by_side(self, gap, word):
        angle = 1.0  # where neither has an edge nor a sample
        away = 13.0 + gap
        other = bar(circle(5.0), length=4.0).moved(EYE, (away * np.cos(angle), away * np.sin(angle), 7.0))
        if word is None:
            assert len((self.shaft + other).boundary.caps) == 4
        else:
            assert word in self.refusal(self.shaft, other)

    @pytest.mark.parametrize(("lift", "word"), [(-0.5, "overlaps"), (0.0, "touches"), (0.01, None)])
    def test_a_ball_on_a_plate(self, lift, word):
        plate = bar(hexagon(12.0), length=4.0)
        ball = gw.revolve(gw.Section(loops=(HALF_DISC,))).moved(turned(0.2), (1.0, 2.0, 5.0 + lift))
        if word is None:
            assert (plate + ball).properties().volume == pytest.approx(plate.moments.volume + 4.0 * np.pi / 3.0)
        else:
            assert word in self.refusal(plate, ball)

    def test_a_body_inside_another(self):
        text = self.refusal(bar(hexagon(30.0), length=60.0), self.shaft.moved(EYE, (1.0, 2.0, 9.0)))
        assert "the second overlaps the first near (" in text

    def test_a_body_around_another(self):
        text = self.refusal(self.shaft.moved(EYE, (1.0, 2.0, 9.0)), bar(hexagon(30.0), length=60.0))
        assert "overlaps" in text

    def test_the_same_body_twice(self):
        self.refusal(GEAR, GEAR)

    @pytest.mark.parametrize("gap", [1e-6, -1e-6, 3e-5])
    def test_a_gap_too_small_to_be_meant(self, gap):
        plate = bar(hexagon(12.0), length=5.0).moved(EYE, up(40.0 + gap))
        assert "touches" in self.refusal(self.shaft, plate)

    def test_what_is_no_solid(self):
        with pytest.raises(TypeError):
            self.shaft + 3
        with pytest.raises(TypeError):
            self.shaft + self.shaft.properties()


@pytest.mark.parametrize(("gap", "caps"), [(1e-9, 3), (-1e-9, 3), (1e-3, 4)])
def test_a_gap_of_rounding_is_none_and_a_real_one_is_kept(gap, caps):
    plate = bar(hexagon(12.0), length=5.0).moved(EYE, up(40.0 + gap))
    assert len((bar(circle(8.0), length=40.0) + plate).boundary.caps) == caps


def test_nested_borders_may_come_close():
    """Down to a hundred-thousandth of the size, finer than any first look at the borders."""
    whole = bar(circle(8.0), length=4.0) + bar(circle(8.0 - 2e-4), length=4.0).moved(EYE, up(4.0))
    assert len(whole.boundary.caps) == 3
    assert whole.properties().area == pytest.approx(np.pi * (128.0 + 64.0 + 8.0 * (8.0 - 2e-4)), rel=1e-9)
