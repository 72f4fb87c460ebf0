"""Followers laid on their cams: they touch at one place, lie nowhere inside, and all that is said of it is so.

The followers are placed here by plane geometry from the element's parameters; the cam is only a set of points.
"""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from gearwright.elements.cams.cam import Cam
from gearwright.elements.cams.kinds import KINDS
from gearwright.elements.cams.laws import FIXED_LAWS

THESIS = "dwell 36, rise 72, dwell 144, return 108"
SLOW = "rise 150, dwell 60, return 150"
FOLLOWERS = {
    "oscillating flat face": {
        "swing": 20.0, "pivot_distance": 20.0, "face_offset": 70.0, "initial_angle": 20.0, "programme": SLOW,
    },
    "oscillating flat face, with the cam": {
        "swing": 20.0, "pivot_distance": 80.0, "face_offset": 60.0, "initial_angle": 35.0, "sense": "same",
        "programme": SLOW,
    },
    "translating flat face": {
        "follower": "translating-flat-face", "lift": 10.0, "base_radius": 45.0, "programme": THESIS,
    },
    "translating roller": {
        "follower": "translating-roller", "lift": 12.0, "base_radius": 25.0, "roller_radius": 8.0, "offset": 5.0,
        "programme": THESIS,
    },
    "translating roller, offset back": {
        "follower": "translating-roller", "lift": 10.0, "base_radius": 28.0, "roller_radius": 6.0, "offset": -7.0,
        "programme": THESIS,
    },
    "oscillating roller": {
        "follower": "oscillating-roller", "swing": 25.0, "pivot_distance": 80.0, "arm_length": 60.0,
        "base_radius": 28.0, "roller_radius": 9.0, "programme": THESIS,
    },
    "oscillating roller, with the cam": {
        "follower": "oscillating-roller", "swing": 25.0, "pivot_distance": 80.0, "arm_length": 60.0,
        "initial_angle": 30.0, "roller_radius": 9.0, "sense": "same", "programme": THESIS,
    },
}  # fmt: skip
LAWS = [*FIXED_LAWS, "spline"]
ANGLES = 2.0 * np.pi * np.arange(4000) / 4000
"""Cam angles at which the profile is taken; the follower is laid on it at every tenth."""
PLACED = ANGLES[::10]


SPLINE = (0.03, 0.18, 0.42, 0.62, 0.85, 0.97)


@cache
def built(name):
    """The cam of a follower and a law, "translating roller, harmonic"."""
    follower, law = name.rsplit(", ", 1)
    more = {"spline_values": SPLINE * 2} if law == "spline" else {}
    return Cam(**FOLLOWERS[follower], law=law, thickness=10.0, **more)


@pytest.fixture
def cam(request):
    return built(request.param)


NAMES = [f"{follower}, {law}" for follower in FOLLOWERS for law in LAWS]
every_cam = pytest.mark.parametrize("cam", NAMES, indirect=True)
one_law = pytest.mark.parametrize("cam", [f"{follower}, cycloidal" for follower in FOLLOWERS], indirect=True)


def unit(angle):
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def turned(vectors, angle):
    """Vectors (..., 2) turned counter-clockwise."""
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)], axis=-1)


def swung(cam, angle, s):
    """Pivot, and the direction from it along face or arm, at cam angle and displacement."""
    found = cam.dimensions
    if "initial_angle" in found:
        initial = np.radians(found["initial_angle"])
    else:  # from the triangle of axis, pivot and roller
        a, d, r = found["arm_length"], found["pivot_distance"], found["base_radius"] + found["roller_radius"]
        initial = np.arccos((a**2 + d**2 - r**2) / (2.0 * a * d))
    sense = -1.0 if cam.sense == "same" else 1.0
    to_axis = -unit(angle)
    return found["pivot_distance"] * unit(angle), turned(to_axis, sense * (initial + s))


def face(cam, angle, s):
    """A point of the flat face and its normal away from the cam."""
    if cam.kind.swings:
        pivot, along = swung(cam, angle, s)
        normal = turned(along, np.pi / 2.0)
        normal = np.where(np.sum(normal * unit(angle), axis=-1)[..., None] > 0.0, normal, -normal)
        return pivot + cam.dimensions["face_offset"] * normal, normal
    return (cam.dimensions["base_radius"] + s)[..., None] * unit(angle), unit(angle)


def roller(cam, angle, s):
    """The roller's centre."""
    found = cam.dimensions
    if cam.kind.swings:
        pivot, along = swung(cam, angle, s)
        return pivot + found["arm_length"] * along
    start = np.sqrt((found["base_radius"] + found["roller_radius"]) ** 2 - found["offset"] ** 2)
    return (start + s)[..., None] * unit(angle) + found["offset"] * unit(angle + np.pi / 2.0)


def gaps(cam, angle, s, points):
    """Distances (k, n) of the profile's points from the follower at k positions; negative inside it."""
    if "flat-face" in cam.follower:
        at, normal = face(cam, angle, s)
        return np.sum((at[:, None] - points) * normal[:, None], axis=-1)
    return np.linalg.norm(roller(cam, angle, s)[:, None] - points, axis=-1) - cam.dimensions["roller_radius"]


def displaced(cam, angle):
    return cam.displacement.derivatives(angle)[0]


@every_cam
def test_the_follower_touches_the_profile_and_lies_nowhere_inside(cam):
    """The envelope check: the support of the profile is p, to 1e-12."""
    points = cam.traced.points(ANGLES)
    found = gaps(cam, PLACED, displaced(cam, PLACED), points)
    size = np.abs(points).max()
    np.testing.assert_allclose(found.min(axis=1), 0.0, atol=1e-12 * size)
    here = np.abs(found[np.arange(len(PLACED)), 10 * np.arange(len(PLACED))])
    assert here.max() <= 1e-12 * size


@every_cam
def test_the_profile_s_curves_are_what_the_follower_touches(cam):
    """The loop, whose quadrature gives the moments, passes through the points, and closes."""
    for curve, start in zip(cam.traced.curves, np.roll([c.end for c in cam.traced.curves], 1, axis=0), strict=True):
        np.testing.assert_allclose(curve.start, start, atol=1e-12 * np.abs(start).max())
    ends = [cut for segment in cam.displacement.segments for cut in segment.cuts[:-1]]
    starts = [curve.start for curve in cam.traced.curves]
    inside = [cut for s in cam.displacement.segments for cut in (s.cuts[:-1] if s.law else s.cuts[:1])]
    assert len(ends) == len(starts) == len(inside)
    np.testing.assert_allclose(cam.traced.points(np.array(ends)), starts, atol=1e-12 * np.abs(starts).max())


@every_cam
def test_the_profile_s_derivative_is_that_of_its_points(cam):
    for curve in cam.traced.curves:
        u, h = curve.parameter(np.array([0.1, 0.45, 0.8])), 1e-5
        found = (curve.point(u + h) - curve.point(u - h)) / (2.0 * h)
        np.testing.assert_allclose(curve.derivative(u), found, atol=2e-6 * np.abs(found).max())


@every_cam
def test_the_area_is_half_the_integral_of_p_squared_minus_q_squared(cam):
    """In ν, for every follower; scipy's quadrature over each analytic piece."""

    def integrand(angle):
        contact = cam.traced.contact(angle)
        return float((contact.support**2 - contact.along**2) * contact.turning) / 2.0

    pieces = [(a, b) for s in cam.displacement.segments for a, b in pairwise(s.cuts)]
    area = sum(quad(integrand, a, b, epsabs=1e-11, epsrel=1e-12)[0] for a, b in pieces)
    assert cam.sizes()["disk_area"].value == pytest.approx(area, rel=1e-10)
    assert cam.properties().volume == pytest.approx(10.0 * area, rel=1e-10)
    assert cam.properties().error_bound < 1e-13


@one_law
def test_the_eccentricity_is_the_distance_of_the_normal_from_the_axis(cam):
    contact, points = cam.traced.contact(PLACED), cam.traced.points(PLACED)
    if "flat-face" in cam.follower:
        normal = face(cam, PLACED, displaced(cam, PLACED))[1]
    else:
        normal = roller(cam, PLACED, displaced(cam, PLACED)) - points
        normal /= np.linalg.norm(normal, axis=1)[:, None]
    arm = normal[:, 0] * points[:, 1] - normal[:, 1] * points[:, 0]
    np.testing.assert_allclose(contact.along, arm, atol=1e-11)
    dense = np.abs(cam.traced.contact(ANGLES).along).max()
    assert dense <= cam.sizes()["largest_eccentricity"].value <= dense * (1.0 + 1e-5)


@one_law
def test_the_pressure_angle_is_between_the_normal_and_the_follower_s_way(cam):
    """The way is found by lifting the follower a little at a held cam angle."""
    s, h = displaced(cam, PLACED), 1e-6
    points = cam.traced.points(PLACED)
    if "roller" in cam.follower:
        way = roller(cam, PLACED, s + h) - roller(cam, PLACED, s - h)
        normal = roller(cam, PLACED, s) - points
    else:
        normal = face(cam, PLACED, s)[1]
        way = turned(points - swung(cam, PLACED, s)[0], np.pi / 2.0) if cam.kind.swings else unit(PLACED)
    cosine = np.sum(way * normal, axis=1) / np.linalg.norm(way, axis=1) / np.linalg.norm(normal, axis=1)
    found = np.arctan(np.abs(cam.traced.contact(PLACED).pressure))
    np.testing.assert_allclose(np.cos(found), np.abs(cosine), atol=1e-8)
    largest = np.degrees(np.arctan(np.abs(cam.traced.contact(ANGLES).pressure)).max())
    assert cam.sizes()["largest_pressure_angle"].value == pytest.approx(largest, rel=1e-5)


@every_cam
def test_the_least_radius_of_curvature_is_that_of_circles_through_neighbouring_points(cam):
    sharpest, h = cam.traced.sharpest, 2e-4
    a, b, c = cam.traced.points(sharpest.angle + np.array([-h, 0.0, h]))
    sides = [np.linalg.norm(v) for v in (b - a, c - b, c - a)]
    double = abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0])
    at_a_joint = min(abs(sharpest.angle - cut) for s in cam.displacement.segments for cut in s.cuts) < 2.0 * h
    if not at_a_joint:  # where the acceleration jumps, so does the curvature
        assert np.prod(sides) / (2.0 * double) == pytest.approx(sharpest.value, rel=2e-3)
    contact = cam.traced.contact(ANGLES)
    radii = contact.speed / contact.turning
    assert radii[contact.turning > 0.0].min() >= sharpest.value * (1.0 - 1e-9)


@pytest.mark.parametrize("follower", [name for name in FOLLOWERS if "flat face" in name])
def test_the_face_is_touched_between_the_ends_that_are_named(follower):
    cam = built(f"{follower}, cycloidal")
    points = cam.traced.points(ANGLES)
    at, normal = face(cam, ANGLES, displaced(cam, ANGLES))
    places = np.sum((points - at) * turned(normal, np.pi / 2.0), axis=1)
    places = np.abs(places) if cam.kind.swings else places
    sizes = cam.sizes()
    assert [sizes["face_start"].value, sizes["face_end"].value] == pytest.approx([places.min(), places.max()], abs=1e-4)
    assert sizes["face_length"].value == pytest.approx(np.ptp(places), abs=1e-4)


def test_every_follower_of_the_catalog_is_laid_on_its_cam():
    assert {built(name).follower for name in NAMES[::6]} == set(KINDS)


@every_cam
def test_radii(cam):
    radii = np.linalg.norm(cam.traced.points(ANGLES), axis=1)
    sizes = cam.sizes()
    assert sizes["base_radius"].value == pytest.approx(radii.min(), rel=1e-12)
    assert sizes["largest_radius"].value == pytest.approx(radii.max(), rel=1e-6)
