"""End faces: the border kept exactly, the tolerance kept inside, shapes graded."""

import numpy as np
import pytest

from gearwright.boundary.rim import triangulate_pattern
from gearwright.boundary.triangulation import triangulate
from gearwright.curves.curve import turn
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.errors import GeometryError
from gearwright.surfaces.plane import Plane
from gearwright.surfaces.sphere import Sphere

from ..laws.facets import barycentric, flatness

PLANE = Plane(origin=(0.0, 0.0, 0.0))


def _ring(radius, count, *, z=0.0, sense=1):
    angle = sense * 2.0 * np.pi * np.arange(count) / count
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(count, z)], axis=1)


def _star(teeth, inner, outer):
    """A toothed loop."""
    period = np.array([[inner, 0.1], [outer, 0.3], [outer, 0.6], [inner, 0.8]])
    corners = [
        (r * np.cos(a), r * np.sin(a))
        for k in range(teeth)
        for r, a in period * [1.0, 2.0 * np.pi / teeth] + [0.0, 2.0 * np.pi * k / teeth]
    ]
    x, y = np.transpose(corners)
    return np.stack([x, y, np.zeros(len(x))], axis=1)


def _area(points, triangles):
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return np.cross(b - a, c - a).sum(axis=0)[2] / 2.0


def _directed(triangles):
    return {(int(a), int(b)) for t in triangles for a, b in zip(t, np.roll(t, -1), strict=True)}


def _is_a_face(points, triangles, loops):
    """Whether triangles cover a face with exactly these loops as their border."""
    edges = _directed(triangles)
    assert len(edges) == 3 * len(triangles)
    border = {edge for edge in edges if edge[::-1] not in edges}
    expected, start = set(), 0
    for loop in loops:
        expected |= {(start + i, start + (i + 1) % len(loop)) for i in range(len(loop))}
        start += len(loop)
    assert border == expected
    assert np.array_equal(np.unique(triangles), np.arange(len(points)))


@pytest.mark.parametrize("sense", [1, -1])
def test_a_disc_with_a_hole(sense):
    loops = [_ring(2.0, 60, sense=sense), _ring(1.0, 20, sense=-sense)]
    inner, triangles = triangulate(PLANE, loops, 0.1)
    points = np.concatenate([*loops, inner])
    _is_a_face(points, triangles, loops)
    polygons = 60 / 2 * 4.0 * np.sin(2 * np.pi / 60) - 20 / 2 * np.sin(2 * np.pi / 20)
    assert _area(points, triangles) == pytest.approx(sense * polygons)
    assert flatness(points[triangles]).min() > 0.2


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 3e-4])
def test_triangles_on_a_sphere_keep_the_tolerance(tolerance):
    """Also inside triangles, at the foot of the perpendicular from the centre, not only at their middles."""
    sphere = Sphere(radius=5.0)
    count = int(np.ceil(np.pi / np.sqrt(2.0 * tolerance / 3.0)))
    loops = [_ring(3.0, count, z=4.0)]
    inner, triangles = triangulate(sphere, loops, tolerance)
    points = np.concatenate([*loops, inner])
    _is_a_face(points, triangles, loops)
    np.testing.assert_allclose(np.linalg.norm(inner, axis=1), 5.0, rtol=1e-14)
    all_over = np.einsum("nk,mkd->mnd", barycentric(9), points[triangles])
    deepest = (5.0 - np.linalg.norm(all_over, axis=-1)).max()
    assert 0.5 * tolerance < deepest <= tolerance * (1.0 + 1e-9)


def test_loops_that_cross_are_refused():
    with pytest.raises(GeometryError, match="cross or touch"):
        triangulate(PLANE, [_ring(1.0, 40), np.add(_ring(0.5, 20, sense=-1), [0.8, 0.0, 0.0])], 0.1)


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("hole", [None, 0.05, 0.15, 0.3, 0.7])
@pytest.mark.parametrize("teeth", [3, 4, 5, 8, 20, 60])
def test_patterns_are_covered_sector_by_sector(teeth, hole, sense):
    loops = [_star(teeth, 1.0, 1.3)[::sense]]
    if hole is not None:
        loops.append(_ring(hole, 7 * teeth, sense=-sense))
    inner, triangles = triangulate_pattern(PLANE, loops, 0.01, teeth)
    points = np.concatenate([*loops, inner])
    _is_a_face(points, triangles, loops)
    polygons = [0.5 * np.sum(p[:, 0] * np.roll(p[:, 1], -1) - p[:, 1] * np.roll(p[:, 0], -1)) for p in loops]
    assert _area(points, triangles) == pytest.approx(sum(polygons))


def test_patterned_triangles_are_images_of_each_other():
    coarse = _star(20, 1.0, 1.3)
    fine = [coarse * (1.0 - t) + np.roll(coarse, -1, axis=0) * t for t in np.arange(6) / 6.0]
    flat = np.stack(fine, axis=1).reshape(-1, 3)
    loop = np.column_stack([flat[:, :2], np.sqrt(9.0 - flat[:, 0] ** 2 - flat[:, 1] ** 2)])
    inner, triangles = triangulate_pattern(Sphere(radius=3.0), [loop], 1e-3, 20)
    points = np.concatenate([loop, inner])
    at_border = points[triangles[(triangles < len(loop)).any(axis=1)]].mean(axis=1)
    turned = at_border @ turn(2.0 * np.pi / 20, 3).T
    distance = np.linalg.norm(turned[:, None] - at_border[None], axis=-1).min(axis=1)
    assert len(at_border) >= len(loop)
    assert distance.max() < 1e-12


def test_triangles_grow_away_from_a_fine_border():
    """A border of short segments does not make the whole face fine."""
    loops = [_ring(1.0, 2000)]
    inner, triangles = triangulate(PLANE, loops, 1.0)
    assert len(inner) < 8 * 2000
    points = np.concatenate([*loops, inner])
    middle = np.linalg.norm(points[triangles].mean(axis=1), axis=1)
    sides = np.linalg.norm(points[triangles] - np.roll(points[triangles], 1, axis=1), axis=-1).max(axis=1)
    assert sides[middle < 0.3].min() > 20.0 * 2.0 * np.pi / 2000


@pytest.mark.parametrize("short", [1e-2, 1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize("sense", [1, -1])
def test_one_short_segment_costs_little(short, sense):
    """Grading is geometric: a segment a million times shorter adds some dozen points, not a million."""
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [short, 1.0], [0.0, 1.0]])
    loop = np.column_stack([corners, np.zeros(5)])[::sense]
    inner, triangles = triangulate(PLANE, [loop], 1.0)
    assert len(triangles) < 500
    _is_a_face(np.concatenate([loop, inner]), triangles, [loop])


def test_a_fine_tolerance_is_kept_on_a_wide_cone_however_often_triangles_must_be_cut():
    """Twenty insertions; a shell of the tolerance around the gear bounds what its volume may lose."""
    gear = BevelPair(teeth=(16, 20), module=12.7, face_width=38.1).gear
    tolerance = 0.002
    exact, found = gear.properties(), gear.polyhedron(tolerance).properties()
    assert abs(found.volume - exact.volume) < tolerance * found.area
