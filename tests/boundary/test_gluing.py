"""Pieces glued along faces they share."""

import numpy as np
import pytest

from gearwright.boundary.flux import boundary_flux
from gearwright.boundary.gluing import Joint, glued
from gearwright.boundary.sampling import sampling
from gearwright.boundary.tessellation import tessellate
from gearwright.curves.line import Line
from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.errors import GeometryError
from gearwright.sections.loop import Loop

from ..laws.topology import edges_pair_up, fans_at_vertices, genus
from .shapes import circle, extruded, revolved

SHAPE = {"teeth": 20, "module": 4.0, "pitch_angle": 45.0, "face_width": 15.0, "root": "radial", "ends": "spherical"}


def _bored(**more):
    return BevelGear(**SHAPE, bore=20.0, **more).solid


def test_glued_faces_vanish_and_their_neighbours_merge():
    whole = _bored().boundary
    pieces = [piece.boundary for piece in _bored().pieces]
    assert len(whole.patches) == len(pieces[0].patches) - 1 + len(pieces[1].patches) - 3
    assert len(whole.caps) == 2
    for cap in whole.caps:
        assert [loop.pattern.order for loop in cap.loops] == [20, 1]
    assert whole.caps[0].surface != whole.caps[1].surface


def test_gluing_adds_volumes_and_leaves_no_inner_face():
    solid = _bored(trace="logarithmic", spiral_angle=35.0)
    parts = [boundary_flux(p.boundary.patches, p.boundary.caps, 80).matrix for p in solid.pieces]
    whole = boundary_flux(solid.boundary.patches, solid.boundary.caps, 80).matrix
    np.testing.assert_allclose(parts[0] + parts[1], whole, atol=1e-12 * np.abs(whole).max())
    vertices, triangles = tessellate(solid.boundary, sampling(solid.boundary, 0.02))
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    assert genus(triangles) == 1
    assert np.hypot(vertices[:, 0], vertices[:, 1]).min() == pytest.approx(10.0)


def test_neighbours_without_a_common_surface_are_refused():
    """A tube around a plug: the plug's ends are swept by slanting lines, which continue no surface of ours."""
    tube = extruded(circle(2.0), circle(1.0, sense=-1))
    corners = ((0.0, 0.1), (1.0, 0.0), (1.0, 1.0), (0.0, 0.9))
    lines = tuple(Line(first=a, last=b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))
    plug = revolved(Loop(curves=lines))
    with pytest.raises(GeometryError, match="lies on no surface that another face could continue"):
        glued([tube, plug], [Joint(first=0, first_faces=("loop 2.1",), second=1, second_faces=("loop 1.2",))])


def test_faces_that_do_not_meet_are_refused():
    """Removing two faces that have no neighbours in common leaves holes."""
    pieces = [piece.boundary for piece in _bored().pieces]
    with pytest.raises(GeometryError):
        glued(pieces, [Joint(first=0, first_faces=("loop 1.1",), second=1, second_faces=("loop 1.4",))])
