"""Laws that every motion obeys, over all classes of the package, and what is particular to each."""

import inspect
import pkgutil
from dataclasses import dataclass, field
from importlib import import_module

import numpy as np
import pytest

import gearwright.motions
from gearwright.boundary.swept import swept_boundary
from gearwright.curves.arc import Arc
from gearwright.curves.frames import fixed_up, frenet, rotation_minimising
from gearwright.curves.helix import helix
from gearwright.curves.line import Line
from gearwright.curves.meridian import Meridian
from gearwright.curves.parallel import Parallel
from gearwright.curves.path import path_through
from gearwright.curves.spherical_involute import SphericalInvolute
from gearwright.curves.traces.logarithmic import LogarithmicTrace
from gearwright.curves.traces.straight import StraightTrace
from gearwright.moments.matrix import shifted
from gearwright.motions.along import Along
from gearwright.motions.ends import Ends, between
from gearwright.motions.extrusion import Extrusion
from gearwright.motions.herringbone import Herringbone
from gearwright.motions.motion import Motion
from gearwright.motions.placed import Placed
from gearwright.motions.plane_quadrature import quadrature_moments
from gearwright.motions.radial import Radial
from gearwright.motions.revolution import FULL_TURN, Revolution
from gearwright.motions.straight import Straight
from gearwright.motions.transform import polynomial_transform, transform_of
from gearwright.motions.transforming import Transforming
from gearwright.placement import Placement
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.sections.sphere import SphericalSection
from gearwright.solids.solid import flux_moments
from gearwright.surfaces.plane import Plane

TURN = 2.0 * np.pi
LEANING = Placement.of(
    [[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]],  # rows of a rotation about no axis of the frame
    (0.7, -1.9, 3.1),
)
OVERTURNED = Placement.of(np.diag([1.0, -1.0, -1.0]), (0.0, 0.0, 1.2))
RAISED = Placement.of([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]], (0.0, 0.0, -2.0))


def plane_section():
    """A region to the right of the y axis without any symmetry, with a round hole off its middle."""
    arc = Arc(radius=1.6, centre=(2.6, 0.9), interval=(-0.8, 1.9))
    tip = (1.1, -0.4)
    outer = (Line(first=tip, last=tuple(arc.start)), arc, Line(first=tuple(arc.end), last=tip))
    return Section(
        loops=(
            Loop(curves=outer),
            Loop(curves=(Arc(radius=0.5, centre=(2.9, 1.1), interval=(TURN, 0.0)),)),
        )
    )


def meridian_integrals(points, value):
    """∫ value(n) sin θ dθ (n,) along the meridians of points of the unit sphere, from one parallel to them."""
    x, w = np.polynomial.legendre.leggauss(30)
    theta, azimuth = np.arccos(points[:, 2]), np.arctan2(points[:, 1], points[:, 0])
    t = 0.7 + (theta[:, None] - 0.7) * (x + 1.0) / 2.0
    on_sphere = [np.sin(t) * np.cos(azimuth)[:, None], np.sin(t) * np.sin(azimuth)[:, None], np.cos(t)]
    return np.sum(value(np.stack(on_sphere, axis=-1)) * np.sin(t) * w, axis=1) * (theta - 0.7) / 2.0


def spherical_ring():
    """A region around the pole with five teeth and a round hole."""
    step = TURN / 5.0
    teeth = (
        Parallel(polar_angle=1.2, interval=(0.0, 0.5)),
        Meridian(azimuth=0.5, interval=(1.2, 1.0)),
        Parallel(polar_angle=1.0, interval=(0.5, step)),
        Meridian(azimuth=step, interval=(1.0, 1.2)),
    )
    hole = Parallel(polar_angle=0.5, interval=(0.0, -step))
    return SphericalSection(loops=(Loop(curves=teeth, copies=5), Loop(curves=(hole,), copies=5)))


def spherical_section(first=0.2):
    """A region beside the pole +z without any symmetry, with a hole off its middle."""
    flank = SphericalInvolute(base_cone_angle=0.5, interval=(0.3, 1.6))
    inner, outer = np.arccos(flank.start[2]), np.arccos(flank.end[2])
    start, end = (float(np.arctan2(p[1], p[0])) for p in (flank.start, flank.end))
    loop = (
        flank,
        Parallel(polar_angle=outer, interval=(end, end + 0.8)),
        Meridian(azimuth=end + 0.8, interval=(outer, inner)),
        Parallel(polar_angle=inner, interval=(end + 0.8, start)),
    )
    low, high = inner + 0.2 * (outer - inner), inner + 0.5 * (outer - inner)
    hole = (
        Meridian(azimuth=end + first, interval=(low, high)),
        Parallel(polar_angle=high, interval=(end + first, end + 0.6)),
        Meridian(azimuth=end + 0.6, interval=(high, low)),
        Parallel(polar_angle=low, interval=(end + 0.6, end + first)),
    )
    return SphericalSection(loops=(Loop(curves=loop), Loop(curves=tuple(c.reversed() for c in hole[::-1]))))


@dataclass(frozen=True)
class Example:
    motion: Motion
    section: object
    ends: Ends
    shape: str = field(default="")

    def points(self):
        """Points of the section's boundary with curve tangents, (n, d) each."""
        curves = [c for loop in self.section.loops for c in loop.curves]
        u = [c.parameter(np.array([0.1, 0.45, 0.8])) for c in curves]
        return (
            np.concatenate([c.point(x) for c, x in zip(curves, u, strict=True)]),
            np.concatenate([c.derivative(x) for c, x in zip(curves, u, strict=True)]),
            [(c, float(x)) for c, xs in zip(curves, u, strict=True) for x in xs],
        )


def shearing(xi):
    return [[1.0 - 0.1 * xi, 0.2 * np.sin(xi), 0.3 * xi], [0.05 * xi**2, 1.0 + 0.1 * xi, -0.2], [0.0, 0.0, 1.0]]


def spiralling(xi):
    """A turn with even growth: it commutes with every turn."""
    a = np.exp(0.1 * xi)
    return a * np.array([[np.cos(xi), -np.sin(xi)], [np.sin(xi), np.cos(xi)]])


BEND = [(0.0, 0.0, 0.0), (8.0, 1.0, 3.0), (15.0, 7.0, 1.0), (18.0, 16.0, 5.0)]

EXAMPLES = {
    Straight: [Example(Straight(), plane_section(), between(-0.7, 2.1))],
    Extrusion: [
        Example(Extrusion(length=2.5, twist=0.8), plane_section(), between(0.0, 2.5)),
        Example(Extrusion(length=2.5, twist=-4.0, scale=(0.6, 0.6)), plane_section(), between(0.3, 2.1)),
        Example(Extrusion(length=2.5, scale=(0.5, 1.4)), plane_section(), between(0.0, 2.5)),
        Example(Extrusion(length=2.5, skew=(3.0, -1.0)), plane_section(), between(0.0, 2.5)),
        Example(
            Extrusion(length=2.5, twist=2.0, scale=(1.3, 0.7), skew=(-0.4, 0.9)), plane_section(), between(0.0, 2.5)
        ),
        Example(Extrusion(length=2.5, twist=0.6, skew=(0.5, 0.2), near_angle=1.9), plane_section(), between(0.4, 2.5)),
    ],
    Herringbone: [
        Example(Herringbone(length=2.5, twist=0.8), plane_section(), between(0.0, 2.5)),
        Example(Herringbone(length=2.5, twist=-2.6), plane_section(), between(0.3, 2.1)),
        Example(Herringbone(length=2.5, twist=0.8), plane_section(), between(0.1, 1.25)),
        Example(Herringbone(length=2.5, twist=0.8), plane_section(), between(1.25, 2.2)),
    ],
    Transforming: [
        Example(Transforming(transform=transform_of(shearing, 2.5, 1e-14)), plane_section(), between(0.0, 2.5)),
        Example(
            Transforming(transform=polynomial_transform({"f1": [1.0, 0.2, -0.05], "h2": [0.0, 1.0, 0.3]}, 2.0)),
            plane_section(),
            between(0.1, 1.9),
        ),
        Example(Transforming(transform=transform_of(spiralling, 2.5, 1e-14)), plane_section(), between(0.0, 2.5)),
    ],
    Along: [
        Example(Along(frame=rotation_minimising(helix(9.0, 4.0, 0.8))), plane_section(), between(0.0, 1.0)),
        Example(Along(frame=frenet(helix(9.0, 4.0, 0.8, "left"))), plane_section(), between(0.2, 0.9)),
        Example(Along(frame=fixed_up(path_through(BEND))), plane_section(), between(0.0, 1.0)),
        Example(
            Along(frame=rotation_minimising(path_through(BEND)), transform=transform_of(shearing, 1.0, 1e-14)),
            plane_section(),
            between(0.0, 1.0),
        ),
    ],
    Revolution: [
        Example(Revolution(), plane_section(), between(-0.4, 1.3)),
        Example(Revolution(), plane_section(), between(0.5, 4.5)),
        Example(Revolution(), plane_section(), between(-FULL_TURN, 0.0)),
    ],
    Placed: [
        Example(Placed(motion=Extrusion(length=2.5, twist=0.8), placement=LEANING), plane_section(), between(0.0, 2.5)),
        Example(Placed(motion=Straight(), placement=OVERTURNED), plane_section(), between(-0.7, 2.1)),
        Example(Placed(motion=Straight(), placement=RAISED), plane_section(), between(-0.7, 2.1)),
        Example(Placed(motion=Revolution(), placement=LEANING), plane_section(), between(0.5, 4.5)),
        Example(Placed(motion=Herringbone(length=2.5, twist=0.8), placement=LEANING), plane_section(), between(0, 2.5)),
        Example(
            Placed(
                motion=Radial(trace=LogarithmicTrace(ratio=1.2, mean_distance=2.4, mean_spiral_angle=np.pi / 4.0)),
                placement=LEANING,
            ),
            spherical_section(),
            between(2.0, 3.1),
        ),
    ],
    Radial: [
        Example(Radial(trace=StraightTrace()), spherical_section(), between(2.0, 3.1)),
        Example(
            Radial(trace=LogarithmicTrace(ratio=1.2, mean_distance=2.4, mean_spiral_angle=np.pi / 4.0)),
            spherical_section(),
            between(2.0, 3.1),
        ),
        Example(
            Radial(trace=LogarithmicTrace(ratio=-0.7, mean_distance=3.0, mean_spiral_angle=np.pi / 4.0)),
            spherical_section(),
            between(1.4, 3.1),
        ),
        Example(Radial(trace=StraightTrace(), levels=0.0), spherical_section(), between(1.4, 3.1)),
        Example(Radial(trace=StraightTrace(), levels=0.9), spherical_section(), between(1.4, 3.1)),
        Example(
            Radial(trace=LogarithmicTrace(ratio=1.2, mean_distance=2.4, mean_spiral_angle=np.pi / 4.0), levels=0.9),
            spherical_ring(),
            between(2.0, 3.1),
        ),
    ],
}
CASES = [pytest.param(e, id=f"{cls.__name__}-{i}") for cls, es in EXAMPLES.items() for i, e in enumerate(es)]


def test_every_motion_of_the_package_has_an_example():
    found = set()
    for info in pkgutil.iter_modules(gearwright.motions.__path__, "gearwright.motions."):
        classes = [c for _, c in inspect.getmembers(import_module(info.name), inspect.isclass)]
        found |= {c for c in classes if issubclass(c, Motion) and not inspect.isabstract(c)}
    assert found == set(EXAMPLES)


def difference(function, x=0.0, h=1e-3):
    """Central difference of the fourth order."""
    near = function(x + h) - function(x - h)
    far = function(x + 2.0 * h) - function(x - 2.0 * h)
    return (8.0 * near - far) / (12.0 * h)


def parameters(example):
    start, finish = example.ends.start, example.ends.finish
    return [start + f * (finish - start) for f in (0.05, 0.4, 0.95)]


@pytest.mark.parametrize("case", CASES)
class TestEveryMotion:
    def test_velocity_is_the_difference_of_places(self, case):
        points, _, _ = case.points()
        for v in parameters(case):
            numeric = difference(lambda w: case.motion.place(points, w), v)
            np.testing.assert_allclose(case.motion.velocity(points, v), numeric, atol=1e-10)

    def test_carry_is_the_difference_of_places_along_a_curve(self, case):
        points, tangents, curves = case.points()
        for v in parameters(case):
            carried = case.motion.carry(points, tangents, v)
            for row, (curve, u) in zip(carried, curves, strict=True):
                numeric = difference(lambda w, c=curve, v=v: case.motion.place(c.point(w), v), u)
                np.testing.assert_allclose(row, numeric, atol=1e-10)

    def test_the_jacobian_is_the_determinant_of_the_partials(self, case):
        points, _, _ = case.points()
        for v in parameters(case):
            jacobian = case.motion.jacobian(points, v)
            assert np.all(jacobian > 0.0)
            for point, value in zip(points, jacobian, strict=True):
                a, b = self.steps(point)
                columns = [difference(lambda e, s=s, v=v: case.motion.place(s(e), v)) for s in (a, b)]
                columns.append(difference(lambda w, p=point: case.motion.place(p, w), v))
                assert value == pytest.approx(np.linalg.det(np.stack(columns, axis=-1)), rel=1e-9)

    @staticmethod
    def steps(point):
        """Two unit steps across the section from a point, counter-clockwise seen from outside."""
        if point.size == 2:
            return (lambda e: point + e * np.array([1.0, 0.0])), (lambda e: point + e * np.array([0.0, 1.0]))
        x, y, z = point
        rho = np.hypot(x, y)
        south, east = np.array([z * x / rho, z * y / rho, -rho]), np.array([-y / rho, x / rho, 0.0])
        return (lambda e: point * np.cos(e) + south * np.sin(e)), (lambda e: point * np.cos(e) + east * np.sin(e))

    def test_all_parameters_at_once_are_one_by_one(self, case):
        points, tangents, _ = case.points()
        v = np.linspace(case.ends.start, case.ends.finish, len(points))
        for function in (
            case.motion.place,
            lambda p, t: case.motion.carry(p, tangents[: len(p)], t),
            case.motion.velocity,
            case.motion.jacobian,
        ):
            together = function(points, v)
            assert len(together) == len(points)
            np.testing.assert_allclose(together[0], function(points[:1], v[:1])[0], atol=1e-15)
        one_by_one = [case.motion.velocity(points[i], float(v[i])) for i in range(len(points))]
        np.testing.assert_allclose(case.motion.velocity(points, v), one_by_one, atol=1e-14)

    def test_moments_are_those_of_the_flux_through_the_boundary(self, case):
        swept = case.motion.moments(case.section, case.ends)
        flux = flux_moments(swept_boundary(case.section, case.motion, case.ends))
        size = np.cbrt(flux.volume)
        assert swept.method == "exact"
        assert swept.volume == pytest.approx(flux.volume, rel=1e-12)
        np.testing.assert_allclose(swept.centroid, flux.centroid, atol=1e-12 * size)
        norm = np.linalg.norm(flux.central_second)
        np.testing.assert_allclose(swept.central_second, flux.central_second, atol=1e-12 * norm)
        np.testing.assert_allclose(swept.matrix[0, 1:], 0.0, atol=1e-12 * swept.volume)
        assert 0.0 < swept.error_bound < 1e-12

    def test_the_volume_is_the_integral_of_the_jacobian(self, case):
        x, w = np.polynomial.legendre.leggauss(30)
        start, finish = case.ends.start, case.ends.finish
        u = (start + finish) / 2.0 + (finish - start) / 2.0 * x
        volume = 0.0
        for loop in case.section.loops:
            for curve in loop.curves:
                points, tangents = curve.quadrature(30)
                if points.shape[1] == 2:  # straight, in the region: jacobians linear in the section point
                    across = (points[:, 0] * tangents[:, 1] - points[:, 1] * tangents[:, 0]) / 2.0
                    for weight, v in zip(w, u, strict=True):
                        mean = case.motion.jacobian(points * 2.0 / 3.0, v)
                        volume += np.sum(across * mean) * weight * (finish - start) / 2.0
                else:
                    for weight, v in zip(w, u, strict=True):
                        strips = meridian_integrals(points, lambda p, v=v: case.motion.jacobian(p, v))
                        turns = points[:, 0] * tangents[:, 1] - points[:, 1] * tangents[:, 0]
                        turns = loop.copies * turns / (points[:, 0] ** 2 + points[:, 1] ** 2)
                        volume += np.sum(strips * turns) * weight * (finish - start) / 2.0
        assert case.motion.moments(case.section, case.ends).volume == pytest.approx(volume, rel=1e-12)

    def test_the_end_surface_contains_the_section_and_faces_along_the_motion(self, case):
        points, _, _ = case.points()
        for end in (case.ends.start, case.ends.finish):
            surface = case.motion.end_surface(end)
            placed = case.motion.place(points, end)
            assert np.max(surface.deviation(placed)) < 1e-14
            chart = surface.chart(placed)
            np.testing.assert_allclose(surface.point(chart), placed, atol=1e-14)
            first = difference(lambda e, c=chart, s=surface: s.point(c + e * np.array([1.0, 0.0])))
            second = difference(lambda e, c=chart, s=surface: s.point(c + e * np.array([0.0, 1.0])))
            normal = np.cross(first, second)
            assert np.all(np.sum(normal * case.motion.velocity(points, end), axis=1) > 0.0)

    def test_turning_the_section_about_its_axis_turns_the_body_or_the_motion_says_otherwise(self, case):
        points, _, _ = case.points()
        d, v, order = points.shape[1], parameters(case)[1], case.motion.rotation_order

        def commutes(angle):
            c, s = np.cos(angle), np.sin(angle)
            rotation = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
            turned = case.motion.place(points @ rotation[:d, :d].T, v)
            return np.allclose(turned, case.motion.place(points, v) @ rotation.T, rtol=0.0, atol=1e-14)

        assert commutes(TURN / order if order else 0.9)
        assert commutes(0.9) == (order == 0)

    def test_between_its_breaks_it_is_smooth_up_to_them(self, case):
        points, _, _ = case.points()
        for span in case.ends.spans(case.motion.breaks(case.ends)):
            start, finish = span.start, span.finish
            piece, h = case.motion.smooth_piece(span), 1e-3 * (finish - start)
            inside = start + np.array([0.03, 0.5, 0.97])[:, None] * (finish - start)
            np.testing.assert_allclose(piece.place(points, inside), case.motion.place(points, inside), atol=1e-14)
            for v, inward in ((start, h), (finish, -h)):
                np.testing.assert_allclose(piece.place(points, v), case.motion.place(points, v), atol=1e-14)
                rates = [piece.velocity(points, v + k * inward) for k in range(6)]
                # the fifth difference of anything smooth is next to nothing, that of a kink as large as the rates
                fifth = sum(s * rate for s, rate in zip((1.0, -5.0, 10.0, -10.0, 5.0, -1.0), rates, strict=True))
                assert np.max(np.abs(fifth)) < 1e-8 * np.max(np.abs(rates))

    def test_only_a_herringbone_has_a_break(self, case):
        motion = case.motion.motion if isinstance(case.motion, Placed) else case.motion
        broken = isinstance(motion, Herringbone) and case.ends not in (between(0.1, 1.25), between(1.25, 2.2))
        assert case.motion.breaks(case.ends) == ((1.25,) if broken else ())


def test_a_revolution_commutes_with_no_turn_of_its_section():
    assert Revolution().rotation_order == 1


@pytest.mark.parametrize(
    "motion",
    [
        Straight(),
        Extrusion(length=3.0, twist=1.0, scale=(0.5, 2.0), skew=(1.0, 0.0)),
        Revolution(),
        Radial(trace=LogarithmicTrace(ratio=0.7, mean_distance=2.0, mean_spiral_angle=np.pi / 4.0)),
    ],
    ids=repr,
)
def test_one_point_goes_to_many_places(motion):
    point = np.array([0.3, 0.4, np.sqrt(0.75)])[: 3 if isinstance(motion, Radial) else 2]
    v = np.array([1.0, 1.5, 2.5])
    assert motion.velocity(point, v).shape == (3, 3)
    assert motion.place(point, v).shape == (3, 3)
    assert motion.jacobian(point, v).shape == (3,)


class TestStraight:
    def test_it_moves_along_z(self):
        np.testing.assert_array_equal(Straight().place(np.array([1.0, 2.0]), 3.0), [1.0, 2.0, 3.0])

    def test_far_off_along_z_nothing_is_lost(self):
        near = Straight().moments(plane_section(), between(0.0, 1.0))
        far = Straight().moments(plane_section(), between(1e6, 1e6 + 1.0))
        assert far.centroid[2] == 1e6 + 0.5
        np.testing.assert_allclose(far.central_second, near.central_second, rtol=1e-13, atol=1e-14)
        assert far.error_bound == near.error_bound

    def test_far_off_across_it_nothing_is_lost(self):
        section = Section(loops=(Loop(curves=(Arc(radius=1.0, centre=(4096.0, -8192.0), interval=(0.0, TURN)),)),))
        body = Straight().moments(section, between(0.0, 1.0))
        # the curve's own points are rounded to 1e-12 there
        np.testing.assert_allclose(np.diag(body.central_second), [np.pi / 4, np.pi / 4, np.pi / 12], rtol=4e-13)


class TestExtrusion:
    @pytest.mark.parametrize("parameters", [e.motion for e in EXAMPLES[Extrusion]], ids=repr)
    def test_the_closed_form_is_the_quadrature(self, parameters):
        section = plane_section()
        closed = parameters.moments(section, between(0.1, 2.3))
        quadrature = quadrature_moments(parameters, section, 0.1, 2.3)
        assert closed.evaluations == 0 < quadrature.evaluations
        assert closed.volume == pytest.approx(quadrature.volume, rel=2e-15)
        np.testing.assert_allclose(closed.centroid, quadrature.centroid, atol=4e-15)
        scale = np.linalg.norm(quadrature.central_second)
        np.testing.assert_allclose(closed.central_second, quadrature.central_second, atol=4e-15 * scale)

    @pytest.mark.parametrize("distance", [50.0, 1e4])
    def test_far_from_the_axis_it_is_the_quadrature(self, distance):
        """The closed form takes moments about the axis, and would lose the digits that the distance takes."""
        section = Section.rectangle(2.0, 1.0, (distance, 0.0))
        body = Extrusion(length=2.0, twist=1e-3).moments(section, between(0.0, 2.0))
        assert body.evaluations > 0
        assert body.volume == pytest.approx(4.0, rel=1e-13)
        assert body.error_bound < 1e-13 * distance

    @pytest.mark.parametrize("twist", [1e-12, 1e-9, 1e-6, 1e-3])
    def test_tiny_twists_follow_their_series(self, twist):
        """About the axis, where nothing is subtracted: S(twist) to the second order in the twist."""
        section = plane_section()
        m, length = section.moments, 2.0
        body = Extrusion(length=length, twist=twist).moments(section, between(0.0, length))
        matrix = shifted(body.matrix, body.origin)
        xx, yy, xy = m[2, 0], m[0, 2], m[1, 1]
        a, b = twist * length / 2.0, twist**2 * length / 3.0  # ∫ φ dz and ∫ φ² dz
        expected = np.array(
            [
                [length * xx - 2.0 * a * xy + b * (yy - xx), length * xy + a * (xx - yy) - 2.0 * b * xy],
                [length * xy + a * (xx - yy) - 2.0 * b * xy, length * yy + 2.0 * a * xy + b * (xx - yy)],
            ]
        )
        np.testing.assert_allclose(matrix[1:3, 1:3] / xx, expected / xx, rtol=0.0, atol=3e-15 + 4.0 * twist**3)

    @pytest.mark.parametrize("twist", [0.0, 1e-12, 1e-6, 1e-3])
    def test_without_twist_it_is_the_straight_extrusion_and_with_little_its_series(self, twist):
        section, ends = plane_section(), between(0.0, 2.0)
        straight = Straight().moments(section, ends)
        twisted = Extrusion(length=2.0, twist=twist).moments(section, ends)
        assert twisted.volume == pytest.approx(straight.volume, rel=2e-15)
        # to the first order the centroid turns with half the twist
        x, y, z = straight.centroid
        turned = [x - y * twist / 2.0, y + x * twist / 2.0, z]
        np.testing.assert_allclose(twisted.centroid, turned, atol=1e-15 + 2.0 * twist**2)

    def test_a_round_bar_scaled_to_half_is_a_frustum(self):
        bar = Section(loops=(Loop(curves=(Arc(radius=3.0, interval=(0.0, TURN)),)),))
        frustum = Extrusion(length=4.0, scale=(0.5, 0.5)).moments(bar, between(0.0, 4.0))
        assert frustum.volume == pytest.approx(np.pi * 4.0 / 3.0 * (9.0 + 4.5 + 2.25), rel=1e-14)
        fifth = 3.0**5 * (1.0 - 0.5**5) / 0.5
        about_axis = frustum.central_second[0, 0] + frustum.central_second[1, 1]
        assert about_axis == pytest.approx(np.pi * 4.0 / 10.0 * fifth / 3.0, rel=1e-14)

    def test_a_square_bar_twisted_about_its_middle_keeps_its_inertia(self):
        square = Section(loops=(Loop(curves=(Line(first=(1.0, -1.0), last=(1.0, 1.0)),), copies=4),))
        ends = between(0.0, 5.0)
        straight, twisted = (m.moments(square, ends) for m in (Straight(), Extrusion(length=5.0, twist=1.7)))
        np.testing.assert_allclose(twisted.matrix, straight.matrix, atol=1e-13)

    def test_skew_moves_the_far_end(self):
        bar = Section(loops=(Loop(curves=(Arc(radius=1.0, interval=(0.0, TURN)),)),))
        skewed = Extrusion(length=2.0, skew=(3.0, -1.0)).moments(bar, between(0.0, 2.0))
        np.testing.assert_allclose(skewed.centroid, [1.5, -0.5, 1.0], atol=1e-14)
        assert skewed.central_second[0, 1] == pytest.approx(2.0 * np.pi * -3.0 / 12.0, rel=1e-13)


class TestHerringbone:
    def test_it_turns_to_the_middle_and_back(self):
        motion, point = Herringbone(length=4.0, twist=0.6), np.array([1.0, 0.0])
        for height, angle in ((0.0, 0.0), (1.0, 0.3), (2.0, 0.6), (3.0, 0.3), (4.0, 0.0)):
            np.testing.assert_allclose(motion.place(point, height), [np.cos(angle), np.sin(angle), height], atol=1e-15)

    def test_it_is_its_own_mirror_image_in_the_middle_plane(self):
        section, ends = plane_section(), between(0.0, 4.0)
        body = Herringbone(length=4.0, twist=0.6).moments(section, ends)
        half = Extrusion(length=2.0, twist=0.6).moments(section, between(0.0, 2.0))
        matrix, lower = shifted(body.matrix, body.origin), shifted(half.matrix, half.origin)
        mirror = np.diag([1.0, 1.0, 1.0, -1.0])
        mirror[3, 0] = 4.0
        np.testing.assert_allclose(matrix, lower + mirror @ lower @ mirror.T, atol=1e-13 * matrix.max())

    @pytest.mark.parametrize("copies", [3, 8])
    def test_a_whole_wheel_has_the_moments_of_the_straight_one(self, copies):
        step = TURN / copies
        curves = (
            Arc(radius=2.0, interval=(0.0, 0.4 * step)),
            Line(
                first=(2.0 * np.cos(0.4 * step), 2.0 * np.sin(0.4 * step)),
                last=(2.0 * np.cos(step), 2.0 * np.sin(step)),
            ),
        )
        section, ends = Section(loops=(Loop(curves=curves, copies=copies),)), between(0.0, 3.0)
        straight, twisted = (m.moments(section, ends) for m in (Straight(), Herringbone(length=3.0, twist=0.7)))
        assert twisted.volume == pytest.approx(straight.volume, rel=1e-15)
        np.testing.assert_allclose(twisted.centroid, straight.centroid, atol=1e-15)
        np.testing.assert_allclose(twisted.central_second, straight.central_second, atol=1e-14 * straight.volume)


class TestRevolution:
    def test_the_section_s_x_is_the_radius_and_its_y_becomes_z(self):
        np.testing.assert_allclose(Revolution().place(np.array([2.0, 3.0]), 0.0), [2.0, 0.0, 3.0])
        np.testing.assert_allclose(Revolution().place(np.array([2.0, 3.0]), -np.pi / 2), [0.0, 2.0, 3.0], atol=1e-15)

    def test_it_closes_after_a_whole_turn(self):
        for start in (-TURN, 0.0, 1.234):
            assert Revolution().closed(between(start, start + TURN))
            assert not Revolution().closed(between(start, start + 0.999 * TURN))
            assert not Revolution().closed(between(start, start - TURN))

    def test_arcs_about_the_middle_sweep_spheres(self):
        arc = Arc(radius=2.5, interval=(-0.3, 1.1))
        surface = Revolution().swept_surface(arc)
        points = arc.point(np.linspace(-0.3, 1.1, 5))
        assert np.max(surface.deviation(Revolution().place(points, np.linspace(0.0, 4.0, 5)))) < 1e-15
        assert Revolution().swept_surface(Arc(radius=2.5, centre=(0.0, 0.1), interval=(-0.3, 1.1))) is None
        assert Revolution().swept_surface(Line(first=(1.0, 0.0), last=(2.0, 0.1))) is None
        assert Straight().swept_surface(arc) is None

    def test_lines_across_the_axis_sweep_planes(self):
        assert Revolution().swept_surface(Line(first=(2.0, 1.5), last=(1.0, 1.5))) == Plane(origin=(0.0, 0.0, 1.5))

    @pytest.mark.parametrize("lift", [0.0, 10.0])
    def test_a_torus(self, lift):
        body = Revolution().moments(torus_section(lift), between(-TURN, 0.0))
        volume = 2.0 * np.pi**2 * 5.0 * 1.69
        assert body.volume == pytest.approx(volume, rel=1e-14 if not lift else 1e-12)
        np.testing.assert_allclose(body.centroid, [0.0, 0.0, lift], atol=1e-12)
        polar = volume * (25.0 + 0.75 * 1.69)
        expected = np.diag([polar / 2.0, polar / 2.0, volume * 1.69 / 4.0])
        np.testing.assert_allclose(body.central_second, expected, atol=1e-12 * polar)

    def test_a_torus_far_up_its_axis_keeps_its_inertia_about_it(self):
        body = Revolution().moments(torus_section(4096.0), between(-TURN, 0.0))
        polar = body.central_second[0, 0] + body.central_second[1, 1]
        assert polar == pytest.approx(2.0 * np.pi**2 * 5.0 * 1.69 * (25.0 + 0.75 * 1.69), rel=1e-12)

    @pytest.mark.parametrize(
        "lift",
        [0.0, 1e2, 1e3, 1e6],
    )
    def test_the_error_bound_of_a_torus_up_its_axis_holds(self, lift):
        body = Revolution().moments(torus_section(lift), between(-TURN, 0.0))
        volume = 2.0 * np.pi**2 * 5.0 * 1.69
        polar = volume * (25.0 + 0.75 * 1.69)
        exact = np.diag([polar / 2.0, polar / 2.0, volume * 1.69 / 4.0])
        assert abs(body.volume / volume - 1.0) <= body.error_bound
        assert np.linalg.norm(body.central_second - exact) <= body.error_bound * np.linalg.norm(exact)


def torus_section(lift):
    return Section(loops=(Loop(curves=(Arc(radius=1.3, centre=(5.0, lift), interval=(0.0, TURN)),)),))


class TestRadial:
    def test_levels_are_spheres_cones_and_planes(self):
        n = np.array([np.sin(1.1) * np.cos(0.4), np.sin(1.1) * np.sin(0.4), np.cos(1.1)])
        trace = LogarithmicTrace(ratio=0.8, mean_distance=2.0, mean_spiral_angle=np.pi / 4.0)
        for levels in (None, 0.0, 0.9, np.pi / 2.0):
            placed = Radial(trace=trace, levels=levels).place(n, 3.0)
            rho, z = np.hypot(placed[0], placed[1]), placed[2]
            reached = np.hypot(rho, z) if levels is None else rho * np.sin(levels) + z * np.cos(levels)
            assert reached == pytest.approx(3.0, rel=1e-15)
            assert np.arctan2(rho, z) == pytest.approx(1.1, rel=1e-15)
            assert np.arctan2(placed[1], placed[0]) - 0.4 == pytest.approx(0.8 * np.log(np.hypot(rho, z) / 2.0))

    def test_without_symmetry_a_turning_section_between_cones_has_no_reduction(self):
        motion = Radial(trace=LogarithmicTrace(ratio=1.2, mean_distance=2.4, mean_spiral_angle=np.pi / 4.0), levels=0.9)
        assert motion.moments(spherical_section(), between(2.0, 3.1)) is None

    def test_points_move_outward_and_turn_as_the_trace_says(self):
        trace = LogarithmicTrace(ratio=0.8, mean_distance=2.0, mean_spiral_angle=np.pi / 4.0)
        placed = Radial(trace=trace).place(np.array([0.6, 0.0, 0.8]), 3.0)
        assert np.linalg.norm(placed) == pytest.approx(3.0)
        assert placed[2] == pytest.approx(2.4)
        assert np.arctan2(placed[1], placed[0]) == pytest.approx(0.8 * np.log(1.5))

    def test_its_ends_are_spheres(self):
        assert Radial(trace=StraightTrace()).end_surface(2.5).radius == 2.5

    @pytest.mark.parametrize("copies", [3, 8])
    def test_the_spiral_of_a_whole_gear_has_the_moments_of_the_straight_one(self, copies):
        step = TURN / copies
        tooth = (
            SphericalInvolute(base_cone_angle=0.5, interval=(0.0, 0.6)),
            *self.closing(SphericalInvolute(base_cone_angle=0.5, interval=(0.0, 0.6)), step),
        )
        section = SphericalSection(loops=(Loop(curves=tooth, copies=copies),))
        straight = Radial(trace=StraightTrace()).moments(section, between(40.0, 60.0))
        spiral = Radial(trace=LogarithmicTrace(ratio=1.3, mean_distance=50.0, mean_spiral_angle=np.pi / 4.0)).moments(
            section, between(40.0, 60.0)
        )
        assert spiral.volume == pytest.approx(straight.volume, rel=1e-14)
        np.testing.assert_allclose(spiral.centroid, straight.centroid, rtol=1e-14)
        np.testing.assert_allclose(spiral.central_second, straight.central_second, rtol=1e-13)

    @staticmethod
    def closing(flank, step):
        azimuth, top = float(np.arctan2(flank.end[1], flank.end[0])), float(np.arccos(flank.end[2]))
        return (
            Parallel(polar_angle=top, interval=(azimuth, 0.5 * step)),
            Meridian(azimuth=0.5 * step, interval=(top, 0.5)),
            Parallel(polar_angle=0.5, interval=(0.5 * step, step)),
        )


class TestEnds:
    ends = between(1.5, 3.0)

    def test_parameters_run_from_start_to_finish(self):
        np.testing.assert_allclose(self.ends.at(np.array([0.0, 0.2, 0.5, 1.0])), [1.5, 1.8, 2.25, 3.0])
        assert self.ends.at(0.0) == 1.5
        assert self.ends.span == 1.5

    def test_spans_are_cut_at_breaks(self):
        assert between(0.0, 3.0).spans([1.0, 2.5]) == (between(0.0, 1.0), between(1.0, 2.5), between(2.5, 3.0))
        assert self.ends.spans([]) == (self.ends,)
