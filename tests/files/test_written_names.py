"""Names and units in files that are written, however odd."""

import re

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import FileError, ParameterError
from gearwright.files.assembly import Assembly, Part, Smooth
from gearwright.files.step.writer import write as write_step
from gearwright.solids.model import Model

from ..cli.bodies import CORNERS, FACES

BOX = gw.Polyhedron(CORNERS, FACES)


def test_bodies_of_an_obj_keep_names_of_their_own(tmp_path):
    names = ["bolt 1", "bolt  1", "nut ", "nut", "back\\", "line\nend"]
    bodies = dict.fromkeys(names, BOX)
    Model(bodies=bodies, length_unit="mm").save(tmp_path / "a.obj")
    found = Model.load(tmp_path / "a.obj").bodies
    assert list(found) == ["bolt 1", "bolt 1 (2)", "nut", "nut (2)", "back?", "line end"]
    assert all(len(body.vertices) == len(CORNERS) for body in found.values())


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".off", ".glb", ".3mf", ".step"])
def test_units_that_are_none_are_refused(tmp_path, suffix):
    with pytest.raises(FileError, match=r"length_unit = 'furlong': choose one of um, mm, cm, m, in, ft"):
        gw.extrude(gw.Section.circle(1.0), 2.0).save(tmp_path / f"a{suffix}", length_unit="furlong")
    assert not list(tmp_path.iterdir())


def test_letters_beyond_ascii_in_step(tmp_path):
    name = "Zahnrad für 齿轮 😀\x01"
    solid = gw.extrude(gw.Section.circle(1.0), 2.0)
    part = Part(name=name, shape=Smooth(boundary=solid.boundary, tolerance=1e-6))
    write_step(tmp_path / "a.step", Assembly(name=name, parts=(part,)))
    data = (tmp_path / "a.step").read_bytes()
    assert data.isascii()
    assert re.search(rb"PRODUCT\('Zahnrad f\\X2\\00FC\\X0\\r \\X2\\9F7F8F6E\\X0\\ \\X2\\D83DDE00\\X0\\\?'", data)
    assert list(Model.load(tmp_path / "a.step").bodies) == ["Zahnrad für 齿轮 😀?"]


@pytest.mark.parametrize("label", [{"name": "齿轮"}, {"notes": ["first\nsecond"]}, {"date": "a\tb"}, {"name": 5}])
def test_labels_that_a_sheet_cannot_show_are_refused(tmp_path, label):
    gear = gw.SpurGear(teeth=12, module=2, face_width=5)
    for suffix in (".svg", ".dxf", ".pdf"):
        with pytest.raises(ParameterError, match=rf"{next(iter(label))}.* = "):
            gear.save_sheet(tmp_path / f"a{suffix}", gw.SheetLabels(**label))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("turn", [np.nan, np.inf])
def test_turns_that_are_none_are_refused(tmp_path, turn):
    pair = gw.GearPair(kind="spur", teeth=(12, 15), module=2, face_width=5)
    for suffix in (".glb", ".step", ".obj"):
        with pytest.raises(ParameterError, match="a finite angle in degrees is needed"):
            pair.save(tmp_path / f"a{suffix}", turn=turn)
    assert not list(tmp_path.iterdir())


def test_a_rack_is_not_left_where_its_joint_cannot_be(tmp_path):
    pair = gw.GearPair(kind="rack", teeth=(17, 30), module=2, face_width=10)
    with pytest.raises(ParameterError, match=r"turn = 400: the gear meshes from -3\d\d.\d* to 3\d\d"):
        pair.save(tmp_path / "r.xml", 0.5, density="steel", turn=400)
    assert not list(tmp_path.iterdir())
