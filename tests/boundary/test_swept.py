"""Swept boundaries of small solids: poles, apexes, rings, part turns, holes."""

import numpy as np
import pytest

from gearwright.boundary.flux import boundary_flux
from gearwright.boundary.sampling import sampling
from gearwright.boundary.swept import swept_boundary
from gearwright.boundary.tessellation import tessellate
from gearwright.curves.arc import Arc
from gearwright.curves.line import Line
from gearwright.motions.ends import between
from gearwright.motions.herringbone import Herringbone
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section

from ..laws.topology import components, edges_pair_up, fans_at_vertices, genus, volume
from .shapes import BOXES, SQUARE, circle, extruded, polygon, revolved

every_box = pytest.mark.parametrize("name", BOXES)


@every_box
def test_flux_through_the_boundary_is_the_volume(name):
    build, expected, _ = BOXES[name]
    boundary = build()
    flux = boundary_flux(boundary.patches, boundary.caps, 40)
    assert flux.matrix[0, 0] == pytest.approx(expected, rel=1e-12)
    assert np.abs(flux.area_vector).max() < 1e-12 * flux.area


@every_box
@pytest.mark.parametrize("tolerance", [0.3, 0.01, 0.001])
def test_polyhedra_are_watertight_and_approach_the_volume(name, tolerance):
    build, expected, holes = BOXES[name]
    boundary = build()
    vertices, triangles = tessellate(boundary, sampling(boundary, tolerance))
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    assert len(np.unique(triangles)) == len(vertices)
    assert components(triangles) == 1
    assert genus(triangles) == holes
    assert 0.0 < volume(vertices, triangles) <= expected * (1.0 + 1e-12)
    if tolerance <= 0.01:
        assert volume(vertices, triangles) == pytest.approx(expected, rel=6.0 * tolerance)


def test_a_ball_has_two_poles_and_no_seam_left_over():
    boundary = BOXES["ball"][0]()
    assert boundary.caps == ()
    assert sum(edge.degenerate for edge in boundary.edges) == 2
    vertices, triangles = tessellate(boundary, sampling(boundary, 0.01))
    np.testing.assert_allclose(np.linalg.norm(vertices, axis=1), 1.0, rtol=1e-14)
    assert np.count_nonzero(np.hypot(vertices[:, 0], vertices[:, 1]) < 1e-15) == 2
    assert len(np.unique(vertices.round(12), axis=0)) == len(vertices)
    assert len(vertices) - len(triangles) // 2 == 2


def test_copies_are_images_of_one_sector():
    whole, sectors = extruded(circle(2.0, pieces=1)), extruded(circle(2.0, pieces=8))
    assert len(sectors.patches) == 1
    assert sectors.patches[0].pattern.order == 8
    assert whole.patches[0].pattern.order == 1
    found = [boundary_flux(b.patches, b.caps, 40).matrix for b in (whole, sectors)]
    np.testing.assert_allclose(found[0], found[1], atol=1e-12)


def test_holes_run_clockwise_and_are_named():
    boundary = extruded(polygon((-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)), circle(1.0, sense=-1))
    assert {patch.name for patch in boundary.patches} == {"loop 1.1", "loop 1.2", "loop 1.3", "loop 1.4", "loop 2.1"}
    assert [cap.name for cap in boundary.caps] == ["start", "finish"]
    vertices, triangles = tessellate(boundary, sampling(boundary, 1e-3))
    assert volume(vertices, triangles) == pytest.approx(16.0 - np.pi, rel=1e-3)
    assert volume(vertices, triangles) > 16.0 - np.pi


def test_a_different_number_of_copies_falls_back_on_what_both_have():
    boundary = extruded(circle(2.0, pieces=12), circle(1.0, pieces=8, sense=-1))
    assert {patch.pattern.order for patch in boundary.patches} == {4}
    assert len(boundary.patches) == 3 + 2


def test_a_face_on_the_axis_vanishes():
    """The side of a revolved section that lies on the axis sweeps nothing."""
    boundary = revolved(polygon((0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)))
    assert {patch.name for patch in boundary.patches} == {"loop 1.1", "loop 1.2", "loop 1.3"}
    assert boundary_flux(boundary.patches, boundary.caps, 20).matrix[0, 0] == pytest.approx(2.0 * np.pi)


def test_a_cube_needs_no_more_than_its_corners():
    cube = extruded(SQUARE)
    vertices, triangles = tessellate(cube, sampling(cube, 1e-3))
    assert volume(vertices, triangles) == pytest.approx(1.0, rel=1e-15)
    assert len(vertices) < 30


def test_an_arc_may_end_on_the_axis():
    """Where its cosine is 6e-17, not 0."""
    arc = Arc(radius=1.0, interval=(-np.pi / 2.0, np.pi / 2.0))
    boundary = revolved(Loop(curves=(arc, Line(first=(0.0, 1.0), last=(0.0, -1.0)))))
    assert sum(edge.degenerate for edge in boundary.edges) == 2


def test_at_a_break_of_the_motion_each_face_and_rail_goes_on_as_it_came():
    """One-sided differences at both ends of every patch of a herringbone sweep, along the motion."""
    boundary = swept_boundary(Section(loops=(SQUARE,)), Herringbone(length=4.0, twist=0.7), between(0.0, 4.0))
    assert len(boundary.patches) == 8
    u, h = np.array([0.2, 0.7]), 1e-6
    for patch in boundary.patches:
        for v, step in ((0.0, h), (1.0, -h)):
            ends = np.full(2, v)
            numeric = (patch.point(u, ends + step) - patch.point(u, ends)) / step
            np.testing.assert_allclose(patch.partials(u, ends)[1], numeric, atol=1e-5)
            for use in (patch.sides[1], patch.sides[3]):
                rail = use.edge.curve
                np.testing.assert_allclose(rail.derivative(v), (rail.point(v + step) - rail.point(v)) / step, atol=1e-5)
