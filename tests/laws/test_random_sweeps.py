"""Random sections under random motions: the routes to their moments agree, and polyhedra bound the same body."""

from dataclasses import replace

import numpy as np
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright.motions.plane_quadrature import quadrature_moments
from gearwright.solids.solid import flux_moments

TURN = 2.0 * np.pi
some = settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])


def ray_polygon(random, corners, least, most):
    """Corners at random distances along evenly spaced rays: never crossing, never symmetric."""
    angles = TURN * (np.arange(corners) + random.uniform(-0.3, 0.3, corners)) / corners
    radii = random.uniform(least, most, corners)
    return np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=-1)


@st.composite
def sections(draw):
    """Polygons and splines, with or without a hole, about a centre off the origin."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    outer = ray_polygon(random, draw(st.integers(3, 9)), 1.4, 2.0)
    hole = ray_polygon(random, draw(st.integers(3, 6)), 0.15, 0.3)
    centre = random.uniform(-1.0, 1.0, 2)
    build = draw(st.sampled_from([gw.Section.polygon, gw.Section.spline]))
    holes = [hole + centre] if draw(st.booleans()) else []
    try:
        return build(outer + centre, holes)
    except gw.GeometryError:  # a spline through few corners may swing through its hole
        assume(False)


@st.composite
def extrusions(draw):
    section = draw(sections())
    number = st.floats(0.4, 1.8)
    return gw.extrude(
        section,
        draw(st.floats(0.05, 20.0)),
        twist=draw(st.sampled_from([0.0, 1e-9, 1e-4]) | st.floats(-700.0, 700.0)),
        scale=draw(st.just((1.0, 1.0)) | st.tuples(number, number)),
        skew=draw(st.just((0.0, 0.0)) | st.tuples(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0))),
    )


@st.composite
def transforms(draw):
    a, b, c, d, e = (draw(st.floats(-0.3, 0.3)) for _ in range(5))
    section, length = draw(sections()), draw(st.floats(0.5, 2.0))
    return gw.sweep(
        section,
        lambda z: [[1 + a * np.sin(2 * z), b * z, c * z**2], [d * np.cos(z), 1 + e * z, np.sin(c * z)], [0, 0, 1]],
        length,
    )


@st.composite
def paths(draw):
    """Helices, splines through random points far enough apart, closed rings that undulate."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    kind = draw(st.sampled_from(["helix", "spline", "ring"]))
    frame = draw(st.sampled_from(["rotation-minimising", "fixed-up", "frenet"]))
    if kind == "helix":
        hand = draw(st.sampled_from(["right", "left"]))
        return gw.helix(random.uniform(6, 12), random.uniform(7, 12), random.uniform(0.2, 2.5), hand), frame
    if kind == "spline":
        steps = np.stack([random.uniform(8, 12, 5), random.uniform(-3, 3, 5), random.uniform(-3, 3, 5)], axis=-1)
        return np.cumsum(steps, axis=0), frame
    height, phase = random.uniform(0.3, 1.5), random.uniform(0.0, TURN)
    angles = np.linspace(0.0, TURN, 33)
    ring = np.stack([10 * np.cos(angles), 9 * np.sin(angles), height * np.sin(2 * angles + phase)], axis=-1)
    ring[-1] = ring[0]
    return ring, frame


@st.composite
def sweeps_along(draw):
    path, frame = draw(paths())
    try:
        return gw.sweep_along(draw(sections()), path, frame=frame)
    except gw.GeometryError as error:  # a normal that is not defined, or a bend too tight: refused, and said why
        if any(words in str(error) for words in ("choose another frame", "rougher", "would do", "differ by")):
            assume(False)
        raise


@st.composite
def revolutions(draw):
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    centre = np.array([random.uniform(1.6, 9.0), random.uniform(-5.0, 5.0)])
    outline = ray_polygon(random, draw(st.integers(3, 8)), 0.5, 1.5)
    return gw.revolve(gw.Section.polygon(outline + centre), draw(st.floats(5.0, 355.0) | st.just(360.0)))


def agree(found, expected, relative):
    size = np.cbrt(expected.volume)
    reach = size + np.max(np.abs(expected.centroid))
    scale = np.linalg.norm(expected.central_second)
    assert abs(found.volume / expected.volume - 1.0) < relative
    assert np.max(np.abs(found.centroid - expected.centroid)) < relative * reach
    assert np.max(np.abs(found.central_second - expected.central_second)) < relative * scale


@some
@given(st.one_of(extrusions(), transforms(), sweeps_along(), revolutions()))
def test_exact_moments_are_those_of_the_flux(solid):
    agree(solid.moments, flux_moments(solid.boundary), 1e-11)
    assert not solid.properties().validity()


@some
@given(extrusions())
def test_closed_forms_are_the_quadrature(solid):
    quadrature = quadrature_moments(solid.motion, solid.section, solid.ends.start, solid.ends.finish)
    agree(solid.moments, quadrature, 1e-13)


@some
@given(st.one_of(extrusions(), transforms(), sweeps_along(), revolutions()))
def test_polyhedra_bound_the_same_body(solid):
    exact = solid.properties()
    tolerance = 2e-3 * np.cbrt(exact.volume)
    polyhedron = solid.polyhedron(tolerance)
    assert polyhedron.validity().valid
    found = polyhedron.properties()
    bound = tolerance * exact.area / exact.volume
    assert abs(found.volume / exact.volume - 1.0) < bound
    assert np.max(np.abs(found.centroid - exact.centroid)) < bound * np.linalg.norm(np.ptp(exact.bounding_box, axis=0))
    low, high = exact.bounding_box
    reach = 1e-9 * np.max(high - low)
    assert np.all(polyhedron.vertices >= low - reach)
    assert np.all(polyhedron.vertices <= high + reach)


@some
@given(sections(), st.floats(-300.0, 300.0))
def test_a_twist_about_the_centroid_keeps_volume_and_centroid(section, twist):
    middle = section.properties().centroid
    centred = gw.Section(
        loops=tuple(
            type(loop)(curves=tuple(_shifted(curve, -middle) for curve in loop.curves)) for loop in section.loops
        )
    )
    straight, twisted = (gw.extrude(centred, 3.0, twist=t).properties() for t in (0.0, twist))
    assert abs(twisted.volume / straight.volume - 1.0) < 1e-14
    assert np.max(np.abs(twisted.centroid - straight.centroid)) < 1e-14 * 3.0


def _shifted(curve, offset):
    if hasattr(curve, "control"):
        return replace(curve, control=tuple(tuple((np.array(p) + offset).tolist()) for p in curve.control))
    return replace(curve, first=tuple(np.array(curve.first) + offset), last=tuple(np.array(curve.last) + offset))


@some
@given(st.integers(3, 9), st.floats(-600.0, 600.0), st.integers(0, 2**32 - 1))
def test_a_section_of_equal_principal_moments_keeps_its_inertia_under_a_twist(copies, twist, seed):
    """A random tooth, turned round: every section with at least three of them has equal principal moments."""
    radii = np.random.default_rng(seed).uniform(1.0, 2.0, 4)
    angles = TURN / copies * (np.arange(copies)[:, None] + np.array([0.0, 0.2, 0.5, 0.7])).ravel()
    points = np.tile(radii, copies)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    section = gw.Section.polygon(points)
    straight, twisted = (gw.extrude(section, 3.0, twist=t).properties() for t in (0.0, twist))
    scale = np.linalg.norm(straight.central_inertia)
    np.testing.assert_allclose(twisted.central_inertia, straight.central_inertia, rtol=0.0, atol=1e-14 * scale)
