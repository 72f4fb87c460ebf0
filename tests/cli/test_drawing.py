"""`--drawing FILE.dxf|svg`."""

import json
import sys
from pathlib import Path

import pytest

import gearwright as gw
from gearwright import catalog
from gearwright.cli import common_options
from gearwright.cli.output_problems import output_problems
from gearwright.sections import drawings

SPUR = "spur --teeth 18 --module 4 --face-width 20 --bore 14".split()
SWEEP = "sweep --length 5 --section".split()


@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
def test_a_gear_is_drawn_as_python_draws_it(run, tmp_path, suffix):
    path = tmp_path / "made" / f"gear{suffix}"
    outcome = run(*SPUR, "--drawing", path, "--json")
    assert (outcome.code, outcome.err) == (0, f"wrote {path}\n")
    gear = gw.SpurGear(teeth=18, module=4.0, face_width=20.0, bore=14.0)
    area = gw.Section.load(path).properties().area
    assert area == pytest.approx(gear.profile.properties().area, rel=1e-8)
    assert area * 20.0 == pytest.approx(json.loads(outcome.out)["properties"]["volume"], rel=1e-8)


def test_inches_are_stated(run, tmp_path):
    words = "spur --teeth 12 --diametral-pitch 6 --face-width 1 --length-unit in --drawing".split()
    assert run(*words, tmp_path / "gear.svg").code == 0
    assert drawings.read(tmp_path / "gear.svg").length_unit == "in"


def test_a_sweep_and_a_design_are_drawn(run, tmp_path):
    (tmp_path / "plate.csv").write_text("0,0\n4,0\n1,3\n")
    assert run(*SWEEP, tmp_path / "plate.csv", "--drawing", tmp_path / "plate.dxf").code == 0
    (tmp_path / "plate.toml").write_text('element = "sweep"\nlength = 5\nsection = "plate.dxf"\n')
    outcome = run("build", tmp_path / "plate.toml", "--drawing", tmp_path / "again.svg")
    assert outcome.code == 0, outcome.err
    assert gw.Section.load(tmp_path / "again.svg").properties().area == pytest.approx(6.0, rel=1e-14)


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ([*SPUR, "--drawing", "a.pdf"], "--drawing a.pdf: no such files are written here, but .dxf, .svg"),
        ([*SPUR, "--drawing", "a"], "--drawing a: no such files are written here, but .dxf, .svg"),
        ([*SPUR, "--drawing", "."], "--drawing: a name is needed"),
        (
            "bevel --teeth 20 --mate-teeth 16 --module 4 --face-width 15 --drawing a.dxf".split(),
            "--drawing: a bevel gear has no plane section, which is what is drawn; --picture shows it",
        ),
        (
            "bevel --teeth 20 16 --module 4 --face-width 15 --drawing a.dxf".split(),
            "--drawing: a bevel pair has no plane section",
        ),
    ],
)
def test_what_cannot_be_drawn_is_refused_before_anything_is_written(run, words, text, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = run(*words, "-o", "a.stl")
    assert (outcome.code, outcome.out) == (2, "")
    assert text in outcome.err
    assert "Traceback" not in outcome.err
    assert not list(tmp_path.iterdir())


def test_all_problems_are_named_together(run):
    outcome = run("spur", "--teeth", 2, "--module", 4, "--face-width", 20, "--drawing", "a.png")
    assert outcome.code == 2
    assert "--teeth = 2" in outcome.err
    assert "--drawing a.png" in outcome.err


def test_a_folder_that_cannot_be_and_a_missing_extra(run, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    outcome = run(*SPUR, "--drawing", tmp_path / "file" / "gear.dxf")
    assert (outcome.code, outcome.out) == (2, "")
    assert "a file stands in its way" in outcome.err
    monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
    outcome = run(*SPUR, "--drawing", tmp_path / "gear.dxf")
    assert (outcome.code, outcome.out) == (3, "")
    assert "pip install 'gearwright[drawing]'" in outcome.err


def test_the_option_accepts_what_is_written():
    kind = next(one for one in catalog.ELEMENTS if one.plane)
    for suffix in (*drawings.WRITTEN, ".png", ".stl"):
        refused = output_problems(common_options.Outputs(drawing=Path(f"drawing{suffix}")), kind)
        assert bool(refused) == (suffix not in drawings.WRITTEN)


def test_two_outputs_do_not_share_a_file(run, tmp_path):
    file = tmp_path / "one.svg"
    outcome = run(*SPUR, "--drawing", file, "--convergence", file)
    assert (outcome.code, outcome.out) == (2, "")
    assert f"--convergence {file}: the file of --drawing, too" in outcome.err
    assert not file.exists()


def test_files_written_before_one_that_fails_are_named(run, tmp_path):
    (tmp_path / "in-the-way").write_text("")
    outcome = run(*SPUR, "-o", tmp_path / "gear.stl", "--drawing", tmp_path / "in-the-way" / "gear.dxf")
    assert outcome.code in (2, 3)
    assert f"wrote {tmp_path / 'gear.stl'}" in outcome.err
    assert (tmp_path / "gear.stl").exists()
