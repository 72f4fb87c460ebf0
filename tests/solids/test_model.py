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


def test_pieces_of_one_boundary_close_when_they_are_joined():
    model = Model.of(Contents(bodies=(body("a", FACES[:3]), body("b", FACES[3:])), length_unit="in", remarks=("so",)))
    assert (model.length_unit, model.remarks, list(model.bodies)) == ("in", ("so",), ["a", "b"])
    assert not model.polyhedron.validity().closed
    assert model.joined.properties().volume == 1.0
    assert len(model.joined.vertices) == 8


def test_corners_apart_stay_apart():
    model = Model.of(Contents(bodies=(body("", FACES), body("", FACES, [1.0 + 1e-15, 0, 0]))))
    assert list(model.bodies) == ["body 1", "body 2"]
    assert len(model.joined.vertices) == 16
