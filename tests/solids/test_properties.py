"""Mass properties against closed forms, and their laws."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import gearwright as gw
from gearwright.errors import GeometryError, ParameterError
from gearwright.moments.body import BodyMoments
from gearwright.moments.matrix import moment_matrix, shifted
from gearwright.solids.extent import Extent
from gearwright.solids.polyhedron import Polyhedron
from gearwright.solids.properties import MassProperties

FACES = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def box(low, high):
    """A box as a polyhedron."""
    (x, y, z), (u, v, w) = low, high
    return Polyhedron([[x, y, z], [u, y, z], [u, v, z], [x, v, z], [x, y, w], [u, y, w], [u, v, w], [x, v, w]], FACES)


def cuboid(a=1.0, b=2.0, c=3.0, centre=(0.0, 0.0, 0.0), density=1.0):
    """A cuboid from its textbook formulas."""
    second = a * b * c / 12 * np.diag([a * a, b * b, c * c])
    return MassProperties(volume=a * b * c, centroid=np.array(centre), central_second=second, density=density)


def turn(axis, angle):
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def assert_same(one, other, tolerance=1e-12):
    assert one.mass == pytest.approx(other.mass, rel=tolerance)
    assert one.volume == pytest.approx(other.volume, rel=tolerance)
    scale = np.abs(other.moments).max()
    np.testing.assert_allclose(one.moments, other.moments, atol=tolerance * scale)
    np.testing.assert_allclose(one.central_inertia, other.central_inertia, atol=tolerance * scale)


def test_cuboid_away_from_the_origin_by_hand():
    body = cuboid(1, 2, 3, (10, 20, 30), density=0.5)
    assert body.mass == 3
    np.testing.assert_allclose(body.first_moment, [30, 60, 90])
    np.testing.assert_allclose(body.central_inertia, 3 / 12 * np.diag([4 + 9, 1 + 9, 1 + 4]))
    np.testing.assert_allclose(body.products, [3 * 200, 3 * 600, 3 * 300])
    assert body.inertia[0, 1] == pytest.approx(-600)
    assert body.inertia[1, 2] == pytest.approx(-1800)
    assert body.inertia[0, 0] == pytest.approx(3 * (400 + 900) + 3 / 12 * 13)
    assert body.second_moment[2, 2] == pytest.approx(3 * 900 + 3 * 9 / 12)
    np.testing.assert_allclose(body.principal_moments, [1.25, 2.5, 3.25])
    np.testing.assert_allclose(body.radii_of_gyration**2, np.array([5, 10, 13]) / 12)
    np.testing.assert_allclose(body.moments[0], [3, 30, 60, 90])
    np.testing.assert_allclose(body.about((0, 0, 0)), body.inertia)
    np.testing.assert_allclose(body.about(body.centroid), body.central_inertia)
    assert body.about((10, 20, 29))[0, 0] == pytest.approx(3.25 + 3)


def test_from_moments_about_a_point():
    matrix = moment_matrix(6.0, np.zeros(3), np.diag([0.5, 2.0, 4.5]))
    moments = BodyMoments(origin=np.ones(3), matrix=shifted(matrix, [0.1, 0, 0]), method="quadrature", error_bound=1e-9)
    body = MassProperties.from_moments(
        moments, density=2, find_extent=lambda: Extent(22, np.array([[0, 0, 0], [1, 2, 3]]))
    )
    assert_same(body, cuboid(1, 2, 3, (1.1, 1, 1), density=2))
    assert (body.method, body.error_bound, body.area) == ("quadrature", 1e-9, 22)


angles = st.floats(-7, 7)
coordinates = st.floats(-20, 20)
vectors = st.tuples(coordinates, coordinates, coordinates)


@given(vectors.filter(lambda v: np.linalg.norm(v) > 1e-3), angles, vectors, vectors)
def test_moving_the_body_moves_its_properties(axis, angle, shift, centre):
    rotation = turn(axis, angle)
    body = cuboid(1, 2, 3, centre, density=7.8)
    moved = body.moved(rotation, shift)
    np.testing.assert_allclose(moved.principal_moments, body.principal_moments, rtol=1e-12)
    back = moved.moved(rotation.T, -rotation.T @ np.array(shift))
    np.testing.assert_allclose(back.centroid, body.centroid, atol=1e-12)
    np.testing.assert_allclose(back.central_second, body.central_second, atol=1e-12)
    corners = box(np.subtract(centre, [0.5, 1, 1.5]), np.add(centre, [0.5, 1, 1.5]))
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, shift
    assert_same(moved, corners.transformed(matrix).properties(7.8), 1e-11)


def test_bounding_box_follows_quarter_turns_only():
    body = box((0, 0, 0), (1, 2, 3)).properties()
    quarter = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    np.testing.assert_array_equal(body.moved(quarter, (1, 0, 0)).bounding_box, [[-1, 0, 0], [1, 1, 3]])
    assert body.moved(turn((0, 0, 1), 0.3)).bounding_box is None


@pytest.mark.parametrize("rotation", [np.diag([1, 1, -1]), 2 * np.eye(3), np.zeros((3, 3)), np.eye(2)])
def test_moving_takes_rotations_only(rotation):
    with pytest.raises(GeometryError):
        cuboid().moved(rotation)


@given(coordinates.map(lambda x: x / 50), st.floats(0.5, 8), st.floats(0.5, 8))
def test_a_cut_body_is_the_sum_of_its_parts(cut, first_density, second_density):
    whole = box((-1, 0, 0), (1, 2, 3)).properties(first_density)
    left, right = (
        box((-1, 0, 0), (cut, 2, 3)).properties(first_density),
        box((cut, 0, 0), (1, 2, 3)).properties(first_density),
    )
    assert_same(left + right, whole, 1e-13)
    assert_same(whole - left, right, 1e-10)
    np.testing.assert_array_equal((left + right).bounding_box, whole.bounding_box)
    other = box((cut, 0, 0), (1, 2, 3)).properties(second_density)
    mixed = left + other
    np.testing.assert_allclose(mixed.moments, left.moments + other.moments, rtol=1e-12, atol=1e-12)
    assert_same(mixed - other, left, 1e-10)


def test_taking_a_cavity_away():
    body = box((0, 0, 0), (4, 4, 4)).properties() - box((1, 1, 1), (2, 3, 3)).properties()
    assert body.volume == pytest.approx(60)
    np.testing.assert_allclose(
        body.moments, box((0, 0, 0), (4, 4, 4)).properties().moments - box((1, 1, 1), (2, 3, 3)).properties().moments
    )
    np.testing.assert_array_equal(body.bounding_box, [[0, 0, 0], [4, 4, 4]])
    assert body.area is None
    assert body.error_bound > box((0, 0, 0), (4, 4, 4)).properties().error_bound


def test_taking_too_much_away_is_refused():
    with pytest.raises(GeometryError, match="check the order, the units and the densities"):
        cuboid(1, 1, 1) - cuboid(1, 1, 2)


def test_sums_keep_the_coarser_method_and_far_parts_keep_their_digits():
    far = cuboid(centre=(1e9, 0, 0)) + cuboid(centre=(1e9 + 4, 0, 0))
    assert far.central_inertia[1, 1] == pytest.approx(2 * 6 / 12 * 10 + 12 * 4, rel=1e-14)
    assert (cuboid() + box((2, 2, 2), (3, 3, 3)).properties()).method == "polyhedron"


@given(vectors.filter(lambda v: np.linalg.norm(v) > 1e-3), angles)
def test_principal_axes_are_right_handed_settled_and_diagonalise(axis, angle):
    body = cuboid().moved(turn(axis, angle))
    axes = body.principal_axes
    assert np.linalg.det(axes) == pytest.approx(1.0)
    np.testing.assert_allclose(axes.T @ body.central_inertia @ axes, np.diag(body.principal_moments), atol=1e-12)
    for column in axes.T[:2]:
        assert column[np.argmax(np.round(np.abs(column), 7))] > 0
    np.testing.assert_allclose(body.principal_moments, np.sort(body.principal_moments))


@pytest.mark.parametrize(
    ("sides", "expected"),
    [
        ((1, 1, 1), np.eye(3)),
        ((1, 1, 0.2), np.eye(3)),  # a disc: two small equal moments, the great one about z
        ((1, 1, 5), [[0, 1, 0], [0, 0, 1], [1, 0, 0]]),  # a rod: z first, then x, y
        ((5, 1, 1), np.eye(3)),
        ((1, 5, 1), [[0, 1, 0], [1, 0, 0], [0, 0, -1]]),
    ],
)
def test_equal_moments_take_the_frames_axes(sides, expected):
    body = cuboid(*sides)
    noise = 1e-16 * np.array([[1, 2, -3], [2, -1, 1], [-3, 1, 2.0]])
    noisy = MassProperties(volume=body.volume, centroid=body.centroid, central_second=body.central_second + noise)
    for one in (body, noisy):
        np.testing.assert_allclose(one.principal_axes, expected, atol=1e-12)


def test_validity_names_what_no_body_can_have():
    assert cuboid().validity() == ()
    bad = MassProperties(volume=-1, centroid=np.zeros(3), central_second=np.diag([1.0, 2.0, -0.5]))
    texts = [str(problem) for problem in bad.validity()]
    assert "volume = -1" in texts[0]
    assert "at most the sum of the other two" in texts[1]


@pytest.mark.parametrize("density", [0, -1, float("nan"), float("inf"), "steel", None])
def test_density_is_positive(density):
    with pytest.raises(ParameterError, match="mass per cubed length unit"):
        cuboid(density=density)


def test_not_finite_and_misshapen_values_are_refused():
    with pytest.raises(ParameterError, match="centroid"):
        cuboid(centre=(np.nan, 0, 0))
    with pytest.raises(GeometryError, match="shape"):
        cuboid(centre=(0, 0))


def test_nothing_can_be_changed():
    body = cuboid()
    with pytest.raises(ValueError, match="read-only"):
        body.centroid[0] = 1
    with pytest.raises(AttributeError):
        body.volume = 2


def test_dictionary_is_plain_and_complete():
    body = box((0, 0, 0), (1, 2, 3)).properties(2.0)
    values = json.loads(json.dumps(body.to_dict(), allow_nan=False))
    assert values["mass"] == pytest.approx(12)
    assert values["products"] == pytest.approx({"xy": 6.0, "yz": 18.0, "zx": 9.0})
    assert values["bounding_box"] == [[0, 0, 0], [1, 2, 3]]
    assert values["area"] == pytest.approx(22)
    assert (
        list(values)
        == (
            "volume mass density centroid first_moment second_moment inertia central_inertia products"
            " central_products principal_moments principal_axes principal_quaternion radii_of_gyration"
            " central_radii_of_gyration moments area bounding_box method error_bound evaluations warnings"
        ).split()
    )


def test_what_is_about_the_centroid_by_hand():
    body = cuboid(1, 2, 3, (10, 20, 30), density=0.5).moved([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    np.testing.assert_allclose(body.central_products, 0, atol=1e-15)
    np.testing.assert_allclose(body.central_radii_of_gyration**2, np.array([10, 13, 5])[[0, 1, 2]] / 12)
    np.testing.assert_allclose(cuboid(2, 2, 2).central_radii_of_gyration ** 2, [8 / 12] * 3)


def test_products_about_the_centroid_are_minus_the_off_diagonals():
    body = cuboid(1, 2, 3, (1, 2, 3), density=0.5).moved(turn([1, 2, 3], 0.7))
    # a body long in the direction (1, 1, 0) has a positive product xy
    rod = cuboid(10, 0.1, 0.1).moved(turn([0, 0, 1], np.pi / 4))
    assert rod.central_products[0] == pytest.approx(0.1 * 0.1 * 10 * (100 - 0.01) / 24, rel=1e-12)
    for value, (i, j) in zip(body.central_products, [(0, 1), (1, 2), (2, 0)], strict=True):
        assert value == pytest.approx(-body.central_inertia[i, j], rel=1e-12)


@given(vectors.filter(lambda axis: np.linalg.norm(axis) > 1), angles)
def test_the_quaternion_turns_the_frame_into_the_principal_axes(axis, angle):
    body = cuboid(1, 2, 4).moved(turn(axis, angle))
    w, x, y, z = body.principal_quaternion
    assert w >= 0
    for column, unit in zip(body.principal_axes.T, np.eye(3), strict=True):
        v = np.array([x, y, z])
        turned = unit + 2 * w * np.cross(v, unit) + 2 * np.cross(v, np.cross(v, unit))
        np.testing.assert_allclose(turned, column, atol=1e-14)


def test_the_bound_of_a_long_sum_grows_with_its_length_alone():
    total = sum(cuboid(1, 2, 3, (30.0 * k, 0, 0)) for k in range(60))
    assert 0 < total.error_bound <= 60 * 1.2e-15
    assert total.volume == pytest.approx(360, rel=1e-14)


def test_far_away_the_bound_of_a_sum_knows_the_digits_of_its_centroids():
    near, far = cuboid(1, 1, 1, (0.1, 0, 0)) + cuboid(1, 1, 1, (1.2, 0, 0)), 1e8 / 7
    body = cuboid(1, 1, 1, (0.1 + far, 0, 0)) + cuboid(1, 1, 1, (1.2 + far, 0, 0))
    error = np.abs(body.central_second - near.central_second).max() / np.linalg.norm(near.central_second)
    assert 0 < error <= body.error_bound < 1e-6


def test_a_part_that_reaches_beyond_the_whole_is_not_taken_away():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    whole = gw.Polyhedron(corners * 10, faces).properties()
    assert (whole - gw.Polyhedron(corners * [10, 1, 1], faces).properties()).volume == pytest.approx(990)
    for beyond in ([200, 0, 0], [9.5, 0, 0], [0, 0, -0.01]):
        part = gw.Polyhedron(corners + beyond, faces).properties()
        with pytest.raises(GeometryError, match=r"its box, .* reaches beyond the body"):
            whole - part


def test_a_matrix_that_nearly_turns_is_counted_in_the_bound():
    body = cuboid(1, 2, 3, (1, 2, 3))
    moved = body.moved(np.eye(3) * (1 + 4e-10))
    assert abs(np.trace(moved.central_second) / np.trace(body.central_second) - 1) <= moved.error_bound < 1e-8


def test_the_least_moment_of_a_needle_keeps_its_digits():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * [1, 1e-8, 1e-8]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    needle = gw.Polyhedron(corners, faces).properties()
    assert needle.central_inertia[0, 0] == pytest.approx(1e-16 * 2e-16 / 12, rel=1e-7)
