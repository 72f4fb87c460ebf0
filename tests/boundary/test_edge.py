"""Vertices, edges and patterns."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.boundary.edge import Profile, Rail
from gearwright.boundary.faces import Patch
from gearwright.boundary.pattern import ALONE, Pattern
from gearwright.curves.meridian import Meridian
from gearwright.curves.parallel import Parallel
from gearwright.curves.traces.logarithmic import LogarithmicTrace
from gearwright.motions.ends import between
from gearwright.motions.radial import Radial
from gearwright.motions.revolution import FULL_TURN, Revolution

from .shapes import BOXES

SPIRAL = Radial(trace=LogarithmicTrace(ratio=0.8, mean_distance=3.0, mean_spiral_angle=np.pi / 4.0))


@pytest.mark.parametrize(
    "curve",
    [
        Rail(motion=SPIRAL, section_point=(0.6, 0.0, 0.8), ends=between(2.0, 4.0)),
        Rail(motion=Revolution(), section_point=(1.5, 0.3), ends=between(-FULL_TURN, 0.0)),
        Profile(
            motion=SPIRAL,
            curve=Meridian(azimuth=0.4, interval=(0.2, 0.9)),
            v=2.5,
            interval=(0.2, 0.9),
        ),
        Profile(
            motion=SPIRAL,
            curve=Parallel(polar_angle=0.5, interval=(0.0, -1.0)),
            v=3.5,
            interval=(0.0, -1.0),
        ),
    ],
    ids=["spiral rail", "circular rail", "meridian", "parallel"],
)
def test_derivatives_of_edges(curve):
    u = curve.parameter(np.linspace(0.05, 0.95, 11))
    h = 1e-5
    np.testing.assert_allclose(curve.derivative(u), (curve.point(u + h) - curve.point(u - h)) / (2.0 * h), atol=1e-8)


def test_a_rail_goes_from_end_to_end():
    rail = Rail(motion=SPIRAL, section_point=(0.6, 0.0, 0.8), ends=between(2.0, 4.0))
    assert np.linalg.norm(rail.start) == pytest.approx(2.0)
    assert np.linalg.norm(rail.end) == pytest.approx(4.0)


def test_poles_are_degenerate_edges_and_seams_are_not_closed():
    cone = BOXES["cone"][0]()
    assert {edge.name: edge.degenerate for edge in cone.edges if edge.degenerate}
    assert not any(edge.closed and edge.degenerate for edge in cone.edges)
    assert all(edge.start is edge.end for edge in cone.edges if edge.closed or edge.degenerate)


def test_images_of_a_pattern():
    images = Pattern(order=4).images(np.array([[1.0, 0.0, 5.0], [0.0, 2.0, 6.0]]))
    assert images.shape == (4, 2, 3)
    np.testing.assert_allclose(images[:, 0], [[1, 0, 5], [0, 1, 5], [-1, 0, 5], [0, -1, 5]], atol=1e-15)
    np.testing.assert_allclose(images[1, 1], [-2.0, 0.0, 6.0], atol=1e-15)
    assert np.array_equal(ALONE.images(np.ones((2, 3)))[0], np.ones((2, 3)))


def _near(function, u, h=1e-5):
    return (function(u + h) - function(u - h)) / (2.0 * h)


def test_partials_of_a_patch():
    curve = Meridian(azimuth=0.4, interval=(0.2, 0.9))
    patch = Patch(name="conical", curve=curve, motion=replace(SPIRAL, levels=0.6), ends=between(2.0, 4.0), sides=())
    u, v = (a.ravel() for a in np.meshgrid(np.linspace(0.05, 0.95, 7), np.linspace(0.05, 0.95, 5)))
    du, dv = patch.partials(u, v)
    np.testing.assert_allclose(du, _near(lambda x: patch.point(x, v), u), atol=1e-8)
    np.testing.assert_allclose(dv, _near(lambda x: patch.point(u, x), v), atol=1e-8)
    profile = Profile(motion=patch.motion, curve=curve, v=2.0, interval=curve.interval)
    np.testing.assert_allclose(patch.point(u, 0.0 * v), profile.point(profile.parameter(u)), atol=1e-14)
