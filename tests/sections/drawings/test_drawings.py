"""From loose curves to one region: joints, twins, holes, regions, and files of any kind."""

import random
import re
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.bezier import Bezier
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.line import Line
from gearwright.curves.rational_bezier import RationalBezier
from gearwright.sections import drawings
from gearwright.sections.drawings.chains import JOINT, closed_chains
from gearwright.sections.drawings.joints import fitted
from gearwright.sections.loop import Loop

from .drawn import csv, dxf, svg

FRACTIONS = np.linspace(0.0, 1.0, 41)


def load(folder, draw, **options):
    return gw.Section.load(dxf(folder, draw), **options)


def numbers(text):
    """The places (x, y) that a message names."""
    return [tuple(map(float, pair)) for pair in re.findall(r"\(([-+\d.e]+), ([-+\d.e]+)\)", text)]


def square_with_gap(size, gap):
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, gap / size)]) * size

    def draw(_, space):
        for a, b in pairwise(corners):
            space.add_line(a, b)

    return draw


class TestJoints:
    @pytest.mark.parametrize("size", [1.0, 100.0])
    def test_a_visible_gap_is_refused_with_both_ends_and_the_distance(self, tmp_path, size):
        with pytest.raises(gw.GeometryError, match=r"0\.001 apart") as error:
            load(tmp_path, square_with_gap(size, 1e-3))
        np.testing.assert_allclose(sorted(numbers(str(error.value))), [(0, 0), (0, 1e-3)], atol=1e-12)
        assert len(error.value.problems) == 1

    @pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-7, 0.9 * JOINT])
    def test_a_gap_of_rounding_is_joined(self, tmp_path, gap):
        section = load(tmp_path, square_with_gap(1.0, gap))
        assert section.moments[0, 0] == pytest.approx(1.0, abs=gap + 1e-14)
        assert len(section.loops[0].curves) == 4

    def test_the_tolerance_is_relative_to_the_drawing(self, tmp_path):
        for gap, joined in [(0.9 * JOINT, True), (1.1 * JOINT, False)]:
            for size in (1e-3, 1e5):
                draw = square_with_gap(size, gap * size)
                if joined:
                    load(tmp_path, draw)
                else:
                    with pytest.raises(gw.GeometryError, match="open ends"):
                        load(tmp_path, draw)

    def test_a_single_line_has_two_open_ends(self, tmp_path):
        with pytest.raises(gw.GeometryError, match=r"open ends at \(1, 2\) and \(4, 6\), 5 apart"):
            load(tmp_path, lambda _, s: s.add_line((1, 2), (4, 6)))

    def test_an_end_where_three_curves_meet_is_refused_once_with_its_place(self, tmp_path):
        def draw(document, space):
            square_with_gap(2.0, 0.0)(document, space)
            space.add_line((2, 2), (3, 3))

        with pytest.raises(gw.GeometryError, match=r"3 ends of curves meet at \(2, 2\)") as error:
            load(tmp_path, draw)
        assert "(3, 3)" in str(error.value)
        assert len(error.value.problems) == 2

    def test_curves_shorter_than_a_joint_are_passed_over_and_counted(self, tmp_path):
        def draw(document, space):
            square_with_gap(2.0, 1e-6)(document, space)
            space.add_line((0, 0), (0, 1e-6))

        drawing = drawings.read(dxf(tmp_path, draw))
        assert drawing.passed_over == {"curve shorter than a joint": 1}

    def test_many_places_are_counted_after_the_first(self, tmp_path):
        def draw(_, space):
            for k in range(40):
                space.add_line((k, 0), (k, 0.3))

        with pytest.raises(gw.GeometryError, match="28 more: of the same kinds") as error:
            load(tmp_path, draw)
        assert len(error.value.problems) == 13


def open_curves():
    return [
        Line(first=(0.0, 0.0), last=(3.0, 1.0)),
        Arc(radius=2.0, centre=(1.0, 1.0), interval=(0.3, 2.0)),
        Arc(radius=2.0, centre=(1.0, 1.0), interval=(0.3, 6.5)),
        Arc(radius=2.0, centre=(1.0, 1.0), interval=(2.0, -4.2)),
        EllipticArc(centre=(1.0, 0.0), a=(2.0, 0.4), b=(-0.1, 1.0), interval=(0.0, 6.0)),
        EllipticArc(centre=(1.0, 0.0), a=(2.0, 0.4), b=(-0.1, 1.0), interval=(1.0, -1.0)),
        Bezier(control=((0.0, 0.0), (1.0, 2.0), (3.0, -1.0), (2.0, 2.0))),
        Bezier(control=((0.0, 0.0), (1.0, 2.0), (3.0, -1.0), (2.0, 2.0))).reversed(),
        RationalBezier(control=((0.0, 0.0), (1.0, 2.0), (3.0, -1.0)), weights=(1.0, 0.4, 2.0)).reversed(),
    ]


class TestFitting:
    @pytest.mark.parametrize("first", open_curves(), ids=lambda c: type(c).__name__)
    @pytest.mark.parametrize("second", [0, 1, 4, 6, 8])
    def test_gaps_close_and_nothing_moves_by_much_more(self, first, second):
        """The first curve and its neighbour, which is brought to it with gaps of 1e-6 at both ends."""
        gap = 1e-6 * np.array([[0.6, -0.8], [1.0, 0.0]])
        start, end = first.end + gap[0], first.start + gap[1]
        joining = brought(open_curves()[second], start, end)
        chain = fitted([first, joining])
        Loop(curves=chain)  # refuses gaps
        for before, after in zip(chain, (*chain[1:], chain[0]), strict=True):
            assert np.linalg.norm(before.end - after.start) <= 1e-14
        drawn = np.concatenate([c.point(c.parameter(FRACTIONS)) for c in (first, joining)])
        new = np.concatenate([c.point(c.parameter(np.linspace(0, 1, 4001))) for c in chain])
        distances = np.min(np.linalg.norm(drawn[:, None] - new[None], axis=2), axis=1)
        assert distances.max() <= 3e-3  # the samples' spacing; the points themselves:
        assert nearest(drawn, chain) <= 3e-6

    def test_a_chain_without_gaps_stays_as_it_is(self):
        a, b = Line(first=(0.0, 0.0), last=(1.0, 0.0)), Line(first=(1.0, 0.0), last=(0.0, 1.0))
        chain = (a, b, Line(first=(0.0, 1.0), last=(0.0, 0.0)))
        assert fitted(chain) == chain

    def test_a_line_moves_to_the_end_of_an_arc(self):
        arc = Arc(radius=1.0, interval=(0.0, np.pi))
        line = Line(first=(-1.0, 1e-7), last=(1.0, 1e-7))
        chain = fitted([arc, line])
        assert chain[0] == arc
        np.testing.assert_array_equal([chain[1].start, chain[1].end], [arc.end, arc.start])


def brought(curve, start, end):
    """A curve with other ends: its control points or vectors under the similarity that takes its ends there."""
    a, b, p, q = (complex(*z) for z in (curve.start, curve.end, start, end))
    factor = (q - p) / (b - a)

    def image(point):
        z = p + factor * (complex(*point) - a)
        return (z.real, z.imag)

    def vector(v):
        z = factor * complex(*v)
        return (z.real, z.imag)

    match curve:
        case Line():
            return Line(first=image(curve.first), last=image(curve.last))
        case Arc():
            turn = np.angle(factor)
            interval = (curve.interval[0] + turn, curve.interval[1] + turn)
            return Arc(radius=curve.radius * abs(factor), centre=image(curve.centre), interval=interval)
        case EllipticArc():
            vectors = {"a": vector(curve.a), "b": vector(curve.b)}
            return EllipticArc(centre=image(curve.centre), interval=curve.interval, **vectors)
        case Bezier():
            return Bezier(control=tuple(map(image, curve.control)), interval=curve.interval)
    control = tuple(map(image, curve.control))
    return RationalBezier(control=control, weights=curve.weights, interval=curve.interval)


def nearest(points, chain):
    """The largest distance of points from a chain, by the feet of perpendiculars (Newton from samples)."""
    worst = 0.0
    for p in points:
        best = np.inf
        for c in chain:
            u = c.parameter(np.linspace(0, 1, 401))
            u0 = u[np.argmin(np.linalg.norm(c.point(u) - p, axis=1))]
            low, high = sorted(c.interval)
            for _ in range(5):
                d = c.derivative(u0)
                u0 = np.clip(u0 - (c.point(u0) - p) @ d / (d @ d), low, high)
            best = min(best, float(np.linalg.norm(c.point(u0) - p)))
        worst = max(worst, best)
    return worst


class TestTwins:
    def test_a_curve_drawn_twice_is_refused_with_its_place(self, tmp_path):
        def draw(document, space):
            square_with_gap(2.0, 0.0)(document, space)
            space.add_line((2, 2), (2, 0))  # the other way

        with pytest.raises(gw.GeometryError, match=r"drawn twice: the curve from \(2, 0\) by way of \(2, 1\)"):
            load(tmp_path, draw)

    def test_a_circle_drawn_twice_is_refused_though_its_curves_differ(self, tmp_path):
        def draw(_, space):
            space.add_circle((3, 4), 2)
            space.add_arc((3, 4), 2, 17, 200)
            space.add_arc((3, 4), 2, 200, 17)

        with pytest.raises(gw.GeometryError, match=r"drawn twice: the loop about \(3, 4\), 4 wide and 4 high"):
            load(tmp_path, draw)

    def test_loops_that_share_their_centre_and_area_only_are_no_twins(self, tmp_path):
        """A square and the same one turned by 45° cross."""

        def draw(_, space):
            for turn in (0.0, np.pi / 4):
                points = [(np.cos(turn + k * np.pi / 2), np.sin(turn + k * np.pi / 2)) for k in range(4)]
                space.add_lwpolyline(points, close=True)

        with pytest.raises(gw.GeometryError, match="cross or touch"):
            load(tmp_path, draw)

    def test_two_arcs_between_the_same_ends_are_no_twins(self, tmp_path):
        def draw(_, space):
            space.add_arc((0, -1), np.sqrt(2), 45, 135)
            space.add_arc((0, 1), np.sqrt(2), 225, 315)

        assert load(tmp_path, draw).moments[0, 0] == pytest.approx(np.pi - 2, rel=1e-13)


class TestRegions:
    def test_the_sense_of_a_drawing_means_nothing(self, tmp_path):
        corners = [(0, 0), (5, 0), (5, 5), (0, 5)]
        hole = [(1, 1), (2, 1), (2, 3)]
        for a in (1, -1):
            for b in (1, -1):

                def draw(_, space, a=a, b=b):
                    space.add_lwpolyline(hole[::b], close=True)
                    space.add_lwpolyline(corners[::a], close=True)

                section = load(tmp_path, draw)
                assert section.moments[0, 0] == pytest.approx(24, rel=1e-14)
                assert [len(loop.curves) for loop in section.loops] == [4, 3]

    @staticmethod
    def rings(*radii, at=(0, 0)):
        def draw(_, space):
            for radius in radii:
                space.add_circle(at, radius)

        return draw

    def test_an_island_in_a_hole_is_a_region_of_its_own(self, tmp_path):
        path = dxf(tmp_path, self.rings(5, 4, 2, 1))
        with pytest.raises(gw.GeometryError, match=r"holds 2 regions.*around=\(x, y\)") as error:
            gw.Section.load(path)
        assert [str(p).split(", with ")[1] for p in error.value.problems] == ["1 hole", "1 hole"]
        assert gw.Section.load(path, around=(0, 0)).moments[0, 0] == pytest.approx(3 * np.pi, rel=1e-13)
        assert gw.Section.load(path, around=(3, 0)).moments[0, 0] == pytest.approx(9 * np.pi, rel=1e-13)
        assert gw.Section.load(path, around=(0, 4.5)).moments[0, 0] == pytest.approx(9 * np.pi, rel=1e-13)

    def test_regions_apart_are_named_with_places_sizes_and_layers(self, tmp_path):
        def draw(_, space):
            space.add_circle((0, 0), 2, dxfattribs={"layer": "A"})
            space.add_circle((0, 0), 1, dxfattribs={"layer": "A"})
            space.add_lwpolyline([(10, 0), (13, 0), (13, 2), (10, 2)], close=True, dxfattribs={"layer": "B"})

        path = dxf(tmp_path, draw)
        with pytest.raises(gw.GeometryError) as error:
            gw.Section.load(path)
        text = str(error.value)
        assert "one layer as layer= (A, B)" in text
        assert "region 1: loop about (0, 0), 4 wide and 4 high, with 1 hole" in text
        assert "region 2: loop about (11.5, 1), 3 wide and 2 high, with no holes" in text
        assert gw.Section.load(path, layer="B").moments[0, 0] == pytest.approx(6, rel=1e-14)
        assert gw.Section.load(path, around=(11, 1)).moments[0, 0] == pytest.approx(6, rel=1e-14)
        with pytest.raises(gw.GeometryError, match=r"no region around \(5, 0\)"):
            gw.Section.load(path, around=(5, 0))

    @pytest.mark.parametrize("around", ["middle", (1,), (1, np.nan), 3])
    def test_a_place_is_two_numbers(self, tmp_path, around):
        with pytest.raises(gw.GeometryError, match="two finite coordinates"):
            load(tmp_path, self.rings(5), around=around)

    def test_crossing_loops_are_refused_with_both(self, tmp_path):
        def draw(_, space):
            space.add_circle((0, 0), 2)
            space.add_circle((3, 0), 2)

        with pytest.raises(gw.GeometryError, match="cross or touch") as error:
            load(tmp_path, draw)
        assert {(0, 0), (3, 0)} <= set(numbers(str(error.value)))

    @pytest.mark.parametrize("wall", [0.1, 1e-3])
    @pytest.mark.parametrize("start", [0.0, 0.61, 77.7])
    def test_the_hole_of_a_thin_ring_is_a_hole(self, tmp_path, wall, start):
        def draw(_, space):
            space.add_circle((0, 0), 1)
            space.add_arc((0, 0), 1 - wall, start, start + 360)

        assert load(tmp_path, draw).moments[0, 0] == pytest.approx(np.pi * (1 - (1 - wall) ** 2), rel=1e-11)

    def test_a_loop_that_encloses_nothing_is_refused(self, tmp_path):
        def draw(_, space):
            space.add_circle((0, 0), 5)
            space.add_lwpolyline([(1, 1), (3, 1), (2, 1)], close=True)

        with pytest.raises(gw.GeometryError, match=r"loop about \(2, 1\), 2 wide and 0 high: this encloses nothing"):
            load(tmp_path, draw)

    @pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6, 1e-5, -1e-5])
    def test_arcs_there_and_in_two_pieces_back_enclose_nothing(self, tmp_path, gap):
        sagitta = 5.0 + gap
        half = np.tan(np.arctan(sagitta / 10.0) / 2.0)

        def draw(_, space):
            outline = [(-10, 0, 0, 0, 0.5), (10, 0, 0, 0, -half), (0, -sagitta, 0, 0, -half)]
            space.add_lwpolyline(outline, close=True)

        with pytest.raises(gw.GeometryError, match="high: this encloses nothing: a line there and back"):
            load(tmp_path, draw)

    def test_halves_that_add_up_to_nothing_are_told_as_what_crosses(self, tmp_path):
        def draw(_, space):
            space.add_lwpolyline([(0, 0), (10, 10), (10, 0), (0, 10)], close=True)

        with pytest.raises(gw.GeometryError, match=r"10 wide and 10 high, at \(5, 5\): the outline crosses itself"):
            load(tmp_path, draw)


@settings(deadline=None, max_examples=60)
@given(
    sides=st.lists(st.integers(3, 7), min_size=1, max_size=5),
    seed=st.integers(0, 10**6),
    digits=st.integers(7, 16),
)
def test_chains_of_shuffled_reversed_rounded_lines_are_the_polygons(sides, seed, digits):
    chance = random.Random(seed)
    polygons = []
    for k, n in enumerate(sides):
        phase = chance.random()
        angles = 2 * np.pi * (np.arange(n) + phase) / n
        polygons.append(np.stack([3 * k + np.cos(angles), np.sin(angles)], axis=1))
    lines = []
    for polygon in polygons:
        for a, b in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
            ends = [tuple(float(f"{x + chance.uniform(-1, 1) * 10.0**-digits:.{digits}f}") for x in p) for p in (a, b)]
            chance.shuffle(ends)
            lines.append(Line(first=ends[0], last=ends[1]))
    chance.shuffle(lines)
    chains = [fitted(chain) for chain in closed_chains(lines, JOINT)]
    chains.sort(key=lambda chain: chain[0].start[0])  # the polygons lie side by side
    for chain, polygon in zip(chains, polygons, strict=True):
        apart = np.linalg.norm(np.array([c.start for c in chain])[:, None] - polygon[None], axis=2)
        assert len(chain) == len(polygon)
        assert np.all(apart.min(axis=0) <= 1e-6)


class TestFiles:
    def test_the_three_formats_give_the_same_section(self, tmp_path):
        files = [
            dxf(tmp_path, lambda _, s: s.add_lwpolyline([(0, 0), (4, 0), (1, 3)], close=True)),
            svg(tmp_path, '<polygon points="0,0 4,0 1,-3"/>'),
            csv(tmp_path, "0,0\n4,0\n1,3\n"),
        ]
        for path in files:
            np.testing.assert_allclose(gw.Section.load(path).moments[:2, 0], [6, 10], rtol=1e-13)
            upper = path.rename(path.with_suffix(path.suffix.upper()))
            np.testing.assert_allclose(gw.Section.load(str(upper)).moments[0, 1], 6, rtol=1e-13)

    @pytest.mark.parametrize("name", ["gear.step", "gear", "gear.dxf.bak", "."])
    def test_other_names_are_refused_with_what_is_read(self, name):
        with pytest.raises(gw.FileError, match=r"read from \.dxf, \.svg, \.csv"):
            gw.Section.load(name)

    @pytest.mark.parametrize("suffix", [".dxf", ".svg", ".csv"])
    def test_missing_empty_and_huge_files_are_refused(self, tmp_path, suffix):
        path = tmp_path / f"drawing{suffix}"
        with pytest.raises(gw.FileError, match="no such file"):
            gw.Section.load(path)
        path.write_text("\n \n")
        with pytest.raises(gw.FileError, match="empty"):
            gw.Section.load(path)
        with path.open("wb") as stream:
            stream.truncate(3 << 30)
        with pytest.raises(gw.FileError, match="larger than 32 MB"):
            gw.Section.load(path)

    def test_a_drawing_says_what_it_read(self, tmp_path):
        drawing = drawings.read(csv(tmp_path, "0,0\n4,0\n1,3\n"))
        assert (len(drawing.regions), drawing.passed_over, drawing.length_unit) == (1, {}, None)
        assert drawing.region() == drawing.regions[0]
