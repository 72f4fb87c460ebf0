"""Edges cut into shorter ones."""

import numpy as np
import pytest

from gearwright.boundary.flux import boundary_flux
from gearwright.boundary.placed import written_out
from gearwright.boundary.sampling import sampling
from gearwright.boundary.splitting import split
from gearwright.boundary.tessellation import tessellate

from ..laws.topology import components, edges_pair_up, fans_at_vertices, genus, volume
from .shapes import BOXES


@pytest.mark.parametrize("name", BOXES)
def test_a_body_stays_what_it_is_wherever_an_edge_is_cut(name):
    build, expected, holes = BOXES[name]
    boundary = written_out(build())
    for edge in boundary.edges:
        if edge.degenerate:
            continue
        cut = split(boundary, {edge: [0.3, 0.85]})
        assert edge not in cut.edges
        assert len(cut.edges) > len(boundary.edges)
        flux = boundary_flux(cut.patches, cut.caps, 24)
        assert flux.matrix[0, 0] == pytest.approx(expected, rel=1e-12)
        vertices, triangles = tessellate(cut, sampling(cut, 0.01))
        assert edges_pair_up(triangles)
        assert set(fans_at_vertices(triangles)) == {1}
        assert (components(triangles), genus(triangles)) == (1, holes)
        assert volume(vertices, triangles) == pytest.approx(expected, rel=0.03)


def test_corners_are_put_where_they_were_asked_for():
    boundary = BOXES["cylinder"][0]()
    circle = next(edge for edge in boundary.edges if edge.closed)
    cut = split(boundary, {circle: [0.25]})
    wanted = circle.curve.point(circle.curve.parameter(0.25))
    assert min(np.linalg.norm(edge.start.position - wanted) for edge in cut.edges) < 1e-15
