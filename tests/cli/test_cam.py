"""`gearwright cam`: what is printed, drawn and refused."""

import json
import shlex

import pytest

FACE = shlex.split(
    'cam --programme "rise 150, dwell 60, return 150" --follower translating-flat-face --lift 10 --thickness 8'
)


def test_sizes_and_json(run):
    outcome = run(*FACE, "--base-radius", 40)
    assert outcome.code == 0, outcome.err
    for text in ("least curvature radius", "ρ_min", "polygon area", "face length"):
        assert text in outcome.out
    found = json.loads(run(*FACE, "--base-radius", 40, "--json").out)
    assert set(found) == {"parameters", "sizes", "placement", "properties", "beside"}
    assert found["sizes"]["disk_area"]["unit"] == "mm^2"
    assert 0.99 < found["beside"]["polygon"]["volume"] / found["properties"]["volume"] < 1.0


def test_the_polygon_stands_beside_the_exact_values(run):
    outcome = run(*FACE, "--base-radius", 40, "--density", 7850)
    rows = [line.split() for line in outcome.out.splitlines()]
    assert ["unit", "cam", "polygon"] in rows
    (volumes,) = (row[2:] for row in rows if row[:1] == ["volume"])
    assert 0.99 < float(volumes[1]) / float(volumes[0]) < 1.0


def test_a_synthesis_is_told_on_stderr_and_in_json(run):
    outcome = run(*FACE, "--minimise", "area", "--free-values", 3, "--json")
    assert outcome.code == 0, outcome.err
    assert "note: least area found:" in outcome.err
    assert "note: the least area rests on these limits: eccentricity at" in outcome.err
    found = json.loads(outcome.out)["synthesis"]
    assert set(found) == {"area", "law", "dimensions", "spline_values", "active", "fixed_laws", "gain"}
    assert found["law"] == "spline"
    assert len(found["spline_values"]) == 6
    assert found["gain"] > 0.1
    assert set(found["fixed_laws"]) == {"cycloidal", "harmonic", "3-4-5", "4-5-6-7", "modified-sine"}
    assert found["active"][0]["limit"] == "eccentricity"


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_a_diagram_is_drawn_into_a_folder_that_is_made(run, tmp_path, suffix):
    path = tmp_path / "new" / f"cam.{suffix}"
    outcome = run(*FACE, "--base-radius", 40, "--diagram", path)
    assert outcome.code == 0, outcome.err
    assert f"wrote {path}" in outcome.err
    assert path.stat().st_size > 10_000


def test_diagrams_are_refused_where_there_are_none(run):
    outcome = run(*"spur --teeth 16 --module 8 --face-width 50 --diagram gear.png".split())
    assert outcome.code == 2
    assert "--diagram: applies to a bevel pair or a cam" in outcome.err
    outcome = run(*FACE, "--base-radius", 40, "--diagram", "cam.jpg")
    assert outcome.code == 2
    assert "--diagram cam.jpg: no such files are written here, but .png, .svg" in outcome.err


def test_a_cusp_names_the_option_that_mends_it(run):
    words = [word.replace("rise 150, dwell 60", "rise 60, dwell 150") for word in FACE]
    outcome = run(*words, "--base-radius", 2)
    assert outcome.code == 2
    assert "--base-radius = 2 mm: undercut: at cam angle" in outcome.err
    assert "--base-radius greater than" in outcome.err


def test_a_programme_is_refused_with_the_place(run):
    words = [word.replace("dwell 60", "dwel 60") for word in FACE]
    outcome = run(*words, "--base-radius", 40)
    assert outcome.code == 2
    assert 'part 2, "dwel 60": it begins with none of dwell, rise, return; did you mean dwell?' in outcome.err


def test_a_design_of_a_cam_is_built_and_drawn(run, tmp_path):
    (tmp_path / "cam.toml").write_text(
        'element = "cam"\nprogramme = "rise 150, dwell 60, return 150"\nfollower = "translating-flat-face"\n'
        'lift = 10\nbase_radius = 60\nthickness = 8\nlaw = "spline"\nspline_values = [0.1, 0.5, 0.9, 0.1, 0.5, 0.9]\n'
    )
    outcome = run("build", tmp_path / "cam.toml", "--diagram", tmp_path / "cam.svg")
    assert outcome.code == 0, outcome.err
    assert (tmp_path / "cam.svg").exists()
