import json
import re

import numpy as np
import pytest

import gearwright

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
FACES = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


@pytest.fixture
def files(tmp_path):
    """A sound box, one pierced by a bar, one on another, one without its last face, one that is not there."""
    bar = CORNERS * [0.25, 0.5, 3.0] + [0.3125, 0.125, -1.0]
    above = CORNERS * [0.5, 0.5, 1.0] + [0.25, 0.25, 1.0]
    both = np.concatenate([FACES, FACES + 8])
    bodies = {
        "box": (CORNERS, FACES),
        "pierced": (np.concatenate([CORNERS, bar]), both),
        "stacked": (np.concatenate([CORNERS, above]), both),
        "open": (CORNERS, FACES[:-1]),
    }
    paths = {name: tmp_path / f"{name}.stl" for name in (*bodies, "missing")}
    for name, body in bodies.items():
        gearwright.Polyhedron(*body).save(paths[name])
    return paths


def test_a_sound_body_passes(run, files):
    outcome = run("check", files["box"])
    assert outcome.code == 0
    assert outcome.err == ""
    assert outcome.out == (
        f"{files['box']}: all is well (12 faces, 1 component)\n"
        "  valid: closed, outward, of one orientation\n"
        "  no face passes through another\n"
    )


def test_a_body_through_another_fails(run, files):
    outcome = run("check", files["pierced"])
    assert outcome.code == 1
    assert f"{files['pierced']}: a check failed (24 faces, 2 components)" in outcome.out
    assert "passing through each other" in outcome.out
    assert "bodies 0 and 1 overlap" in outcome.out
    assert "valid: closed" in outcome.out


def test_bodies_in_contact_pass_with_a_remark(run, files):
    outcome = run("check", files["stacked"])
    assert outcome.code == 0
    assert "remark: " in outcome.out
    assert "touching" in outcome.out
    assert "problem" not in outcome.out


def test_a_hole_fails(run, files):
    outcome = run("check", files["open"])
    assert outcome.code == 1
    assert re.search(
        r"problem: 4 open edges, the first between vertices \d and \d, near \(.*, 1\) in one chain", outcome.out
    )
    assert "Close Holes" in outcome.out
    assert "no face passes through another" in outcome.out


def test_json_has_a_line_for_each_file_that_can_be_used(run, files):
    outcome = run("check", "--json", *files.values())
    lines = [json.loads(line) for line in outcome.out.splitlines()]
    assert [line["file"] for line in lines] == [str(files[name]) for name in ("box", "pierced", "stacked", "open")]
    assert [line["passed"] for line in lines] == [True, False, True, False]
    assert [line["valid"] for line in lines] == [True, True, True, False]
    assert [line["faces"] for line in lines] == [12, 24, 24, 10]
    assert [line["open_edges"] for line in lines] == [0, 0, 0, 4]
    crossings = [line["self_intersections"] for line in lines]
    assert [found["count"] > 0 for found in crossings] == [False, True, False, False]
    assert [len(found["touching"]) > 0 for found in crossings] == [False, False, True, False]
    assert np.shape(crossings[1]["points"]) == (crossings[1]["count"], 3)
    assert set(np.array(crossings[1]["points"])[:, 2]) == {0.0, 1.0}
    assert [found["bodies"] for found in crossings] == [[], [[0, 1]], [], []]
    assert [line["kinds"] for line in lines] == [[], [], [], ["open"]]
    assert [line["bodies"] for line in lines] == [1, 2, 2, 1]
    assert [line["inertia_problems"] for line in lines] == [[], [], [], []]
    assert outcome.code == 2
    assert str(files["missing"]) in outcome.err


@pytest.mark.parametrize(
    ("names", "code"),
    [
        (("box", "stacked"), 0),
        (("open", "box"), 1),
        (("box", "pierced"), 1),
        (("missing", "box"), 2),
        (("missing", "pierced"), 2),
        (("pierced", "missing"), 2),
    ],
)
def test_the_worst_code_counts(run, files, names, code):
    assert run("check", *(files[name] for name in names)).code == code


def test_a_file_is_needed(run):
    outcome = run("check")
    assert outcome.code == 2
    assert "gearwright check --help" in outcome.err


def test_corners_written_anew_are_remarked(run, tmp_path):
    path = tmp_path / "anew.obj"
    lines = [f"v {x} {y} {z}" for face in FACES for x, y, z in CORNERS[face]]
    path.write_text("\n".join([*lines, *(f"f {k} {k + 1} {k + 2} {k + 3}" for k in range(1, 25, 4))]))
    outcome = run("check", path, "--json")
    assert outcome.code == 1
    assert json.loads(outcome.out)["sound"] == ["body 1 closes only with its corners at equal coordinates joined"]
    assert "remark: body 1 closes only with" in run("check", path).out
    assert run("properties", path).code == 0


def test_whatever_one_file_brings_about_the_others_are_done(run, files, monkeypatch):
    from gearwright.solids.model import Model

    load = Model.load.__func__

    def loaded(cls, path):
        if path.name == "open.stl":
            raise MemoryError
        return load(cls, path)

    monkeypatch.setattr(Model, "load", classmethod(loaded))
    outcome = run("check", files["open"], files["box"])
    assert outcome.code == 3
    assert f"{files['open']}: Not enough memory" in outcome.err
    assert "all is well" in outcome.out
