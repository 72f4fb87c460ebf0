"""Bodies of a file, apart, together and joined."""

import numpy as np

from gearwright.files.contents import Body, Contents
from gearwright.moments.faces import corner_lists
from gearwright.solids.model import Model

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def body(name, faces, at=(0, 0, 0)):
    indices, offsets = corner_lists(faces)
    return Body(name=name, vertices=CORNERS + np.array(at, float), indices=indices, offsets=offsets)


def model(*bodies, **more):
    return Model.of(Contents(bodies=bodies, **more))


def test_pieces_of_one_boundary_are_one_body():
    pieces = model(body("a", FACES[:3]), body("b", FACES[3:]), length_unit="in", remarks=("so",))
    assert (pieces.length_unit, pieces.remarks, list(pieces.bodies)) == ("in", ("so",), ["a", "b"])
    assert not pieces.polyhedron.validity().closed
    found = pieces.sound
    assert list(found.bodies) == ["a, b"]
    assert found.bodies["a, b"].properties().volume == 1.0
    assert len(found.polyhedron.vertices) == 8
    assert found.remarks == ("so", "its 2 bodies bound a solid only together and are taken as one")


def test_a_void_of_its_own_belongs_to_the_body_around_it():
    half = Body(**{**vars(body("void", [f[::-1] for f in FACES])), "vertices": CORNERS / 2 + 0.25})
    found = model(body("skin", FACES), half).sound
    assert found.bodies["skin, void"].properties().volume == 1.0 - 0.125


def test_corners_written_anew_are_joined_where_only_that_closes_a_body():
    corners = np.concatenate([CORNERS[face] for face in FACES])
    anew = Body(name="anew", vertices=corners, indices=np.arange(24), offsets=np.arange(0, 25, 4), rounding=1e-9)
    whole = body("whole", FACES, [3, 0, 0])
    found = model(anew, whole).sound
    assert found.bodies["anew"].properties().volume == 1.0
    assert found.bodies["anew"].rounding == 1e-9
    assert len(found.bodies["anew"].vertices) == 8
    assert found.remarks == ("anew closes only with its corners at equal coordinates joined",)
    assert found.bodies["whole"].properties().volume == 1.0


def test_what_closes_stays_as_it_stands():
    apart = model(body("", FACES), body("", FACES, [1.0 + 1e-15, 0, 0]))
    assert list(apart.bodies) == ["body 1", "body 2"]
    assert apart.sound is apart
    open_ = model(body("", FACES[1:]))
    assert open_.sound is open_
    assert len(apart.polyhedron.vertices) == 16
