"""Faces that pass through each other: shapes whose answer is known, and random ones against rational arithmetic."""

import json
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.sections.loop import Loop
from gearwright.solids.box_tree import overlapping_pairs
from gearwright.solids.orientations import side, turn

from ..examples import every_part, polyhedron
from .rational_triangles import dot, meetings, minus, normal, passings

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
ITS_FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
BOX = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
ITS_QUADS = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
UP = np.array([0.0, 0.0, 1.0])
RAISED = np.array([0.2, 0.2, -0.5])


def together(*bodies):
    """One polyhedron of bodies (vertices, faces), no vertices shared."""
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in bodies)])
    faces = [[i + start for i in face] for start, (_, faces) in zip(starts, bodies, strict=False) for face in faces]
    return gw.Polyhedron(np.concatenate([vertices for vertices, _ in bodies]), faces)


def pushed(offset=RAISED, move=lambda points: points):
    """Two tetrahedra, the second moved by an offset."""
    return together((move(TETRAHEDRON), ITS_FACES), (move(TETRAHEDRON + offset), ITS_FACES))


def sets(found):
    return {tuple(pair) for pair in found.pairs.tolist()}, {tuple(pair) for pair in found.touching.tolist()}


# shapes whose answer is known


def test_tetrahedra_pushed_through_each_other():
    """The tip of the lower one comes out of the base of the upper: three of its faces cut the base's plane."""
    found = pushed().self_intersections()
    assert found
    assert sets(found) == ({(0, 5), (0, 6), (0, 7)}, set())
    # each on the section of the lower one at z = 0, a triangle of half its size with its right angle at (0.2, 0.2)
    np.testing.assert_allclose(found.points, [[0.45, 0.2, 0], [0.2, 0.45, 0], [0.45, 0.45, 0]], atol=1e-15)
    assert found.depths[0] == pytest.approx(0.2, rel=1e-14)


def test_they_are_apart_or_touch_when_moved():
    assert not pushed([2.0, 0.0, 0.0]).self_intersections()
    assert not len(pushed([0.2, 0.2, -1.001]).self_intersections().touching)
    tip = pushed([0.2, 0.2, -1.0]).self_intersections()
    assert sets(tip) == (set(), {(0, 5), (0, 6), (0, 7)})
    assert tip.problem is None
    assert tip.remark is not None
    deeper = pushed([0.2, 0.2, np.nextafter(-1.0, 0.0)]).self_intersections()
    assert sets(deeper)[0] == {(0, 5), (0, 6), (0, 7)}
    assert 0.0 < deeper.depths[0] < 1e-15


@pytest.mark.parametrize("exponent", [-1000, -300, 300, 450])
def test_scale_does_not_matter(exponent):
    found = pushed(move=lambda points: np.ldexp(points, exponent)).self_intersections()
    assert np.array_equal(found.pairs, pushed().self_intersections().pairs)
    np.testing.assert_allclose(np.ldexp(found.points, -exponent)[0], [0.45, 0.2, 0.0], atol=1e-15)


@pytest.mark.parametrize("far", [2.0**30, -(2.0**40)])
def test_place_does_not_matter(far):
    """Of coordinates that all places express exactly; the tip comes through by a thousandth."""
    offset = np.array([0.25, 0.25, -1.0 + 2.0**-10])
    shift = np.array([far, 0.5 * far, -far])
    near = pushed(offset).self_intersections()
    found = pushed(offset, lambda points: points + shift).self_intersections()
    assert near.count == 3
    assert np.array_equal(found.pairs, near.pairs)
    np.testing.assert_allclose(found.depths, near.depths, rtol=1e-12)
    np.testing.assert_allclose(found.points - shift, near.points, atol=1e-15 * abs(far))


def test_a_vertex_pulled_through_the_opposite_side():
    ball = globe()
    points = ball.vertices.copy()
    top = int(np.argmax(points[:, 2]))
    points[top] = [0.013, 0.021, -1.3]
    found = gw.Polyhedron(points, ball.faces).self_intersections()
    spike = np.flatnonzero((np.asarray(ball.faces) == top).any(axis=1))
    assert found.count >= len(spike)
    assert np.all(np.isin(found.pairs, spike).sum(axis=1) == 1)
    assert set(spike) <= set(found.pairs.ravel())
    np.testing.assert_allclose(np.linalg.norm(found.points, axis=1), 1.0, atol=0.03)
    assert np.all(found.points[:, 2] < -0.9)
    points[top] = [0.013, 0.021, -0.9]
    assert not gw.Polyhedron(points, ball.faces).self_intersections()


def globe(rings=12, sectors=17):
    """A unit sphere's triangles."""
    angles = np.pi * np.arange(1, rings) / rings
    turns = 2.0 * np.pi * np.arange(sectors) / sectors
    grid = [[np.sin(a) * np.cos(t), np.sin(a) * np.sin(t), np.cos(a)] for a in angles for t in turns]
    faces = tube_faces(rings - 1, sectors, 2)
    return gw.Polyhedron(np.array([[0, 0, 1], [0, 0, -1], *grid]), faces)


def tube_faces(rings, sides, first):
    """Triangles of rings of vertices from number `first` on, closed by vertex 0 before and 1 after them."""
    around = [(k, (k + 1) % sides) for k in range(sides)]
    faces = [[0, first + a, first + b] for a, b in around]
    for ring in range(rings - 1):
        low, high = first + ring * sides, first + (ring + 1) * sides
        faces += [[low + a, high + a, high + b] for a, b in around] + [[low + a, high + b, low + b] for a, b in around]
    last = first + (rings - 1) * sides
    return np.array(faces + [[1, last + b, last + a] for a, b in around])


def loop_tube(climb, radius=0.1):
    """A tube along a path whose ends cross over, one `climb` above the other, at (0, 0)."""
    s = np.linspace(-1.3, 1.3, 60)
    path = np.stack([s**3 - s, 1.0 - s**2, climb / 2.0 * s], axis=-1)
    along = np.gradient(path, axis=0)
    across = np.cross([0.0, 0.0, 1.0], along)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    up = np.cross(along, across)
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    turns = 2.0 * np.pi * np.arange(13) / 13
    rings = path[:, None] + radius * (
        np.cos(turns)[:, None] * across[:, None, :] + np.sin(turns)[:, None] * up[:, None, :]
    )
    points = np.concatenate([path[[0, -1]], rings.reshape(-1, 3)])
    return gw.Polyhedron(points, tube_faces(60, 13, 2)[:, ::-1])


@pytest.mark.parametrize("climb", [0.0, 0.1, 0.19])
def test_a_tube_bent_through_itself(climb):
    tube = loop_tube(climb)
    assert tube.validity().valid
    found = tube.self_intersections()
    assert found.count > 10
    # the two stretches meet at a right angle, so the cut stays within twice the radius of the crossing
    assert np.linalg.norm(found.points, axis=1).max() < 0.2
    assert "tightly" in str(found.problem)


def test_a_tube_that_passes_over_itself_is_whole():
    assert sets(loop_tube(0.25).self_intersections()) == (set(), set())


def test_a_torus_and_other_sweeps_have_none():
    ring = gw.Section(loops=(Loop(curves=(Arc(radius=1.3, centre=(5.0, 0.0), interval=(0.0, 2.0 * np.pi)),)),))
    for solid in (gw.revolve(ring), gw.revolve(ring, 200.0), gw.extrude(ring, 3.0, twist=20.0, scale=(0.3, 2.0))):
        found = solid.self_intersections(0.01)
        assert sets(found) == (set(), set())
        assert found.problem is None
        assert found.remark is None


@every_part
def test_gears_have_none(part):
    assert sets(polyhedron(part, 1e-3).self_intersections()) == (set(), set())


def test_a_gear_turned_anyhow_has_none():
    """Its planes are then planes only to rounding."""
    gear = gw.SpurGear(teeth=16, module=8.0, face_width=50.0)
    matrix = np.eye(4)
    matrix[:3, :3] = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    matrix[:3, 3] = 1e6
    turned = gear.polyhedron(0.05).transformed(matrix)
    assert sets(turned.self_intersections()) == (set(), set())


# contact, folds, edges


@pytest.mark.parametrize("quads", [ITS_QUADS, np.roll(ITS_QUADS, 1, axis=1)])
@pytest.mark.parametrize("shared", [False, True])
def test_boxes_on_each_other_only_touch(quads, shared):
    """Face to face, their diagonals the same or crossed, their vertices shared or not."""
    stacked = together((BOX, ITS_QUADS), (BOX + UP, quads))
    if shared:
        points, numbers = np.unique(stacked.vertices, axis=0, return_inverse=True)
        stacked = gw.Polyhedron(points, numbers.reshape(-1)[np.asarray(stacked.faces)])
    through, touching = sets(stacked.self_intersections())
    assert not through
    assert (5, 10) in touching


def test_boxes_that_overlap_on_common_planes():
    found = together((BOX, ITS_QUADS), (BOX + 0.5 * UP, ITS_QUADS)).self_intersections()
    assert sets(found)[0] == {(0, 6), (1, 7), (2, 8), (3, 9)}
    assert np.all(found.depths == 0.0)
    assert np.all((found.points[:, 2] > 0.5) & (found.points[:, 2] < 1.0))


def test_a_box_pierced_by_another_is_reported_by_faces():
    """Quads are two triangles each, and every pair of them is named once."""
    bar = BOX * [0.4, 0.5, 3.0] + [0.3, 0.2, -1.0]
    found = together((BOX, ITS_QUADS), (bar, ITS_QUADS)).self_intersections()
    sides = (6, 7, 8, 9)
    assert sets(found) == ({(low, side) for low in (4, 5) for side in sides}, set())


def post(bottom):
    """A post of height 1 with a ring of vertices half way up."""
    ring = [[0.2, 0.3], [0.7, 0.3], [0.7, 0.8], [0.2, 0.8]]
    sides = [[4 * n + k, 4 * n + (k + 1) % 4, 4 * n + 4 + (k + 1) % 4, 4 * n + 4 + k] for n in (0, 1) for k in range(4)]
    return np.array([[x, y, bottom + z] for z in (0.0, 0.5, 1.0) for x, y in ring]), [
        [3, 2, 1, 0],
        [8, 9, 10, 11],
        *sides,
    ]


def test_a_sheet_that_passes_exactly_along_its_edges():
    """No insides meet when the ring lies in the box's lower face, only edges."""
    through, touching = sets(together((BOX, ITS_QUADS), post(-0.5)).self_intersections())
    assert through == {(4, side) for side in range(8, 16)}
    assert not touching


@pytest.mark.parametrize("bottom", [-1.0, 1.0])
def test_a_post_that_ends_on_a_box_only_touches(bottom):
    through, touching = sets(together((BOX, ITS_QUADS), post(bottom)).self_intersections())
    assert not through
    assert len(touching) == 5


def test_a_flattened_tetrahedron_is_folded_onto_itself():
    flat = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.3, 0.3, 0]])
    assert sets(gw.Polyhedron(flat, ITS_FACES).self_intersections()) == ({(0, 1), (0, 2), (0, 3)}, set())


def test_neighbours_that_meet_only_in_what_they_share():
    assert sets(gw.Polyhedron(TETRAHEDRON, ITS_FACES).self_intersections()) == (set(), set())
    # quads of one plane around a vertex, and an L whose fan of triangles lies in one plane
    outline = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], float)
    prism = np.concatenate([np.c_[outline, np.zeros(6)], np.c_[outline, np.ones(6)]])
    sides = [[k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6] for k in range(6)]
    body = gw.Polyhedron(prism, [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11], *sides])
    assert body.validity().valid
    assert sets(body.self_intersections()) == (set(), set())


def test_a_neighbour_that_pierces():
    """Triangles that share a vertex: the opposite edge of one goes through the other."""
    points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 1], [3, 3, -1], [3, 3, 1]]
    assert sets(gw.Polyhedron(points, [[0, 1, 2], [0, 3, 4]]).self_intersections())[0] == {(0, 1)}
    assert sets(gw.Polyhedron(points, [[1, 2, 0], [0, 4, 3]]).self_intersections())[0] == {(0, 1)}
    assert sets(gw.Polyhedron(points, [[0, 1, 2], [1, 5, 6]]).self_intersections()) == (set(), set())


def test_faces_without_area_meet_nothing():
    points = np.concatenate([TETRAHEDRON, [[0.2, 0.2, -1], [0.2, 0.2, 0.1], [0.2, 0.2, 1]]])
    faces = np.concatenate([ITS_FACES, [[4, 5, 6]]])
    assert sets(gw.Polyhedron(points, faces).self_intersections()) == (set(), set())


def test_triangles_of_one_face_do_not_count():
    """A snail of more than one turn around its first corner covers itself, but is one face; two halves are two."""
    turns = np.radians(60.0) * np.arange(8)
    snail = (1.0 + 0.1 * np.arange(8))[:, None] * np.stack([np.cos(turns), np.sin(turns), 0.0 * turns], axis=-1)
    points = np.concatenate([np.zeros((1, 3)), snail])
    assert sets(gw.Polyhedron(points, [list(range(9))]).self_intersections()) == (set(), set())
    halves = gw.Polyhedron(points, [[0, 1, 2, 3, 4], [0, 4, 5, 6, 7, 8]])
    assert sets(halves.self_intersections()) == ({(0, 1)}, set())


def test_nothing_has_none():
    assert sets(gw.Polyhedron([], []).self_intersections()) == (set(), set())


# the report


def test_the_report_is_fit_for_json_and_exceptions():
    found = pushed().self_intersections()
    document = json.loads(json.dumps(found.to_dict()))
    assert document["count"] == len(document["pairs"]) == len(document["points"]) == len(document["depths"]) == 3
    assert document["touching"] == []
    assert document["remark"] is None
    assert document["problem"].startswith("3 pairs of faces, the first 0 and 5 near (0.45, 0.2, 0), ")
    with pytest.raises(gw.GeometryError, match="passes through itself") as caught:
        found.raise_any()
    assert caught.value.problems == (found.problem,)
    pushed([2.0, 0.0, 0.0]).self_intersections().raise_any()


# against exact arithmetic by another route

GRIDS = {
    "integers": st.integers(0, 3).map(float),
    "tenths": st.integers(0, 4).map(lambda n: 0.1 * n),
    "floats": st.floats(-1.0, 1.0, allow_subnormal=False).filter(lambda x: x == 0.0 or abs(x) > 1e-30),
}


@st.composite
def soups(draw):
    """Points of a grid, often in one plane that rounding bends, and triangles between them."""
    count = draw(st.integers(4, 8))
    coordinate = GRIDS[draw(st.sampled_from(sorted(GRIDS)))]
    points = np.array(draw(st.lists(st.tuples(*3 * [coordinate]), min_size=count, max_size=count)))
    match draw(st.sampled_from(["any", "level", "sloping", "turned"])):
        case "level":
            points[:, 2] = points[0, 2]
        case "sloping":
            points[:, 2] = points[:, 0] + points[:, 1]
        case "turned":
            points[:, 2] = 0.0
            points = points @ np.linalg.qr(np.random.default_rng(draw(st.integers(0, 9))).normal(size=(3, 3)))[0]
    choices = st.sampled_from(list(combinations(range(count), 3)))
    triangles = np.array(draw(st.lists(choices, min_size=2, max_size=6)))
    swapped = np.array([draw(st.booleans()) for _ in triangles])
    triangles[swapped] = triangles[swapped][:, ::-1]
    return points, triangles


@settings(deadline=None, max_examples=400)
@given(soups())
def test_random_soups_agree_with_rational_arithmetic(soup):
    points, triangles = soup
    found = gw.Polyhedron(points, triangles).self_intersections()
    through, touching = passings(points, triangles)
    assert sets(found) == (through, touching)
    assert sum(map(len, meetings(points, triangles))) == len(through) + len(touching)


@pytest.mark.parametrize("level", [True, False])
def test_corners_on_sides_but_for_rounding(level):
    """Apart, touching or through by the last digit, in one plane and across."""
    random = np.random.default_rng(11)
    seen = set()
    for _ in range(300):
        a, b, c, d, e = random.random((5, 3))
        tip = a + random.integers(1, 8) / 8.0 * (b - a)
        points = np.array([a, b, c, tip, tip + (tip - c) + 0.1 * (d - a), tip + (tip - c) + 0.1 * (e - b)])
        if level:
            points[:, 2] = 0.5
        found = sets(gw.Polyhedron(points, [[0, 1, 2], [3, 4, 5]]).self_intersections())
        assert found == passings(points, [[0, 1, 2], [3, 4, 5]])
        seen.add(tuple(map(len, found)))
    assert {(0, 0), (0, 1) if level else (1, 0)} <= seen


@settings(deadline=None, max_examples=200)
@given(soups())
@example(  # what they share ends in a corner of one and on a side of the other
    (
        np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
        np.array([[0, 1, 2], [1, 3, 4]]),
    )
)
def test_points_lie_on_both_triangles(soup):
    points, triangles = soup
    found = gw.Polyhedron(points, triangles).self_intersections()
    corners = points[triangles[found.pairs]]
    low, high = corners.min(axis=2).max(axis=1), corners.max(axis=2).min(axis=1)
    assert np.all((found.points >= low - 1e-12) & (found.points <= high + 1e-12))
    for pair, point in zip(corners, found.points, strict=True):
        for a, b, c in pair:
            sides = np.array([b - a, c - a]).T
            if np.linalg.cond(sides) < 1e3:  # in thinner ones rounding moves the point
                shares, *_ = np.linalg.lstsq(sides, point - a)
                np.testing.assert_allclose(sides @ shares, point - a, atol=1e-9)
                assert shares.min() > -1e-9
                assert shares.sum() < 1.0 + 1e-9


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("far", [0.0, 1e3, 1e8])
def test_signs_next_to_planes_and_lines(seed, far):
    """Of points on a plane or a line but for rounding, where plain arithmetic gives many wrong signs."""
    random = np.random.default_rng(seed)
    shares = random.integers(-8, 9, (300, 2)) / 8.0
    signs = []
    for u, v in shares:
        a, b, c = random.random((3, 3)) + far
        points = np.array([a, b, c, a + u * (b - a) + v * (c - a), a + u * (b - a)])
        exact = [[Fraction(float(x)) for x in point] for point in points]
        height = dot(minus(exact[3], exact[0]), normal(exact[:3]))
        across = normal([exact[0], exact[1], exact[4]])
        signs.append(np.sign(height))
        assert side(points, 0, 1, 2, 3) == np.sign(height)
        assert side(points, 1, 0, 2, 3) == -np.sign(height)
        assert [turn(points, 0, 1, 4, axis) for axis in range(3)] == [np.sign(x) for x in across]
    assert {-1, 0, 1} == set(signs) or far == 0.0


@pytest.mark.parametrize("count", [1, 2, 4, 5, 9, 300, 9000])
def test_the_tree_finds_the_pairs_that_overlap(count):
    random = np.random.default_rng(count)
    middles = random.random((count, 1, 3)) * [1.0, 1.0, 0.1]
    halves = random.exponential(0.5, (count, 1, 3)) * min(1.0, 3.0 / count) ** 0.5
    boxes = np.concatenate([middles - halves, middles + halves], axis=1)
    found = np.concatenate(list(overlapping_pairs(boxes)))
    seen = {(min(pair), max(pair)) for pair in found.tolist()}
    assert len(seen) == len(found)
    expected = set()
    for i in range(count):
        meets = np.all((boxes[i, 0] <= boxes[i + 1 :, 1]) & (boxes[i + 1 :, 0] <= boxes[i, 1]), axis=1)
        expected |= {(i, i + 1 + int(j)) for j in np.flatnonzero(meets)}
    assert seen == expected
