"""Boundaries are checked when they are made."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.boundary.boundary import Boundary
from gearwright.boundary.edge import EdgeUse
from gearwright.boundary.faces import Cap, CapLoop
from gearwright.errors import GeometryError
from gearwright.motions.ends import between
from gearwright.surfaces.plane import Plane

from .shapes import SQUARE, circle, extruded


def test_a_missing_face_is_named_by_its_edges():
    cube = extruded(SQUARE)
    with pytest.raises(GeometryError) as error:
        Boundary(patches=cube.patches[:-1], caps=cube.caps)
    subjects = {problem.subject for problem in error.value.problems}
    assert subjects == {f"edge {use.edge.name}" for use in cube.patches[-1].sides}
    assert all("not once each" in problem.message for problem in error.value.problems)


def test_a_missing_cap_is_found():
    cube = extruded(SQUARE)
    with pytest.raises(GeometryError) as error:
        Boundary(patches=cube.patches, caps=cube.caps[:1])
    assert len(error.value.problems) == 4


def test_a_face_twice_is_found():
    cube = extruded(SQUARE)
    with pytest.raises(GeometryError) as error:
        Boundary(patches=(*cube.patches, cube.patches[0]), caps=cube.caps)
    assert len(error.value.problems) == 4


def test_a_face_that_runs_the_wrong_way_along_its_edge_is_found():
    cube = extruded(SQUARE)
    first = cube.patches[0]
    sides = tuple(EdgeUse(edge=use.edge, reverse=not use.reverse, turn=use.turn) for use in first.sides)
    with pytest.raises(GeometryError, match="2 times forward and 0 backward"):
        Boundary(patches=(replace(first, sides=sides), *cube.patches[1:]), caps=cube.caps)


def test_a_face_apart_from_its_edges_is_found():
    """Its edges are all right, but it lies where they are not."""
    cube = extruded(SQUARE)
    moved = replace(cube.patches[0], ends=between(0.0, 0.9))
    with pytest.raises(GeometryError, match="∮ n dA"):
        Boundary(patches=(moved, *cube.patches[1:]), caps=cube.caps)


def test_faces_that_all_look_inward_are_found():
    """A section moved against its normal."""
    with pytest.raises(GeometryError, match="turned inward"):
        extruded(SQUARE, height=-1.0)


def test_edges_and_uses():
    cube = extruded(SQUARE)
    assert len(cube.edges) == 12
    assert len(list(cube.uses())) == 24
    tube = extruded(circle(2.0), circle(1.0, sense=-1))
    assert len(tube.edges) == 6
    assert [edge.closed for edge in tube.edges].count(True) == 4


def test_a_cap_s_reversed_loop_counts_as_reversed():
    cube = extruded(SQUARE)
    start = cube.caps[0]
    wrong = Cap(name="start", surface=start.surface, loops=(CapLoop(uses=start.loops[0].uses, reverse=False),))
    with pytest.raises(GeometryError):
        Boundary(patches=cube.patches, caps=(wrong, cube.caps[1]))


def test_planes_compare_by_where_they_are():
    assert Plane(origin=(0.0, 0.0, 1.0)) == Plane(origin=(0.0, 0.0, 1.0))
    assert Plane(origin=(0.0, 0.0, 1.0)) != Plane(origin=(0.0, 0.0, 2.0))
    assert np.array_equal(Plane(origin=(0.0, 0.0, 1.0)).chart(np.array([[1.0, 2.0, 1.0]])), [[1.0, 2.0]])
