"""Sections written as drawings: what ezdxf and svgpathtools find in the files, against the true curves."""

import re
import sys
from collections import Counter
from itertools import pairwise

import ezdxf
import numpy as np
import pytest
import svgpathtools
from ezdxf import bbox
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.bezier import Bezier
from gearwright.curves.curve import Mapped, mapped, turn
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.involute import Involute
from gearwright.curves.line import Line
from gearwright.curves.rational_bezier import RationalBezier
from gearwright.sections import drawings
from gearwright.sections.drawings.chains import JOINT
from gearwright.sections.drawings.fitting import cubics_along
from gearwright.sections.drawings.writing import FINEST, TOLERANCE
from gearwright.sections.loop import Loop

from .drawn import section_moments

FORMATS = (".dxf", ".svg")


def line(a, b):
    return Line(first=tuple(map(float, a)), last=tuple(map(float, b)))


def closed_by_line(curve):
    return [curve, line(curve.end, curve.start)]


def quintic():
    return Bezier(control=((0.0, 0.0), (5.0, -2.0), (7.0, 1.0), (8.0, 6.0), (2.0, 7.0), (1.0, 3.0)))


def rational(start=0.0, end=1.0):
    return RationalBezier(
        control=((0.0, 0.0), (6.0, -1.0), (7.0, 4.0), (1.0, 5.0)), weights=(1.0, 0.5, 2.0, 1.5), interval=(start, end)
    )


def bored_gear():
    return gw.SpurGear(teeth=7, module=4.0, face_width=5.0, addendum=3.0, bore=10.0, root="radial").profile


def stadium(centre=(2.0, 1.0)):
    """Two half circles and two lines, and a round hole of four arcs that run clockwise."""
    x, y = centre
    right = Arc(radius=3.0, centre=(x + 5.0, y), interval=(-np.pi / 2, np.pi / 2))
    left = Arc(radius=3.0, centre=(x - 5.0, y), interval=(np.pi / 2, 3 * np.pi / 2))
    hole = [Arc(radius=1.5, centre=(x, y), interval=(0.3 - k * np.pi / 2, 0.3 - (k + 1) * np.pi / 2)) for k in range(4)]
    outline = [right, line(right.end, left.start), left, line(left.end, right.start)]
    return gw.Section.outline(outline, [hole])


def mixed():
    """A mirrored and turned arc, an arc of an ellipse under a shear, part of a cubic run backwards, and lines."""
    image = mapped(Arc(radius=2.0, centre=(1.0, 0.5), interval=(2.0, 0.2)), turn(0.7, 2, mirrored=True), (9.0, 4.0))
    oval = mapped(
        EllipticArc(centre=(0.0, 0.0), a=(3.0, 0.5), b=(-0.2, 1.0), interval=(0.4, 2.9)),
        [[1.0, 0.4], [0.1, 1.2]],
        (2.0, 9),
    )
    cubic = Bezier(control=((-6.0, 0.0), (-9.0, 3.0), (-3.0, 6.0), (-6.0, 9.0)), interval=(0.8, 0.1))
    chain = [image, oval, cubic]
    joined = [piece for a, b in pairwise([*chain, image]) for piece in (a, line(a.end, b.start))]
    return gw.Section.outline(joined)


def mirrored_oval():
    """Part of an ellipse whose half diameters run clockwise from the first to the second, turned, and its chord."""
    oval = EllipticArc(centre=(1.0, 2.0), a=(4.0, 0.5), b=(0.3, 2.0), interval=(0.3, 4.0))
    return gw.Section.outline(closed_by_line(mapped(oval, turn(0.4, 2, mirrored=True))))


def image_of_an_image():
    """Half a disc under two maps that do not commute, the inner one with an offset; and its chord."""
    inner = mapped(Arc(radius=2.0, centre=(1.0, 0.0), interval=(0.0, 3.0)), [[2.0, 0.3], [0.0, 1.0]], (3.0, -1.0))
    return gw.Section.outline(closed_by_line(mapped(inner, turn(1.1, 2), (0.5, 4.0))))


def repeated_sides():
    """A hexagon by one of its sides, and a hole like a pinwheel by a third of it, thirds following clockwise."""
    corner = np.array([5.0, 0.0])
    side = line(corner, turn(np.pi / 3, 2) @ corner)
    tip, notch, following = 0.6 * corner, np.array([1.0, 0.5]), 0.6 * turn(-2 * np.pi / 3, 2) @ corner
    notch = turn(-np.pi / 3, 2) @ notch
    third = (line(tip, notch), line(notch, following))
    return gw.Section(loops=(Loop(curves=(side,), copies=6), Loop(curves=third, copies=3)))


SECTIONS = {
    "gear with radial roots and a bore": bored_gear(),
    "gear with its roots above the base circle": gw.SpurGear(
        teeth=7, module=2.0, face_width=5.0, pressure_angle=35.0, addendum=0.8, dedendum=1.2
    ).profile,
    "stadium": stadium(),
    "far stadium": stadium((3000.0, -500.0)),
    "polygon with holes": gw.Section.polygon(
        [(-10, -6), (10, -6), (12, 7), (-8, 6)], [[(-6, -2), (-3, -2), (-3, 2)], [(2, -2), (6, -2), (6, 2), (2, 2)]]
    ),
    "repeated sides": repeated_sides(),
    "spline": gw.Section.spline([(2, 0), (1, 1.5), (-1, 1), (-2, -0.5), (0, -1)]),
    "mixed": mixed(),
    "mirrored oval": mirrored_oval(),
    "image of an image": image_of_an_image(),
    "quintic": gw.Section.outline(closed_by_line(quintic())),
    "rational": gw.Section.outline(closed_by_line(rational())),
    "part of a rational, backwards": gw.Section.outline(closed_by_line(rational(0.9, 0.2))),
    "tiny disc": gw.Section.circle(1e-3, (2e-3, 0.0)),
}

EXACT = {
    ".dxf": set(SECTIONS) - {"gear with radial roots and a bore", "gear with its roots above the base circle"},
    ".svg": {
        "stadium",
        "far stadium",
        "polygon with holes",
        "spline",
        "mixed",
        "mirrored oval",
        "repeated sides",
        "image of an image",
        "tiny disc",
    },
}
"""Sections that the format holds without a tolerance."""

every_section = pytest.mark.parametrize("name", SECTIONS)
every_format = pytest.mark.parametrize("suffix", FORMATS)


def saved(section, folder, suffix, **options):
    path = folder / f"drawing{suffix}"
    section.save(path, **options)
    return path


def space_of(path):
    document = ezdxf.readfile(path)
    return document.modelspace()


def dxf_samples(path, count=60):
    """Points of every entity, by ezdxf's own evaluation."""
    found = []
    for entity in space_of(path):
        fractions = np.linspace(0.0, 1.0, count)
        match entity.dxftype():
            case "LINE":
                a, b = np.array(entity.dxf.start), np.array(entity.dxf.end)
                points = a + fractions[:, None] * (b - a)
            case "ARC":
                points = list(entity.vertices(entity.angles(count)))
            case "CIRCLE":
                points = list(entity.vertices(360.0 * fractions))
            case "ELLIPSE":
                points = list(entity.vertices(entity.params(count)))
            case "SPLINE":
                points = evaluated(entity, 20 * entity.control_point_count())
        found.append(np.array([(p[0], p[1]) for p in points]))
    return found


def evaluated(spline, count):
    """Points of a SPLINE by scipy, from the numbers that the file holds."""
    weights = np.array(spline.weights or np.ones(spline.control_point_count()))[:, None]
    control = np.array(spline.control_points)[:, :2]
    knots = np.array(spline.knots)
    curve = BSpline(knots, np.hstack([control * weights, weights]), spline.dxf.degree)
    homogeneous = curve(np.linspace(knots[0], knots[-1], count))
    return homogeneous[:, :2] / homogeneous[:, 2:]


def svg_samples(path, count=40):
    """Points of every segment, y upwards, by svgpathtools."""
    paths, _ = svgpathtools.svg2paths(str(path))
    fractions = np.linspace(0.0, 1.0, count)
    segments = [segment for path in paths for segment in path]
    values = [np.array([segment.point(t) for t in fractions]) for segment in segments]
    return [np.column_stack([z.real, -z.imag]) for z in values]


SAMPLES = {".dxf": dxf_samples, ".svg": svg_samples}


def curves_of(section):
    return [curve for loop in section.loops for curve in loop.with_copies(1).curves]


def distances(points, section):
    """Distances (n,) of points from the section's true curves, by the feet of perpendiculars on every curve nearby."""
    fractions = np.linspace(0.0, 1.0, 129)
    found = np.full(len(points), np.inf)
    for curve in curves_of(section):
        looks = curve.point(curve.parameter(fractions))
        spacing = 2.0 * np.linalg.norm(np.diff(looks, axis=0), axis=1).max()
        apart, index = cKDTree(looks).query(points, k=2, distance_upper_bound=spacing)
        for column in (0, 1):  # of a whole circle, both sides of its seam
            near = np.flatnonzero(np.isfinite(apart[:, column]))
            first = fractions[np.clip(index[near, column], 1, len(fractions) - 2)]  # at a cusp no step leads away
            found[near] = np.minimum(found[near], distances_from(points[near], curve, curve.parameter(first)))
    return found


def distances_from(points, curve, u):
    """Distances of points from places near their feet, by Gauss–Newton steps from parameters (n,)."""
    low, high = sorted(curve.interval)
    for _ in range(20):  # next to a cusp the steps are short
        d, off = curve.derivative(u), points - curve.point(u)
        squares = np.maximum(np.sum(d * d, axis=-1), 1e-300)
        u = np.clip(u + np.clip(np.sum(off * d, axis=-1) / squares, low - high, high - low), low, high)
    return np.linalg.norm(points - curve.point(u), axis=1)


class TestRoundTrip:
    @every_format
    @every_section
    def test_what_is_loaded_again_has_the_same_moments(self, tmp_path, name, suffix):
        section = SECTIONS[name]
        loaded = gw.Section.load(saved(section, tmp_path, suffix))
        relative = 1e-12 if name in EXACT[suffix] else 20.0 * TOLERANCE
        before, after = section.properties(), loaded.properties()
        assert after.area == pytest.approx(before.area, rel=relative)
        assert after.perimeter == pytest.approx(before.perimeter, rel=relative)
        np.testing.assert_allclose(after.centroid, before.centroid, atol=relative * section.size)
        np.testing.assert_allclose(
            section_moments(loaded), section_moments(section), rtol=0, atol=relative * section_moments(section).max()
        )
        assert len(loaded.loops) == len(section.loops)

    @every_format
    @every_section
    def test_written_and_true_curves_lie_within_the_tolerance(self, tmp_path, name, suffix):
        section = SECTIONS[name]
        path = saved(section, tmp_path, suffix)
        size = section.size
        far = 1e-14 * float(np.abs(section.middle).max())
        most = (1e-13 * size + far) if name in EXACT[suffix] else TOLERANCE * size
        drawn = np.concatenate(SAMPLES[suffix](path))
        assert distances(drawn, section).max() <= most
        loaded = gw.Section.load(path)
        true = np.concatenate([c.point(c.parameter(np.linspace(0, 1, 101))) for c in curves_of(section)])
        assert distances(true, loaded).max() <= most

    @every_format
    def test_a_tolerance_that_is_given_is_kept_and_not_far_undercut(self, tmp_path, suffix):
        section = SECTIONS["gear with radial roots and a bore"]
        sizes = []
        for tolerance in (1e-3, 1e-5, 1e-9 * section.size):
            path = saved(section, tmp_path, suffix, tolerance=tolerance)
            worst = distances(np.concatenate(SAMPLES[suffix](path)), section).max()
            assert 1e-3 * tolerance <= worst <= tolerance
            sizes.append(path.stat().st_size)
            gw.Section.load(path)
        assert sizes == sorted(sizes)

    @every_format
    def test_the_section_stands_where_it_is_and_not_mirrored(self, tmp_path, suffix):
        corners = [(10, 20), (14, 21), (11, 27)]
        loaded = gw.Section.load(saved(gw.Section.polygon(corners), tmp_path, suffix))
        starts = sorted(tuple(np.round(curve.start, 9).tolist()) for curve in loaded.loops[0].curves)
        assert starts == sorted((float(x), float(y)) for x, y in corners)


class TestEntities:
    def test_a_gear_has_true_arcs_a_circle_and_one_spline_a_flank(self, tmp_path):
        path = saved(bored_gear(), tmp_path, ".dxf")
        entities = list(space_of(path))
        assert Counter(e.dxftype() for e in entities) == {"ARC": 14, "LINE": 14, "SPLINE": 14, "CIRCLE": 1}
        gear = gw.SpurGear(teeth=7, module=4.0, face_width=5.0, addendum=3.0, root="radial").toothing
        radii = Counter(round(e.dxf.radius, 9) for e in entities if e.dxftype() == "ARC")
        assert radii == {round(gear.tip_radius, 9): 7, round(gear.root_radius, 9): 7}
        assert [e.dxf.radius for e in entities if e.dxftype() == "CIRCLE"] == [5.0]
        assert {e.dxf.layer for e in entities} == {"profile"}
        box = bbox.extents(entities)
        assert box.size.x <= 2.0 * gear.tip_radius + 1e-6

    def test_the_audit_finds_nothing(self, tmp_path):
        for section in SECTIONS.values():
            audit = ezdxf.readfile(saved(section, tmp_path, ".dxf")).audit()
            assert not audit.errors
            assert not audit.fixes

    @pytest.mark.parametrize(
        ("name", "kinds"),
        [
            ("stadium", {"ARC": 2, "LINE": 2, "CIRCLE": 1}),
            ("spline", {"SPLINE": 1}),
            ("mixed", {"ARC": 1, "ELLIPSE": 1, "SPLINE": 1, "LINE": 3}),
            ("quintic", {"SPLINE": 1, "LINE": 1}),
            ("rational", {"SPLINE": 1, "LINE": 1}),
            ("tiny disc", {"CIRCLE": 1}),
        ],
    )
    def test_curves_stay_what_they_are(self, tmp_path, name, kinds):
        path = saved(SECTIONS[name], tmp_path, ".dxf")
        assert Counter(e.dxftype() for e in space_of(path)) == kinds

    def test_degrees_and_weights_are_kept(self, tmp_path):
        for name, degree, weights in (("quintic", 5, []), ("rational", 3, [1.0, 0.5, 2.0, 1.5])):
            (spline,) = space_of(saved(SECTIONS[name], tmp_path, ".dxf")).query("SPLINE")
            assert (spline.dxf.degree, list(spline.weights)) == (degree, weights)

    def test_what_is_one_line_circle_or_ellipse_is_drawn_once(self, tmp_path):
        square = [(0, 0), (1, 0), (2, 0), (4, 0), (4, 4), (2, 4), (0, 4), (0, 1)]
        path = saved(gw.Section.polygon(square), tmp_path, ".dxf")
        assert Counter(e.dxftype() for e in space_of(path)) == {"LINE": 4}
        cuts = [0.4, 1.0, 2.5, 4.0, 0.4 + 2 * np.pi]
        oval = [EllipticArc(centre=(1.0, 2.0), a=(3.0, 1.0), b=(-0.5, 1.5), interval=(a, b)) for a, b in pairwise(cuts)]
        (ellipse,) = space_of(saved(gw.Section.outline(oval), tmp_path, ".dxf"))
        assert ellipse.dxftype() == "ELLIPSE"
        assert ellipse.dxf.ratio * ellipse.dxf.major_axis.magnitude**2 == pytest.approx(3 * 1.5 + 0.5, rel=1e-13)
        assert gw.Section.load(tmp_path / "drawing.dxf").moments[0, 0] == pytest.approx(5 * np.pi, rel=1e-13)

    def test_arcs_of_one_circle_with_a_corner_between_stay_apart(self, tmp_path):
        """A lens: both arcs have one radius, and other centres."""
        lens = [
            Arc(radius=5.0, centre=(0.0, -3.0), interval=(np.arcsin(0.6), np.pi - np.arcsin(0.6))),
            Arc(radius=5.0, centre=(0.0, 3.0), interval=(np.pi + np.arcsin(0.6), 2 * np.pi - np.arcsin(0.6))),
        ]
        assert Counter(e.dxftype() for e in space_of(saved(gw.Section.outline(lens), tmp_path, ".dxf"))) == {"ARC": 2}

    def test_cubics_with_a_corner_between_stay_apart(self, tmp_path):
        """The corner is of 0.6°; without it they are one SPLINE."""
        for corner, kinds in ((0.0, {"SPLINE": 1, "LINE": 1}), (0.01, {"SPLINE": 2, "LINE": 1})):
            first = Bezier(control=((0.0, 0.0), (0.5, 1.0), (2.0, 2.0), (3.0, 2.0)))
            second = Bezier(control=((3.0, 2.0), (4.0, 2.0 - corner), (6.0, 1.0), (6.0, 0.0)))
            chain = [first, second, line(second.end, first.start)]
            path = saved(gw.Section.outline(chain), tmp_path, ".dxf")
            assert Counter(e.dxftype() for e in space_of(path)) == kinds

    @pytest.mark.parametrize("name", [name for name in SECTIONS if "far" not in name])
    def test_ends_meet_to_the_last_bit(self, tmp_path, name):
        """As ezdxf computes those of arcs; every end is shared by two entities. Ellipses' ends are rounded."""
        ends = Counter()
        for entity in space_of(saved(SECTIONS[name], tmp_path, ".dxf")):
            match entity.dxftype():
                case "LINE":
                    both = [entity.dxf.start, entity.dxf.end]
                case "ARC":
                    both = [entity.start_point, entity.end_point]
                case "SPLINE":
                    both = [entity.control_points[0], entity.control_points[-1]]
                case "ELLIPSE":
                    both = [[round(x, 12) for x in p] for p in (entity.start_point, entity.end_point)]
                case _:
                    both = []
            ends.update((float(p[0]), float(p[1])) for p in both)
        if name in ("mixed", "mirrored oval", "image of an image"):
            ends = Counter((round(x, 12), round(y, 12)) for x, y in ends.elements())
        assert set(ends.values()) <= {2}

    @pytest.mark.parametrize("name", ["gear with radial roots and a bore", "spline"])
    def test_splines_have_no_corners_and_true_tangents_at_their_ends(self, tmp_path, name):
        section = SECTIONS[name]
        curves = curves_of(section)
        for spline in list(space_of(saved(section, tmp_path, ".dxf")).query("SPLINE"))[:4]:
            tool = spline.construction_tool()
            knots = sorted(set(tool.knots()))
            assert len(knots) > 4
            for knot in knots[1:-1]:
                before, after = (np.array(tool.derivative(knot + step, 1)[1])[:2] for step in (-1e-9, 1e-9))
                np.testing.assert_allclose(before, after, atol=1e-4 * np.linalg.norm(after))
                assert Counter(tool.knots())[knot] < tool.degree
            if name == "spline":
                continue
            for at, end in ((knots[0], 0.0), (knots[-1], 1.0)):
                point, tangent = (np.array(v)[:2] for v in tool.derivative(at, 1))
                truth = true_tangent(curves, point, end)
                assert abs(tangent[0] * truth[1] - tangent[1] * truth[0]) <= 1e-9 * np.linalg.norm(tangent)
                assert tangent @ truth > 0.0


def true_tangent(curves, point, end):
    """Direction of the involute with that start (end = 0) or end (1), a hair from its very end, where it may vanish."""
    flanks = [curve for curve in curves if isinstance(innermost(curve), Involute)]
    ends = np.array([flank.point(flank.parameter(end)) for flank in flanks])
    flank = flanks[int(np.argmin(np.linalg.norm(ends - point, axis=1)))]
    rate = flank.derivative(flank.parameter(abs(end - 1e-10))) * np.sign(flank.interval[1] - flank.interval[0])
    return rate / np.linalg.norm(rate)


def innermost(curve):
    return innermost(curve.curve) if isinstance(curve, Mapped) else curve


class TestFitting:
    def test_the_cusp_of_an_involute_is_left_along_the_radius(self):
        control = cubics_along(Involute(base_radius=2.0, interval=(0.0, 0.7)), 1e-6)
        first = control[0, 1] - control[0, 0]
        assert first[0] > 0.0
        assert abs(first[1]) <= 1e-9 * first[0]

    def test_the_finest_pieces_at_a_cusp_are_longer_than_the_gaps_that_readers_close(self):
        control = cubics_along(Involute(base_radius=1.0, interval=(0.0, 0.6)), FINEST)
        lengths = np.linalg.norm(control[:, 3] - control[:, 0], axis=1)
        assert lengths.min() > 2.0 * 2.0 * JOINT  # in a drawing two base radii wide, with as much to spare

    def test_the_pieces_join_in_point_and_direction(self):
        control = cubics_along(Involute(base_radius=2.0, interval=(0.9, 0.1)), 1e-8)
        np.testing.assert_array_equal(control[1:, 0], control[:-1, 3])
        before, after = control[:-1, 3] - control[:-1, 2], control[1:, 1] - control[1:, 0]
        across = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
        assert np.abs(across).max() <= 1e-14 * np.sum(before * after, axis=1).max()
        assert np.sum(before * after, axis=1).min() > 0.0

    def test_a_curve_that_no_spline_follows_is_refused_with_its_place(self):
        class Rough(Line):
            def point(self, u):
                return super().point(u) + 0.01 * np.sin(1e8 * np.asarray(u)[..., None])

        with pytest.raises(gw.GeometryError, match=r"Rough at \(.*\): no spline of 2000 pieces comes within 0\.001"):
            cubics_along(Rough(first=(0.0, 0.0), last=(1.0, 1.0)), 1e-3)


class TestSvg:
    def test_one_path_holds_all_loops_and_the_holes_stay_open(self, tmp_path):
        path = saved(SECTIONS["polygon with holes"], tmp_path, ".svg")
        paths, attributes = svgpathtools.svg2paths(str(path))
        assert len(paths) == 1
        assert attributes[0]["fill-rule"] == "evenodd"
        assert len(paths[0].continuous_subpaths()) == 3
        assert all(part.isclosed() for part in paths[0].continuous_subpaths())
        assert Counter(type(s).__name__ for s in paths[0]) == {"Line": 11}
        text = path.read_text()
        assert (text.count("M"), text.count("L"), text.count("Z")) == (3, 8, 3)

    def test_arcs_are_arcs_and_splines_cubics(self, tmp_path):
        paths, _ = svgpathtools.svg2paths(str(saved(bored_gear(), tmp_path, ".svg")))
        kinds = Counter(type(segment).__name__ for segment in paths[0])
        assert (kinds["Arc"], kinds["Line"]) == (14 + 3, 14)
        assert set(kinds) == {"Arc", "Line", "CubicBezier"}
        text = (tmp_path / "drawing.svg").read_text()
        assert re.search(r'd="([^"]*)"', text)[1].count("A5 5 ") == 3

    @pytest.mark.parametrize("unit", ["mm", "in"])
    def test_the_page_is_as_large_as_the_section_in_its_unit(self, tmp_path, unit):
        path = saved(stadium(), tmp_path, ".svg", length_unit=unit)
        text = path.read_text()
        width, height = (re.search(rf'{side}="([\d.]+){unit}"', text)[1] for side in ("width", "height"))
        assert 16.0 <= float(width) <= 17.0
        assert 6.0 <= float(height) <= 7.0
        x, y, w, h = map(float, re.search(r'viewBox="([^"]+)"', text)[1].split())
        assert (w, h) == (float(width), float(height))
        assert x <= -6.0 <= 10.0 <= x + w
        assert y <= -4.0 <= 2.0 <= y + h
        assert drawings.read(path).length_unit == unit
        line = float(re.search(r'stroke-width="([^"]+)"', text)[1])
        assert line * {"mm": 1.0, "in": 25.4}[unit] == pytest.approx(0.1)

    def test_an_outline_across_of_half_circles_keeps_its_centres(self, tmp_path):
        """A half circle's centre is ill determined by its ends and radius, so it is written in pieces."""
        loaded = gw.Section.load(saved(stadium(), tmp_path, ".svg"))
        centres = [curve.centre for curve in loaded.loops[0].curves if isinstance(curve, Arc)]
        assert len(centres) == 4
        np.testing.assert_allclose(sorted(centres), [(-3, 1), (-3, 1), (7, 1), (7, 1)], atol=1e-14)


class TestSheets:
    def test_inches_are_stated(self, tmp_path):
        for unit, code, metric in (("in", 1, 0), ("mm", 4, 1)):
            path = saved(stadium(), tmp_path, ".dxf", length_unit=unit)
            header = ezdxf.readfile(path).header
            assert (header["$INSUNITS"], header["$MEASUREMENT"]) == (code, metric)
            assert drawings.read(path).length_unit == unit

    def test_the_header_says_how_far_the_drawing_reaches(self, tmp_path):
        header = ezdxf.readfile(saved(stadium(), tmp_path, ".dxf")).header
        np.testing.assert_allclose([header["$EXTMIN"][:2], header["$EXTMAX"][:2]], [(-6, -2), (10, 4)], atol=1e-12)

    @every_format
    def test_profiles_stand_on_their_layers_where_they_are_put(self, tmp_path, suffix):
        """A pair in mesh: no distance between the pitch circles, and the mate turned by half a pitch."""
        small, large = (gw.SpurGear(teeth=z, module=2.0, face_width=5.0, bore=8.0) for z in (14, 20))
        centre = small.pitch_radius + large.pitch_radius
        mate = drawings.Profile(
            section=large.profile, layer="gear & mate", turn=np.pi + np.pi / 20, shift=(centre, 0.0)
        )
        path = tmp_path / f"pair{suffix}"
        drawings.write(path, [drawings.Profile(section=small.profile, layer="pinion"), mate])
        drawing = drawings.read(path)
        assert set(drawing.layers) == {"pinion", "gear & mate"}
        assert len(drawing.regions) == 2
        pinion, gear = (gw.Section.load(path, layer=layer) for layer in ("pinion", "gear & mate"))
        assert pinion.properties().area == pytest.approx(small.profile.properties().area, rel=1e-7)
        assert gear.properties().area == pytest.approx(large.profile.properties().area, rel=1e-7)
        np.testing.assert_allclose(pinion.properties().centroid, (0, 0), atol=1e-7)
        np.testing.assert_allclose(gear.properties().centroid, (centre, 0), atol=1e-7)
        corners = np.concatenate([curve.start[None] for curve in gear.loops[0].curves])
        reach = np.hypot(*(corners - (centre, 0)).T)
        tips = corners[reach > large.tip_radius - 1e-6] - (centre, 0)
        angles = np.sort(np.degrees(np.arctan2(tips[:, 1], -tips[:, 0])))
        assert np.all(np.abs(angles) > 1.0), "a space, not a tooth, lies on the line of centres"
        np.testing.assert_allclose(angles + angles[::-1], 0.0, atol=1e-6)

    @every_format
    def test_profiles_of_one_layer_share_it(self, tmp_path, suffix):
        path = tmp_path / f"two{suffix}"
        disc = gw.Section.circle(1.0)
        drawings.write(path, [drawings.Profile(section=disc), drawings.Profile(section=disc, shift=(3.0, 0.0))])
        drawing = drawings.read(path)
        assert drawing.layers == ("profile",)
        assert len(drawing.regions) == 2


class TestRefusals:
    @pytest.mark.parametrize("name", ["a.step", "a", "a.csv", "."])
    def test_other_suffixes_are_refused_with_those_written(self, tmp_path, name):
        with pytest.raises(gw.FileError, match=r"drawn as \.dxf, \.svg; end the name in one of these"):
            stadium().save(tmp_path / name)
        assert not list(tmp_path.iterdir())

    def test_case_does_not_matter(self, tmp_path):
        for suffix in FORMATS:
            stadium().save(tmp_path / f"a{suffix.upper()}")
            gw.Section.load(tmp_path / f"a{suffix.upper()}")

    @every_format
    def test_a_missing_folder_and_a_folder_in_the_way_are_refused(self, tmp_path, suffix):
        with pytest.raises(gw.FileError, match="there is no folder"):
            stadium().save(tmp_path / f"none/a{suffix}")
        (tmp_path / f"b{suffix}").mkdir()
        with pytest.raises(gw.FileError, match="this is a folder"):
            stadium().save(tmp_path / f"b{suffix}")

    def test_units_and_tolerances_that_cannot_be_are_named_together(self, tmp_path):
        for tolerance in (0.0, -1.0, float("nan"), float("inf"), 1e-12, 10.0):
            with pytest.raises(gw.GeometryError) as error:
                saved(bored_gear(), tmp_path, ".dxf", length_unit="ell", tolerance=tolerance)
            subjects = [problem.subject for problem in error.value.problems]
            assert subjects == ["length_unit = 'ell'", f"tolerance = {tolerance!r}"]
        assert not list(tmp_path.iterdir())

    @every_format
    @pytest.mark.parametrize(
        ("unit", "stated", "factor"), [("cm", "mm", 10.0), ("m", "mm", 1000.0), ("ft", "in", 12.0)]
    )
    def test_other_units_are_converted(self, tmp_path, suffix, unit, stated, factor):
        found = drawings.read(saved(stadium(), tmp_path, suffix, length_unit=unit))
        assert found.length_unit == stated
        area = gw.Section(loops=found.regions[0]).properties().area
        assert area == pytest.approx(stadium().properties().area * factor**2, rel=1e-12)

    def test_nothing_to_draw_is_refused(self, tmp_path):
        with pytest.raises(gw.GeometryError, match="0 profiles: at least one is needed"):
            drawings.write(tmp_path / "a.dxf", [])

    @every_format
    def test_a_section_that_crosses_itself_is_refused_and_the_old_file_stays(self, tmp_path, suffix):
        path = saved(stadium(), tmp_path, suffix)
        old = path.read_bytes()
        square = gw.Section.polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
        hole = gw.Section.polygon([(3, 1), (6, 1), (6, 2), (3, 2)]).loops[0]
        backwards = type(hole)(curves=tuple(c.reversed() for c in reversed(hole.curves)))
        crossing = gw.Section(loops=(*square.loops, backwards))
        with pytest.raises(gw.GeometryError, match="crosses itself or a hole"):
            crossing.save(path)
        assert path.read_bytes() == old
        assert list(tmp_path.iterdir()) == [path]

    def test_a_missing_extra_says_what_to_install(self, tmp_path, monkeypatch):
        monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
        with pytest.raises(gw.MachineError, match=r"pip install 'gearwright\[drawing\]'"):
            stadium().save(tmp_path / "a.dxf")
        stadium().save(tmp_path / "a.svg")
        assert [path.name for path in tmp_path.iterdir()] == ["a.svg"]
