"""Compiled sums against the plain reference, at every size at which they take another way."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.errors import GeometryError
from gearwright.moments.bare import mass_properties
from gearwright.moments.body import BodyMoments
from gearwright.moments.faces import Corners, corner_lists
from gearwright.moments.indexed import Polygons, Triangles
from gearwright.moments.polyhedron import polyhedron_moments
from gearwright.moments.reference import reference_sums
from gearwright.moments.soup import Soup, soup_moments
from gearwright.moments.summation import CHUNK

from .bodies import cube, gear_like, joined, moved, reversed_faces, star_shaped

ORIGIN = np.array([0.3, -0.2, 0.1])


def random_faces(count, vertices=200, seed=0):
    random = np.random.default_rng(seed)
    points = random.normal(size=(vertices, 3))
    return points, random.integers(0, vertices, (count, 3))


def assert_equal_sums(found, vertices, indices, offsets):
    expected = reference_sums(vertices, indices, offsets, ORIGIN)
    # what cancels in a sum is measured by its last two rows
    scale = np.array([expected[14], *[expected[14]] * 3, *[expected[15]] * 6, *[expected[13]] * 4, *expected[14:]])
    np.testing.assert_array_less(np.abs(found.rounded - expected), 4e-16 * np.maximum(scale, 1.0))


@pytest.mark.parametrize("kind", [np.int32, np.int64])
@pytest.mark.parametrize("count", [0, 1, 3, 4, 5, 31, 32, 33, 127, 128, 129, 131, 1000])
def test_triangles_equal_the_reference(count, kind):
    vertices, triangles = random_faces(count, seed=count)
    found = Triangles(vertices=vertices, triangles=triangles.astype(kind)).sums(ORIGIN)
    assert_equal_sums(found, vertices, *corner_lists(triangles))


@pytest.mark.parametrize("kind", [np.int32, np.int64])
def test_polygons_equal_the_reference(kind):
    random = np.random.default_rng(3)
    vertices = random.normal(size=(50, 3))
    sizes = random.integers(3, 9, 300)
    indices, offsets = random.integers(0, 50, sizes.sum()), np.concatenate([[0], np.cumsum(sizes)])
    found = Polygons(vertices=vertices, indices=indices.astype(kind), offsets=offsets).sums(ORIGIN)
    assert_equal_sums(found, vertices, indices, offsets)


def test_triangles_of_the_last_vertex_only():
    vertices, triangles = random_faces(64, vertices=3)
    assert_equal_sums(
        Triangles(vertices=vertices, triangles=triangles).sums(ORIGIN), vertices, *corner_lists(triangles)
    )


def test_nothing_outside_the_vertices_is_read():
    """The numbers after the last vertex are another array's: if they counted, they would be seen."""
    space = np.full(3 * 200 + 64, np.nan)
    vertices, triangles = random_faces(500)
    inside = space[: vertices.size].reshape(vertices.shape)
    inside[:] = vertices
    for at, count in ((inside, 500), (inside[:150], 300)):
        chosen = triangles[np.all(triangles < len(at), axis=1)][:count]
        found = Triangles(vertices=at, triangles=np.ascontiguousarray(chosen)).sums(ORIGIN)
        assert_equal_sums(found, at.copy(), *corner_lists(chosen))


@pytest.mark.parametrize("threads", [1, 2, 3, 7])
def test_the_number_of_threads_changes_no_bit(threads):
    vertices, triangles = random_faces(5 * CHUNK + 77)
    alone = Triangles(vertices=vertices, triangles=triangles, threads=1).sums(ORIGIN)
    found = Triangles(vertices=vertices, triangles=triangles, threads=threads).sums(ORIGIN)
    np.testing.assert_array_equal(found.high, alone.high)
    np.testing.assert_array_equal(found.low, alone.low)


def test_several_callers_at_once():
    vertices, triangles = random_faces(3 * CHUNK)
    expected = Triangles(vertices=vertices, triangles=triangles).sums(ORIGIN).rounded
    found = []

    def call():
        found.append(Triangles(vertices=vertices, triangles=triangles).sums(ORIGIN).rounded)

    callers = [threading.Thread(target=call) for _ in range(8)]
    for caller in callers:
        caller.start()
    for caller in callers:
        caller.join()
    assert all(np.array_equal(one, expected) for one in found)
    assert len(found) == 8


@pytest.mark.parametrize("kind", [np.int32, np.int64])
@pytest.mark.parametrize("place", [0, 5, 3 * 130 + 1, 3 * (CHUNK + 5) + 2])
@pytest.mark.parametrize("number", [-1, 200, 2**31 - 1, -(2**31)])
def test_numbers_out_of_range_are_named(number, place, kind):
    vertices, triangles = random_faces(CHUNK + 100)
    triangles = triangles.astype(kind)
    triangles.reshape(-1)[place] = number
    with pytest.raises(GeometryError, match=f"vertex number {number} in face {place // 3}: vertex numbers go from 0"):
        mass_properties(vertices, triangles)
    with pytest.raises(GeometryError, match=f"vertex number {number} in face {place // 3}: "):
        mass_properties(vertices, Corners(triangles.reshape(-1), np.arange(0, triangles.size + 1, 3)))


def test_offsets_out_of_order_are_named():
    vertices, _ = cube()
    with pytest.raises(GeometryError, match="offsets go from 0 up"):
        mass_properties(vertices, Corners(np.arange(6), np.array([0, 4, 3, 6])))
    with pytest.raises(GeometryError, match="face 1 of 2 corners: at least 3"):
        mass_properties(vertices, Corners(np.arange(6), np.array([0, 4, 6])))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("vertex", [0, 3, 7])
def test_coordinates_that_are_not_finite_are_named(vertex, value):
    vertices, faces = cube()
    vertices[vertex, 1] = value
    triangles = np.array([[f[0], f[k], f[k + 1]] for f in faces for k in (1, 2)])
    for given_faces in (faces, triangles):
        with pytest.raises(GeometryError, match=rf"vertex {vertex} = .*: coordinates must be finite"):
            mass_properties(vertices, given_faces)


def test_contiguous_arrays_are_not_copied():
    vertices, triangles = random_faces(10)
    for kind in (np.int32, np.int64):
        numbers = triangles.astype(kind)
        assert Triangles(vertices=vertices, triangles=numbers).triangles is numbers
        numbers.flags.writeable = vertices.flags.writeable = False
        Triangles(vertices=vertices, triangles=numbers).sums(ORIGIN)
        vertices.flags.writeable = True


def triangulated(body):
    return body[0], np.array([[f[0], f[k], f[k + 1]] for f in body[1] for k in range(1, len(f) - 1)])


@pytest.mark.parametrize("name", ["cube", "gear", "star", "two far apart", "shell"])
@pytest.mark.parametrize("scale", [1.0, 1e-9, 1e9, 1e-50, 1e50])
def test_the_bare_function_and_the_object_agree(name, scale):
    ball = star_shaped()
    body = {
        "cube": cube(),
        "gear": gear_like(),
        "star": ball,
        "two far apart": joined(ball, moved(ball, [1e6, 0, 0])),
        "shell": joined(ball, reversed_faces(moved(ball, 0.0, 1 - 1e-7))),
    }[name]
    vertices, triangles = triangulated((body[0] * scale, body[1]))
    found = polyhedron_moments(vertices, *corner_lists(triangles)).body
    mass, centroid, inertia = mass_properties(vertices, triangles)
    size = np.abs(found.central_second).max()
    assert mass == pytest.approx(found.volume, rel=1e-15)
    np.testing.assert_allclose(centroid, found.centroid, rtol=1e-15, atol=1e-15 * scale)
    np.testing.assert_allclose(inertia, tensor(found), rtol=0, atol=4e-15 * size)


def tensor(body: BodyMoments):
    return np.trace(body.central_second) * np.eye(3) - body.central_second


class TestSoup:
    @staticmethod
    def of(corners):
        corners = np.asarray(corners, np.float32)
        return Soup(corners=lambda start, stop: corners[start:stop], count=len(corners))

    @staticmethod
    def star(seed=1):
        vertices, triangles = triangulated(star_shaped(seed=seed))
        return vertices.astype(np.float32)[triangles]

    @settings(max_examples=25, deadline=None)
    @given(st.integers(0, 10**6), st.floats(0, 1e4))
    def test_it_equals_the_same_triangles_joined(self, seed, offset):
        corners = self.star(seed) + np.float32(offset)
        points, numbers = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        expected = polyhedron_moments(points.astype(float), *corner_lists(numbers.reshape(-1, 3)))
        soup = self.of(corners)
        look = soup.look(soup.middle)
        found = soup_moments(soup, look)
        assert found.body.volume == pytest.approx(expected.body.volume, rel=4e-15)
        norm = np.linalg.norm(expected.body.central_second)
        np.testing.assert_allclose(found.body.central_second, expected.body.central_second, rtol=0, atol=4e-15 * norm)
        assert found.area == pytest.approx(expected.area, rel=1e-14)
        assert look.sides == 0
        np.testing.assert_array_equal(look.box, [points.min(axis=0), points.max(axis=0)])

    @settings(max_examples=50, deadline=None)
    @given(st.integers(0, 10**6), st.data())
    def test_any_hole_flip_or_tear_is_seen(self, seed, data):
        corners = self.star(seed % 50)
        face = data.draw(st.integers(0, len(corners) - 1))
        broken = [
            np.delete(corners, face, axis=0),
            np.concatenate([corners[:face], corners[face : face + 1, ::-1], corners[face + 1 :]]),
            np.concatenate([corners, corners[face : face + 1]]),
        ]
        torn = corners.copy()
        axis = np.argmax(np.abs(torn[face, 1]))  # next to 0 it would be taken for 0
        torn[face, 1, axis] = np.nextafter(torn[face, 1, axis], np.float32(9))
        for one in (*broken, torn):
            soup = self.of(one)
            assert soup.look(soup.middle).sides != 0
        # two holes far from each other do not make up for one another, as they do in the closure residual
        twice = np.concatenate([corners, -corners[:, ::-1]])
        soup = self.of(np.delete(twice, [face, len(corners) + face], axis=0))
        assert soup.look(soup.middle).sides != 0
        assert self.of(twice).look(ORIGIN).sides == 0

    def test_signs_of_nought_and_rounding_next_to_it_join(self):
        corners = self.star()
        corners[np.abs(corners) < 0.2] = 0.0
        whole = self.of(corners)
        noisy = corners.copy()
        noisy[3::7][noisy[3::7] == 0.0] = -0.0
        noisy[::5][noisy[::5] == 0.0] = 1e-17
        assert whole.look(whole.middle).sides == 0
        soup = self.of(noisy)
        assert soup.look(soup.middle).sides == 0

    def test_a_thin_shell_is_summed_in_doubled_arithmetic(self):
        corners = self.star().astype(np.float64)
        inner = (corners * (1 - 2.0**-20)).astype(np.float32)
        both = np.concatenate([corners.astype(np.float32), inner[:, ::-1]])
        soup = self.of(both)
        points = both.reshape(-1, 3).astype(float)
        expected = polyhedron_moments(points, *corner_lists(np.arange(len(points)).reshape(-1, 3)))
        found = soup_moments(soup, soup.look(soup.middle))
        assert expected.amplification > 1e4
        assert found.body.volume == pytest.approx(expected.body.volume, rel=1e-15)

    @pytest.mark.parametrize("size", [1e-30, 1e-12, 1e12, 1e30])
    def test_any_size_that_single_precision_holds(self, size):
        corners = self.star()
        expected = soup_moments(self.of(corners), self.of(corners).look(self.of(corners).middle))
        # a power of two, so that the coordinates are scaled exactly
        factor = 2.0 ** np.round(np.log2(size))
        soup = self.of(corners * np.float32(factor))
        found = soup_moments(soup, soup.look(soup.middle))
        assert found.body.volume == pytest.approx(expected.body.volume * factor**3, rel=1e-14)
        np.testing.assert_allclose(
            found.body.central_second / factor**5,
            expected.body.central_second,
            rtol=0,
            atol=1e-14 * np.linalg.norm(expected.body.central_second),
        )


CUBE = triangulated(cube())


@pytest.mark.parametrize("kind", [np.int32, np.int64])
def test_no_vertices_are_no_memory_to_read(kind):
    with pytest.raises(GeometryError, match="face 0: there are no vertices"):
        mass_properties(np.empty((0, 3)), np.full((4, 3), 10**9, kind))
    with pytest.raises(GeometryError, match="positive volume"):
        mass_properties(np.empty((0, 3)), np.empty((0, 3), kind))


@pytest.mark.parametrize("size", [1e-103, 1e-85, 1e-70, 1e77, 1e100, 1e150])
def test_sizes_whose_fifth_powers_are_no_numbers_are_refused(size):
    with pytest.raises(GeometryError, match="fifth powers are no numbers; take another length unit"):
        mass_properties(CUBE[0] * size, CUBE[1])


@pytest.mark.parametrize("size", [1e-58, 1e-50, 1e50, 1e59])
def test_sizes_whose_fifth_powers_are_numbers_are_right(size):
    mass, centroid, inertia = mass_properties(CUBE[0] * size, CUBE[1])
    assert mass == pytest.approx(size**3, rel=1e-14)
    np.testing.assert_allclose(centroid, size / 2, rtol=1e-15)
    np.testing.assert_allclose(np.diag(inertia), size**5 / 6, rtol=1e-13)


@pytest.mark.parametrize("density", [None, "1", 1j, [1.0, 2.0], 10**400, 0, -1, np.nan, np.inf])
def test_densities_that_are_none_are_refused(density):
    with pytest.raises(GeometryError, match=r"density = .*a positive number is needed"):
        mass_properties(*CUBE, density)


@pytest.mark.parametrize("threads", [0, -1, "2", 1.5, 10**6])
def test_numbers_of_threads_that_are_none_are_refused(threads):
    with pytest.raises(GeometryError, match="1 to 1024, or None, is needed"):
        mass_properties(*CUBE, threads=threads)


@pytest.mark.parametrize("kind", [">i4", ">i8", "i1", "i2", "u1", "u4", "u8"])
def test_numbers_of_any_kind_are_taken(kind):
    assert mass_properties(CUBE[0], CUBE[1].astype(kind))[0] == pytest.approx(1.0)


@pytest.mark.parametrize("kind", ["f2", "f4", ">f8", "longdouble", "i4"])
def test_vertices_of_any_kind_are_taken(kind):
    assert mass_properties(np.asfortranarray(CUBE[0].astype(kind)), CUBE[1])[0] == pytest.approx(1.0)


@pytest.mark.parametrize("vertices", [[[0, 0, 0], [1, 1]], "cube", CUBE[0] * 1j, CUBE[0][:, :2], [["a", "b", "c"]]])
def test_vertices_that_are_none_are_refused(vertices):
    with pytest.raises(GeometryError, match=r"an array .n, 3. of numbers is needed"):
        mass_properties(vertices, CUBE[1])


def test_an_unused_vertex_that_is_no_point_does_not_matter():
    vertices = np.concatenate([CUBE[0], [[np.nan] * 3]])
    assert mass_properties(vertices, CUBE[1])[0] == pytest.approx(1.0)
    vertices[6] = np.nan
    with pytest.raises(GeometryError, match="vertex 6 = "):
        mass_properties(vertices, CUBE[1])
