"""`gearwright convert`: what is kept, what is said, and what cannot be converted."""

from __future__ import annotations

import json
import os

import numpy as np
import pytest

from gearwright.catalog import FILE_FORMATS
from gearwright.sections.drawings import read
from gearwright.sections.plane import Section
from gearwright.solids.model import Model
from gearwright.solids.polyhedron import Polyhedron

SUFFIXES = [s for one in FILE_FORMATS if one.writer and one.parser and one.holds == "polygons" for s in one.suffixes]
NAMED = (".3mf", ".glb", ".gltf", ".obj")
POINTS = np.array([[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 6.0]])
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
TWO = "o big part\n{}o other\n{}"
VERTICES = "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS)
DESIGN = 'element = "spur"\nteeth = 12\nmodule = 2\nface_width = 5\n'


def faces_from(first):
    return "".join("f " + " ".join(str(k + first) for k in face) + "\n" for face in FACES)


@pytest.fixture
def two(tmp_path):
    """Two bodies of volume 12 and 96, in an OBJ file, which states no unit."""
    larger = "".join(f"v {2 * x + 50} {2 * y} {2 * z}\n" for x, y, z in POINTS)
    path = tmp_path / "two.obj"
    path.write_text(TWO.format(VERTICES + faces_from(1), larger + faces_from(5)))
    return path


@pytest.mark.parametrize("first", SUFFIXES)
@pytest.mark.parametrize("second", SUFFIXES)
def test_names_units_and_places_are_kept_through_any_two_formats(run, two, tmp_path, first, second):
    inches, middle, last = tmp_path / "in.3mf", tmp_path / f"middle{first}", tmp_path / f"last{second}"
    outcome = run("convert", two, inches, "--length-unit", "in")
    assert (outcome.code, outcome.out, outcome.err) == (0, "", f"wrote {inches}\n")
    assert run("convert", inches, middle).code == 0
    assert run("convert", middle, last).code == 0
    found = Model.load(last)
    if first in (".glb", ".gltf") or second in (".glb", ".gltf"):
        unit, scale = "m", 0.0254
    else:
        unit, scale = "in", 1.0
    assert found.length_unit == unit
    if first in NAMED and second in NAMED:
        assert list(found.bodies) == ["big part", "other"]
    else:
        assert len(found.bodies) == 1
    together = found.polyhedron.properties()
    assert together.volume == pytest.approx(108 * scale**3, rel=1e-5)
    # (12 (3/4, 1, 3/2) + 96 (50 + 3/2, 2, 3)) / 108, y up where it is of glTF
    centroid = scale * np.array([(12 * 0.75 + 96 * 51.5) / 108, 17 / 9, 17 / 6])
    if second in (".glb", ".gltf"):
        centroid = centroid[[0, 2, 1]] * [1, 1, -1]
    np.testing.assert_allclose(together.centroid, centroid, rtol=1e-5)


def test_what_is_not_kept_is_said(run, two, tmp_path):
    outcome = run("convert", two, tmp_path / "two.stl")
    assert outcome.code == 0
    assert "its 2 bodies are one in" in outcome.err
    outcome = run("convert", two, tmp_path / "two.glb")
    assert f"note: {two} states no unit of length; mm is taken" in outcome.err
    outcome = run("convert", tmp_path / "two.glb", tmp_path / "back.obj")
    assert "has y up; turned, so that z is up" in outcome.err
    assert "y up" not in run("convert", tmp_path / "two.glb", tmp_path / "back.gltf").err


def test_polygons_stay_polygons(run, tmp_path):
    outline = [[0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [3, 0], [3, 5], [2, 5], [2, 3], [1, 3], [1, 5], [0, 5]]
    count = len(outline)
    around = [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    faces = [list(range(count))[::-1], list(range(count, 2 * count)), *around]
    Polyhedron([(*p, z) for z in (0, 1) for p in outline], faces).save(tmp_path / "h.ply")
    assert run("convert", tmp_path / "h.ply", tmp_path / "h.off").code == 0
    assert sorted(map(len, Polyhedron.load(tmp_path / "h.off").faces)) == [4] * 12 + [12, 12]
    outcome = run("convert", tmp_path / "h.ply", tmp_path / "h.3mf")
    assert outcome.code == 2
    assert "3MF holds triangles; .obj, .off and .ply hold any polygons" in outcome.err
    assert "face 0 of 12 corners" in outcome.err
    assert not (tmp_path / "h.3mf").exists()


def test_a_file_is_converted_into_itself(run, tmp_path):
    path = tmp_path / "part.stl"
    words = ["facet normal 0 0 0\nouter loop\n", "endloop\nendfacet\n"]
    loops = ("".join(f"vertex {x} {y} {z}\n" for x, y, z in POINTS[face]) for face in FACES)
    path.write_text("solid\n" + "".join(words[0] + loop + words[1] for loop in loops) + "endsolid\n")
    assert run("convert", path, path).code == 0
    assert len(path.read_bytes()) == 84 + 4 * 50
    assert Polyhedron.load(path).properties().volume == pytest.approx(12)


@pytest.mark.parametrize(
    ("faces", "said"),
    [(FACES[:3], "problem"), ([FACES[0][::-1], *FACES[1:]], "flipped"), ([f[::-1] for f in FACES], "inward")],
)
def test_what_is_wrong_with_a_body_is_said_and_not_mended(run, tmp_path, faces, said):
    path = tmp_path / "bad.off"
    Polyhedron(POINTS, faces).save(path)
    outcome = run("convert", path, tmp_path / "bad.ply")
    assert outcome.code == 0
    assert "as it was given, unmended" in outcome.err
    found = Polyhedron.load(tmp_path / "bad.ply")
    assert [face.tolist() for face in found.faces] == [list(face) for face in faces]


def test_a_design_is_built_as_by_build(run, tmp_path):
    design = tmp_path / "gear.toml"
    design.write_text(DESIGN)
    for suffix in (".stl", ".glb", ".obj"):
        assert run("convert", design, tmp_path / f"one{suffix}").code == 0
        assert run("build", design, "-o", tmp_path / f"two{suffix}").code == 0
        one, two = Model.load(tmp_path / f"one{suffix}"), Model.load(tmp_path / f"two{suffix}")
        assert one.polyhedron.vertices.tolist() == two.polyhedron.vertices.tolist()
    outcome = run("convert", design, tmp_path / "gear.dxf")
    assert outcome.code == 0
    assert outcome.err.endswith(f"wrote {tmp_path / 'gear.dxf'}\n")


def test_drawings_are_converted_with_their_unit(run, tmp_path):
    design = tmp_path / "gear.toml"
    design.write_text(DESIGN.replace("module = 2", 'diametral_pitch = 10\nlength_unit = "in"').replace("= 5", "= 0.5"))
    assert run("convert", design, tmp_path / "gear.dxf").code == 0
    assert run("convert", tmp_path / "gear.dxf", tmp_path / "gear.svg").code == 0
    areas = [Section.load(tmp_path / f"gear.{s}").properties().area for s in ("dxf", "svg")]
    assert areas[0] == pytest.approx(areas[1], rel=1e-6)
    assert read(tmp_path / "gear.svg").length_unit == "in"
    (tmp_path / "square.csv").write_text("0,0\n4,0\n4,4\n0,4\n")
    outcome = run("convert", tmp_path / "square.csv", tmp_path / "square.svg")
    assert "states no unit of length; mm is taken" in outcome.err
    assert Section.load(tmp_path / "square.svg").properties().area == pytest.approx(16)


@pytest.mark.parametrize(
    ("source", "target", "words"),
    [
        ("two.obj", "out.igs", ("ends in .igs", ".stl, .3mf")),
        ("two.obj", "out", ("no suffix", ".stl, .3mf")),
        ("two.obj", "out.step", ("it holds smooth faces, and bodies are read as polygons", ".stl, .3mf")),
        ("two.obj", "out.png", ("pictures are drawn by --picture", ".stl, .3mf")),
        ("two.obj", "out.dxf", ("ends in .dxf", ".stl, .3mf")),
        ("two.igs", "out.stl", ("ends in .igs cannot be read", "drawings as .dxf", "designs as .toml")),
        ("none.obj", "out.stl", ("there is no such file",)),
        ("none", "out.stl", ("there is no such file",)),
        ("square.csv", "out.stl", ("is a drawing", "gearwright sweep --section")),
        ("square.csv", "out.csv", ("is a drawing", ".dxf, .svg")),
        ("gear.toml", "out.png", ("is a design", ".stl", ".dxf")),
        ("bad.toml", "out.stl", ("module",)),
        ("inch.obj --length-unit mm", "out.3mf", ("says itself that lengths are in in",)),
        ("gear.toml --length-unit mm", "out.3mf", ("a design states its own",)),
        ("two.obj --length-unit cubit", "out.3mf", ("choose one of um, mm",)),
        ("two.obj", "nowhere/out.3mf", ("there is no folder",)),
        ("two.obj", "folder.3mf", ("folder or device",)),
    ],
)
def test_what_cannot_be_converted(run, two, tmp_path, monkeypatch, source, target, words):
    (tmp_path / "square.csv").write_text("0,0\n4,0\n4,4\n0,4\n")
    (tmp_path / "gear.toml").write_text(DESIGN)
    (tmp_path / "bad.toml").write_text(DESIGN.replace("= 2", "= -2"))
    (tmp_path / "folder.3mf").mkdir()
    Polyhedron(POINTS, FACES).save(tmp_path / "inch.obj", length_unit="in")
    monkeypatch.chdir(tmp_path)
    before = sorted(tmp_path.rglob("*"))
    outcome = run("convert", *source.split(), target)
    assert outcome.code == 2
    assert outcome.out == ""
    assert all(word in outcome.err for word in words), outcome.err
    assert "Traceback" not in outcome.err
    assert sorted(tmp_path.rglob("*")) == before


def test_a_full_disk_is_the_machines_fault_and_leaves_the_old_file(run, two, tmp_path, monkeypatch):
    def full(_):
        raise OSError(28, "No space left on device")

    target = tmp_path / "old.3mf"
    target.write_bytes(b"old")
    monkeypatch.setattr(os, "fsync", full)
    outcome = run("convert", two, target)
    assert outcome.code == 3
    assert "No space left on device" in outcome.err
    assert target.read_bytes() == b"old"


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_pair_is_written_placed_in_any_format(run, tmp_path, suffix):
    options = "--teeth 12 20 --module 2 --face-width 5 --tolerance 0.05".split()
    assert run("spur", *options, "-o", tmp_path / f"pair{suffix}").code == 0
    found = Model.load(tmp_path / f"pair{suffix}")
    assert len(found.bodies) == (2 if suffix in NAMED else 1)
    assert list(found.bodies) == (["pinion", "gear"] if suffix in NAMED else ["body 1"])
    outcome = run("spur", *options, "-o", tmp_path / "both", "--format", suffix[1:], "--json")
    assert outcome.code == 0
    assert sorted(p.name for p in (tmp_path / "both").iterdir()) == [f"gear{suffix}", f"pinion{suffix}"]
    volumes = [
        Model.load(tmp_path / "both" / f"{name}{suffix}").polyhedron.properties().volume for name in ("pinion", "gear")
    ]
    assert sum(volumes) == pytest.approx(found.polyhedron.properties().volume, rel=1e-5)
    if suffix in (".3mf", ".obj"):  # the centre distance is 2 (12 + 20) / 2
        middles = np.array([body.properties().centroid for body in found.bodies.values()])
        assert np.linalg.norm(np.diff(middles, axis=0)) == pytest.approx(32, abs=1e-3)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("-o gear.stl --format 3mf", ("--format 3mf: applies to the files in a folder", "gear.stl names a file")),
        ("--format 3mf", ("--format 3mf: applies to the files in a folder", "none is named")),
        ("-o folder --format iges", ("--format iges: one of stl, 3mf,",)),
        ("--clearance 0.1", ("--clearance: applies to files and pictures",)),
        ("-o gear.stl --clearance -1", ("--clearance = -1: at least 0",)),
        ("-o gear.stl --clearance nan", ("--clearance = nan",)),
        ("-o gear.stl --clearance 3", ("clearance = 3: ", "it must be less than")),
    ],
)
def test_options_that_cannot_be(run, tmp_path, monkeypatch, options, words):
    monkeypatch.chdir(tmp_path)
    outcome = run("spur", *"--teeth 12 --module 2 --face-width 5".split(), *options.split())
    assert outcome.code == 2
    assert all(word in outcome.err for word in words), outcome.err
    assert not list(tmp_path.iterdir())


def test_a_clearance_makes_what_is_written_smaller_and_not_what_is_measured(run, tmp_path):
    options = "--teeth 12 --module 2 --face-width 5 --json".split()
    plain, with_play = (
        run("spur", *options, "-o", tmp_path / f"{name}.3mf", *more)
        for name, more in (("plain", ()), ("play", ("--clearance", 0.2)))
    )
    assert json.loads(plain.out) == json.loads(with_play.out)
    boxes = [np.ptp(Polyhedron.load(tmp_path / f"{name}.3mf").vertices, axis=0) for name in ("plain", "play")]
    np.testing.assert_allclose(boxes[0] - boxes[1], 0.2, atol=2e-3)
    assert boxes[0][2] - boxes[1][2] == pytest.approx(0.2, abs=1e-12)
