"""build123d reads the STEP files, and takes the shapes themselves as its own."""

import build123d
import pytest

from gearwright.colours import BRASS, STEEL

from .page import assert_section_prints_what_stands_below
from .parts import DRILLINGS, PARTS, built, solids
from .quadrature import volume

RELATIVE = 1e-7


@pytest.mark.parametrize("name", PARTS)
def test_a_step_file_holds_the_solids_with_their_volumes(name, tmp_path):
    built(name).save(tmp_path / "part.step")
    found = build123d.import_step(tmp_path / "part.step").solids()
    wanted = solids(name)
    assert len(found) == len(wanted)
    for one, exact in zip(found, wanted, strict=True):
        assert one.is_valid
        assert volume(one.wrapped) == pytest.approx(exact.volume, rel=RELATIVE)
        assert one.volume == pytest.approx(exact.volume, rel=RELATIVE)


def test_names_and_colours_of_a_pair(tmp_path):
    built("spiral bevel pair").save(tmp_path / "crossed.step")
    pair = build123d.import_step(tmp_path / "crossed.step")
    assert pair.label == "crossed"
    assert [one.label for one in pair.children] == ["pinion", "gear"]
    for one, colour in zip(pair.children, (BRASS, STEEL), strict=True):
        assert tuple(one.color)[:3] == pytest.approx(colour, abs=1e-6)


def test_a_part_alone_has_the_name_of_its_file(tmp_path):
    built("cam").save(tmp_path / "disk.step")
    assert build123d.import_step(tmp_path / "disk.step").label == "disk"


@pytest.mark.parametrize("drilling", DRILLINGS, ids=lambda one: one.part)
def test_a_shape_is_drilled(drilling):
    solid = build123d.Solid(drilling.element.to_ocp())
    hole = build123d.Solid.make_cylinder(
        drilling.diameter / 2, drilling.high - drilling.low, build123d.Plane((*drilling.place, drilling.low))
    )
    left = solid - hole
    assert len(left.solids()) == 1
    assert left.is_valid
    assert volume(left.solids()[0].wrapped) == pytest.approx(drilling.left, rel=RELATIVE)


def test_the_page_prints_what_stands_below(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_section_prints_what_stands_below("build123d", capsys)
