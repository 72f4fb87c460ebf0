"""How finely edges are cut."""

import re

import numpy as np
import pytest

from gearwright.boundary.sampling import MOST_TRIANGLES, fixed_sampling, sampling
from gearwright.boundary.tessellation import tessellate
from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.errors import GeometryError

from .shapes import BOXES, SQUARE, circle, extruded, polygon, revolved

GEAR = BevelGear(
    teeth=20,
    module=4.0,
    pitch_angle=45.0,
    face_width=15.0,
    bore=20.0,
    trace="logarithmic",
    spiral_angle=35.0,
    root="radial",
    ends="spherical",
)


@pytest.mark.parametrize("tolerance", [1.0, 0.1, 0.01, 0.001])
def test_opposite_sides_of_a_patch_are_cut_alike(tolerance):
    found = sampling(GEAR.boundary, tolerance)
    for patch in GEAR.boundary.patches:
        first, right, second, left = (found.segments[use.edge] for use in patch.sides)
        assert first == second
        assert right == left
    assert set(found.segments) == set(GEAR.boundary.edges)
    assert found.tolerance == tolerance


def test_one_cut_for_the_same_rail_on_both_sides():
    """The layers of all faces of a swept tooth are tied together."""
    found = sampling(GEAR.boundary, 0.01)
    ring = [patch for patch in GEAR.boundary.patches if patch.name.startswith("loop 1.") and patch.pattern.order == 20]
    assert len({found.segments[patch.sides[1].edge] for patch in ring}) == 1


def test_segments_grow_as_the_root_of_the_tolerance():
    cylinder = extruded(circle(1.0), height=2.0)
    counts = [max(sampling(cylinder, tolerance).segments.values()) for tolerance in (1e-2, 1e-4, 1e-6)]
    # 1 − cos(π/n) ≈ π²/2n²
    for tolerance, count in zip((1e-2, 1e-4, 1e-6), counts, strict=True):
        assert count == pytest.approx(np.pi / np.sqrt(2.0 * tolerance), rel=0.2)
        assert 1.0 - np.cos(np.pi / count) <= tolerance


def test_straight_edges_are_not_cut():
    assert set(sampling(extruded(SQUARE), 1e-6).segments.values()) == {1}


def test_coarse_tolerances_leave_closed_edges_a_shape():
    for tolerance in (10.0, 1e6):
        cylinder = extruded(circle(1.0), height=2.0)
        vertices, _ = tessellate(cylinder, sampling(cylinder, tolerance))
        assert len(vertices) >= 12
        for name, (build, _, _) in BOXES.items():
            if name == "ball":
                continue  # two poles alone enclose nothing
            boundary = build()
            assert tessellate(boundary, sampling(boundary, tolerance))[1].size


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan"), float("-inf")])
def test_tolerances_that_are_none_are_refused(tolerance):
    with pytest.raises(GeometryError, match="greater than 0"):
        sampling(extruded(SQUARE), tolerance)


def test_a_tolerance_that_is_a_slip_is_refused_with_the_least_possible_one():
    cylinder = extruded(circle(1.0), height=2.0)
    with pytest.raises(GeometryError) as error:
        sampling(cylinder, 1e-15)
    message = error.value.problems[0].message
    assert "more than 400000 points around end faces" in message
    least = float(re.search(r"try ([0-9.e-]+[0-9])", message).group(1))
    assert max(sampling(cylinder, least * 1.02).segments.values()) <= MOST_TRIANGLES
    with pytest.raises(GeometryError):
        sampling(cylinder, least * 0.5)


def test_fixed_sampling():
    found = fixed_sampling(GEAR.boundary, across=3, layers=7, tolerance=0.1)
    tooth = GEAR.boundary.patches[0]
    assert [found.segments[use.edge] for use in tooth.sides] == [3, 7, 3, 7]


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4])
def test_a_sharp_rim_is_cut_as_finely_as_its_own_curve_asks(tolerance):
    """Faces that meet there nearly in one plane hardly bend along the rim; the rim itself does."""
    lens = revolved(polygon((0.0, -0.02), (1.0, 0.0), (0.0, 0.02)))
    found = sampling(lens, tolerance)
    rim = max(edge.curve.point(0.5)[0] ** 2 + edge.curve.point(0.5)[1] ** 2 for edge in lens.edges)
    assert rim == pytest.approx(1.0)
    count = max(found.segments.values())
    assert 1.0 - np.cos(np.pi / count) <= tolerance
