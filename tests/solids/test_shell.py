"""Thin shells against closed forms, the difference of two solids, and the laws of motions."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import gearwright as gw
from gearwright.rotations import rotation_of

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
L_SHAPE = np.array([[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 4, 0], [0, 4, 0]], float)
"""Rectangles of 3 × 1 and 1 × 3 that meet; not convex."""


def box(a, b, c):
    return gw.Polyhedron(CORNERS * [a, b, c], FACES)


def sphere(rings):
    """A unit sphere of triangles and trapezia."""
    theta = np.linspace(0, np.pi, rings + 1)[1:-1]
    phi = np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False)
    points = np.stack([np.outer(np.sin(theta), np.cos(phi)), np.outer(np.sin(theta), np.sin(phi)),
                       np.outer(np.cos(theta), np.ones_like(phi))], -1).reshape(-1, 3)  # fmt: skip
    n, last = len(phi), len(points)
    faces = [[last, k, (k + 1) % n] for k in range(n)]
    for ring in range(rings - 2):
        for k in range(n):
            a, b = ring * n + k, ring * n + (k + 1) % n
            faces.append([a, a + n, b + n, b])
    low = (rings - 2) * n
    faces += [[last + 1, low + (k + 1) % n, low + k] for k in range(n)]
    return gw.Polyhedron(np.vstack([points, [[0, 0, 1], [0, 0, -1]]]), faces)


def assert_same(one, other, tolerance):
    assert one.mass == pytest.approx(other.mass, rel=tolerance)
    np.testing.assert_allclose(one.centroid, other.centroid, atol=tolerance * 10)
    scale = np.abs(other.central_inertia).max()
    np.testing.assert_allclose(one.central_inertia, other.central_inertia, atol=tolerance * scale)


def test_a_box_of_six_plates_by_hand():
    a, b, c = 2.0, 3.0, 4.0
    shell = box(a, b, c).shell_properties(0.01, density=5.0)
    area = 2 * (a * b + b * c + c * a)
    assert shell.area == pytest.approx(area, rel=1e-15)
    assert shell.volume == pytest.approx(area * 0.01, rel=1e-15)
    assert shell.mass == pytest.approx(area * 0.05, rel=1e-15)
    np.testing.assert_allclose(shell.centroid, [1, 1.5, 2], rtol=1e-15)
    # ∫ x² of two plates at ±a/2 and of four that reach from −a/2 to a/2
    xx = 2 * b * c * a**2 / 4 + 2 * (b + c) * a**3 / 12
    assert shell.central_second[0, 0] == pytest.approx(0.01 * xx, rel=1e-14)
    np.testing.assert_array_equal(shell.bounding_box, [[0, 0, 0], [a, b, c]])


def test_a_shell_is_the_limit_of_a_body_without_a_slightly_smaller_one():
    t = 1e-4
    outer, inner = (box(*(np.array([2, 3, 4]) + d)).transformed(shift(-(np.array([2, 3, 4]) + d) / 2)) for d in (t, -t))
    difference = outer.properties() - inner.properties()
    shell = box(2, 3, 4).transformed(shift([-1, -1.5, -2])).shell_properties(t)
    assert shell.volume == pytest.approx(difference.volume, rel=1e-7)
    np.testing.assert_allclose(shell.central_inertia, difference.central_inertia, rtol=1e-6, atol=1e-12)


def shift(translation):
    matrix = np.eye(4)
    matrix[:3, 3] = translation
    return matrix


def test_a_spherical_shell_in_the_limit():
    errors = []
    for rings in (20, 40, 80):
        shell = sphere(rings).shell_properties(0.5)
        np.testing.assert_allclose(shell.centroid, 0, atol=1e-14)
        # I = ⅔ m r² about every axis, area 4π
        errors.append([abs(shell.area / (4 * np.pi) - 1), abs(shell.central_inertia[0, 0] / (4 * np.pi / 3) - 1)])
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2, atol=0.05)


def test_a_disk_in_the_limit():
    phi = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    disk = gw.Polyhedron(np.stack([3 * np.cos(phi), 3 * np.sin(phi), 0 * phi], 1), [list(range(1000))])
    shell = disk.shell_properties(0.2, density=2.0)
    assert shell.mass == pytest.approx(np.pi * 9 * 0.4, rel=1e-5)
    np.testing.assert_allclose(shell.principal_moments, shell.mass * 9 * np.array([0.25, 0.25, 0.5]), rtol=2e-5)
    np.testing.assert_allclose(abs(shell.principal_axes[:, 2]), [0, 0, 1], atol=1e-12)
    assert shell.validity() == ()


@pytest.mark.parametrize("start", range(6))
def test_a_face_that_is_not_convex_is_the_sum_of_its_rectangles(start):
    corners = np.roll(np.arange(6), start)
    whole = gw.Polyhedron(L_SHAPE, [corners.tolist()]).shell_properties(1.0)
    points = [[0, 0, 0], [3, 0, 0], [3, 1, 0], [0, 1, 0], [1, 1, 0], [1, 4, 0], [0, 4, 0]]
    parts = gw.Polyhedron(points, [[0, 1, 2, 3], [3, 4, 5, 6]]).shell_properties(1.0)
    assert whole.area == pytest.approx(6.0, rel=1e-15)
    np.testing.assert_allclose(whole.centroid, [(3 * 1.5 + 3 * 0.5) / 6, (3 * 0.5 + 3 * 2.5) / 6, 0], atol=1e-15)
    assert_same(whole, parts, 1e-14)


def test_the_sense_of_faces_does_not_matter():
    turned = [face[::-1] if k % 2 else face for k, face in enumerate(FACES)]
    assert_same(gw.Polyhedron(CORNERS, turned).shell_properties(1), box(1, 1, 1).shell_properties(1), 1e-15)


def test_an_open_surface_has_properties():
    whole, lid = box(2, 3, 4), gw.Polyhedron(CORNERS * [2, 3, 4], [FACES[0]])
    rest = gw.Polyhedron(CORNERS * [2, 3, 4], FACES[1:])
    assert_same(rest.shell_properties(1) + lid.shell_properties(1), whole.shell_properties(1), 1e-14)


quaternions = st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1)


@given(quaternions, st.tuples(*[st.floats(-50, 50)] * 3))
def test_shells_follow_motions(quaternion, translation):
    matrix = shift(translation)
    matrix[:3, :3] = rotation_of(quaternion)
    moved = box(2, 3, 4).transformed(matrix).shell_properties(0.1)
    np.testing.assert_allclose(
        moved.moments, box(2, 3, 4).shell_properties(0.1).moved(matrix[:3, :3], translation).moments, atol=1e-9
    )


def test_digits_are_kept_far_from_the_origin():
    # 2²⁶ keeps every coordinate: nothing is lost before the sums begin
    near, far = (box(2, 3, 4).transformed(shift(t)).shell_properties(0.1) for t in ([0, 0, 0], [2.0**26] * 3))
    np.testing.assert_allclose(far.central_second, near.central_second, rtol=1e-15, atol=1e-16)
    assert far.volume == near.volume


def test_digits_are_kept_where_a_speck_is_far_from_all_the_rest():
    side, far = 2.0**-20, 2.0**20
    speck = CORNERS[[0, 2, 6, 4]] * side + [far, 0, 0]  # a square across z
    both = gw.Polyhedron(np.vstack([CORNERS, speck]), [*FACES, [8, 9, 10, 11]]).shell_properties(1.0)
    area, small = 6.0, side**2
    apart = far + side / 2 - 0.5
    assert both.centroid[0] == pytest.approx(0.5 + small * apart / (area + small), rel=1e-15)
    # ∫ x² of the box's plates and of the speck about their own middles, and of both about the common one
    xx = 2 / 4 + 4 / 12 + side**4 / 12 + area * small / (area + small) * apart**2
    assert both.central_second[0, 0] == pytest.approx(xx, rel=1e-15)
    assert both.error_bound < 1e-14


def test_scaling_scales_with_the_fourth_power():
    one = sphere(8).shell_properties(1.0)
    other = sphere(8).transformed(np.diag([3.0, 3.0, 3.0, 1.0])).shell_properties(1.0)
    np.testing.assert_allclose(other.central_second, 81 * one.central_second, rtol=1e-13, atol=1e-12)


@pytest.mark.parametrize("thickness", [0, -1, np.nan, np.inf, "1"])
def test_a_thickness_that_is_none_is_refused(thickness):
    with pytest.raises(gw.ParameterError, match="thickness"):
        box(1, 1, 1).shell_properties(thickness)


def test_a_surface_without_area_is_refused():
    for faces in ([], [[0, 1, 2]]):
        with pytest.raises(gw.GeometryError, match="no area"):
            gw.Polyhedron([[0, 0, 0], [1, 0, 0], [2, 0, 0]], faces).shell_properties(1)


def test_a_bent_face_is_refused():
    with pytest.raises(gw.GeometryError, match=r"face, 0 near .*, not planar"):
        gw.Polyhedron([[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]], [[0, 1, 2, 3]]).shell_properties(1)


def test_shells_far_apart_keep_their_digits():
    hull = np.array([[0.1, 0.2, 0.3], [1.1, 0.23, 0.31], [0.17, 1.3, 0.37], [0.13, 0.29, 1.7]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    far = hull * 0.9 + [1e6, 5e5, 3e5]
    both = gw.Polyhedron(np.concatenate([hull, far]), np.concatenate([faces, faces + 4])).shell_properties(1.0)
    apart = [gw.Polyhedron(v, faces).shell_properties(1.0).area for v in (hull, far)]
    assert both.area == pytest.approx(sum(apart), rel=both.error_bound)
    assert both.error_bound < 1e-14
