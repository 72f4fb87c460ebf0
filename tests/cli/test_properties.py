import json

import numpy as np
import pytest

import gearwright

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


@pytest.fixture
def box(tmp_path):
    """A box of 2 × 3 × 4 with one corner at the origin."""
    path = tmp_path / "box.stl"
    gearwright.Polyhedron(CORNERS * [2, 3, 4], FACES).save(path)
    return path


def test_properties_of_a_box(run, box):
    outcome = run("properties", box)
    assert outcome.code == 0
    assert "volume" in outcome.out
    assert "24" in outcome.out
    assert "minus the products" in outcome.out


def test_json_has_a_line_for_each_file(run, box):
    gearwright.Polyhedron.load(box).save(box, length_unit="in")
    outcome = run("properties", box, box, "--json", "--density", 1000)
    lines = [json.loads(line) for line in outcome.out.splitlines()]
    assert [line["file"] for line in lines] == [str(box)] * 2
    assert lines[0]["volume"] == pytest.approx(24, rel=1e-12)
    assert lines[0]["length_unit"] == "in"
    assert lines[0]["mass"] == pytest.approx(24 * 0.016387064, rel=1e-12)
    assert lines[0]["products"]["xy"] == pytest.approx(lines[0]["mass"] * 1.0 * 1.5, rel=1e-12)


def test_a_unit_against_the_file_s_own_is_refused(run, box):
    outcome = run("properties", box, "--length-unit", "in")
    assert outcome.code == 2
    assert "it says itself that lengths are in mm, not in" in outcome.err


def test_a_file_without_a_unit_takes_the_one_asked_for(run, box):
    data = bytearray(box.read_bytes())
    data[:80] = b" " * 80
    box.write_bytes(data)
    assert json.loads(run("properties", box, "--json", "--length-unit", "in").out)["length_unit"] == "in"
    assert json.loads(run("properties", box, "--json").out)["length_unit"] == "mm"


def test_a_file_that_cannot_be_used_is_named_and_the_rest_is_done(run, box, tmp_path):
    broken = tmp_path / "broken.stl"
    broken.write_bytes(b"")
    outcome = run("properties", tmp_path / "missing.stl", broken, box, "--json")
    assert outcome.code == 2
    assert "missing.stl" in outcome.err
    assert "broken.stl" in outcome.err
    assert len(outcome.out.splitlines()) == 1


def test_an_open_polyhedron_is_refused(run, tmp_path):
    path = tmp_path / "open.stl"
    gearwright.Polyhedron(CORNERS, FACES[:-1]).save(path)
    outcome = run("properties", path)
    assert outcome.code == 2
    assert outcome.err.startswith(f"{path}: ")


def test_a_file_is_needed(run):
    outcome = run("properties")
    assert outcome.code == 2
    assert "FILE" in outcome.err.upper()
    assert "gearwright properties --help" in outcome.err
