"""Sections: orientation, families, and moments against polygons, brute force and closed forms."""

from dataclasses import dataclass

import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.curve import Curve, mapped, turn
from gearwright.curves.involute import Involute
from gearwright.curves.line import Line
from gearwright.curves.meridian import Meridian
from gearwright.curves.parallel import Parallel
from gearwright.curves.spherical_involute import SphericalInvolute
from gearwright.errors import GeometryError
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.sections.sphere import SphericalSection

TURN = 2.0 * np.pi
POWERS = [(a, b) for a in range(4) for b in range(4 - a)]


def lines(*corners):
    return tuple(Line(first=a, last=b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))


def circle(radius, centre=(0.0, 0.0), sense=1):
    return Loop(curves=(Arc(radius=radius, centre=centre, interval=(0.0, TURN) if sense > 0 else (TURN, 0.0)),))


def parallel(polar_angle, sense=1):
    return Loop(curves=(Parallel(polar_angle=polar_angle, interval=(0.0, TURN) if sense > 0 else (TURN, 0.0)),))


def ratchet(copies, scale=1.0):
    """Teeth with an involute on one side only: no mirror symmetry."""
    base, roll, step = 3.0 * scale, 0.9, TURN / copies
    involute = Involute(base_radius=base, interval=(0.0, roll))
    foot = (base * np.cos(0.7 * step), base * np.sin(0.7 * step))
    falling = Line(first=tuple(involute.end), last=foot)
    return Loop(curves=(involute, falling, Arc(radius=base, interval=(0.7 * step, step))), copies=copies)


def spherical_ratchet(copies, polar=0.7, sense=1):
    step = TURN / copies
    flank = SphericalInvolute(base_cone_angle=polar, interval=(0.0, 0.8))
    azimuth, top = np.arctan2(flank.end[1], flank.end[0]), np.arccos(flank.end[2])
    curves = (
        flank,
        Parallel(polar_angle=top, interval=(azimuth, azimuth + 0.3 * step)),
        Meridian(azimuth=azimuth + 0.3 * step, interval=(top, polar)),
        Parallel(polar_angle=polar, interval=(azimuth + 0.3 * step, step)),
    )
    return Loop(curves=curves if sense > 0 else tuple(c.reversed() for c in curves[::-1]), copies=copies)


def whole(loop):
    return loop.with_copies(1).curves


def polygon_moments(vertices):
    """m[a, b] of a polygon: triangles from the origin, with a barycentric rule exact to degree 3."""
    p, q = vertices, np.roll(vertices, -1, axis=0)
    area = (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]) / 2.0
    corner = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)]
    middles = [(0.5, 0.5), (0.0, 0.5), (0.5, 0.0)]
    rule = [(1 / 20, c) for c in corner] + [(2 / 15, m) for m in middles] + [(9 / 20, (1 / 3, 1 / 3))]
    moments = np.zeros((4, 4))
    for a, b in POWERS:
        for weight, (s, t) in rule:
            x, y = (s * p + t * q).T
            moments[a, b] += np.sum(weight * area * x**a * y**b)
    return moments


def inscribed(loop, segments):
    curves = whole(loop)
    return np.concatenate([c.point(c.parameter(np.arange(segments) / segments)) for c in curves])


def polar_fan(curves, nodes=60):
    """[Ω Nᵀ; N Q] of a region by brute force: area elements between each curve and the pole +z.

    A curve's point (δ, φ) sweeps the meridian from the pole to it: dΩ = sin(s δ) δ dφ ds.
    """
    x, w = np.polynomial.legendre.leggauss(nodes)
    s, ws = (x + 1.0) / 2.0, w / 2.0
    total = np.zeros((4, 4))
    for curve in curves:
        points, tangents = curve.quadrature(nodes)
        delta = np.arctan2(np.hypot(points[:, 0], points[:, 1]), points[:, 2])
        turned = (points[:, 0] * tangents[:, 1] - points[:, 1] * tangents[:, 0]) / (
            points[:, 0] ** 2 + points[:, 1] ** 2
        )
        unit = points[:, :2] / np.hypot(points[:, 0], points[:, 1])[:, None]
        polar = np.outer(delta, s)
        weight = np.sin(polar) * (delta * turned)[:, None] * ws
        h = np.stack(
            [np.ones_like(polar), np.sin(polar) * unit[:, :1], np.sin(polar) * unit[:, 1:], np.cos(polar)], axis=-1
        )
        total += np.einsum("ij,ijk,ijl->kl", weight, h, h)
    return total


class TestOrientation:
    @pytest.mark.parametrize(("section", "make"), [(Section, circle), (SphericalSection, parallel)])
    def test_an_outer_loop_runs_counter_clockwise(self, section, make):
        with pytest.raises(GeometryError, match=r"loop 1 runs clockwise: the outer loop runs counter-clockwise"):
            section(loops=(make(0.7, sense=-1),))

    @pytest.mark.parametrize(("section", "make"), [(Section, circle), (SphericalSection, parallel)])
    def test_a_hole_runs_clockwise(self, section, make):
        with pytest.raises(GeometryError, match=r"loop 2 runs counter-clockwise: a hole runs clockwise") as caught:
            section(loops=(make(0.7), make(0.2)))
        assert len(caught.value.problems) == 1

    def test_every_wrong_loop_is_named_at_once(self):
        with pytest.raises(GeometryError) as caught:
            Section(loops=(circle(1.0, sense=-1), circle(0.2), circle(0.1, (0.5, 0.0), -1), circle(0.1, (-0.5, 0.0))))
        assert [str(p).split(" runs")[0] for p in caught.value.problems] == ["loop 1", "loop 2", "loop 4"]

    def test_a_loop_that_encloses_nothing_is_no_outer_loop(self):
        there, back = Line(first=(0.0, 0.0), last=(1.0, 0.0)), Line(first=(1.0, 0.0), last=(0.0, 0.0))
        with pytest.raises(GeometryError, match="loop 1"):
            Section(loops=(Loop(curves=(there, back)),))

    def test_a_region_around_the_south_pole_is_refused(self):
        with pytest.raises(GeometryError, match="loop 1"):
            SphericalSection(loops=(parallel(2.0, sense=-1),))


class TestSymmetryAndFamilies:
    def test_the_order_is_common_to_all_loops(self):
        hole = Loop(curves=(Arc(radius=1.0, interval=(0.0, -TURN / 9.0)),), copies=9)
        assert Section(loops=(ratchet(6),)).order == 6
        assert Section(loops=(ratchet(6), hole)).order == 3
        assert Section(loops=(ratchet(6), circle(1.0, sense=-1))).order == 1

    @pytest.mark.parametrize("section", [Section(loops=(ratchet(6),)), SphericalSection(loops=(parallel(0.7),))])
    def test_a_constant_section_is_itself(self, section):
        assert section.at(0.4) is section

    def test_a_family_gives_a_section_of_its_own_kind(self):
        grown = Section(loops=(Loop(curves=(Growing(interval=(0.0, TURN)),)), circle(0.2, sense=-1))).at(2.0)
        assert isinstance(grown, Section)
        assert grown.moments[0, 0] == pytest.approx(np.pi * (9.0 - 0.04))


@dataclass(frozen=True, kw_only=True)
class Growing(Curve):
    """A circle of radius 1 + v."""

    v: float = 0.0

    def point(self, u):
        u = np.asarray(u, float)
        return (1.0 + self.v) * np.stack([np.cos(u), np.sin(u)], axis=-1)

    def derivative(self, u):
        u = np.asarray(u, float)
        return (1.0 + self.v) * np.stack([-np.sin(u), np.cos(u)], axis=-1)

    def at(self, v):
        return Growing(interval=self.interval, v=float(v))


class TestPlaneMoments:
    def test_a_circle(self):
        cx, cy, r = 1.5, -0.7, 2.0
        m = Section(loops=(circle(r, (cx, cy)),)).moments
        area, bend = np.pi * r**2, np.pi * r**4 / 4.0
        expected = {
            (0, 0): area,
            (1, 0): area * cx,
            (0, 1): area * cy,
            (2, 0): bend + area * cx**2,
            (1, 1): area * cx * cy,
            (0, 2): bend + area * cy**2,
            (3, 0): area * cx**3 + 3.0 * cx * bend,
            (2, 1): area * cx**2 * cy + cy * bend,
            (1, 2): area * cx * cy**2 + cx * bend,
            (0, 3): area * cy**3 + 3.0 * cy * bend,
        }
        for (a, b), value in expected.items():
            assert m[a, b] == pytest.approx(value, rel=1e-13), (a, b)
        assert all(m[a, b] == 0.0 for a in range(4) for b in range(4) if a + b > 3)

    def test_an_annulus(self):
        m = Section(loops=(circle(3.0), circle(1.0, sense=-1))).moments
        assert m[0, 0] == pytest.approx(8.0 * np.pi, rel=1e-14)
        assert m[2, 0] == pytest.approx(20.0 * np.pi, rel=1e-14)
        assert m[0, 2] == pytest.approx(20.0 * np.pi, rel=1e-14)

    def test_a_rectangle(self):
        x0, x1, y0, y1 = -0.5, 2.0, 1.0, 4.0
        m = Section(loops=(Loop(curves=lines((x0, y0), (x1, y0), (x1, y1), (x0, y1))),)).moments
        for a, b in POWERS:
            exact = (x1 ** (a + 1) - x0 ** (a + 1)) / (a + 1) * (y1 ** (b + 1) - y0 ** (b + 1)) / (b + 1)
            assert m[a, b] == pytest.approx(exact, rel=1e-13), (a, b)

    def test_a_triangle(self):
        m = Section(loops=(Loop(curves=lines((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))),)).moments
        exact = {(0, 0): 1 / 2, (1, 0): 1 / 6, (0, 1): 1 / 6, (2, 0): 1 / 12, (1, 1): 1 / 24, (0, 2): 1 / 12}
        exact |= {(3, 0): 1 / 20, (2, 1): 1 / 60, (1, 2): 1 / 60, (0, 3): 1 / 20}
        for (a, b), value in exact.items():
            assert m[a, b] == pytest.approx(value, rel=1e-13), (a, b)

    @pytest.mark.parametrize("copies", [1, 2, 3, 4, 7])
    def test_teeth_converge_on_it_as_polygons_with_the_second_order(self, copies):
        loop = ratchet(copies)
        moments = Section(loops=(loop,)).moments
        coarse, fine = (polygon_moments(inscribed(loop, n)) for n in (300, 600))
        scale = 4.0 ** np.add.outer(np.arange(4), np.arange(4)) * moments[0, 0]
        np.testing.assert_allclose(moments / scale, ((4.0 * fine - coarse) / 3.0) / scale, atol=1e-10)
        for a, b in ((0, 0), (2, 0), (0, 2)):
            order = np.log2((moments[a, b] - coarse[a, b]) / (moments[a, b] - fine[a, b]))
            assert order == pytest.approx(2.0, abs=0.01)

    @pytest.mark.parametrize("copies", [2, 3, 4, 5, 6, 12])
    def test_the_periods_may_be_written_out(self, copies):
        loop = ratchet(copies)
        once = Section(loops=(Loop(curves=whole(loop)),)).moments
        np.testing.assert_allclose(Section(loops=(loop,)).moments, once, rtol=1e-12, atol=1e-11)
        for divisor in (d for d in range(2, copies) if copies % d == 0):
            some = Section(loops=(loop.with_copies(divisor),)).moments
            np.testing.assert_allclose(some, once, rtol=1e-12, atol=1e-11)

    def test_moments_that_symmetry_forbids_are_exactly_nought(self):
        m = Section(loops=(ratchet(5), Loop(curves=(Arc(radius=1.0, interval=(0.0, -TURN / 5)),), copies=5))).moments
        assert all(m[a, b] == 0.0 for a, b in POWERS if (a, b) not in {(0, 0), (2, 0), (0, 2)})
        assert m[2, 0] == m[0, 2]

    def test_a_clockwise_hole_with_copies_takes_its_area_away(self):
        outer = circle(5.0)
        teeth = ratchet(6)
        hole = Loop(curves=tuple(c.reversed() for c in teeth.curves[::-1]), copies=6)
        area = Section(loops=(teeth,)).moments[0, 0]
        assert Section(loops=(outer, hole)).moments[0, 0] == pytest.approx(25.0 * np.pi - area, rel=1e-13)

    def test_a_mirrored_tooth_has_mirrored_moments(self):
        m = Section(loops=(Loop(curves=whole(ratchet(1))),)).moments
        mirror = turn(0.0, 2, mirrored=True)
        curves = tuple(mapped(c, mirror).reversed() for c in whole(ratchet(1))[::-1])
        image = Section(loops=(Loop(curves=curves),)).moments
        signs = np.array([[(-1.0) ** b for b in range(4)]] * 4)
        np.testing.assert_allclose(image, signs * m, rtol=1e-12, atol=1e-11)


class TestSphericalMoments:
    @pytest.mark.parametrize("delta", [0.01, 0.4, 1.5, 2.0, 3.0])
    def test_a_cap(self, delta):
        section = SphericalSection(loops=(parallel(delta),))
        m, c = section.moments, np.cos(delta)
        cap = 2.0 * np.pi * (1.0 - c)
        assert m[0, 0] == pytest.approx(4.0 * np.pi * np.sin(delta / 2.0) ** 2, rel=1e-12)
        np.testing.assert_allclose(m[0, 1:], [0.0, 0.0, np.pi * (1.0 - c**2)], atol=1e-14)
        axial = TURN * (1.0 - c**3) / 3.0
        np.testing.assert_allclose(m[1:, 1:], np.diag([(cap - axial) / 2, (cap - axial) / 2, axial]), atol=1e-13)

    def test_a_zone(self):
        m = SphericalSection(loops=(parallel(2.2), parallel(0.9, sense=-1))).moments
        a, b = np.cos(2.2), np.cos(0.9)
        assert m[0, 0] == pytest.approx(TURN * (b - a), rel=1e-14)
        assert m[0, 3] == pytest.approx(np.pi * (b**2 - a**2), rel=1e-13)
        assert m[3, 3] == pytest.approx(TURN * (b**3 - a**3) / 3.0, rel=1e-13)

    @pytest.mark.parametrize("turned", [0.0, 0.4])
    def test_an_octant(self, turned):
        curves = (
            Meridian(azimuth=0.0, interval=(0.0, np.pi / 2.0)),
            Parallel(polar_angle=np.pi / 2.0, interval=(0.0, np.pi / 2.0)),
            Meridian(azimuth=np.pi / 2.0, interval=(np.pi / 2.0, 0.0)),
        )
        matrix = turn(turned, 3)
        m = SphericalSection(loops=(Loop(curves=tuple(mapped(c, matrix) for c in curves)),)).moments
        assert m[0, 0] == pytest.approx(np.pi / 2.0, rel=1e-14)
        np.testing.assert_allclose(matrix.T @ m[1:, 0], np.full(3, np.pi / 4.0), rtol=1e-14)
        expected = np.full((3, 3), 1.0 / 3.0) + np.eye(3) * (np.pi / 6.0 - 1.0 / 3.0)
        np.testing.assert_allclose(matrix.T @ m[1:, 1:] @ matrix, expected, rtol=1e-13)

    @pytest.mark.parametrize("copies", [1, 2, 3, 7])
    @pytest.mark.parametrize("polar", [0.3, 0.7, 1.2])
    def test_teeth_are_those_of_brute_force(self, copies, polar):
        loop = spherical_ratchet(copies, polar)
        m = SphericalSection(loops=(loop,)).moments
        np.testing.assert_allclose(m, polar_fan(whole(loop)), atol=1e-12)

    def test_a_region_beside_the_pole_is_that_of_brute_force(self):
        curves = lines_on_sphere(((0.4, 0.1), (0.9, 0.3), (1.1, 1.2), (0.5, 0.9)))
        m = SphericalSection(loops=(Loop(curves=curves),)).moments
        np.testing.assert_allclose(m, polar_fan(curves), atol=1e-13)

    def test_the_trace_of_the_second_moment_is_the_solid_angle(self):
        m = SphericalSection(loops=(spherical_ratchet(1),)).moments
        assert np.trace(m[1:, 1:]) == pytest.approx(m[0, 0], rel=1e-14)

    def test_holes_with_copies_take_their_share_away(self):
        outer, hole = parallel(1.3), spherical_ratchet(5, 0.6, sense=-1)
        m = SphericalSection(loops=(outer, hole)).moments
        expected = polar_fan(outer.curves) + polar_fan(whole(hole))
        np.testing.assert_allclose(m, expected, atol=1e-12)


def lines_on_sphere(corners):
    """Pieces of meridians and parallels joined by skew curves through corners (δ, φ)."""
    return tuple(Skew(a=a, b=b, interval=(0.0, 1.0)) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))


@dataclass(frozen=True, kw_only=True)
class Skew(Curve):
    """A curve of the sphere straight in (δ, φ)."""

    a: tuple
    b: tuple

    def _angles(self, u):
        u = np.asarray(u, float)
        return tuple(p + (q - p) * u for p, q in zip(self.a, self.b, strict=True))

    def point(self, u):
        d, f = self._angles(u)
        return np.stack([np.sin(d) * np.cos(f), np.sin(d) * np.sin(f), np.cos(d)], axis=-1)

    def derivative(self, u):
        d, f = self._angles(u)
        dd, df = self.b[0] - self.a[0], self.b[1] - self.a[1]
        return np.stack(
            [
                np.cos(d) * np.cos(f) * dd - np.sin(d) * np.sin(f) * df,
                np.cos(d) * np.sin(f) * dd + np.sin(d) * np.cos(f) * df,
                -np.sin(d) * dd,
            ],
            axis=-1,
        )


@dataclass(frozen=True, kw_only=True)
class Bump(Curve):
    """y = 1/(1 + (x/w)²) from x = 1 to −1: as hard to integrate as w is small."""

    width: float

    def point(self, u):
        u = np.asarray(u, float)
        return np.stack([u, 1.0 / (1.0 + (u / self.width) ** 2)], axis=-1)

    def derivative(self, u):
        u = np.asarray(u, float)
        return np.stack([np.ones_like(u), -2.0 * u / self.width**2 / (1.0 + (u / self.width) ** 2) ** 2], axis=-1)


class TestError:
    @pytest.mark.parametrize("width", [1.0, 0.3, 0.1, 0.05, 0.03, 0.02, 0.01])
    def test_it_bounds_what_a_hard_curve_leaves(self, width):
        foot = 1.0 / (1.0 + width**-2)
        curves = (
            Bump(width=width, interval=(1.0, -1.0)),
            *lines((-1.0, foot), (-1.0, -0.5), (1.0, -0.5), (1.0, foot))[:3],
        )
        section = Section(loops=(Loop(curves=curves),))
        exact = 1.0 + 2.0 * width * np.arctan(1.0 / width)
        assert abs(section.moments[0, 0] - exact) <= exact * section.moments_error * 1.5
        assert section.moments_error < (1e-14 if width >= 0.3 else 1.0)

    def test_it_is_rounding_for_gears(self):
        for section in (Section(loops=(ratchet(7),)), SphericalSection(loops=(spherical_ratchet(7),))):
            assert 0.0 < section.moments_error < 4e-15

    @pytest.mark.parametrize("wall", [1e-3, 1e-6, 1e-9])
    def test_it_tells_of_the_cancellation_in_a_thin_wall(self, wall):
        inner = 1.0 - wall
        section = Section(loops=(circle(1.0), circle(inner, sense=-1)))
        exact = np.pi * (1.0 - inner) * (1.0 + inner)
        assert abs(section.moments[0, 0] / exact - 1.0) <= 4.0 * max(section.moments_error, 1e-15)

    @pytest.mark.parametrize("centre", [(30.0, 10.0), (300.0, 10.0)])
    def test_it_bounds_the_rounding_away_from_the_origin(self, centre):
        section, radius = Section(loops=(circle(2.0, centre),)), 2.0
        area, bend = np.pi * radius**2, np.pi * radius**4 / 4.0
        exact = area * centre[0] ** 3 + 3.0 * centre[0] * bend
        assert np.max(section.moments) == section.moments[3, 0]
        assert abs(section.moments[3, 0] / exact - 1.0) <= section.moments_error
        assert section.moments[0, 0] == pytest.approx(area, rel=1e-14)

    @pytest.mark.parametrize("scale", [1e2, 1e3, 1e6])
    def test_it_does_not_depend_on_the_unit_of_length(self, scale):
        assert Section(loops=(circle(scale),)).moments_error < 4e-15
