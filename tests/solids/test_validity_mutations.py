"""Sound polyhedra broken in one way: it is found, under its name and at its place, and the sound ones are clean."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gearwright.errors import GeometryError
from gearwright.moments.components import winding_number
from gearwright.solids.polyhedron import Polyhedron

from .broken import shell_of, sound_bodies

SETTINGS = settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])


def choice(data, count):
    return data.draw(st.integers(0, count - 1))


def edges_of(face):
    return {tuple(sorted(edge)) for edge in zip(face, [*face[1:], face[0]], strict=True)}


def refused(vertices, faces):
    with pytest.raises(GeometryError) as caught:
        Polyhedron(vertices, faces).properties()
    return str(caught.value)


def said_only(vertices, faces, *kinds):
    """The report, after seeing that it names these kinds of problems and no others, and that properties are refused."""
    report = Polyhedron(vertices, faces).validity()
    assert set(report.found) == set(kinds)
    assert refused(vertices, faces).count("\n") == len(kinds) + 1
    return report


@SETTINGS
@given(sound_bodies())
def test_sound_bodies_are_clean(body):
    report = Polyhedron(*body).validity()
    assert report.found == {}
    assert report.noted == {}
    assert report.closure < 1e-12
    assert Polyhedron(*body).properties().warnings == ()


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_flipped_face(body, data):
    vertices, faces = body
    face = choice(data, len(faces))
    faces[face] = faces[face][::-1]
    report = said_only(vertices, faces, "flipped")
    assert report.flipped_faces.tolist() == [face]
    assert set(map(tuple, report.edges.flipped.tolist())) == edges_of(faces[face])
    assert f"1 face, {face} near (" in str(report)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_missing_face(body, data):
    vertices, faces = body
    face = faces.pop(choice(data, len(faces)))
    report = said_only(vertices, faces, "open")
    assert set(map(tuple, report.edges.open.tolist())) == edges_of(face)
    assert report.holes == 1
    assert f"{len(face)} open edges, the first between vertices" in str(report)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_repeated_face_however_its_corners_begin(body, data):
    vertices, faces = body
    chosen, turn = choice(data, len(faces)), choice(data, 5)
    again = faces[chosen]
    faces.append(again[turn % len(again) :] + again[: turn % len(again)])
    report = said_only(vertices, faces, "repeated", "open")
    assert report.duplicates.tolist() == [len(faces) - 1]
    assert set(map(tuple, report.edges.open.tolist())) == edges_of(again)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_wall_without_thickness_is_remarked(body, data):
    vertices, faces = body
    face = faces[choice(data, len(faces))]
    whole = Polyhedron(vertices, faces).properties().volume
    report = Polyhedron(vertices, [*faces, face, face[::-1]]).validity()
    assert "repeated" in report.found
    # a wall of corners that no other face joins in this order: two faces of its own
    apart = Polyhedron(
        np.concatenate([vertices, vertices[face[:3]] * 1.01]),
        [
            *faces,
            list(range(len(vertices), len(vertices) + 3)),
            list(range(len(vertices), len(vertices) + 3))[::-1],
        ],
    )
    assert apart.validity().found == {}
    assert apart.validity().back_to_back.tolist() == [len(faces) + 1]
    assert apart.properties().volume == pytest.approx(whole, rel=1e-12)


@SETTINGS
@given(sound_bodies(), st.data(), st.sampled_from([np.nan, np.inf, -np.inf]))
def test_a_coordinate_that_is_not_finite(body, data, value):
    vertices, faces = body
    vertex = choice(data, len(vertices))
    vertices[vertex, choice(data, 3)] = value
    assert f"vertex {vertex} = [" in refused(vertices, faces)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_vertex_number_out_of_range(body, data):
    vertices, faces = body
    face = choice(data, len(faces))
    wrong = data.draw(st.sampled_from([-1, -len(vertices), len(vertices), 2**40]))
    faces[face][choice(data, len(faces[face]))] = wrong
    assert f"vertex number {wrong} in face {face}: there are vertices 0 to {len(vertices) - 1}" in refused(
        vertices, faces
    )


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_component_turned_inside_out(body, data):
    """Bodies, and bodies in voids, become inward; voids become outward in another."""
    vertices, faces = body
    shell = shell_of(faces, choice(data, len(faces)))
    void = _volume(vertices, faces, shell) < 0.0
    for face in shell:
        faces[face] = faces[face][::-1]
    report = said_only(vertices, faces, "nested" if void else "inward")
    assert (report.buried if void else report.inward).tolist() == [[shell[0], len(shell)]]
    assert f"the one of face {shell[0]} ({len(shell)} faces)" in str(report)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_body_buried_in_another(body, data):
    """A small tetrahedron near a corner, within: turned outward it counts twice, turned inward it is a void."""
    vertices, faces = body
    outward = [shell for shell in _shells(faces) if _volume(vertices, faces, shell) > 0.0]
    shell = outward[choice(data, len(outward))]
    chosen = max((faces[f] for f in shell), key=lambda face: _area(vertices[face]))
    a, b, c = vertices[chosen[:3]]
    normal = _normal(vertices[chosen])
    inside = a + 0.4 * (b - a) + 0.02 * (c - b)
    size = 1e-4 * np.linalg.norm(b - a)
    low = inside - 3.0 * size * normal
    tetrahedron = low + size * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    its = [[i + len(vertices) for i in face] for face in ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3])]
    points = np.concatenate([vertices, tetrahedron])
    whole = Polyhedron(vertices, faces)
    if round(winding_number(low, vertices, whole.triangles())) == 0:
        # the triangle of the face's first corners is not all on the face, or the body is thinner there
        assert Polyhedron(points, faces + its).validity().found == {}
        return
    report = said_only(points, faces + its, "nested")
    assert report.buried.tolist() == [[len(faces), 4]]
    void = Polyhedron(points, faces + [face[::-1] for face in its])
    assert void.validity().found == {}
    assert void.validity().bodies == len(outward)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_corner_moved_off_its_plane(body, data):
    vertices, faces = body
    quads = [f for f, face in enumerate(faces) if len(face) > 3]
    if not quads:
        return
    face = quads[choice(data, len(quads))]
    vertex = faces[face][choice(data, len(faces[face]))]
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    accepted = Polyhedron(vertices, faces).validity().planarity
    nudged, bent = vertices.copy(), vertices.copy()
    nudged[vertex] += 0.1 * accepted * _normal(vertices[faces[face]])
    bent[vertex] += 1e-3 * diagonal * _normal(vertices[faces[face]])
    assert Polyhedron(nudged, faces).validity().valid
    report = Polyhedron(bent, faces).validity()
    assert set(report.found) == {"nonplanar"}
    assert face in report.nonplanar_faces
    assert all(vertex in faces[f] for f in report.nonplanar_faces)
    assert report.deviation == report.deviations.max()
    assert 1e-5 * diagonal < report.deviation <= 1e-3 * diagonal
    assert f"{report.nonplanar_faces[0]} near (" in str(report)


@SETTINGS
@given(sound_bodies(), st.data())
def test_a_shared_vertex_split_by_the_last_digit(body, data):
    vertices, faces = body
    face = choice(data, len(faces))
    corner = choice(data, len(faces[face]))
    vertex = faces[face][corner]
    faces[face][corner] = len(vertices)
    vertices = np.concatenate([vertices, np.nextafter(vertices[vertex], np.inf)[None]])
    report = said_only(vertices, faces, "open")
    assert all({vertex, len(vertices) - 1} & set(edge) for edge in report.edges.open.tolist())
    assert len(report.edges.open) == 4
    assert report.holes == 1


def _normal(points):
    vector = sum(np.cross(points[i] - points[0], points[i + 1] - points[0]) for i in range(1, len(points) - 1))
    return vector / np.linalg.norm(vector)


def _area(points):
    return np.linalg.norm(np.cross(points[1] - points[0], points[2] - points[0]))


def _volume(vertices, faces, chosen):
    """Sign of the volume of a shell, by tetrahedra from one of its corners."""
    first = vertices[faces[chosen[0]][0]]
    fans = ((faces[f][0], faces[f][k], faces[f][k + 1]) for f in chosen for k in range(1, len(faces[f]) - 1))
    return sum(np.linalg.det(vertices[list(fan)] - first) for fan in fans)


def _shells(faces):
    left, result = set(range(len(faces))), []
    while left:
        result.append(shell_of(faces, min(left)))
        left -= set(result[-1])
    return result
