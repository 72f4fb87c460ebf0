"""Laws of polyhedra: watertight, manifold, outward, on the surface, and within the tolerance of it everywhere."""

import numpy as np
import pytest

from gearwright.solids.solid import DEFAULT_TOLERANCE
from gearwright.surfaces.plane import Plane
from gearwright.surfaces.sphere import Sphere

from ..examples import BEVEL_PARTS, PARTS, Part, built, every_part, polyhedron, size
from .facets import barycentric, distance_from_patch, distance_to_patch, facets, flatness
from .topology import components, edges_pair_up, fans_at_vertices, genus, volume

TOLERANCES = (1e-2, 1e-3, DEFAULT_TOLERANCE)
every_tolerance = pytest.mark.parametrize("relative", TOLERANCES)


@every_tolerance
@every_part
def test_watertight_manifold_and_outward(part, relative):
    found = polyhedron(part, relative)
    triangles = np.asarray(found.faces)
    assert triangles.shape[1] == 3
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    assert components(triangles) == 1
    assert genus(triangles) == _handles(built(part).boundary)
    assert volume(found.vertices, triangles) > 0.0
    assert not found.validity().problems


def _handles(boundary):
    """Each inner loop of an end face begins a tunnel to the other end; without end faces the body is one ring."""
    return len(boundary.caps[0].loops) - 1 if boundary.caps else 1


@every_tolerance
@every_part
def test_no_triangle_twice_or_without_area_and_no_vertex_for_nothing(part, relative):
    found = polyhedron(part, relative)
    triangles = np.asarray(found.faces)
    assert len(np.unique(np.sort(triangles, axis=1), axis=0)) == len(triangles)
    assert np.array_equal(np.unique(triangles), np.arange(len(found.vertices)))
    assert flatness(found.vertices[triangles]).min() > 1e-6
    assert len(np.unique(found.vertices.round(12), axis=0)) == len(found.vertices)


@pytest.mark.parametrize("relative", [1e-3, DEFAULT_TOLERANCE, 1e-5])
@every_part
def test_chords_keep_the_tolerance_everywhere(part, relative):
    tolerance = relative * size(part)
    found = facets(built(part).boundary, tolerance)
    random = np.random.default_rng(3)
    for one in found.patches:
        some = one.subset(random, 800)
        assert distance_to_patch(some, 8).max() <= tolerance, one.patch.name
        assert distance_from_patch(one, random, 400).max() <= tolerance, one.patch.name
    for surface, corners in found.caps:
        points = np.einsum("nk,mkd->mnd", barycentric(8), _largest(corners, 4000))
        assert surface.deviation(points).max() <= tolerance * (1.0 + 1e-9)


def _largest(corners, most):
    """The triangles with the longest sides, where chords are deepest."""
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).max(axis=1)
    return corners[np.argsort(longest)[-most:]]


@every_part
def test_tolerance_is_used_not_wasted(part):
    tolerance = DEFAULT_TOLERANCE * size(part)
    found = facets(built(part).boundary, tolerance)
    worst = max(distance_to_patch(one.subset(np.random.default_rng(4), 800), 8).max() for one in found.patches)
    assert worst > 0.4 * tolerance


@every_part
def test_every_triangle_belongs_to_one_face_and_every_vertex_lies_on_it(part):
    boundary = built(part).boundary
    found = facets(boundary, 1e-3 * size(part))
    for one in found.patches:
        assert len(one.corners) == 2 * one.columns * one.layers
    patches = sum(len(one.corners) * one.patch.pattern.order for one in found.patches)
    assert patches + sum(len(corners) for _, corners in found.caps) == len(found.triangles)


@every_part
def test_triangles_face_the_way_of_the_surface(part):
    found = facets(built(part).boundary, DEFAULT_TOLERANCE * size(part))
    for one in found.patches:
        middle = one.fractions.mean(axis=1)
        outward = one.patch.area_vector(middle[:, 0], middle[:, 1])
        assert np.all(np.einsum("md,md->m", outward, _normals(one.corners)) > 0.0), one.patch.name
    for (surface, corners), sense in zip(found.caps, _senses(part, found.caps), strict=True):
        assert np.all(sense * np.sum(_onward(surface, corners) * _normals(corners), axis=-1) > 0.0)


def _senses(part, caps):
    """Which of the end faces look back: the first of two; of a bevel gear's spheres, cones, planes the nearer one."""
    if not part.element.startswith("bevel"):
        return (-1.0, 1.0)[: len(caps)]
    far = [(type(surface), _distance(surface)) for surface, _ in caps]
    return [-1.0 if d == min(e for other, e in far if other is kind) else 1.0 for kind, d in far]


def _distance(surface):
    """Of a sphere, cone or plane about z from the apex."""
    if isinstance(surface, Plane):
        return surface.origin[2]
    return surface.radius if isinstance(surface, Sphere) else surface.distance


def _onward(surface, corners):
    """The way from the first end to the last, at triangles of an end face: from the apex, along a plane's normal."""
    return np.cross(surface.x_axis, surface.y_axis) if isinstance(surface, Plane) else corners.mean(axis=1)


def _normals(corners):
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


@pytest.mark.parametrize("part", BEVEL_PARTS, ids=str)
def test_triangles_of_end_faces_are_well_shaped(part):
    """The worst lie where an involute's short chords at its cusp meet a long chord; most are near equilateral."""
    found = facets(built(part).boundary, DEFAULT_TOLERANCE * size(part))
    for _, corners in found.caps:
        shape = flatness(corners)
        assert shape.min() > 0.008  # flat ends cut steep spirals aslant
        assert np.quantile(shape, 0.05) > 0.15
        assert np.median(shape) > 0.5


@pytest.mark.parametrize("member", ["pinion", "gear"])
def test_triangles_of_the_straight_pair_are_well_shaped(member):
    part = Part("bevel pair", "16/20 straight", member)
    found = facets(built(part).boundary, DEFAULT_TOLERANCE * size(part))
    assert min(flatness(corners).min() for _, corners in found.caps) > 0.06


def test_default_tolerance_is_of_the_bounding_diagonal():
    """About that: from points along the edges."""
    part = PARTS[0]
    own = built(part).polyhedron()
    spread = np.ptp(polyhedron(part, 1e-4).vertices, axis=0)
    assert size(part) == pytest.approx(float(np.linalg.norm(spread)), rel=0.03)
    assert np.array_equal(own.vertices, polyhedron(part, 1e-4).vertices)


def test_coordinates_scale_with_the_part():
    small = built(Part("spur gear", "radial root below the base circle"))
    large = type(small)(teeth=16, module=8.0 * 1024.0, face_width=50.0 * 1024.0, root="radial")
    np.testing.assert_allclose(large.polyhedron().vertices, 1024.0 * small.polyhedron().vertices, rtol=1e-12, atol=1e-9)
