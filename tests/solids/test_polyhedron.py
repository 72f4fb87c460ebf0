"""Polyhedra: what is refused and in which words, validity, transformation, files."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.errors import FileError, GeometryError
from gearwright.solids.polyhedron import Polyhedron

CUBE = np.array([[x, y, z] for z in (0.0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
FACES = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def cubes(*bodies):
    """Several cubes (low corner, side, sense) in one polyhedron."""
    vertices = np.concatenate([CUBE * side + np.asarray(low) for low, side, _ in bodies])
    faces = [[i + 8 * k for i in face[::sense]] for k, (_, _, sense) in enumerate(bodies) for face in FACES]
    return Polyhedron(vertices, faces)


def problems(polyhedron):
    with pytest.raises(GeometryError) as caught:
        polyhedron.properties()
    return str(caught.value)


def test_properties_of_a_cube():
    body = Polyhedron(CUBE, FACES).properties(2.0)
    assert (body.volume, body.mass, body.area, body.method) == (1.0, 2.0, 6.0, "polyhedron")
    np.testing.assert_allclose(body.central_inertia, np.eye(3) / 3, atol=1e-16)
    np.testing.assert_array_equal(body.bounding_box, [[0, 0, 0], [1, 1, 1]])
    assert body.error_bound < 1e-14


def test_faces_and_arrays():
    given = np.array(FACES)
    polyhedron = Polyhedron(CUBE, given)
    np.testing.assert_array_equal(polyhedron.faces, FACES)
    assert polyhedron.triangles().shape == (12, 3)
    mixed = Polyhedron(CUBE, [[0, 1, 2], [0, 1, 2, 3]])
    assert [face.tolist() for face in mixed.faces] == [[0, 1, 2], [0, 1, 2, 3]]
    with pytest.raises(ValueError, match="read-only"):
        polyhedron.vertices[0, 0] = 3
    given[0, 0] = 5  # what was given stays the caller's
    assert polyhedron.faces[0, 0] == 3
    assert Polyhedron([], []).faces == ()


@pytest.mark.parametrize(
    ("vertices", "faces", "said"),
    [
        (CUBE, [[0, 1, 8]], "vertex number 8 in face 0: there are vertices 0 to 7; lists that count from 1"),
        (CUBE, [[0, 1, 2], [0, -1, 2]], "vertex number -1 in face 1"),
        (CUBE, [[0, 1, 2], [0, 1]], "face 1 of 2 corners: at least 3"),
        (CUBE, [[0, 1, 2], []], "face 1 of 0 corners"),
        (CUBE, np.zeros((3, 2), int), "face 0 of 2 corners and 2 more"),
        (CUBE, [[0, 1, 2.0]], "whole numbers"),
        (CUBE, 7, "lists of vertex numbers"),
        (CUBE, "abc", "whole numbers"),
        (CUBE[:, :2], [[0, 1, 2]], r"vertices of shape \(8, 2\)"),
        ([[0, 0, 0], [1, 1]], [[0, 1, 2]], r"an array \(n, 3\) of numbers"),
        ("abc", [[0, 1, 2]], r"an array \(n, 3\) of numbers"),
        (np.where(CUBE == 1, np.nan, CUBE), FACES, "vertex 1 = .*nan.* and 6 more: coordinates must be finite"),
    ],
)
def test_what_is_no_polyhedron_is_refused(vertices, faces, said):
    with pytest.raises(GeometryError, match=said):
        Polyhedron(vertices, faces)


def test_all_problems_are_named_together():
    vertices = CUBE.copy()
    vertices[3, 1] = np.inf
    with pytest.raises(GeometryError) as caught:
        Polyhedron(vertices, [[0, 1], [0, 1, 99]])
    assert len(caught.value.problems) == 3


def test_an_open_boundary_is_refused_with_its_place():
    text = problems(Polyhedron(CUBE, FACES[1:]))
    assert "4 open edges, the first between vertices 0 and 1, near (0.5, 0, 0)" in text
    assert "missing faces" in text
    assert Polyhedron(CUBE, FACES[1:]).validity().closure == pytest.approx(0.2)


def test_unshared_vertices_are_an_open_boundary():
    loose = Polyhedron(CUBE[np.array(FACES)].reshape(-1, 3), np.arange(24).reshape(6, 4))
    assert "24 open edges" in problems(loose)


def test_a_flipped_face_is_named():
    text = problems(Polyhedron(CUBE, [FACES[0][::-1], *FACES[1:]]))
    assert "1 face, 0 near (0.5, 0.5, 0), flipped" in text
    assert "open edge" not in text


def test_an_inward_body_is_refused_with_the_way_out():
    text = problems(cubes(((0, 0, 0), 1, -1)))
    assert "1 component, the one of face 0 (6 faces) near (0.5, 0.5, 0), turned inward" in text
    assert "faces[:, ::-1]" in text


def test_one_inward_body_of_two_is_found_though_the_volume_is_positive():
    text = problems(cubes(((0, 0, 0), 3, 1), ((5, 0, 0), 1, -1)))
    assert "1 component, the one of face 6 (6 faces) near (5.5, 0.5, 0), turned inward" in text


def test_a_void_must_be_reversed():
    assert cubes(((0, 0, 0), 3, 1), ((1, 1, 1), 1, -1)).properties().volume == pytest.approx(26)
    assert "face 6 (6 faces) near (1.5, 1.5, 1), outward but inside another" in problems(
        cubes(((0, 0, 0), 3, 1), ((1, 1, 1), 1, 1))
    )


def test_a_body_in_a_void_is_right():
    nested = cubes(((2, 2, 2), 1, 1), ((0, 0, 0), 5, 1), ((1, 1, 1), 3, -1))
    assert nested.properties().volume == pytest.approx(125 - 27 + 1)
    assert nested.validity().components == 3


def test_a_body_in_the_bounding_box_of_another_but_outside_it_is_right():
    corners = np.array([[0.0, 0], [4, 0], [4, 1], [1, 1], [1, 4], [0, 4]])
    ell = np.concatenate([np.column_stack([corners, np.full(6, z)]) for z in (0.0, 4.0)])
    walls = [[i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i] for i in range(6)]
    faces = [[5, 4, 3, 2, 1, 0], list(range(6, 12)), *walls, *([i + 12 for i in face] for face in FACES)]
    assert Polyhedron(np.concatenate([ell, CUBE + 2]), faces).properties().volume == pytest.approx(29)


def test_bodies_that_touch_along_an_edge_are_right_but_remarked():
    shared = {tuple(v): i for i, v in enumerate(CUBE)}
    vertices, second = list(CUBE), []
    for vertex in CUBE + np.array([1, 1, 0]):
        if tuple(vertex) not in shared:
            shared[tuple(vertex)] = len(vertices)
            vertices.append(vertex)
        second.append(shared[tuple(vertex)])
    touching = Polyhedron(vertices, [*FACES, *([second[i] for i in face] for face in FACES)])
    assert touching.properties().volume == pytest.approx(2)
    report = touching.validity()
    assert report.valid
    assert report.edges.non_manifold.tolist() == [[2, 6]]
    assert [body.properties().volume for body in touching.bodies()] == [1.0, 1.0]
    assert "non-manifold" in str(report)


def test_degenerate_faces_are_remarked_and_harmless():
    collapsed = Polyhedron(CUBE, [*FACES, [0, 0, 1], [2, 3, 2], [4, 4, 4]])
    assert collapsed.properties().volume == 1
    assert collapsed.validity().degenerate_faces.tolist() == [6, 7, 8]
    assert not len(collapsed.validity().edges.non_manifold)
    assert set(collapsed.validity().noted) == {"degenerate"}
    doubled = Polyhedron(CUBE, [[3, 3, 2, 1, 0], *FACES[1:]])
    assert doubled.validity().degenerate_faces.tolist() == [0]
    assert set(doubled.validity().noted) == {"degenerate"}
    again = Polyhedron(CUBE, [FACES[0], [4, 5, 6, 7, 4], *FACES[2:]])
    assert again.validity().degenerate_faces.tolist() == [1]
    assert set(again.validity().noted) == {"degenerate"}
    assert Polyhedron(CUBE, [[3, 3, 2, 1, 0], *FACES[1:]]).properties().volume == 1


def test_a_warped_face_is_refused():
    warped = CUBE.copy()
    warped[6, 2] = 1.01
    text = problems(Polyhedron(warped, FACES))
    assert "1 face, 1 near (0.5, 0.5, 1.0025), not planar, up to 0.0025 off; 1.7e-06 is accepted" in text
    assert "split it into triangles" in text
    triangles = Polyhedron(warped, Polyhedron(warped, FACES).triangles())
    assert triangles.properties().volume == pytest.approx(1 + 0.01 / 3, rel=1e-3)


def test_flat_and_empty_polyhedra_are_refused():
    assert "0 faces" in problems(Polyhedron([], []))
    assert "volume 0" in problems(Polyhedron(CUBE, [[0, 1, 2], [2, 1, 0]]))


def test_report_as_text_and_dictionary():
    report = Polyhedron(CUBE, FACES).validity()
    assert report.valid
    assert report.closed
    assert str(report).startswith("valid")
    broken = Polyhedron(CUBE, FACES[1:]).validity().to_dict()
    assert broken["open_edges"] == 4
    assert not broken["valid"]


def test_transformed():
    matrix = np.array([[2.0, 0, 0, 5], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    body = Polyhedron(CUBE, FACES).transformed(matrix).properties()
    assert body.volume == pytest.approx(2)
    np.testing.assert_allclose(body.centroid, [6, -0.5, 0.5])


@pytest.mark.parametrize("faces", [FACES, [[3, 2, 1], [3, 1, 0], *FACES[1:]]])
def test_mirrored_bodies_stay_outward(faces):
    mirrored = Polyhedron(CUBE, faces).transformed(np.diag([-1.0, 1, 1, 1])).properties()
    assert mirrored.volume == pytest.approx(1)
    assert mirrored.centroid[0] == pytest.approx(-0.5)


@pytest.mark.parametrize(
    "matrix",
    [np.eye(3), np.diag([1, 1, 0, 1]), np.diag([1, 1, 1, 2]), np.eye(4).T + np.eye(4, k=-3), np.eye(4) * np.nan],
)
def test_other_matrices_are_refused(matrix):
    with pytest.raises(GeometryError, match="columns"):
        Polyhedron(CUBE, FACES).transformed(matrix)


def test_saved_and_loaded(tmp_path):
    path = tmp_path / "cube.STL"
    Polyhedron(CUBE, FACES).save(path)
    assert Polyhedron.load(path).properties().volume == 1
    (tmp_path / "cube").touch()
    for name in ("cube.xyz", "cube"):
        with pytest.raises(FileError, match=r"known suffixes: \.stl"):
            Polyhedron(CUBE, FACES).save(tmp_path / name)
        with pytest.raises(FileError, match=r"known suffixes: \.stl"):
            Polyhedron.load(tmp_path / name)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["cube", "cube.STL"]


def test_a_face_seen_whole_from_one_corner_only_is_written_without_overlaps(tmp_path):
    dart = np.array([[2.0, 0], [0, 1], [0.5, 0], [0, -1]])  # all of it is seen from corners 0 and 2
    for first in range(4):
        corners = np.roll(dart, first, axis=0)
        vertices = np.concatenate([np.column_stack([corners, np.full(4, z)]) for z in (0.0, 1.0)])
        Polyhedron(vertices, FACES).save(tmp_path / "dart.stl")
        loaded = Polyhedron.load(tmp_path / "dart.stl")
        assert loaded.properties().area == pytest.approx(Polyhedron(vertices, FACES).properties().area, rel=1e-6)


def test_a_face_no_corner_sees_whole_is_not_written(tmp_path):
    angle = np.arange(10) * np.pi / 5
    star = np.stack([np.cos(angle), np.sin(angle)], axis=1) * np.where(np.arange(10) % 2, 0.3, 1.0)[:, None]
    vertices = np.concatenate([np.column_stack([star, np.full(10, z)]) for z in (0.0, 1.0)])
    walls = [[i, (i + 1) % 10, 10 + (i + 1) % 10, 10 + i] for i in range(10)]
    polyhedron = Polyhedron(vertices, [list(range(10))[::-1], list(range(10, 20)), *walls])
    assert polyhedron.properties().volume == pytest.approx(10 * 0.5 * 0.3 * np.sin(np.pi / 5))
    with pytest.raises(GeometryError, match="split it into convex faces"):
        polyhedron.save(tmp_path / "star.stl")
    assert not list(tmp_path.iterdir())


def test_repeated_faces_are_refused():
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    turned = [[2, 1, 0], [1, 3, 0], [3, 1, 2], [3, 2, 0]]
    assert Polyhedron(corners, faces).properties().volume == pytest.approx(1.0 / 6.0)
    with pytest.raises(
        GeometryError,
        match=r"4 faces, the first 4 near \(0.333333, 0.333333, 0\), repeated: .* their volume counts twice",
    ):
        Polyhedron(corners, faces + turned).properties()


def test_two_bodies_that_share_a_face_from_both_sides_are_one_of_their_sum():
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]]
    upper = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    lower = [[0, 1, 2], [0, 4, 1], [1, 4, 2], [0, 2, 4]]
    assert Polyhedron(corners, upper + lower).properties().volume == pytest.approx(1.0 / 3.0)
