"""Extrusions and revolutions by the names people use."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.line import Line
from gearwright.sections.loop import Loop
from gearwright.solids.solid import flux_moments

TURN = 2.0 * np.pi


def ring(radius, centre, sense=1):
    return Loop(curves=(Arc(radius=radius, centre=centre, interval=(0.0, sense * TURN)),))


def bracket():
    """An L with a hole, without symmetry, right of the y axis."""
    corners = [(0.5, 0.0), (4.5, 0.0), (4.5, 1.0), (1.5, 1.2), (1.5, 3.0), (0.5, 3.0)]
    sides = tuple(Line(first=a, last=b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True))
    return gw.Section(loops=(Loop(curves=sides), ring(0.3, (3.5, 0.5), -1)))


SOLIDS = {
    "straight": lambda: gw.extrude(bracket(), 3.0),
    "twisted": lambda: gw.extrude(bracket(), 3.0, twist=70.0),
    "scaled": lambda: gw.extrude(bracket(), 3.0, scale=(0.5, 1.3)),
    "skewed": lambda: gw.extrude(bracket(), 3.0, skew=(2.0, -1.0)),
    "all of it": lambda: gw.extrude(bracket(), 3.0, twist=-200.0, scale=(1.4, 0.6), skew=(0.5, 0.7)),
    "part turn": lambda: gw.revolve(bracket(), 130.0),
    "whole turn": lambda: gw.revolve(bracket()),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_the_routes_agree(name):
    solid = SOLIDS[name]()
    exact, flux = solid.moments, flux_moments(solid.boundary)
    assert exact.volume == pytest.approx(flux.volume, rel=1e-12)
    np.testing.assert_allclose(exact.centroid, flux.centroid, atol=1e-12)
    scale = np.linalg.norm(exact.central_second)
    np.testing.assert_allclose(exact.central_second, flux.central_second, atol=1e-12 * scale)
    errors = []
    for tolerance in (0.01, 0.0025):
        polyhedron = solid.polyhedron(tolerance)
        assert polyhedron.validity().valid
        errors.append(abs(polyhedron.properties().volume - exact.volume) / exact.volume)
    assert errors[0] < 0.02
    assert errors[1] < 0.6 * errors[0] or errors[1] < 1e-3


def test_a_torus():
    torus = gw.revolve(gw.Section(loops=(ring(1.3, (5.0, 0.0)),))).properties()
    assert torus.volume == pytest.approx(166.796314, abs=5e-7)
    assert torus.inertia[2, 2] == pytest.approx(4381.322188, abs=5e-7)
    assert torus.volume == pytest.approx(2.0 * np.pi**2 * 5.0 * 1.69, rel=1e-13)


def test_a_part_turn_begins_at_azimuth_nought():
    box = gw.revolve(gw.Section(loops=(ring(1.0, (3.0, 0.0)),)), 90.0).properties().bounding_box
    np.testing.assert_allclose(box, [[0.0, 0.0, -1.0], [4.0, 4.0, 1.0]], atol=1e-9)


def test_a_positive_twist_is_right_handed():
    """The far end of a bar beside the axis is turned counter-clockwise seen from +z."""
    bar = gw.extrude(gw.Section(loops=(ring(0.1, (2.0, 0.0)),)), 1.0, twist=90.0)
    x, y, _ = bar.properties().centroid
    assert y == pytest.approx(x, rel=1e-12)
    assert x > 1.0


def test_every_problem_is_named():
    with pytest.raises(gw.ParameterError) as error:
        gw.extrude(bracket(), -1.0, twist=float("nan"), scale=(0.0, 1.0), skew=(float("inf"), 0.0))
    assert [p.subject.split(" = ")[0] for p in error.value.problems] == ["length", "twist", "scale", "skew"]
    with pytest.raises(gw.ParameterError, match="at most 360° is needed"):
        gw.revolve(bracket(), 361.0)
