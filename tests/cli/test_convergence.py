import json

import pytest

import gearwright as gw

SPUR = "spur --teeth 8 --module 4 --face-width 20 --root radial".split()


def test_the_table_shows_each_study_and_its_order(run):
    outcome = run(*SPUR, "--convergence")
    assert outcome.code == 0
    for text in (
        "errors by tolerance in mm",
        "errors by segments",
        "errors by layers",
        "exact to rounding",
        "Volume: ",
    ):
        assert text in outcome.out
    (order,) = (line.split() for line in outcome.out.splitlines() if line.split()[:1] == ["order"] and "1.9" in line)
    assert float(order[1]) == pytest.approx(2.0, abs=0.05)
    assert max(map(len, outcome.out.splitlines())) <= 100


def test_json_holds_what_python_finds(run):
    found = json.loads(run(*SPUR, "--convergence", "--json").out)["convergence"]
    assert list(found) == ["tolerance", "segments", "layers"]
    gear = gw.SpurGear(teeth=8, module=4.0, face_width=20.0, root="radial")
    assert found["tolerance"] == gw.approximation_error(gear).to_dict()
    assert found["layers"]["orders"] == {"volume": None, "centroid": None, "inertia": None}


def test_without_the_option_nothing_is_measured(run):
    assert "convergence" not in json.loads(run(*SPUR, "--json").out)


def test_a_pair_has_both_members_in_one_plot(run, pair_options, tmp_path):
    file = tmp_path / "made" / "errors.svg"
    outcome = run("bevel", *pair_options, "--convergence", file, "--json")
    assert outcome.code == 0, outcome.err
    assert f"wrote {file}" in outcome.err
    pair = gw.BevelPair(teeth=(16, 20), module=4.0, face_width=15.0, root="radial", ends="spherical")
    studies = [
        study(member)
        for member in (pair.pinion, pair.gear)
        for study in (gw.approximation_error, gw.section_refinement, gw.layer_refinement)
    ]
    title = f"Errors of polyhedra, bevel pair: {pair.description}"
    gw.plot_convergence(studies, tmp_path / "own.svg", title=title, names=3 * ["pinion"] + 3 * ["gear"])
    assert file.read_bytes() == (tmp_path / "own.svg").read_bytes()
    found = json.loads(outcome.out)
    assert found["pinion"]["convergence"] != found["gear"]["convergence"]
    assert "convergence" not in found["pair"]


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["a.gif"], "--convergence a.gif: no such files are written here, but .png, .svg"),
        (["."], "--convergence: a name is needed"),
        (["a.png", "b.png"], "--convergence: at most one value is accepted, not 2."),
    ],
)
def test_unusable_files_are_refused_before_anything_is_measured(run, words, text, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = run(*SPUR, "--convergence", *words)
    assert outcome.code == 2
    assert text in outcome.err
    assert not list(tmp_path.iterdir())
