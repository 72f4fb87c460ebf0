"""The report on polyhedra: each kind by examples whose answer is known, and what stays sound however odd it looks."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.errors import GeometryError
from gearwright.moments.bare import mass_properties
from gearwright.solids.model import Model
from gearwright.solids.polyhedron import Polyhedron
from gearwright.solids.validity.kinds import PROBLEM_KINDS, PROBLEMS, REMARKS

from ..moments.bodies import cube, gear_like, joined, moved, reversed_faces, star_shaped

CUBE, FACES = cube()


def refusal(polyhedron):
    with pytest.raises(GeometryError) as caught:
        polyhedron.properties()
    return str(caught.value)


# what other libraries answer in silence


def test_an_open_mesh_is_refused_with_its_place():
    assert "4 open edges, the first between vertices 0 and 1, near (0.5, 0, 0) in one chain" in refusal(
        Polyhedron(CUBE, FACES[1:])
    )


def test_a_flipped_face_is_refused_with_its_place():
    assert "1 face, 3 near (1, 0.5, 0.5), flipped" in refusal(
        Polyhedron(CUBE, [*FACES[:3], FACES[3][::-1], *FACES[4:]])
    )


def test_a_coordinate_that_is_no_number_is_refused_with_its_place():
    vertices = CUBE.copy()
    vertices[5, 1] = np.nan
    assert "vertex 5 = [1.0, nan, 1.0]" in _not_made(vertices, FACES)


@pytest.mark.parametrize("wrong", [-1, 8])
def test_a_vertex_number_out_of_range_is_refused_with_its_place(wrong):
    assert f"vertex number {wrong} in face 2: there are vertices 0 to 7" in _not_made(
        CUBE, [*FACES[:2], [0, wrong, 5, 4], *FACES[3:]]
    )


def test_bodies_that_overlap_are_refused_with_their_place():
    both = Polyhedron(*joined(cube(), moved(cube(), [0.5, 0.25, 0.125])))
    found = both.self_intersections()
    assert found.bodies.tolist() == [[0, 1]]
    assert "; bodies 0 and 1 overlap" in str(found)
    with pytest.raises(GeometryError, match="bodies 0 and 1 overlap"):
        found.raise_any()
    inside = joined(cube(3.0), moved(cube(), 1.0))
    assert "1 component, the one of face 6 (6 faces) near (1.5, 1.5, 1), outward but inside another" in refusal(
        Polyhedron(*inside)
    )


def test_bodies_side_by_side_do_not_overlap_nor_do_faces_of_one_body():
    apart = Polyhedron(*joined(cube(), moved(cube(), [1.5, 0, 0]))).self_intersections()
    assert apart.bodies.tolist() == []
    crossed = CUBE.copy()
    crossed[4:] = CUBE[[6, 5, 4, 7]]  # opposite corners of the top exchanged: the body passes through itself
    twisted = Polyhedron(crossed, Polyhedron(crossed, FACES).triangles()).self_intersections()
    assert twisted
    assert "overlap;" not in str(twisted)
    assert twisted.bodies.tolist() == []


def test_a_void_that_is_not_reversed_is_refused_with_its_place():
    shell = joined(cube(3.0), moved(reversed_faces(cube()), 1.0))
    assert Polyhedron(*shell).properties().volume == pytest.approx(26)
    assert "the one of face 6 (6 faces)" in refusal(Polyhedron(*joined(cube(3.0), moved(cube(), 1.0))))


def test_vertices_with_a_fourth_column_are_refused():
    assert "vertices of shape (8, 4): an array (n, 3) is needed" in _not_made(np.c_[CUBE, np.ones(8)], FACES)


def test_faces_with_a_fourth_column_are_refused_with_their_place():
    """Triangles with a colour, a count or a marker beside them are quadrilaterals, and these do not close."""
    triangles = Polyhedron(CUBE, FACES).triangles()
    assert "open edges, the first between vertices 0 and 1" in refusal(
        Polyhedron(CUBE, np.c_[triangles, np.zeros(12, int)])
    )
    assert "open edge" in refusal(Polyhedron(CUBE, np.c_[np.full(12, 3), triangles]))
    assert "vertex number 9 in face 0 and 11 more" in _not_made(CUBE, np.c_[triangles, np.full(12, 9)])


def _not_made(vertices, faces):
    with pytest.raises(GeometryError) as caught:
        Polyhedron(vertices, faces)
    return str(caught.value)


# sound, however odd


def test_a_face_with_a_hole_and_a_bridge_to_it_is_sound():
    """Ends of a pierced prism as drawing programs write them: one polygon along a bridge, there and back."""
    vertices, faces = gear_like(8, hole=True)
    walls = [face for face in faces if not _horizontal(vertices[face])]
    outer, inner = list(range(8, 16)), list(range(24, 32))
    top = [*outer, 8, 24, *inner[:0:-1], 24]
    bottom = [i - 8 for i in top][::-1]
    keyhole = Polyhedron(vertices, [*walls, top, bottom])
    report = keyhole.validity()
    assert report.found == {}
    assert report.noted == {}
    assert keyhole.properties().volume == pytest.approx(Polyhedron(vertices, faces).properties().volume, rel=1e-14)
    assert "1 face, 17 near" in str(Polyhedron(vertices, [*walls, top, bottom[::-1]]).validity())
    assert len(Polyhedron(vertices, [*walls, top]).validity().edges.open) == 16


def test_a_face_that_runs_along_an_edge_to_and_fro_keeps_its_side_there():
    to_and_fro = Polyhedron(CUBE, [[3, 2, 1, 0, 1, 0], *FACES[1:]])
    assert to_and_fro.validity().found == {}
    assert not len(to_and_fro.validity().edges.non_manifold)
    assert to_and_fro.properties().volume == pytest.approx(1.0)


def _horizontal(points):
    return np.ptp(points[:, 2]) == 0.0


def test_a_face_that_touches_itself_at_a_corner_is_sound():
    """A prism over two triangles that share a corner: its edge there has four faces."""
    corners = np.array([[0.0, 0], [-1, 1], [-1, -1], [1, -1], [1, 1]])
    vertices = np.concatenate([np.c_[corners, np.full(5, z)] for z in (0.0, 1.0)])
    outline = [0, 1, 2, 0, 3, 4]
    sides = [[a, b, b + 5, a + 5] for a, b in zip(outline, outline[1:] + outline[:1], strict=True)]
    bow = Polyhedron(vertices, [outline[::-1], [i + 5 for i in outline], *sides])
    assert bow.validity().found == {}
    assert bow.validity().edges.non_manifold.tolist() == [[0, 5]]
    assert set(bow.validity().noted) == {"non-manifold"}
    assert bow.properties().volume == pytest.approx(2.0)


def test_bodies_that_touch_at_a_vertex_are_two_and_pinched():
    vertices = np.concatenate([CUBE, -CUBE[1:]])
    second = [[0 if i == 0 else i + 7 for i in face][::-1] for face in FACES]
    both = Polyhedron(vertices, FACES + second)
    assert both.validity().found == {}
    assert both.validity().pinched_vertices.tolist() == [0]
    assert "1 pinched vertex, 0 at (0, 0, 0)" in str(both.validity())
    assert [body.properties().volume for body in both.bodies()] == [1.0, 1.0]
    wrong = Polyhedron(vertices, FACES + [face[::-1] for face in second])
    assert set(wrong.validity().found) == {"inward"}
    assert wrong.validity().inward.tolist() == [[6, 6]]


def test_cells_with_a_wall_between_them_are_one_component_and_the_wall_is_remarked():
    vertices = np.concatenate([CUBE, CUBE[4:] + np.array([0, 0, 1])])
    upper = [[i + 4 for i in face] for face in FACES]
    cells = Polyhedron(vertices, FACES + upper)
    report = cells.validity()
    assert report.found == {}
    assert report.components == 1
    assert report.back_to_back.tolist() == [6]
    assert set(report.noted) == {"non-manifold", "back-to-back"}
    # all faces of the upper cell but its wall: they agree with each other, not with the rest
    turned = Polyhedron(vertices, FACES + [upper[0]] + [face[::-1] for face in upper[1:]]).validity()
    assert list(turned.found) == ["flipped"]
    assert not len(turned.flipped_faces)
    assert "4 flipped edges, the first between vertices 4 and 5, near (0.5, 0, 1)" in str(turned)


def test_vertices_of_no_face_are_remarked():
    loose = Polyhedron(np.concatenate([CUBE, [[1e140, 0, 0]]]), FACES)
    assert loose.validity().valid
    assert "1 unused vertex, 8 at (1e+140, 0, 0)" in str(loose.validity())
    assert loose.properties().volume == 1.0


# kinds


def test_a_moebius_strip_is_said_to_be_one_sided():
    n = 12
    strip = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(n - 1)] + [[2 * n - 2, 1, 0, 2 * n - 1]]
    angle = np.arange(n) * 2 * np.pi / n
    across = np.stack([np.cos(angle / 2) * np.cos(angle), np.cos(angle / 2) * np.sin(angle), np.sin(angle / 2)], axis=1)
    middle = 3 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    vertices = np.stack([middle - across, middle + across], axis=1).reshape(-1, 3)
    report = Polyhedron(*joined((vertices, strip), moved(cube(), 9.0))).validity()
    assert report.one_sided.tolist() == [[0, n]]
    assert {"one-sided", "open"} <= set(report.found)
    assert "flipped" not in report.found
    assert report.holes == 1
    assert f"1 group, the one of face 0 ({n} faces) near" in str(report)


@pytest.mark.parametrize("depth", [1, 2, 3, 4])
def test_shells_in_shells_must_take_turns(depth):
    """Of nested cubes each even one must look outward, each odd one inward, in any order of faces."""
    sides = np.random.default_rng(depth).permutation(depth + 1)
    body = None
    for k in sides:
        one = moved(cube(10.0 - 2.0 * k), float(k))
        one = reversed_faces(one) if k % 2 else one
        body = one if body is None else joined(body, one)
    sound = Polyhedron(*body)
    assert sound.validity().found == {}
    assert sound.validity().bodies == depth // 2 + 1
    for place, k in enumerate(sides):
        faces = [face[::-1] if i // 6 == place else face for i, face in enumerate(body[1])]
        report = Polyhedron(body[0], faces).validity()
        assert list(report.found) == ["nested" if k % 2 else "inward"]
        assert (report.buried if k % 2 else report.inward).tolist() == [[6 * place, 6]]


def test_a_body_twice_with_vertices_of_its_own_counts_as_nested():
    assert "the one of face 6 (6 faces)" in refusal(Polyhedron(*joined(cube(), cube())))
    assert Polyhedron(*joined(gear_like(), gear_like())).validity().buried.tolist() == [[26, 26]]


def test_a_void_that_touches_the_wall_is_still_a_void():
    notch = joined(cube(3.0), moved(reversed_faces(cube()), [0.0, 1.0, 1.0]))
    assert Polyhedron(*notch).validity().found == {}
    assert Polyhedron(*notch).validity().bodies == 1
    outward = joined(cube(3.0), moved(cube(), [0.0, 1.0, 1.0]))
    assert list(Polyhedron(*outward).validity().found) == ["nested"]


def test_nothing_is_said_of_the_sense_of_a_void_whose_wall_has_a_hole():
    vertices, faces = joined(cube(3.0), moved(reversed_faces(cube()), 1.0))
    report = Polyhedron(vertices, faces[1:]).validity()
    assert list(report.found) == ["open"]
    assert report.bodies == 1


def test_chains_of_open_edges_are_counted_and_their_places_kept():
    report = Polyhedron(CUBE, FACES[2:]).validity()
    assert report.holes == 2
    assert len(report.edges.open) == 8
    assert "8 open edges, the first between vertices 0 and 1, near (0.5, 0, 0) in 2 chains" in str(report)


def test_faces_may_be_off_their_planes_as_far_as_the_file_rounds():
    bent = CUBE.copy()
    bent[6, 2] += 4e-4
    assert list(Polyhedron(bent, FACES).validity().found) == ["nonplanar"]
    assert Polyhedron(bent, FACES, rounding=1e-4).validity().valid
    assert list(Polyhedron(bent, FACES, rounding=1e-5).validity().found) == ["nonplanar"]
    larger = Polyhedron(bent, FACES, rounding=1e-4).transformed(np.diag([-1e3, 1e3, 1e3, 1.0]))
    assert larger.rounding == pytest.approx(0.1)
    assert larger.validity().valid
    assert Polyhedron.united([larger, Polyhedron(CUBE, FACES)]).rounding == larger.rounding
    far = np.round((bent - CUBE) * 0 + CUBE * 0.1 + 1e12, 3)
    assert Polyhedron(far + 0.0, FACES).validity().planarity >= 4e-4
    with pytest.raises(GeometryError, match="rounding = -1"):
        Polyhedron(CUBE, FACES, rounding=-1)


def test_roundings_of_files_reach_the_polyhedra(tmp_path):
    path = tmp_path / "cube.stl"
    Polyhedron(CUBE * 1000.0, FACES).save(path)
    single = np.spacing(np.float32(1000.0)) / 2.0
    assert Polyhedron.load(path).rounding == single
    assert [body.rounding for body in Model.load(path).bodies.values()] == [single]


# bodies apart


def test_bodies_come_apart_with_their_voids_in_the_order_of_first_faces():
    shelled = joined(star_shaped(4, 7), joined(moved(cube(3.0), 5.0), moved(reversed_faces(cube()), 6.0)))
    vertices, faces = joined(shelled, moved(gear_like(), [0, 0, -9.0]))
    mixed = np.random.default_rng(1).permutation(len(faces))
    whole = Polyhedron(vertices, [faces[i] for i in mixed])
    bodies = whole.bodies()
    volumes = [Polyhedron(*star_shaped(4, 7)).properties().volume, 26.0, Polyhedron(*gear_like()).properties().volume]
    starts = [0, len(star_shaped(4, 7)[1]), len(star_shaped(4, 7)[1]) + 12]
    first = [min(np.flatnonzero((mixed >= a) & (mixed < b))) for a, b in zip(starts, [*starts[1:], 999], strict=True)]
    assert [body.properties().volume for body in bodies] == pytest.approx([volumes[i] for i in np.argsort(first)])
    assert sum(len(body.vertices) for body in bodies) == len(vertices)
    assert whole.validity().components == 4
    np.testing.assert_array_equal(
        np.sort(np.concatenate([body.vertices for body in bodies]), axis=0), np.sort(vertices, axis=0)
    )


def test_a_single_body_is_itself():
    single = Polyhedron(CUBE, FACES)
    assert single.bodies() == (single,)


# an answer all the same


def test_names_that_are_no_kinds_are_refused_with_the_list():
    for wrong in (("holes",), ("flat",), "open"):
        with pytest.raises(ValueError, match="some of open, flipped, one-sided, repeated, inward, nested, nonplanar"):
            Polyhedron(CUBE, FACES).properties(allow=wrong)


def test_every_problem_that_is_not_allowed_is_refused_with_the_way_out():
    bent = CUBE.copy()
    bent[6, 2] += 0.1
    broken = Polyhedron(bent, FACES[1:])
    with pytest.raises(GeometryError, match=r'properties\(allow=\("open", "nonplanar",\)\)'):
        broken.properties()
    with pytest.raises(GeometryError, match=r'allow=\("open", "nonplanar",\)') as caught:
        broken.properties(allow=("open",))
    assert "open edge" not in str(caught.value)
    assert len(broken.properties(allow=("nonplanar", "open")).warnings) == 2


def test_an_allowed_hole_is_closed_towards_the_centre_of_the_box():
    """The missing side of a cube leaves out its pyramid: a sixth, whose moments are known."""
    found = Polyhedron(CUBE, FACES[1:]).properties(allow=("open",))
    missing_side = Polyhedron(CUBE, FACES).properties()
    pyramid = Polyhedron(
        np.concatenate([CUBE[:4], [[0.5, 0.5, 0.5]]]), [FACES[0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    )
    left = missing_side - pyramid.properties()
    assert found.volume == pytest.approx(left.volume, rel=1e-14)
    np.testing.assert_allclose(found.centroid, left.centroid, rtol=1e-14)
    np.testing.assert_allclose(found.central_second, left.central_second, atol=1e-15)
    assert found.area == pytest.approx(5.0)
    (warning,) = found.warnings
    assert "4 open edges" in warning
    assert "another point would give another volume" in warning
    away = Polyhedron(CUBE + 1e3, FACES[1:]).properties(allow=("open",))
    assert away.volume == pytest.approx(left.volume, rel=1e-12)


@pytest.mark.parametrize(("kind", "times"), [("open", 1), ("flipped", 2)])
def test_the_centre_of_the_box_stays_the_centre_where_the_terms_cancel(kind, times):
    """Of bodies far apart moments are taken about the centroid, where the closing triangles count."""
    vertices, faces = joined(cube(), moved(cube(3.0), [20.0, 0, 0]))
    side = faces.pop(2)  # at y = 0; the centre is at y = 1.5
    assert np.all(vertices[side, 1] == 0.0)
    found = Polyhedron(vertices, faces + ([side[::-1]] if kind == "flipped" else [])).properties(allow=(kind,))
    assert found.volume == pytest.approx(28.0 - times * 1.5 / 3.0, rel=1e-12)


def test_what_is_left_without_a_volume_is_refused_though_allowed():
    with pytest.raises(GeometryError, match="must be positive"):
        Polyhedron(CUBE, [[0, 1, 2]]).properties(allow=("open",))
    round_about = Polyhedron(CUBE, [face[::-1] for face in FACES]).properties(2.0, allow=("inward",))
    np.testing.assert_allclose(round_about.central_inertia, np.eye(3) / 3, atol=1e-15)
    assert round_about.mass == pytest.approx(2.0)
    assert round_about.error_bound == np.inf
    opposed = joined(cube(), moved(reversed_faces(cube()), 5.0))
    with pytest.raises(GeometryError, match="must be positive"):
        Polyhedron(*opposed).properties(allow=("inward",))
    far = joined(cube(3.0), moved(reversed_faces(cube()), 9.0))
    with pytest.raises(GeometryError, match="at most the sum of the other two"):
        Polyhedron(*far).properties(allow=("inward",))


def test_allowed_flips_bodies_inward_and_bodies_twice_count_as_they_are():
    flipped = Polyhedron(CUBE, [FACES[0][::-1], *FACES[1:]]).properties(allow=("flipped",))
    assert flipped.volume == pytest.approx(1.0 - 2.0 / 6.0)
    inward = joined(cube(3.0), moved(reversed_faces(cube()), [3.5, 1.0, 1.0]))
    assert Polyhedron(*inward).properties(allow=("inward",)).volume == pytest.approx(26.0)
    nested = joined(cube(3.0), moved(cube(), 1.0))
    assert Polyhedron(*nested).properties(allow=("nested",)).volume == pytest.approx(28.0)
    twice = Polyhedron(CUBE, FACES + FACES).properties(allow=("repeated",))
    assert twice.volume == pytest.approx(2.0)


def test_an_allowed_warped_face_is_the_fan_from_the_mean_of_its_corners():
    bent = CUBE.copy()
    bent[6, 2] += 0.3
    found = Polyhedron(bent, FACES).properties(allow=("nonplanar",))
    centre = bent[FACES[1]].mean(axis=0)
    fan = [[a, b, 8] for a, b in zip(FACES[1], FACES[1][1:] + FACES[1][:1], strict=True)]
    cut = Polyhedron(np.concatenate([bent, [centre]]), [FACES[0], *fan, *FACES[2:]]).properties()
    assert found.volume == pytest.approx(cut.volume, rel=1e-14)
    assert found.area == pytest.approx(cut.area, rel=1e-14)
    np.testing.assert_allclose(found.central_second, cut.central_second, rtol=1e-13)
    # nothing depends on the corner that the face begins with, as it would in a fan from there
    for turn in range(4):
        turned = [FACES[0], FACES[1][turn:] + FACES[1][:turn], *FACES[2:]]
        assert Polyhedron(bent, turned).properties(allow=("nonplanar",)).volume == pytest.approx(
            found.volume, rel=1e-14
        )


def test_warnings_stay_with_what_is_made_of_the_properties():
    sound, holed = Polyhedron(CUBE, FACES).properties(), Polyhedron(CUBE, FACES[1:]).properties(allow=("open",))
    for made in (sound + holed, holed + sound, sound - holed, holed + holed, holed.moved(np.eye(3), [1, 2, 3])):
        assert made.warnings == holed.warnings
        assert made.to_dict()["warnings"] == list(holed.warnings)
    assert (sound + sound).warnings == ()


def test_allowing_what_is_not_there_changes_nothing():
    everything = Polyhedron(CUBE, FACES).properties(allow=PROBLEM_KINDS)
    assert everything.warnings == ()
    assert everything.volume == mass_properties(CUBE, FACES)[0]


def test_every_kind_says_what_mends_it_and_what_allowing_it_means():
    for kind in PROBLEM_KINDS:
        assert PROBLEMS[kind].allowed
        assert PROBLEMS[kind].mends
    assert all(text.mends for text in REMARKS.values())


def test_the_dictionary_names_kinds_and_counts():
    found = Polyhedron(CUBE, [FACES[0][::-1], *FACES[1:]]).validity().to_dict()
    assert found["kinds"] == ["flipped"]
    assert (found["flipped_faces"], found["flipped_edges"], found["open_edges"], found["holes"]) == (1, 4, 0, 0)
    assert (found["components"], found["bodies"]) == (1, 1)
