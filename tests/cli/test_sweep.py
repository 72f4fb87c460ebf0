"""`gearwright sweep`, as a person types it."""

import json
from pathlib import Path

import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.sweep import Sweep

OUTLINE = "x,y\n1,0\n4,0\n4,2\n1,3\n"
CORNERS = ((1, 0), (4, 0), (4, 2), (1, 3))
BEND = "0,0,0\n0,0,30\n20,10,60\n"
POINTS = ((0, 0, 0), (0, 0, 30), (20, 10, 60))


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A folder with an outline and a path."""
    (tmp_path / "outline.csv").write_text(OUTLINE)
    (tmp_path / "bend.csv").write_text(BEND)
    monkeypatch.chdir(tmp_path)
    return tmp_path


WAYS = {
    "straight": ("--length 50", {"length": 50}),
    "twisted, scaled and skewed": (
        "--length 50 --twist -30 --scale 0.5 1.5 --skew -3 0.5",
        {"length": 50, "twist": -30, "scale": (0.5, 1.5), "skew": (-3, 0.5)},
    ),
    "along a path": ("--path bend.csv", {"path": POINTS}),
    "along a path, all of it": (
        "--path bend.csv --frame fixed-up --twist 90 --scale 0.5 0.5 --length-unit in",
        {"path": POINTS, "frame": "fixed-up", "twist": 90, "scale": (0.5, 0.5), "length_unit": "in"},
    ),
    "revolved": ("--angle 270", {"angle": 270}),
}


@pytest.mark.parametrize("way", WAYS)
def test_what_is_typed_is_what_is_built(run, way):
    options, parameters = WAYS[way]
    if parameters.get("frame") == "fixed-up":
        parameters = {**parameters, "path": ((0, 0, 0), (30, 0, 0), (60, 10, 20))}
        Path("bend.csv").write_text("0,0,0\n30,0,0\n60,10,20\n")
    outcome = run("sweep", "--section", "outline.csv", *options.split(), "--json")
    assert outcome.code == 0, outcome.err
    found = json.loads(outcome.out)
    expected = Sweep(section={"polygon": CORNERS}, **parameters)
    assert found["properties"]["volume"] == expected.properties().volume
    np.testing.assert_array_equal(found["properties"]["centroid"], expected.properties().centroid)
    assert found["properties"]["length_unit"] == parameters.get("length_unit", "mm")
    area = found["sizes"]["section_area"]
    assert area["value"] == pytest.approx(7.5, rel=1e-14)
    assert area["unit"] == f"{expected.length_unit}^2"
    assert found["parameters"]["section"] == "outline.csv"


def test_tables_files_and_pictures(run, folder):
    options = "--section outline.csv --length 5 --twist 30 --tolerance 0.01 --density 7850".split()
    outcome = run("sweep", *options, "-o", "made/here.stl", "--picture", "made/here.png")
    assert outcome.code == 0, outcome.err
    for text in ("section area", "mm²", "7.5", "kg", "volume"):
        assert text in outcome.out
    assert max(map(len, outcome.out.splitlines())) <= 100
    body = gw.Polyhedron.load(folder / "made/here.stl").properties()
    assert body.volume == pytest.approx(37.5, rel=0.01)
    assert (folder / "made/here.png").read_bytes().startswith(b"\x89PNG")
    assert "wrote made/here.stl" in outcome.err


def test_a_folder_gets_one_file(run, folder):
    assert run("sweep", *"--section outline.csv --angle 360 --tolerance 0.1 -o parts".split()).code == 0
    assert [path.name for path in (folder / "parts").iterdir()] == ["sweep.stl"]


REFUSALS = [
    ("", ("--section: is needed", "--length: how the section moves")),
    ("--section outline.csv", ("--length: how the section moves", "path", "angle")),
    ("--section outline.csv --length 50 --path bend.csv", ("--length = 50 mm: not together with path",)),
    ("--length 50", ("--section: is needed",)),
    ("--section no.dxf --path no.csv --twist x", ("--section = 'no.dxf': there is no", "--path = 'no.csv'", "--twist")),
    ("--section outline.csv --path outline.csv", ("--path", "line 2: '1,0'")),
    ("--section outline.txt --length 3", ("--section = 'outline.txt'",)),
    ("--section outline.csv --length 3 --scale 2", ("--scale = 2.0: 2 numbers are needed",)),
    ("--section outline.csv --length 3 --scale 1 0", ("--scale = (1.0, 0.0): must be greater than 0",)),
    ("--section outline.csv --length 3 --skew 1 2 3", ("--skew: one or two values are accepted, not 3",)),
    ("--section outline.csv --length 3 --frame frenet", ("--frame = 'frenet': does not apply",)),
    ("--section outline.csv --length 0x3 --angle 3", ("--length", "not together with angle")),
    ("--section outline.csv --angle 400", ("--angle = 400°: at most 360",)),
    ("--section outline.csv --length 3 --density -1 -o a.igs", ("--density = -1", "--output a.igs")),
    ("--section outline.csv --length 3 --placed --picture a.png", ("--placed: applies to a pair",)),
    ("--section outline.csv --length 3 --transform f1", ("Unknown option: --transform",)),
    ("--section outline.csv --length 3 -o outline.csv/a.stl", ("outline.csv: cannot be a folder",)),
    ("--section outline.csv --length", ("--length: a value is needed",)),
    ("--section . --length 3", ("--section = '.'",)),
]


@pytest.mark.parametrize(("options", "words"), REFUSALS, ids=[options for options, _ in REFUSALS])
def test_refused_in_the_words_of_the_command_line(run, folder, options, words):
    before = sorted(folder.iterdir())
    outcome = run("sweep", *options.split())
    assert outcome.code == 2
    assert outcome.out == ""
    assert "Traceback" not in outcome.err
    assert all(word in outcome.err for word in words), outcome.err
    assert sorted(folder.iterdir()) == before


def test_the_headline_names_no_teeth(run):
    assert run("sweep").err.splitlines()[0] == "A sweep cannot be built with these options:"


def test_lines_of_a_file_stand_below_their_option(run):
    lines = run("sweep", *"--section outline.csv --path outline.csv".split()).err.splitlines()
    assert lines[1].startswith("  --path = 'outline.csv': a point of the path is")
    assert lines[2].startswith("    line 2")
