"""Polyhedra whose report once was wrong."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from gearwright.errors import GeometryError
from gearwright.solids.polyhedron import Polyhedron

from ..moments.bodies import cube, exact_moments, joined, moved, reversed_faces

_SIDES = [
    ((-1, 0, 0), [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)]),
    ((1, 0, 0), [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)]),
    ((0, -1, 0), [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]),
    ((0, 1, 0), [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)]),
    ((0, 0, -1), [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)]),
    ((0, 0, 1), [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]),
]


def box(low, high):
    return cube()[0] * (np.array(high, float) - low) + low, cube()[1]


def together(*bodies):
    result = bodies[0]
    for body in bodies[1:]:
        result = joined(result, body)
    return result


def triangulated(body):
    return body[0], [[face[0], *pair] for face in body[1] for pair in itertools.pairwise(face[1:])]


def gridded(body, count):
    """The faces of a box, in count × count quads each."""
    vertices, faces = [], []
    for face in body[1]:
        a, b, _, d = body[0][face]
        for i, j in itertools.product(range(count), repeat=2):
            steps = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            faces.append(range(len(vertices), len(vertices) + 4))
            vertices += [a + (b - a) * (s / count) + (d - a) * (t / count) for s, t in steps]
    points, numbers = np.unique(np.round(vertices, 12), axis=0, return_inverse=True)
    return points, [numbers.reshape(-1)[list(face)].tolist() for face in faces]


def voxels(cells):
    """The quads between cells and what is not one; they share vertices wherever they meet."""
    numbers, faces = {}, []
    for cell in sorted(cells):
        for beside, corners in _SIDES:
            if tuple(np.add(cell, beside)) not in cells:
                points = [tuple(np.add(cell, corner).tolist()) for corner in corners]
                faces.append([numbers.setdefault(point, len(numbers)) for point in points])
    return np.array(list(numbers), float), faces


def turned(body, seed, shift=0.0):
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return body[0] @ (turn * np.linalg.det(turn)).T + shift, body[1]


def kinds(*bodies):
    return list(Polyhedron(*together(*bodies)).validity().found)


OUTER = box((0, 0, 0), (2, 2, 2))
FLUSH = {
    "corner": box((0, 0, 0), (1, 1, 1)),
    "half": box((0, 0, 0), (2, 2, 1)),
    "edge": box((0, 0, 0), (2, 1, 1)),
    "slab": box((0.5, 0, 0), (1.5, 2, 2)),
    "bar": box((0.5, 0.5, 0), (1.5, 1.5, 2)),
    "peg": box((0.5, 0.5, 0), (1.5, 1.5, 1)),
}


@pytest.mark.parametrize("inner", FLUSH.values(), ids=FLUSH)
@pytest.mark.parametrize("shape", [lambda body: body, triangulated, lambda body: triangulated(gridded(body, 5))])
def test_a_body_in_a_body_flush_with_its_walls(inner, shape):
    inner = shape(inner)
    assert kinds(OUTER, inner) == kinds(inner, OUTER) == ["nested"]
    assert kinds(OUTER, reversed_faces(inner)) == kinds(reversed_faces(inner), OUTER) == []
    assert kinds(triangulated(OUTER), inner) == ["nested"]
    # beside it, on the other side of the same walls
    assert kinds(OUTER, moved(inner, [2.0, 0, 0])) == kinds(OUTER, moved(inner, [0, 0, -2.0])) == []


@pytest.mark.parametrize("inner", FLUSH.values(), ids=FLUSH)
def test_flush_bodies_turned_and_far_away(inner):
    for seed, shift in itertools.product(range(5), (0.0, 1e3)):
        one, other = turned(OUTER, seed, shift), turned(inner, seed, shift)
        assert kinds(one, other) == kinds(other, one) == ["nested"]
        assert kinds(one, reversed_faces(other)) == []


@pytest.mark.parametrize("inner", FLUSH.values(), ids=FLUSH)
def test_flush_bodies_whose_boxes_are_rounded_apart(inner):
    """Turned by 30° three times, so that walls are along the axes again but for rounding."""
    c, s = np.sqrt(0.75), 0.5
    for axes in itertools.permutations(range(3)):
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])[np.ix_(axes, axes)]
        one, other = OUTER, triangulated(gridded(inner, 3))
        for _ in range(3):
            one, other = (one[0] @ turn, one[1]), (other[0] @ turn, other[1])
        assert kinds(one, other) == ["nested"]
        assert kinds(one, reversed_faces(other)) == []


def test_the_few_faces_that_are_not_flush_decide_wherever_they_stand():
    points, faces = triangulated(gridded(box((0.25, 0, 0), (0.75, 1, 1)), 8))
    across = [face for face in faces if np.ptp(points[face][:, 0]) == 0.0]
    along = [face for face in faces if np.ptp(points[face][:, 0]) > 0.0]
    for order in (along + across, across + along):
        assert kinds(cube(), (points, order)) == ["nested"]


def test_a_body_all_of_whose_faces_are_flush_is_told_by_its_sides():
    """Two cells with a wall between them are one shell; a body that fills one of them lies on it all over."""
    vertices = np.concatenate([cube()[0], cube()[0][4:] + np.array([0, 0, 1])])
    cells = vertices, cube()[1] + [[i + 4 for i in face] for face in cube()[1]]
    for filled in (cube(), moved(cube(), [0, 0, 1.0])):
        assert kinds(cells, filled) == kinds(filled, cells) == ["nested"]
        assert kinds(cells, reversed_faces(filled)) == []
        assert kinds(triangulated(filled), cells) == ["nested"]
    assert kinds(cells, moved(cube(), [0, 0, 2.0])) == kinds(cells, moved(cube(), [1.0, 0, 0])) == []


BLOCK = {(i, j, k) for i in range(5) for j in range(5) for k in range(5)}


@pytest.mark.parametrize(("cells", "contained"), [(BLOCK - {(3, 3, 4)}, "cells"), (BLOCK | {(3, 3, 5)}, "block")])
def test_the_larger_of_two_that_are_flush_is_not_in_the_smaller(cells, contained):
    """A block and the same with a dent or a bump, of which no single point in the block's large faces knows."""
    stepped, block = voxels(cells), box((0, 0, 0), (5, 5, 5))
    first = {"cells": (6, 0), "block": (0, len(stepped[1]))}[contained]
    for place, order in enumerate(((block, stepped), (stepped, block))):
        assert Polyhedron(*together(*order)).validity().buried[:, 0].tolist() == [first[place]]


def test_a_plug_in_a_pocket_is_beside_its_walls():
    cells = {(i, j, k) for i in range(3) for j in range(3) for k in range(3)} - {(1, 1, 1)}
    plug, lid = box((1, 1, 1), (2, 2, 2)), box((1, 1, 2), (2, 2, 3))
    pocket = voxels(cells - {(1, 1, 2)})
    assert kinds(voxels(cells), plug) == kinds(plug, voxels(cells)) == []
    assert kinds(pocket, lid) == kinds(plug, pocket) == kinds(pocket, lid, plug) == []
    assert kinds(voxels(cells | {(1, 1, 1)}), plug) == ["nested"]


SPLIT = (
    np.array([[0, 0, 0], [10, 10, 10], [10, 0, 0], [10, 10, 0], [5, 5, 5]], float),
    [[2, 4, 0], [2, 1, 4], [4, 1, 0], [1, 3, 0], [3, 2, 0], [2, 3, 1]],
)


def test_a_triangle_without_area_hides_nothing():
    inner = box((7.1, 4.2, 2.1), (7.9, 4.9, 2.7))
    assert kinds(SPLIT, inner) == kinds(SPLIT, triangulated(inner)) == ["nested"]
    assert kinds(SPLIT, reversed_faces(inner)) == []
    assert list(Polyhedron(*SPLIT).validity().noted) == ["degenerate"]


def test_a_void_that_a_body_fills_in_any_order():
    bodies = [box((0, 0, 0), (10, 10, 10)), box((3, 3, 3), (6, 6, 6)), reversed_faces(box((3, 3, 3), (6, 6, 6)))]
    halves = [box((3, 3, 3), (6, 6, 4)), box((3, 3, 4), (6, 6, 6))]
    for order in itertools.permutations(bodies):
        assert kinds(*order) == kinds(*map(triangulated, order)) == []
        assert Polyhedron(*together(*order)).validity().bodies == 2
    for order in itertools.permutations([bodies[0], bodies[2], *halves]):
        assert kinds(*order) == []
    filled_twice = [*bodies, *bodies[1:]]
    for first in range(5):
        assert kinds(*filled_twice[first:], *filled_twice[:first]) == []
    # twice in it is once too often
    for order in itertools.permutations([*bodies, bodies[1]]):
        assert kinds(*order) == ["nested"]


CELLS = {(0, 2, 1), (0, 3, 1), (1, 2, 1), (1, 2, 2), (1, 3, 0), (1, 3, 2), (1, 4, 1), (2, 3, 0), (2, 3, 1), (2, 3, 2)}
CELLS |= {(2, 4, 1), (3, 3, 2), (3, 3, 3), (3, 3, 4), (4, 3, 4), (4, 4, 0)}


def test_a_void_that_touches_walls_along_edges():
    whole = Polyhedron(*voxels(CELLS))
    assert whole.validity().found == {}
    assert whole.properties().volume == 16.0


@pytest.mark.parametrize("seed", range(60))
def test_voxels_at_random_are_sound(seed):
    random = np.random.default_rng(seed)
    cells = {tuple(cell) for cell in np.argwhere(random.random((4, 5, 5)) < random.uniform(0.3, 0.8)).tolist()}
    points, faces = voxels(cells)
    faces = [faces[i] for i in random.permutation(len(faces))]
    whole = Polyhedron(points, faces)
    assert whole.validity().found == {}
    assert whole.properties().volume == len(cells)
    assert sum(body.properties().volume for body in whole.bodies()) == pytest.approx(len(cells))
    assert "inward" in kinds(reversed_faces((points, faces)))


@pytest.mark.parametrize("seed", range(20))
def test_thin_bodies_have_the_sense_of_their_corners(seed):
    rod = turned(box((0, 0, 0), (1, 1e-10, 1e-10)), seed)
    assert kinds(rod) == []
    assert kinds(reversed_faces(rod)) == ["inward"]
    sheared = cube()
    sheared[0][4:, 0] += 1e7
    assert kinds(sheared) == []
    assert Polyhedron(*sheared).properties().volume == pytest.approx(1.0, rel=1e-15)
    leaning = triangulated(turned(sheared, seed))
    volume = exact_moments(*leaning)[0]
    assert abs(volume) > 0.1  # or the corners' roundings would have made it
    assert kinds(leaning) == ([] if volume > 0 else ["inward"])


@pytest.mark.parametrize("low", [0.0, -1e-14, 1.0])
def test_a_plate_is_as_thick_as_its_corners_say(low):
    high = 1e-14 if low < 1.0 else float(np.nextafter(1.0, 2.0))
    plate = box((0, 0, low), (1, 1, high))
    assert kinds(plate) == []
    assert kinds(reversed_faces(plate)) == ["inward"]
    assert Polyhedron(*plate).properties().volume == pytest.approx(high - low, rel=1e-15, abs=0.0)
    assert kinds(box((0, 0, low), (1, 1, low))) == ["flat"]


def test_a_sheet_without_thickness_is_flat_however_it_is_turned():
    for seed in range(30):
        sheet = turned(box((0, 0, 0), (1, 1, 0)), seed, [0.3, 2.0, -1.1])
        assert kinds(sheet) == kinds(triangulated(sheet)) == ["flat"]


def test_a_body_far_away_lets_no_bent_face_pass():
    bent = cube()
    bent[0][6] += [0.3, 0.2, 0.4]
    for far in (1e3, 1e6):
        both = Polyhedron(*joined(bent, moved(cube(), [far, 0, 0])))
        assert list(both.validity().found) == ["nonplanar"]
        assert set(both.validity().nonplanar_faces.tolist()) == set(Polyhedron(*bent).validity().nonplanar_faces)
        assert both.validity().planarity == pytest.approx(1e-6 * np.linalg.norm([1.3, 1.2, 1.4]))
        assert kinds(bent, moved(cube(), [2.0, 0, 0], far)) == ["nonplanar"]
    # nor does a small one beside it make a large one's faces bent
    large = moved(cube(), 0.0, 1e3)
    large[0][6, 2] += 1e-3
    assert kinds(large, moved(cube(), [2e3, 0, 0], 1e-3)) == kinds(large) == []


def test_coordinates_whose_fifth_powers_are_no_numbers_are_refused():
    large = Polyhedron(cube()[0] * 1e61, cube()[1])
    for ask in (large.properties, lambda: large.shell_properties(1.0)):
        with pytest.raises(GeometryError, match=r"coordinates up to 1e\+61: up to 1e\+60 their fifth powers"):
            ask()
    with pytest.raises(GeometryError, match=r"vertex 1 = .*: up to 1e\+150 products of two are numbers"):
        Polyhedron(cube()[0] * 1e151, cube()[1])


def test_a_face_of_many_corners_without_area_takes_memory_in_proportion():
    vertices, faces = cube()
    assert Polyhedron(vertices, [*faces, [1] * 50_000]).properties().volume == 1.0
