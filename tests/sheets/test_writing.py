"""Files of sheets: DXF that programs read without complaint, SVG, PDF; whole or not at all."""

import re
import sys
from xml.etree import ElementTree as ET

import ezdxf
import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.sheets import SheetLabels, element_sheet
from gearwright.sheets.marks import Dimension, Hatch

GEARS = {
    "spur": lambda: gw.SpurGear(
        teeth=40, module=2.5, face_width=25.0, bore=20.0, keyway="din-6885", hub_diameter=36.0, hub_length=38.0,
        rim_diameter=82.0, web_thickness=10.0, web_holes=6, web_hole_diameter=12.0,
    ),
    "rack": lambda: gw.Rack(teeth=30, module=2.0, face_width=12.0),
    "bevel": lambda: gw.BevelGear(teeth=20, mate_teeth=30, module=4.0, face_width=22.0, bore=20.0),
    "cam": lambda: gw.Cam(
        programme="rise 180, return 180", follower="translating-flat-face", lift=5.0, base_radius=30.0, thickness=9.0
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", GEARS)
def test_a_dxf_passes_the_audit_and_its_dimensions_measure_themselves(name, tmp_path):
    element = GEARS[name]()
    element.save_sheet(tmp_path / "a.dxf")
    document = ezdxf.readfile(tmp_path / "a.dxf")
    audit = document.audit()
    assert (audit.errors, audit.fixes) == ([], [])
    assert document.header["$INSUNITS"] == 4
    expected = [m for m in element_sheet(element, SheetLabels(), title="x").marks if isinstance(m, Dimension)]
    found = document.modelspace().query("DIMENSION")
    assert len(found) == len(expected)
    for entity in found:
        text = entity.dxf.text.removeprefix("Ø").removesuffix("°").replace("−", "-")
        scale = 1.0 if entity.dimtype == 5 else entity.get_dim_style().dxf.dimlfac
        measured = float(entity.get_measurement()) * scale  # by ezdxf, from the points of definition
        assert measured == pytest.approx(float(text), abs=0.51 * 10.0 ** -len(text.partition(".")[2]))
        assert len(document.blocks[entity.dxf.geometry])


def test_a_dxf_renders_as_large_as_the_paper(tmp_path):
    from ezdxf import bbox

    GEARS["bevel"]().save_sheet(tmp_path / "a.dxf", SheetLabels(paper="A4"))
    extents = bbox.extents(ezdxf.readfile(tmp_path / "a.dxf").modelspace())
    np.testing.assert_allclose((extents.size.x, extents.size.y), (267.0, 190.0), atol=1e-6)


def test_an_svg_has_a_page_of_paper_for_each_sheet(tmp_path):
    gw.BevelPair(teeth=(16, 24), module=4.0, face_width=18.0).save_sheet(tmp_path / "a.svg")
    root = ET.parse(tmp_path / "a.svg").getroot()  # noqa: S314  our own file
    assert (root.get("width"), root.get("height")) == ("420mm", "604mm")
    said = [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")]
    assert said.count("Data") == 2
    assert {"1/2", "2/2"} <= set(said)


@pytest.mark.parametrize("suffix", [".svg", ".pdf"])
def test_the_same_part_gives_the_same_file(suffix, tmp_path):
    files = [tmp_path / f"{name}{suffix}" for name in ("a", "b")]
    for file in files:
        GEARS["cam"]().save_sheet(file)
    assert files[0].read_bytes() == files[1].read_bytes()


def test_a_pdf_has_a_page_for_each_member(tmp_path):
    gw.GearPair(kind="spur", teeth=(12, 20), module=2.0, face_width=9.0).save_sheet(
        tmp_path / "a.pdf", SheetLabels(paper="A4", material="steel", date="2026-01-31", notes=("Case hardened.",))
    )
    data = (tmp_path / "a.pdf").read_bytes()
    assert data.startswith(b"%PDF-")
    assert data.rstrip().endswith(b"%%EOF")
    assert len(re.findall(rb"/Type\s*/Page\b", data)) == 2
    assert re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", data)[0][0].startswith(b"841.8")  # 297 mm in points


def test_hatching_covers_the_region_and_no_more():
    outline = np.array([[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [0.0, 20.0]])
    hole = np.array([[10.0, 5.0], [20.0, 5.0], [20.0, 15.0], [10.0, 15.0]])
    hatch = Hatch(outline=outline, holes=(hole,), distance=0.5)
    lengths = np.linalg.norm(np.diff(hatch.lines, axis=1)[:, 0], axis=1)
    assert lengths.sum() * 0.5 == pytest.approx(30.0 * 20.0 - 100.0, rel=0.01)
    middles = hatch.lines.mean(axis=1)
    assert not np.any(np.all((middles > [10.0, 5.0]) & (middles < [20.0, 15.0]), axis=1))


def test_what_cannot_be_written_leaves_nothing_behind(tmp_path, monkeypatch):
    gear = GEARS["cam"]()
    with pytest.raises(gw.FileError, match=r"sheets are drawn as \.dxf, \.svg, \.pdf"):
        gear.save_sheet(tmp_path / "a.png")
    with pytest.raises(gw.FileError, match="there is no folder"):
        gear.save_sheet(tmp_path / "no" / "a.svg")
    monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
    with pytest.raises(gw.MachineError, match=r"pip install 'gearwright\[drawing\]'"):
        gear.save_sheet(tmp_path / "a.dxf")
    assert not list(tmp_path.iterdir())


def test_an_old_file_stays_where_the_new_one_fails(tmp_path, monkeypatch):
    path = tmp_path / "a.dxf"
    path.write_text("old")
    monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
    with pytest.raises(gw.MachineError):
        GEARS["cam"]().save_sheet(path)
    assert path.read_text() == "old"
