"""Laws that every curve obeys, over all classes of the package: a new one is covered once it has an example."""

import inspect
import pkgutil
from dataclasses import dataclass
from importlib import import_module

import numpy as np
import pytest

import gearwright.curves
from gearwright.curves.arc import Arc
from gearwright.curves.bezier import Bezier
from gearwright.curves.crowned_rolled import CrownedRolled
from gearwright.curves.curve import Curve, Mapped, along, gauss_legendre, mapped, points_along, turn
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.envelope import Envelope, Tangents
from gearwright.curves.family import Member
from gearwright.curves.helix import helix
from gearwright.curves.interpolated import Interpolated, chebyshev_stations
from gearwright.curves.involute import Involute
from gearwright.curves.line import Line
from gearwright.curves.meridian import Meridian
from gearwright.curves.octoid import Octoid
from gearwright.curves.parallel import Parallel
from gearwright.curves.path import Path, path_through
from gearwright.curves.polynomial import Polynomial
from gearwright.curves.rational_bezier import RationalBezier
from gearwright.curves.relieved_involute import RelievedInvolute
from gearwright.curves.relieved_rolled import RelievedRolled
from gearwright.curves.rolled_involute import RolledInvolute
from gearwright.curves.spherical_involute import SphericalInvolute
from gearwright.curves.spherical_trochoid import SphericalTrochoid
from gearwright.curves.stereographic import Stereographic
from gearwright.curves.trochoid import Trochoid
from gearwright.curves.turning import Turned, TurnedArc


@dataclass(frozen=True)
class EllipseTangents:
    """Those of the ellipse with half axes a and b, by the angle of their normals, turned unevenly."""

    a: float
    b: float

    def __call__(self, u):
        angle, pace = u + 0.1 * np.sin(u), 1.0 + 0.1 * np.cos(u)
        c, s = np.cos(angle), np.sin(angle)
        p = np.sqrt((self.a * c) ** 2 + (self.b * s) ** 2)
        radius = (self.a * self.b) ** 2 / p**3
        along = (self.b**2 - self.a**2) * s * c / p
        return Tangents(normal=np.stack([c, s], axis=-1), support=p, along=along, speed=radius * pace)


SHEARED_MIRROR = [[0.8, 0.3], [0.5, -1.1]]
CROWNING = Polynomial(coefficients=(0.1, -0.4, 0.7), centre=0.6)
TURNED = Turned(interval=(0.1, 1.1), curve=Involute(base_radius=2.0, interval=(0.1, 1.1)), turning=CROWNING)
KNOTS = chebyshev_stations(-2.0, 2.5, 20)
WIDENING = Interpolated(
    members=tuple(
        SphericalInvolute(base_cone_angle=0.7 + 0.1 * v, interval=(0.3, 1.0 + 0.2 * v)) for v in KNOTS.tolist()
    ),
    stations=tuple(KNOTS.tolist()),
)
OCTOID = Octoid(pitch_angle=0.9, pressure_angle=0.4, interval=(-0.3, 0.5))
LIFTING = Polynomial(coefficients=(0.0, 0.3, 0.0, -0.2))

EXAMPLES = {
    Line: [
        Line(first=(1.0, -2.0), last=(-0.5, 3.0)),
        Line(first=(1.0, 0.3, -2.0), last=(4.0, 0.1, 0.7), interval=(0.2, 1.7)),
    ],
    Arc: [Arc(radius=1.7, centre=(0.4, -0.9), interval=(0.3, 2.9)), Arc(radius=0.2, interval=(1.0, -2.5))],
    Bezier: [
        Bezier(control=((0.0, 0.0), (1.0, 2.0), (3.0, -1.0), (2.0, 2.0))),
        Bezier(control=((1.0, 0.0, 1.0), (0.5, 0.7, 0.2), (-1.0, 1.0, 0.3)), interval=(0.9, 0.2)),
        Bezier(control=((0.3, 1.0), (2.0, 2.5)), interval=(0.0, 1.0)),
    ],
    RationalBezier: [
        RationalBezier(control=((0.0, 0.0), (1.0, 2.0), (3.0, -1.0), (2.0, 2.0)), weights=(1.0, 0.7, 1.6, 1.2)),
        RationalBezier(control=((1.0, 0.0, 1.0), (0.5, 0.7, 0.2)), weights=(0.8, 1.3), interval=(0.9, 0.2)),
        RationalBezier(control=((0.3, 1.0), (2.0, 2.5)), weights=(1.5, 1.0)),
    ],
    EllipticArc: [
        EllipticArc(centre=(0.4, -0.9), a=(1.7, 0.3), b=(-0.2, 0.9), interval=(0.3, 2.9)),
        EllipticArc(centre=(0.0, 0.0), a=(0.2, 0.0), b=(0.0, -0.5), interval=(1.0, -2.5)),
    ],
    Envelope: [
        Envelope(tangents=EllipseTangents(2.0, 1.6), interval=(0.2, 1.7)),
        Envelope(tangents=EllipseTangents(0.8, 1.0), interval=(1.0, -0.5)),
    ],
    Involute: [Involute(base_radius=2.3, interval=(0.0, 1.4)), Involute(base_radius=0.7, interval=(0.8, -0.5))],
    RelievedInvolute: [
        RelievedInvolute(base_radius=2.3, amount=0.02, begin=0.2, full=0.7, power=1, interval=(0.2, 0.7)),
        RelievedInvolute(base_radius=2.3, amount=-0.02, begin=0.6, full=0.3, power=2, interval=(0.6, 0.3)),
    ],
    Trochoid: [
        Trochoid(pitch_radius=3.0, depth=0.3, offset=0.05, half_axes=(0.12, 0.1), interval=(1.57, 0.4)),
        Trochoid(pitch_radius=2.0, depth=-0.02, offset=0.0, half_axes=(0.1, 0.1), interval=(0.6, 1.5)),
    ],
    Meridian: [Meridian(azimuth=2.2, interval=(0.4, 1.9))],
    Parallel: [Parallel(polar_angle=2.1, interval=(-0.4, 1.9))],
    Path: [
        helix(2.0, 0.7, 1.3, "left"),
        path_through([(0.0, 0.0, 1.0), (2.0, 0.3, 0.0), (3.0, 2.0, -1.0), (1.0, 4.0, 0.5)]),
    ],
    SphericalInvolute: [
        SphericalInvolute(base_cone_angle=0.6, interval=(0.0, 3.5)),
        SphericalInvolute(base_cone_angle=1.3, interval=(3.1, 0.2)),
    ],
    Octoid: [OCTOID, Octoid(pitch_angle=np.pi / 2.0, pressure_angle=0.3, interval=(1.1, -0.9))],
    RolledInvolute: [RolledInvolute(pitch_angle=0.8, pressure_angle=0.35, interval=(-0.2, 0.6))],
    CrownedRolled: [
        CrownedRolled(pitch_angle=0.9, flank=OCTOID, amount=0.03, full=0.5, interval=(0.0, 0.5)),
        CrownedRolled(
            pitch_angle=0.8,
            flank=RolledInvolute(pitch_angle=0.8, pressure_angle=0.35, interval=(0.0, 0.0)),
            amount=0.02,
            full=-0.1,
            interval=(-0.1, 0.0),
        ),
    ],
    RelievedRolled: [
        RelievedRolled(pitch_angle=0.9, flank=OCTOID, amount=0.03, begin=0.1, full=0.5, power=2, interval=(0.1, 0.5)),
        RelievedRolled(
            pitch_angle=0.8,
            flank=RolledInvolute(pitch_angle=0.8, pressure_angle=0.35, interval=(0.0, 0.0)),
            amount=-0.02,
            begin=0.3,
            full=-0.1,
            power=1,
            interval=(0.3, -0.1),
        ),
    ],
    SphericalTrochoid: [
        SphericalTrochoid(pitch_angle=0.8, depth=0.06, offset=0.02, radius=0.03, interval=(1.57, 0.5)),
        SphericalTrochoid(pitch_angle=np.pi / 2.0, depth=-0.02, offset=0.0, radius=0.05, interval=(0.6, 1.5)),
    ],
    Turned: [
        TURNED,
        Turned(interval=(0.9, 0.2), curve=TURNED, turning=LIFTING),
        Turned(
            interval=(0.3, 2.0),
            curve=SphericalInvolute(base_cone_angle=0.7, interval=(0.3, 2.0)),
            turning=Polynomial(coefficients=(0.2, 1.3), centre=-2.0),
        ),
        Turned(
            interval=(0.0, 1.0),
            curve=Line(first=(1.0, -2.0), last=(-0.5, 3.0)),
            turning=Polynomial(coefficients=(0.4,)),
        ),
    ],
    Interpolated: [WIDENING],
    Stereographic: [
        Stereographic(
            curve=SphericalInvolute(base_cone_angle=0.7, interval=(0.3, 2.0)),
            interval=(0.3, 2.0),
        ),
        Stereographic(curve=Meridian(azimuth=2.2, interval=(1.9, 0.4)), interval=(1.9, 0.4)),
    ],
    TurnedArc: [
        TurnedArc(radius=1.7, azimuths=(-0.2, 0.3), turnings=(CROWNING, LIFTING)),
        TurnedArc(radius=0.6, azimuths=(2.0, -0.9), turnings=(LIFTING, CROWNING), interval=(0.8, 0.1)),
    ],
    Member: [
        TURNED.at(0.35),
        Turned(interval=(0.9, 0.2), curve=TURNED, turning=LIFTING).at(-0.8),
        TurnedArc(radius=1.7, azimuths=(-0.2, 0.3), turnings=(CROWNING, LIFTING)).at(1.2),
    ],
    Mapped: [
        mapped(TURNED, SHEARED_MIRROR),
        mapped(Involute(base_radius=2.0, interval=(0.1, 1.1)), SHEARED_MIRROR),
        mapped(Arc(radius=1.5, interval=(0.2, 1.0)), turn(0.7, 2, mirrored=True)).reversed(),
        mapped(SphericalInvolute(base_cone_angle=0.7, interval=(0.3, 2.0)), turn(-1.9, 3, mirrored=True)),
        mapped(Involute(base_radius=2.0, interval=(0.1, 1.1)), SHEARED_MIRROR, (3.0, -0.7)),
    ],
}
CURVES = [pytest.param(c, id=f"{cls.__name__}-{i}") for cls, cs in EXAMPLES.items() for i, c in enumerate(cs)]
FRACTIONS = np.array([0.07, 0.31, 0.5, 0.77, 0.96])


def subclasses(cls):
    for child in cls.__subclasses__():
        yield child
        yield from subclasses(child)


def test_every_curve_of_the_package_has_an_example():
    for module in pkgutil.iter_modules(gearwright.curves.__path__, "gearwright.curves."):
        import_module(module.name)
    found = {
        c for c in subclasses(Curve) if c.__module__.startswith("gearwright.curves.") and not inspect.isabstract(c)
    }
    assert found == set(EXAMPLES)


def difference(function, x, h=1e-3):
    """Central difference of the fourth order."""
    near = function(x + h) - function(x - h)
    far = function(x + 2.0 * h) - function(x - 2.0 * h)
    return (8.0 * near - far) / (12.0 * h)


@pytest.mark.parametrize("curve", CURVES)
def test_the_derivative_is_the_difference_of_points(curve):
    u = curve.parameter(FRACTIONS)
    np.testing.assert_allclose(curve.derivative(u), difference(curve.point, u), atol=1e-10)


@pytest.mark.parametrize("curve", CURVES)
def test_points_and_derivatives_take_any_shape_of_parameters(curve):
    u = curve.parameter(np.linspace(0.1, 0.9, 6)).reshape(2, 3)
    for function in (curve.point, curve.derivative):
        grid = function(u)
        assert grid.shape == (2, 3, curve.start.size)
        assert grid.dtype == np.float64
        np.testing.assert_allclose(function(u[1, 2]), grid[1, 2], rtol=1e-15, atol=1e-15)
        assert function(float(u[0, 0])).shape == (curve.start.size,)


@pytest.mark.parametrize("examples", EXAMPLES.values(), ids=[cls.__name__ for cls in EXAMPLES])
def test_many_curves_at_once_are_one_by_one(examples):
    like = [curve for curve in examples if curve.start.size == examples[0].start.size]
    curves = [*like, *(curve.reversed() for curve in like), *like]
    points, tangents = along(curves, FRACTIONS)
    np.testing.assert_array_equal(points_along(curves, FRACTIONS), points)
    for curve, p, t in zip(curves, points, tangents, strict=True):
        u = curve.parameter(FRACTIONS)
        np.testing.assert_allclose(p, curve.point(u), rtol=1e-15, atol=1e-15)
        width = curve.interval[1] - curve.interval[0]
        np.testing.assert_allclose(t, curve.derivative(u) * width, rtol=1e-14, atol=1e-14)


def test_curves_of_several_classes_at_once_keep_their_order():
    curves = [Line(first=(0.0, 0.0), last=(1.0, 0.0)), Arc(radius=1.0, interval=(0.0, 1.0)), *EXAMPLES[Bezier][:1]]
    curves += [Line(first=(2.0, 3.0), last=(1.0, 0.5))]
    points = points_along(curves, np.array([0.0, 1.0]))
    np.testing.assert_array_equal(along(curves, np.array([0.0, 1.0]))[0], points)
    np.testing.assert_array_equal(points, [[c.start, c.end] for c in curves])


@pytest.mark.parametrize("curve", CURVES)
def test_the_interval_runs_from_start_to_end(curve):
    np.testing.assert_array_equal(curve.start, curve.point(curve.interval[0]))
    np.testing.assert_array_equal(curve.end, curve.point(curve.interval[1]))
    np.testing.assert_allclose(
        curve.parameter([0.0, 0.25, 1.0]) - curve.interval[0],
        np.ptp(curve.interval) * np.sign(curve.interval[1] - curve.interval[0]) * np.array([0.0, 0.25, 1.0]),
        atol=1e-15,
    )


@pytest.mark.parametrize("curve", CURVES)
def test_a_reversed_curve_runs_the_other_way(curve):
    back = curve.reversed()
    np.testing.assert_array_equal(back.start, curve.end)
    np.testing.assert_array_equal(back.end, curve.start)
    np.testing.assert_allclose(
        back.point(back.parameter(FRACTIONS)), curve.point(curve.parameter(1.0 - FRACTIONS)), atol=1e-14
    )
    assert back.reversed() == curve


@pytest.mark.parametrize("curve", CURVES)
def test_quadrature_integrates_an_exact_form_to_the_difference_of_its_ends(curve):
    k = np.array([0.7, -0.4, 0.9])[: curve.start.size]
    points, tangents = curve.quadrature(24)
    along = np.sum(np.exp(points @ k)[:, None] * k * tangents)
    assert along == pytest.approx(np.exp(curve.end @ k) - np.exp(curve.start @ k), rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("curve", CURVES)
def test_quadrature_integrates_any_form_as_fine_chords_do(curve):
    def form(p):
        return np.stack([p[:, 1] ** 2, np.sin(p[:, 0]), *([p[:, 0] * p[:, 1]] if p.shape[1] == 3 else [])], axis=-1)

    def chords(n):
        p = curve.point(curve.parameter(np.linspace(0.0, 1.0, n + 1)))
        return np.sum((form(p)[:-1] + form(p)[1:]) / 2.0 * np.diff(p, axis=0))

    points, tangents = curve.quadrature(24)
    extrapolated = (4.0 * chords(2000) - chords(1000)) / 3.0
    assert np.sum(form(points) * tangents) == pytest.approx(extrapolated, abs=1e-9)
    backwards = curve.reversed().quadrature(24)
    assert np.sum(form(backwards[0]) * backwards[1]) == pytest.approx(-extrapolated, abs=1e-9)


FAMILIES = [p for p in CURVES if p.values[0].varies]
CONSTANT = [p for p in CURVES if not p.values[0].varies]
STATIONS = np.array([-0.7, 0.0, 0.31, 0.9, 1.6])


@pytest.mark.parametrize("curve", CONSTANT)
def test_a_constant_curve_is_its_own_family(curve):
    assert curve.at(0.7) is curve
    assert curve.extremes(-9.0, 9.0) == ()


@pytest.mark.parametrize("curve", CONSTANT)
def test_a_constant_curve_does_not_vary(curve):
    u = curve.parameter(FRACTIONS)[:, None]
    variation = curve.variation(u, np.array([0.1, 0.2]))
    assert variation.shape == (5, 2, curve.start.size)
    assert not variation.any()


@pytest.mark.parametrize("curve", CURVES)
def test_the_variation_is_the_difference_of_members(curve):
    u = curve.parameter(FRACTIONS)[:, None]
    variation = curve.variation(u, STATIONS)
    assert variation.shape == (5, 5, curve.start.size)
    for v, found in zip(STATIONS, np.moveaxis(variation, 1, 0), strict=True):
        numeric = difference(lambda w: curve.at(w).point(u[:, 0]), v)
        np.testing.assert_allclose(found, numeric, atol=1e-10)
        # interpolated ones are sums, which many parameters at once may round in another order
        np.testing.assert_allclose(curve.variation(u[:, 0], v), found, rtol=1e-15, atol=1e-14)


@pytest.mark.parametrize("curve", CURVES)
def test_members_at_an_array_of_parameters_are_one_by_one(curve):
    u, v = np.meshgrid(curve.parameter(FRACTIONS), STATIONS)
    member = curve.at(v)
    for function, of in ((member.point, "point"), (member.derivative, "derivative")):
        for i, j in np.ndindex(u.shape):
            one = getattr(curve.at(float(v[i, j])), of)(float(u[i, j]))
            np.testing.assert_allclose(function(u)[i, j], one, rtol=1e-15, atol=1e-15)


@pytest.mark.parametrize("curve", FAMILIES)
class TestEveryFamily:
    def test_a_member_has_the_interval_and_no_members_of_its_own(self, curve):
        member = curve.at(0.9)
        assert member.interval == curve.interval
        assert not member.varies
        assert not member.variation(member.parameter(FRACTIONS), 0.3).any()
        back = curve.reversed()
        np.testing.assert_array_equal(back.at(0.9).start, member.end)

    def test_the_derivative_of_a_member_is_the_difference_of_its_points(self, curve):
        for v in STATIONS:
            member = curve.at(v)
            u = member.parameter(FRACTIONS)
            np.testing.assert_allclose(member.derivative(u), difference(member.point, u), atol=1e-10)


@pytest.mark.parametrize(
    "curve", [Meridian(azimuth=0.3, interval=(0.2, 2.0)), Parallel(polar_angle=0.8, interval=(0, 1))]
)
def test_circles_of_the_sphere_have_the_spherical_coordinates_they_say(curve):
    u = curve.parameter(FRACTIONS)
    x, y, z = curve.point(u).T
    polar, azimuth = (u, 0.3) if isinstance(curve, Meridian) else (0.8, u)
    np.testing.assert_allclose(x**2 + y**2 + z**2, 1.0, atol=1e-15)
    np.testing.assert_allclose(np.arccos(z), polar, atol=1e-15)
    np.testing.assert_allclose(np.arctan2(y, x), azimuth, atol=1e-15)


def test_an_arc_keeps_its_distance_from_its_centre_and_starts_on_plus_x():
    arc = Arc(radius=2.0, centre=(3.0, -1.0), interval=(0.0, 1.0))
    np.testing.assert_allclose(np.linalg.norm(arc.point([0.1, 2.0, 4.0]) - [3.0, -1.0], axis=1), 2.0)
    np.testing.assert_array_equal(arc.start, [5.0, -1.0])
    assert arc.point(np.pi / 2.0)[1] == pytest.approx(1.0)


def test_a_line_divides_its_segment_evenly():
    line = Line(first=(1.0, 2.0, 3.0), last=(5.0, 4.0, -1.0))
    np.testing.assert_array_equal(line.point([0.0, 0.25, 1.0]), [[1, 2, 3], [2, 2.5, 2], [5, 4, -1]])


def test_an_envelope_of_an_ellipse_s_tangents_is_the_ellipse():
    (curve, _) = EXAMPLES[Envelope]
    x, y = curve.point(curve.parameter(FRACTIONS)).T
    np.testing.assert_allclose((x / 2.0) ** 2 + (y / 1.6) ** 2, 1.0, atol=1e-15)


class TestMapped:
    def test_points_are_carried_by_the_matrix(self):
        involute = Involute(base_radius=2.0, interval=(0.1, 1.1))
        image = mapped(involute, SHEARED_MIRROR)
        for u in (0.1, 0.6, 1.1):
            x, y = involute.point(u)
            np.testing.assert_allclose(image.point(u), [0.8 * x + 0.3 * y, 0.5 * x - 1.1 * y], atol=1e-15)

    def test_an_offset_is_added_to_points_and_to_nothing_else(self):
        involute = Involute(base_radius=2.0, interval=(0.1, 1.1))
        image, shifted = mapped(involute, SHEARED_MIRROR), mapped(involute, SHEARED_MIRROR, (3.0, -0.7))
        np.testing.assert_allclose(shifted.point(0.6) - image.point(0.6), [3.0, -0.7], atol=1e-15)
        np.testing.assert_array_equal(shifted.derivative(0.6), image.derivative(0.6))

    def test_a_turn_adds_to_the_azimuth(self):
        for dimension in (2, 3):
            base = np.array([0.6, -0.2, 0.9][:dimension])
            moved = turn(0.8, dimension) @ base
            assert np.arctan2(moved[1], moved[0]) == pytest.approx(np.arctan2(-0.2, 0.6) + 0.8, abs=1e-15)
            assert np.hypot(moved[0], moved[1]) == pytest.approx(np.hypot(0.6, 0.2))
            np.testing.assert_array_equal(moved[2:], base[2:])

    def test_a_mirror_image_is_taken_before_the_turn(self):
        for dimension in (2, 3):
            base = np.array([0.6, 0.2, 0.9][:dimension])
            moved = turn(0.8, dimension, mirrored=True) @ base
            assert np.arctan2(moved[1], moved[0]) == pytest.approx(0.8 - np.arctan2(0.2, 0.6), abs=1e-15)
            np.testing.assert_array_equal(moved[2:], base[2:])
            assert np.linalg.det(turn(0.8, dimension, mirrored=True)) == pytest.approx(-1.0)

    def test_a_mirror_image_encloses_the_opposite_area(self):
        circle = Arc(radius=1.5, centre=(1.0, 2.0), interval=(0.0, 2.0 * np.pi))

        def area(curve):
            points, tangents = curve.quadrature(40)
            return np.sum(points[:, 0] * tangents[:, 1])

        assert area(circle) == pytest.approx(np.pi * 2.25)
        assert area(mapped(circle, turn(0.3, 2, mirrored=True))) == pytest.approx(-np.pi * 2.25)


@dataclass(frozen=True, kw_only=True)
class Swelling(Curve):
    """A circle whose radius is 1 + v², to see families pass through."""

    v: float = 0.0

    def point(self, u):
        u = np.asarray(u, float)
        return (1.0 + self.v**2) * np.stack([np.cos(u), np.sin(u)], axis=-1)

    def derivative(self, u):
        u = np.asarray(u, float)
        return (1.0 + self.v**2) * np.stack([-np.sin(u), np.cos(u)], axis=-1)

    def at(self, v):
        return Swelling(interval=self.interval, v=float(v))

    def variation(self, u, v):
        u = np.asarray(u, float)
        return 2.0 * np.asarray(v)[..., None] * np.stack([np.cos(u), np.sin(u)], axis=-1)


class TestMappedFamily:
    family = mapped(Swelling(interval=(0.2, 1.5)), SHEARED_MIRROR)

    def test_a_member_is_the_image_of_the_member(self):
        np.testing.assert_allclose(
            self.family.at(1.5).point(0.4), 3.25 * np.array(SHEARED_MIRROR) @ [np.cos(0.4), np.sin(0.4)]
        )

    def test_the_variation_is_the_difference_of_members(self):
        numeric = difference(lambda v: self.family.at(v).point(0.4), 0.9)
        np.testing.assert_allclose(self.family.variation(0.4, np.array(0.9)), numeric, atol=1e-10)

    def test_a_member_of_a_reversed_family_is_reversed(self):
        back = self.family.reversed()
        assert back.at(1.5).interval == back.interval
        np.testing.assert_array_equal(back.at(0.0).start, self.family.at(0.0).end)


def test_gauss_legendre_is_exact_to_degree_2n_minus_1_and_no_further():
    for n in (1, 2, 5, 10):
        x, w = gauss_legendre(n)
        for degree in range(2 * n):
            assert np.sum(w * x**degree) == pytest.approx((1 + (-1) ** degree) / (degree + 1), abs=1e-14)
        assert abs(np.sum(w * x ** (2 * n)) - 2.0 / (2 * n + 1)) > 1e-6


@pytest.mark.parametrize("nodes", [160, 224])
def test_gauss_legendre_keeps_machine_precision_with_many_nodes(nodes):
    x, w = gauss_legendre(nodes)
    for degree in (2, 4, 6):
        assert np.sum(w * x**degree) * (degree + 1) / 2.0 == pytest.approx(1.0, abs=3e-15)


class TestInterpolated:
    @pytest.mark.parametrize("v", [-2.0, -0.83, 0.2, 2.5])
    def test_members_are_those_of_the_analytic_family(self, v):
        expected = SphericalInvolute(base_cone_angle=0.7 + 0.1 * v, interval=(0.3, 1.0 + 0.2 * v))
        member = WIDENING.at(v)
        np.testing.assert_allclose(
            member.point(member.parameter(FRACTIONS)), expected.point(expected.parameter(FRACTIONS)), atol=3e-15
        )

    def test_members_at_many_parameters_are_each_its_own(self):
        v = np.array([[-0.5], [0.3], [KNOTS[4]]])
        u = np.broadcast_to(FRACTIONS, (3, FRACTIONS.size))
        together = WIDENING.at(v).point(u)
        for row, one in zip(together, v[:, 0], strict=True):
            np.testing.assert_allclose(row, WIDENING.at(float(one)).point(FRACTIONS), atol=1e-15)

    def test_what_is_kept_of_fractions_is_of_those_and_of_points_or_rates_apart(self):
        """More sets of fractions than are kept, out of order and repeated, each twice, points and rates in turn."""
        fresh = Interpolated(members=WIDENING.members, stations=WIDENING.stations)
        sets = [np.array([[0.9, k / 20.0], [k / 20.0, 0.1]]) for k in range(20)]
        for u in sets + sets[::-1]:
            for found, step in ((fresh.member_point(u, 0.3), 0.0), (fresh.member_derivative(u, 0.3), 1e-6)):
                for place in np.ndindex(2, 2):
                    ends = [WIDENING.at(0.3).point(float(u[place]) + sign * step) for sign in (1.0, -1.0)]
                    expected = (ends[0] - ends[1]) / (2.0 * step) if step else ends[0]
                    np.testing.assert_allclose(found[place], expected, atol=1e-9 if step else 1e-15)

    def test_a_family_needs_a_station_for_each_member(self):
        with pytest.raises(ValueError, match="station"):
            Interpolated(members=WIDENING.members[:3], stations=(0.0, 1.0))


def test_a_stereographic_image_keeps_angles():
    meridian = Meridian(azimuth=2.2, interval=(0.4, 1.9))
    parallel = Parallel(polar_angle=1.1, interval=(0.0, 2.0))
    for azimuth in (0.3, 1.4):
        images = [
            Stereographic(curve=curve, interval=curve.interval).derivative(u)
            for curve, u in ((Meridian(azimuth=azimuth, interval=(0.1, 2.0)), 1.1), (parallel, azimuth))
        ]
        assert images[0] @ images[1] == pytest.approx(0.0, abs=1e-15)
    assert np.hypot(*Stereographic(curve=meridian, interval=meridian.interval).point(1.9)) == pytest.approx(
        np.tan(0.95), rel=1e-15
    )
