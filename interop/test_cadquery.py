"""CadQuery reads the STEP files, and takes the shapes themselves as its own."""

import cadquery
import pytest

from gearwright.colours import BRASS, STEEL

from .page import assert_section_prints_what_stands_below
from .parts import DRILLINGS, PARTS, built, solids
from .quadrature import volume

RELATIVE = 1e-7


@pytest.mark.parametrize("name", PARTS)
def test_a_step_file_holds_the_solids_with_their_volumes(name, tmp_path):
    built(name).save(tmp_path / "part.step")
    found = cadquery.importers.importStep(str(tmp_path / "part.step")).solids().vals()
    wanted = solids(name)
    assert len(found) == len(wanted)
    for one, exact in zip(found, wanted, strict=True):
        assert one.isValid()
        assert volume(one.wrapped) == pytest.approx(exact.volume, rel=RELATIVE)
        assert one.Volume() == pytest.approx(exact.volume, rel=RELATIVE)


def test_names_and_colours_of_a_pair(tmp_path):
    built("spiral bevel pair").save(tmp_path / "crossed.step")
    pair = cadquery.Assembly.importStep(str(tmp_path / "crossed.step"))
    assert pair.name == "crossed"
    assert [one.name for one in pair.children] == ["pinion", "gear"]
    for one, colour in zip(pair.children, (BRASS, STEEL), strict=True):
        assert one.color.toTuple()[:3] == pytest.approx(colour, abs=1e-6)


@pytest.mark.parametrize("drilling", DRILLINGS, ids=lambda one: one.part)
def test_a_shape_is_drilled(drilling):
    solid = cadquery.Workplane(obj=cadquery.Solid(drilling.element.to_ocp()))
    hole = (
        cadquery.Workplane(origin=(*drilling.place, drilling.low))
        .circle(drilling.diameter / 2)
        .extrude(drilling.high - drilling.low)
    )
    (left,) = solid.cut(hole).solids().vals()
    assert left.isValid()
    assert volume(left.wrapped) == pytest.approx(drilling.left, rel=RELATIVE)


def test_the_page_prints_what_stands_below(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_section_prints_what_stands_below("CadQuery", capsys)
