"""DXF drawings: every kind of outline against closed forms or ezdxf's own flattening."""

import random
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.line import Line
from gearwright.sections import drawings

from .drawn import dxf, polygon_moments, section_moments

SQUARE = [(0, 0), (4, 0), (4, 3), (0, 3)]
HALF_CIRCLE = 1.0  # a bulge: the tangent of a quarter of 180°


def load(folder, draw, **options):
    return gw.Section.load(dxf(folder, draw), **options)


def flattened(entity, distance=1e-7):
    return [(p[0], p[1]) for p in entity.flattening(distance)][:-1]


def test_a_rectangle_with_round_corners_and_a_hole(tmp_path):
    def draw(_, space):
        for a, b in [((1, 0), (9, 0)), ((10, 1), (10, 5)), ((9, 6), (1, 6)), ((0, 5), (0, 1))]:
            space.add_line(b, a)
        for centre, start in [((9, 1), 270), ((9, 5), 0), ((1, 5), 90), ((1, 1), 180)]:
            space.add_arc(centre, 1, start, start + 90)
        space.add_circle((3, 3), 0.5)

    section = load(tmp_path, draw)
    area = 60 - (4 - np.pi) - np.pi / 4
    assert section.moments[0, 0] == pytest.approx(area, rel=1e-14)
    assert section.moments[1, 0] == pytest.approx(5 * (60 - 4 + np.pi) - 3 * np.pi / 4, rel=1e-14)
    assert section.moments[0, 1] == pytest.approx(3 * area, rel=1e-14)
    assert [len(loop.curves) for loop in section.loops] == [8, 1]


def test_an_ellipse_and_half_of_one(tmp_path):
    whole = load(tmp_path, lambda _, space: space.add_ellipse((5, -2), (3, 4), 0.3))
    assert whole.moments[0, 0] == pytest.approx(np.pi * 5 * 1.5, rel=1e-14)

    def half(_, space):
        space.add_ellipse((0, 0), (2, 0), 0.5, 0, np.pi)
        space.add_line((2, 0), (-2, 0))

    section = load(tmp_path, half)
    assert section.moments[0, 0] == pytest.approx(np.pi, rel=1e-14)
    assert section.moments[0, 1] == pytest.approx(2 * 2 / 3, rel=1e-14)  # ∫ y dA = 2 a b² / 3, above the axis


def test_a_whole_circle_as_an_arc_or_an_ellipse_that_starts_anywhere(tmp_path):
    for start in (0.0, 30.0, 123.456):
        arc = load(tmp_path, lambda _, s, a=start: s.add_arc((1, 1), 2, a, a + 360))
        assert arc.moments[0, 0] == pytest.approx(4 * np.pi, rel=1e-14)
        u = np.radians(start)
        ellipse = load(tmp_path, lambda _, s, a=u: s.add_ellipse((1, 1), (2, 0), 0.5, a, round(a + 2 * np.pi, 6)))
        assert ellipse.moments[0, 0] == pytest.approx(2 * np.pi, rel=1e-6)


@pytest.mark.parametrize("kind", ["add_lwpolyline", "add_polyline2d"])
def test_a_bulge_is_an_arc_to_the_left(tmp_path, kind):
    """Counter-clockwise, a positive bulge goes out: half discs of radius 1.5 added right, taken off left."""
    points = [(0, 0, 0), (4, 0, HALF_CIRCLE), (4, 3, 0), (0, 3, -HALF_CIRCLE)]
    section = load(tmp_path, lambda _, space: getattr(space, kind)(points, format="xyb", close=True))
    assert section.moments[0, 0] == pytest.approx(12, rel=1e-14)
    half_disc = np.pi * 1.5**2 / 2
    assert section.moments[1, 0] == pytest.approx(24 + half_disc * 4, rel=1e-13)
    assert sum(isinstance(c, Arc) for c in section.loops[0].curves) == 2


def test_a_polyline_in_space_and_repeated_vertices(tmp_path):
    points = [(x, y, 7.0) for x, y in [(0, 0), (4, 0), (4, 0), (4, 3), (0, 3), (0, 0)]]
    section = load(tmp_path, lambda _, space: space.add_polyline3d(points))
    assert section.moments[0, 0] == pytest.approx(12, rel=1e-14)
    assert len(section.loops[0].curves) == 4


def test_vertices_that_only_steer_a_polyline_are_not_on_it(tmp_path):
    def draw(_, space):
        line = space.add_polyline2d([(0, 0), (9, 9), (4, 0), (4, 3)], close=True)
        line.vertices[1].dxf.flags = 16

    assert load(tmp_path, draw).moments[0, 0] == pytest.approx(6, rel=1e-14)


@pytest.mark.parametrize("weights", [None, [1, 2, 0.5, 1, 3, 1, 0.7, 1]])
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_a_spline_is_exact(tmp_path, degree, weights):
    control = [(0, 0), (5, -1), (6, 3), (4, 6), (2, 3), (-1, 5), (-2, 2), (0, 0)]
    entities = []

    def draw(_, space):
        if weights is None:
            entities.append(space.add_open_spline(control, degree))
        else:
            entities.append(space.add_rational_spline(control, weights, degree))

    section = load(tmp_path, draw)
    expected = polygon_moments(flattened(entities[0]))
    np.testing.assert_allclose(section_moments(section), expected * np.sign(expected[0]), rtol=3e-7)


def test_a_closed_spline_with_open_knots(tmp_path):
    from ezdxf.math import closed_uniform_bspline

    n = 7
    angles = np.arange(n) * 2 * np.pi / n
    points = 3 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tool = closed_uniform_bspline([(*p, 0) for p in points], order=4)
    section = load(tmp_path, lambda _, space: space.add_spline().apply_construction_tool(tool))
    from scipy.interpolate import BSpline

    spline = BSpline(np.arange(n + 7), np.concatenate([points, points[:3]]), 3)
    t = np.linspace(3, n + 3, 20001)[:-1]
    np.testing.assert_allclose(section_moments(section), polygon_moments(spline(t)), rtol=1e-6, atol=1e-6)
    assert len(section.loops[0].curves) == n


@pytest.mark.parametrize("weights", [None, [1, 2, 0.5, 1]])
def test_a_spline_of_the_first_degree_is_lines(tmp_path, weights):
    corners = [(0, 0), (4, 0), (1, 3), (0, 0)]

    def draw(_, space):
        spline = space.add_open_spline(corners, 1)
        spline.weights = weights or []

    section = load(tmp_path, draw)
    assert section.moments[0, 0] == pytest.approx(6, rel=1e-14)
    assert [type(c) for c in section.loops[0].curves] == [Line] * 3


def test_a_circle_as_a_rational_spline(tmp_path):
    w = np.sqrt(0.5)
    control = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]

    def draw(_, space):
        space.add_rational_spline([(10 + x, y) for x, y in control], [1, w] * 4 + [1], 2, knots)

    assert load(tmp_path, draw).moments[0, 0] == pytest.approx(np.pi, rel=1e-14)


def turned_and_mirrored(points):
    """Doubled, mirrored in y, turned by 30° and moved to (5, −1)."""
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    return np.asarray(points) @ np.diag([2.0, -2.0]) @ np.array([[c, s], [-s, c]]) + [5, -1]


def test_inserts_within_inserts_turn_scale_and_mirror(tmp_path):
    shape = [(0, 0), (4, 0), (1, 3)]

    def draw(document, space):
        inner, outer = document.blocks.new("INNER"), document.blocks.new("OUTER")
        inner.add_lwpolyline([(*p, 0.3) for p in shape], format="xyb", close=True)
        outer.add_blockref("INNER", (0, 0), dxfattribs={"xscale": 2, "yscale": -2, "rotation": 30})
        space.add_blockref("OUTER", (5, -1))

    section = load(tmp_path, draw)
    plain = load(tmp_path, lambda _, s: s.add_lwpolyline([(*p, 0.3) for p in shape], format="xyb", close=True))
    assert section.moments[0, 0] == pytest.approx(4 * plain.moments[0, 0], rel=1e-14)
    centroid = plain.moments[[1, 0], [0, 1]] / plain.moments[0, 0]
    np.testing.assert_allclose(
        section.moments[[1, 0], [0, 1]] / section.moments[0, 0], turned_and_mirrored(centroid), rtol=1e-13
    )
    assert all(type(c) is Arc for c in section.loops[0].curves)


def test_an_insert_stretched_one_way_makes_ellipses(tmp_path):
    def draw(document, space):
        block = document.blocks.new("DISC")
        block.add_circle((1, 1), 2)
        space.add_blockref("DISC", (3, 4), dxfattribs={"xscale": 3, "yscale": 0.5, "rotation": 90})

    section = load(tmp_path, draw)
    assert section.moments[0, 0] == pytest.approx(np.pi * 6, rel=1e-13)
    np.testing.assert_allclose(section.moments[[1, 0], [0, 1]] / section.moments[0, 0], [3 - 0.5, 4 + 3], rtol=1e-13)
    assert type(section.loops[0].curves[0]) is EllipticArc


def test_what_cannot_be_shown_of_a_block_is_counted_and_no_outline_is_lost(tmp_path, monkeypatch):
    import ezdxf.entities

    def draw(document, space):
        block = document.blocks.new("PART")
        block.add_text("M8")
        block.add_circle((0, 0), 1)
        space.add_blockref("PART", (2, 3))

    def refuse(self, matrix):
        raise NotImplementedError

    path = dxf(tmp_path, draw)
    monkeypatch.setattr(ezdxf.entities.Text, "transform", refuse)
    assert drawings.read(path).passed_over == {"TEXT": 1}
    monkeypatch.setattr(ezdxf.entities.Circle, "transform", refuse)
    with pytest.raises(gw.FileError, match="a CIRCLE of the block 'PART' cannot be shown"):
        gw.Section.load(path)


def test_rows_and_columns_of_an_insert_are_copies(tmp_path):
    def draw(document, space):
        document.blocks.new("HOLE").add_circle((0, 0), 0.5)
        grid = {"column_count": 3, "row_count": 2, "column_spacing": 2, "row_spacing": 3}
        space.add_blockref("HOLE", (1, 1), dxfattribs=grid)
        space.add_lwpolyline([(0, 0), (6, 0), (6, 5), (0, 5)], close=True)

    section = load(tmp_path, draw)
    assert len(section.loops) == 7
    assert section.moments[0, 0] == pytest.approx(30 - 6 * np.pi / 4, rel=1e-14)
    assert section.moments[0, 1] == pytest.approx(75 - 3 * np.pi / 4 * (1 + 4), rel=1e-13)


def test_what_is_drawn_from_below_is_mirrored(tmp_path):
    """The own x of an entity whose normal is −z runs to −x (DXF's arbitrary axis)."""
    below = {"extrusion": (0, 0, -1)}

    def arcs(_, space):
        space.add_arc((5, 1), 2, 0, 90, dxfattribs=below)  # from (−7, 1) to (−5, 3)
        space.add_lwpolyline([(-7, 1), (-5, 1), (-5, 3)])

    section = load(tmp_path, arcs)
    assert section.moments[0, 0] == pytest.approx(np.pi, rel=1e-14)
    assert section.moments[1, 0] == pytest.approx(np.pi * -5 - 8 / 3, rel=1e-14)

    def polyline(_, space):
        space.add_lwpolyline([(0, 0, 0), (4, 0, 1), (4, 3, 0)], format="xyb", close=True, dxfattribs=below)

    section = load(tmp_path, polyline)
    half_disc = np.pi * 1.5**2 / 2
    assert section.moments[0, 0] == pytest.approx(6 + half_disc, rel=1e-14)
    assert section.moments[1, 0] == pytest.approx(-(6 * 8 / 3 + half_disc * 4 + 2 / 3 * 1.5**3), rel=1e-13)


@st.composite
def bulged_loops(draw):
    """Vertices (x, y, bulge) around the origin, far enough apart for small bulges not to cross."""
    n = draw(st.integers(3, 9))
    radii = draw(st.lists(st.floats(1.0, 1.6), min_size=n, max_size=n))
    bulges = draw(st.lists(st.one_of(st.just(0.0), st.floats(-0.2, 0.2)), min_size=n, max_size=n))
    angles = 2 * np.pi * np.arange(n) / n
    return [(r * np.cos(a), r * np.sin(a), b) for r, a, b in zip(radii, angles, bulges, strict=True)]


def segment(vertex, following):
    """Area between a side's chord and its arc, which turns by four arctangents of the bulge."""
    angle = 4 * np.arctan(vertex[2])
    if abs(angle) < 1e-6:
        return np.hypot(*np.subtract(following, vertex)[:2]) ** 2 * vertex[2] / 3
    radius = np.hypot(*np.subtract(following, vertex)[:2]) / (2 * np.sin(angle / 2))
    return radius**2 / 2 * (angle - np.sin(angle))


@settings(deadline=None, max_examples=30)
@given(vertices=bulged_loops(), seed=st.integers(0, 10**6))
def test_loose_shuffled_and_reversed_sides_are_the_same_section(tmp_path_factory, vertices, seed):
    from ezdxf.math import bulge_to_arc

    folder, chance = tmp_path_factory.mktemp("bulges"), random.Random(seed)

    def sides(_, space):
        pairs = list(zip(vertices, [*vertices[1:], vertices[0]], strict=True))
        chance.shuffle(pairs)
        for (x, y, bulge), (x2, y2, _) in pairs:
            if abs(bulge) <= 1e-8:
                space.add_line(*chance.choice([((x, y), (x2, y2)), ((x2, y2), (x, y))]))
            elif chance.random() < 0.3 or abs(bulge) < 1e-5:  # a flatter arc's centre and angles lose its digits
                space.add_lwpolyline([(x2, y2, -bulge), (x, y, 0)], format="xyb")
            else:
                centre, start, end, radius = bulge_to_arc((x, y), (x2, y2), bulge)
                space.add_arc(centre, radius, np.degrees(start), np.degrees(end))

    expected = load(folder, lambda _, s: s.add_lwpolyline(vertices, format="xyb", close=True))
    area = polygon_moments([v[:2] for v in vertices])[0] + sum(map(segment, vertices, [*vertices[1:], vertices[0]]))
    assert expected.moments[0, 0] == pytest.approx(area, rel=1e-7)
    loose = load(folder, sides)
    scale = np.max(np.abs(section_moments(expected)))
    np.testing.assert_allclose(section_moments(loose), section_moments(expected), rtol=1e-9, atol=1e-9 * scale)


class TestUnitsAndLayers:
    @pytest.mark.parametrize(("code", "unit"), [(0, None), (1, "in"), (4, "mm"), (6, "m")])
    def test_the_header_states_the_unit_and_coordinates_stay(self, tmp_path, code, unit):
        path = dxf(tmp_path, lambda _, s: s.add_circle((0, 0), 1), INSUNITS=code)
        drawing = drawings.read(path)
        assert drawing.length_unit == unit
        assert gw.Section.load(path).moments[0, 0] == pytest.approx(np.pi, rel=1e-14)

    @staticmethod
    def layered(document, space):
        document.layers.add("CUT")
        document.layers.add("ENGRAVING").off()
        space.add_circle((0, 0), 5, dxfattribs={"layer": "CUT"})
        space.add_circle((0, 0), 1, dxfattribs={"layer": "HOLES"})
        space.add_line((0, 0), (9, 9), dxfattribs={"layer": "ENGRAVING"})
        space.add_text("M8")
        space.add_point((1, 1))

    def test_all_layers_but_hidden_ones_are_read(self, tmp_path):
        drawing = drawings.read(dxf(tmp_path, self.layered))
        assert [len(region) for region in drawing.regions] == [2]
        assert drawing.passed_over == {"TEXT": 1, "POINT": 1, "LINE on hidden layer ENGRAVING": 1}
        assert set(drawing.layers) == {"CUT", "HOLES"}

    def test_one_layer_is_read_alone(self, tmp_path):
        section = load(tmp_path, self.layered, layer="cut")
        assert section.moments[0, 0] == pytest.approx(25 * np.pi, rel=1e-14)

    def test_a_layer_that_is_asked_for_is_read_even_if_it_is_off(self, tmp_path):
        with pytest.raises(gw.GeometryError, match=r"open ends at \(0, 0\) and \(9, 9\)"):
            load(tmp_path, self.layered, layer="Engraving")

    def test_a_layer_that_is_not_there_is_refused_with_those_that_are(self, tmp_path):
        with pytest.raises(gw.FileError, match=r"no layer 'TOOL'.*'CUT', 'HOLES'"):
            load(tmp_path, self.layered, layer="TOOL")

    def test_layer_0_of_a_block_is_the_layer_of_its_insert(self, tmp_path):
        def draw(document, space):
            document.blocks.new("DISC").add_circle((0, 0), 1)
            space.add_blockref("DISC", (0, 0), dxfattribs={"layer": "CUT"})
            space.add_circle((9, 0), 1)

        assert load(tmp_path, draw, layer="CUT").moments[1, 0] == pytest.approx(0, abs=1e-14)


class TestRefusals:
    def test_a_cut_off_file(self, tmp_path):
        path = dxf(tmp_path, lambda _, s: s.add_circle((0, 0), 1))
        whole = path.read_bytes()
        for share in (0.3, 0.9, 0.999):
            path.write_bytes(whole[: int(share * len(whole))])
            with pytest.raises(gw.FileError, match="cut off"):
                gw.Section.load(path)

    def test_a_damaged_file(self, tmp_path):
        path = dxf(tmp_path, lambda _, s: s.add_circle((0, 0), 1.25))
        path.write_bytes(path.read_bytes().replace(b"1.25", b"1.x5"))
        with pytest.raises(gw.FileError, match="damaged"):
            gw.Section.load(path)

    def test_a_file_that_is_none(self, tmp_path):
        path = tmp_path / "noise.dxf"
        path.write_bytes(bytes(range(256)) * 100)
        with pytest.raises(gw.FileError, match="no DXF"):
            gw.Section.load(path)

    def test_a_binary_file_is_read_as_the_text_is(self, tmp_path):
        import ezdxf

        path = dxf(tmp_path, lambda _, s: s.add_circle((0, 0), 1))
        ezdxf.readfile(path).saveas(path, fmt="bin")
        assert gw.Section.load(path).moments[0, 0] == pytest.approx(np.pi, rel=1e-14)

    def test_blocks_that_hold_one_another(self, tmp_path):
        def draw(document, space):
            document.blocks.new("A").add_blockref("B", (0, 0))
            document.blocks.new("B").add_blockref("A", (0, 0))
            space.add_blockref("A", (0, 0))

        with pytest.raises(gw.FileError, match="'A' holds itself"):
            load(tmp_path, draw)

    def test_copies_beyond_all_bounds(self, tmp_path, monkeypatch):
        from gearwright.sections.drawings import sheet

        monkeypatch.setattr(sheet, "MOST_CURVES", 500)

        def draw(document, space):
            document.blocks.new("EMPTY")
            space.add_blockref("EMPTY", (0, 0), dxfattribs={"column_count": 32767, "column_spacing": 1})

        with pytest.raises(gw.FileError, match="more than 500"):
            load(tmp_path, draw)

    def test_outlines_at_different_heights(self, tmp_path):
        def draw(_, space):
            space.add_circle((0, 0, 1), 5)
            space.add_circle((0, 0, 2), 1)

        with pytest.raises(gw.FileError, match=r"heights from z = 1 to 2"):
            load(tmp_path, draw)

    def test_an_outline_in_another_plane(self, tmp_path):
        tilted = {"extrusion": (0, 1, 1), "layer": "SIDE"}
        with pytest.raises(gw.FileError, match="CIRCLE on layer SIDE lies in a plane across"):
            load(tmp_path, lambda _, s: s.add_circle((0, 0), 1, dxfattribs=tilted))

    @pytest.mark.parametrize("angles", [(30, 30), (0, 0), (90, 810)])
    def test_an_arc_from_an_angle_to_the_same_one(self, tmp_path, angles):
        with pytest.raises(gw.FileError, match=rf"ARC on layer 0 starts and ends at {angles[0]}°"):
            load(tmp_path, lambda _, s: s.add_arc((0, 0), 1, *angles))

    @pytest.mark.parametrize(
        ("changes", "match"),
        [
            ({"knots": [0, 0, 0, 1, 1]}, "3 control points and 5 knots"),
            ({"knots": [0, 0, 0, 1, 0.5, 1]}, "knots that do not ascend"),
            ({"knots": [1, 1, 1, 1, 1, 1]}, "knots that do not ascend"),
            ({"weights": [1, 1]}, "2 weights"),
            ({"weights": [1, 0, 1]}, "3 weights; one > 0"),
        ],
    )
    def test_a_spline_whose_numbers_do_not_fit(self, tmp_path, changes, match):
        """ezdxf writes any; the refusal says where the spline starts."""

        def draw(_, space):
            spline = space.add_open_spline([(3, 4), (5, 6), (7, 1)], 2)
            for name, values in changes.items():
                setattr(spline, name, values)

        with pytest.raises(gw.FileError, match=rf"control point at \(3, 4\) has.*{match}"):
            load(tmp_path, draw)

    def test_a_spline_of_fit_points_only(self, tmp_path):
        with pytest.raises(gw.FileError, match=r"SPLINE.* starts at \(3, 4\) and has fit points only"):
            load(tmp_path, lambda _, s: s.add_spline([(3, 4), (5, 6), (7, 1), (3, 4)]))

    def test_nothing_to_read_says_what_was_passed_over(self, tmp_path):
        with pytest.raises(gw.FileError, match="no curves in it; passed over: 2 TEXT"):
            load(tmp_path, lambda _, s: [s.add_text("A"), s.add_text("B")])

    def test_a_missing_reader_is_the_machines_fault(self, tmp_path, monkeypatch):
        path = dxf(tmp_path, lambda _, s: s.add_circle((0, 0), 1))
        monkeypatch.setitem(sys.modules, "ezdxf.document", None)
        with pytest.raises(gw.MachineError, match=r"pip install 'gearwright\[drawing\]'"):
            gw.Section.load(path)
