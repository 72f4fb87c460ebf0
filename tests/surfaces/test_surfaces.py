"""Laws that every surface obeys, over all classes of the package, and what is particular to each."""

import inspect
import pkgutil
from importlib import import_module

import numpy as np
import pytest

import gearwright.surfaces
from gearwright.placement import Placement
from gearwright.surfaces.cone import Cone
from gearwright.surfaces.placed import PlacedSurface
from gearwright.surfaces.plane import Plane
from gearwright.surfaces.sphere import Sphere
from gearwright.surfaces.surface import Surface

C, S = np.cos(0.7), np.sin(0.7)
SLANTED = Plane(origin=(0.4, -1.1, 2.3), x_axis=(C, 0.0, -S), y_axis=(S * 0.6, 0.8, C * 0.6))
LEANING = Placement.of([[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]], (0.7, -1.9, 3.1))

EXAMPLES = {
    Cone: [
        Cone(angle=0.5, distance=1.2),
        Cone(angle=1.35, distance=2.3),
        Cone(angle=np.pi / 2.0, distance=0.9),
    ],
    Plane: [
        Plane(origin=(0.0, 0.0, 1.7)),
        Plane(origin=(0.0, 0.0, 0.0), x_axis=(C, -S, 0.0), y_axis=(0, 0, 1)),
        SLANTED,
    ],
    Sphere: [Sphere(radius=1.0), Sphere(radius=2.6)],
    PlacedSurface: [
        PlacedSurface(surface=Sphere(radius=1.4), placement=LEANING),
        PlacedSurface(surface=SLANTED, placement=LEANING),
    ],
}
SURFACES = [pytest.param(s, id=f"{cls.__name__}-{i}") for cls, ss in EXAMPLES.items() for i, s in enumerate(ss)]
SYMMETRIC = [
    Cone(angle=1.1, distance=1.4),
    Cone(angle=np.pi / 2.0, distance=0.9),
    Plane(origin=(0.0, 0.0, 1.7)),
    Sphere(radius=2.6),
]
CHARTS = np.array([[0.0, 0.0], [0.3, -0.2], [-0.9, 0.8], [1.6, 1.2], [0.1, -2.5]])
OFF_APEX = np.array([[1.0, 0.1], [0.7, -0.6], [-0.9, 0.8], [1.6, 1.2], [0.1, -2.5]])
DISCS = [((0.0, 0.0), 0.4), ((0.3, -0.2), 0.15), ((0.2, 0.1), 1.3)]
OFF_APEX_DISCS = [((1.3, 0.2), 0.4), ((-0.3, 1.2), 0.6)]


def charts(surface):
    """Chart points to look at; a cone has no tangent plane in the middle of its chart."""
    return OFF_APEX if isinstance(surface, Cone) else CHARTS


def discs(surface):
    return OFF_APEX_DISCS if isinstance(surface, Cone) else DISCS


def test_every_surface_of_the_package_has_an_example():
    found = set()
    for info in pkgutil.iter_modules(gearwright.surfaces.__path__, "gearwright.surfaces."):
        classes = [c for _, c in inspect.getmembers(import_module(info.name), inspect.isclass)]
        found |= {c for c in classes if issubclass(c, Surface) and not inspect.isabstract(c)}
    assert found == set(EXAMPLES)


def partials(surface, chart, h=1e-3):
    """∂point/∂chart (..., 2, 3) by central differences of the fourth order."""
    steps = []
    for axis in (np.array([h, 0.0]), np.array([0.0, h])):
        near = surface.point(chart + axis) - surface.point(chart - axis)
        far = surface.point(chart + 2 * axis) - surface.point(chart - 2 * axis)
        steps.append((8.0 * near - far) / (12.0 * h))
    return np.stack(steps, axis=-2)


def disc_loop(surface, centre, radius, n=400, sense=1.0):
    """Points and weighted tangents of a circle of the chart, by the trapezoidal rule."""
    t = sense * np.arange(n) * 2.0 * np.pi / n
    chart = centre + radius * np.stack([np.cos(t), np.sin(t)], axis=-1)
    along = radius * np.stack([-np.sin(t), np.cos(t)], axis=-1) * (sense * 2.0 * np.pi / n)
    return surface.point(chart), np.einsum("ni,nij->nj", along, partials(surface, chart))


def disc_quadrature(surface, centre, radius):
    """Points and area vectors of the face inside that circle, by brute force over the chart."""
    x, w = np.polynomial.legendre.leggauss(40)
    rho, t = (x + 1.0) / 2.0 * radius, np.arange(160) * 2.0 * np.pi / 160
    rho, t = (a.ravel() for a in np.meshgrid(rho, t, indexing="ij"))
    weights = np.repeat(w * radius / 2.0, 160) * rho * 2.0 * np.pi / 160
    chart = centre + rho[:, None] * np.stack([np.cos(t), np.sin(t)], axis=-1)
    d = partials(surface, chart)
    return surface.point(chart), np.cross(d[:, 0], d[:, 1]) * weights[:, None]


@pytest.mark.parametrize("surface", SURFACES)
class TestEverySurface:
    def test_the_chart_and_its_points_are_inverse(self, surface):
        np.testing.assert_allclose(surface.chart(surface.point(charts(surface))), charts(surface), atol=3e-15)
        assert surface.point(charts(surface).reshape(1, 5, 2)).shape == (1, 5, 3)
        assert surface.chart(surface.point(charts(surface)[1])).shape == (2,)

    def test_points_lie_on_the_surface_and_others_as_far_off_as_they_are(self, surface):
        points = surface.point(charts(surface))
        assert np.max(surface.deviation(points)) < 2e-15
        d = partials(surface, charts(surface))
        normal = np.cross(d[:, 0], d[:, 1])
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        for distance in (-0.3, 1e-3, 0.2):
            np.testing.assert_allclose(surface.deviation(points + distance * normal), abs(distance), atol=1e-12)

    def test_the_chart_is_conformal(self, surface):
        d = partials(surface, charts(surface))
        metric = np.einsum("nik,njk->nij", d, d)
        np.testing.assert_allclose(metric, metric[:, :1, :1] * np.eye(2), atol=1e-10)

    @pytest.mark.parametrize("which", range(len(DISCS)))
    def test_flux_is_that_of_brute_force(self, surface, which):
        centre, radius = discs(surface)[which % len(discs(surface))]
        points, areas = disc_quadrature(surface, np.array(centre), radius)
        expected = np.zeros((4, 4))
        outward = np.sum(points * areas, axis=1)
        expected[0, 0] = np.sum(outward) / 3.0
        for i in range(3):
            expected[0, i + 1] = expected[i + 1, 0] = np.sum(outward * points[:, i]) / 4.0
            for j in range(3):
                expected[i + 1, j + 1] = np.sum(outward * points[:, i] * points[:, j]) / 5.0
        np.testing.assert_allclose(surface.flux(*disc_loop(surface, centre, radius)), expected, atol=1e-9)

    def test_area_is_that_of_brute_force_and_signed(self, surface):
        centre, radius = np.array(discs(surface)[1][0]), 0.7
        expected = np.sum(np.linalg.norm(disc_quadrature(surface, centre, radius)[1], axis=1))
        assert surface.area(*disc_loop(surface, centre, radius)) == pytest.approx(expected, rel=1e-10)
        assert surface.area(*disc_loop(surface, centre, radius, sense=-1.0)) == pytest.approx(-expected, rel=1e-10)

    def test_a_hole_takes_its_share_away(self, surface):
        centre = discs(surface)[1][0]
        outer, inner = disc_loop(surface, centre, 0.9), disc_loop(surface, centre, 0.3, sense=-1.0)
        both = tuple(np.concatenate(pair) for pair in zip(outer, inner, strict=True))
        ring = surface.flux(*outer) - surface.flux(*disc_loop(surface, centre, 0.3))
        np.testing.assert_allclose(surface.flux(*both), ring, atol=1e-12)

    @pytest.mark.parametrize("tolerance", [1e-6, 1e-4])
    def test_lattice_triangles_of_the_spacing_keep_the_tolerance(self, surface, tolerance):
        spacing = surface.spacing(tolerance, charts(surface))
        assert spacing.shape == (5,)
        for centre, step in zip(charts(surface), np.minimum(spacing, 10.0), strict=True):
            worst = 0.0
            for corner in ([1, 1], [-1, 1], [1, -1], [-1, -1]):
                a, b, c = surface.point(centre + step * np.array([[0, 0], [corner[0], 0], [0, corner[1]]]))
                inside = np.array([(a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3])
                worst = max(worst, float(np.max(surface.deviation(inside))))
            # the scale of the chart varies over a cell by a part of the order of the step
            assert worst <= tolerance * (1.0 + 8.0 * np.sqrt(tolerance))
            if np.isfinite(spacing).all():
                # a cone bends one way only, and these squares lie as they like to that
                assert worst > (0.2 if isinstance(surface, Cone) else 0.9) * tolerance

    def test_extremes_are_points_where_the_normal_is_along_an_axis(self, surface):
        points = surface.extremes()
        assert points.shape[1:] == (3,)
        assert np.all(surface.deviation(points) < 1e-15)
        d = partials(surface, surface.chart(points))
        normals = np.cross(d[:, 0], d[:, 1])
        on_axis = np.sum(np.abs(normals) > 1e-9 * np.max(np.abs(normals), initial=1.0), axis=1)
        assert np.all(on_axis == 1)


@pytest.mark.parametrize("surface", SYMMETRIC, ids=repr)
def test_charts_turn_with_rotations_about_z(surface):
    given = charts(surface)
    points = surface.point(given)
    c, s = np.cos(2.1), np.sin(2.1)
    turned = np.stack([c * points[:, 0] - s * points[:, 1], s * points[:, 0] + c * points[:, 1], points[:, 2]], axis=1)
    expected = np.stack([c * given[:, 0] - s * given[:, 1], s * given[:, 0] + c * given[:, 1]], axis=1)
    np.testing.assert_allclose(surface.chart(turned), expected, atol=2e-15)


def test_the_normal_of_a_plane_is_x_axis_cross_y_axis_and_that_of_a_sphere_outward():
    for surface in (SLANTED, Sphere(radius=2.0)):
        d = partials(surface, CHARTS)
        normal = np.cross(d[:, 0], d[:, 1])
        out = np.cross(SLANTED.x_axis, SLANTED.y_axis) if surface is SLANTED else surface.point(CHARTS)
        assert np.all(np.sum(normal * out, axis=1) > 0.0)


def test_the_chart_of_a_sphere_has_its_pole_in_the_middle_and_its_equator_on_the_unit_circle():
    sphere = Sphere(radius=3.0)
    np.testing.assert_array_equal(sphere.chart(np.array([0.0, 0.0, 3.0])), [0.0, 0.0])
    np.testing.assert_allclose(sphere.chart(np.array([0.0, 3.0, 0.0])), [0.0, 1.0])
    np.testing.assert_allclose(sphere.chart(3.0 * np.array([np.sin(1.0), 0.0, np.cos(1.0)])), [np.tan(0.5), 0.0])


def test_the_whole_sphere_but_a_pinhole_encloses_the_ball():
    sphere = Sphere(radius=2.0)
    flux = sphere.flux(*disc_loop(sphere, (0.0, 0.0), 1e5, n=32))
    volume = 4.0 / 3.0 * np.pi * 8.0
    expected = volume * np.diag([1.0, 4.0 / 5.0, 4.0 / 5.0, 4.0 / 5.0])
    np.testing.assert_allclose(flux, expected, atol=1e-7)


def test_the_flux_of_a_small_cap_near_the_pole_keeps_its_precision():
    sphere, centre, radius = Sphere(radius=1.0), np.array([2e-3, 1e-3]), 1e-3
    points, areas = disc_quadrature(sphere, centre, radius)
    outward = np.sum(points * areas, axis=1)
    flux = sphere.flux(*disc_loop(sphere, centre, radius))
    assert flux[0, 0] == pytest.approx(np.sum(outward) / 3.0, rel=1e-10)
    assert flux[0, 1] == pytest.approx(np.sum(outward * points[:, 0]) / 4.0, rel=1e-9, abs=0.0)
    assert flux[1, 1] == pytest.approx(np.sum(outward * points[:, 0] ** 2) / 5.0, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("angle", [0.4, 1.2])
def test_the_flux_of_a_cone_about_its_apex_is_that_of_the_body_below_it(angle):
    cone = Cone(angle=angle, distance=1.5)
    apex, radius = 1.5 / np.cos(angle), 0.8
    height = apex - radius * np.tan(angle)  # of the circle where the face ends
    # the part of the body between the face and the origin: the cone over the disc up to the circle, and the tip on it
    disc = np.pi * radius**2
    volume = disc * height / 3.0 + disc * (apex - height) / 3.0
    first = disc * height**2 / 4.0 + disc * (apex - height) / 3.0 * (height + (apex - height) / 4.0)
    around = disc * radius**2 * (height + apex - height) / 20.0
    n = np.arange(64) * 2.0 * np.pi / 64
    points = np.stack([radius * np.cos(n), radius * np.sin(n), np.full(64, height)], axis=1)
    tangents = np.stack([-radius * np.sin(n), radius * np.cos(n), np.zeros(64)], axis=1) * 2.0 * np.pi / 64
    flux = cone.flux(points, tangents)
    assert flux[0, 0] == pytest.approx(volume, rel=1e-14)
    assert flux[0, 3] == pytest.approx(first, rel=1e-14)
    assert flux[1, 1] == pytest.approx(around, rel=1e-14)
    np.testing.assert_allclose(cone.point(np.zeros(2)), [0.0, 0.0, apex], rtol=1e-15)
