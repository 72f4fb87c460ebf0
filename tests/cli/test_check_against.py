import json
from math import cos, radians

import numpy as np
import pytest

import gearwright as gw

DESIGN = {"teeth": 14, "module": 2.0, "face_width": 6.0, "bore": 8.0}


@pytest.fixture
def folder(tmp_path):
    lines = ['element = "spur"', *(f"{name} = {value}" for name, value in DESIGN.items())]
    (tmp_path / "design.toml").write_text("\n".join(lines))
    return tmp_path


@pytest.mark.parametrize("suffix", [".stl", ".3mf", ".glb", ".obj", ".ply", ".off", ".step"])
def test_what_was_written_from_a_design_is_it_in_every_format(run, folder, suffix):
    file, design = folder / f"part{suffix}", folder / "design.toml"
    assert run("build", design, "-o", file).code == 0
    outcome = run("check", file, "--against", design, "--json")
    assert (outcome.code, outcome.err) == (0, "")
    found = json.loads(outcome.out)["against"]
    assert found["passed"]
    assert found["problems"] == []
    (part,) = found["parts"]
    limit = part["within"]
    assert limit == pytest.approx(1e-4 * np.linalg.norm([32.0, 32.0, 6.0]), rel=0.05)
    assert 0.0 <= part["outward"]["distance"] <= limit
    assert -limit <= part["inward"]["distance"] <= 0.0
    assert abs(part["volume"] / part["exact_volume"] - 1.0) < 1e-3
    if suffix == ".step":
        assert part["outward"]["distance"] < 1e-5 * 2.0
        assert abs(part["volume"] / part["exact_volume"] - 1.0) < 1e-7


def test_a_gear_with_play_is_not_the_design_and_where_is_said(run, folder):
    file, design = folder / "part.3mf", folder / "design.toml"
    gw.SpurGear(**DESIGN, backlash=0.1).save(file)
    outcome = run("check", file, "--against", design)
    assert outcome.code == 1
    assert "a check failed" in outcome.out
    assert "valid: closed" in outcome.out
    found = json.loads(run("check", file, "--against", design, "--json").out)["against"]["parts"][0]
    # half the play is this gear's, half of that each flank's, along the pitch circle; cos α of it along the normal
    assert found["inward"]["distance"] == pytest.approx(-0.025 * cos(radians(20.0)), abs=found["within"])
    assert found["outward"]["distance"] <= found["within"]
    assert "inside the design's at (" in outcome.out
    assert run("check", file, "--against", design, "--within", "0.03").code == 0
    assert run("check", file, "--against", design, "--within", "0.02").code == 1


def test_limits_and_designs_that_are_none_are_refused(run, folder):
    file = folder / "part.stl"
    gw.SpurGear(**DESIGN).save(file)
    without = run("check", file, "--within", "0.1")
    assert (without.code, without.out) == (2, "")
    assert "--against" in without.err
    nothing = run("check", file, "--against", folder / "design.toml", "--within", "0")
    assert (nothing.code, nothing.out) == (2, "")
    assert "a positive length is needed" in nothing.err
    missing = run("check", file, "--against", folder / "none.toml")
    assert (missing.code, missing.out) == (2, "")
    assert "none.toml" in missing.err


def test_an_open_file_is_told_its_deviation_and_fails(run, folder):
    file, design = folder / "part.off", folder / "design.toml"
    whole = gw.SpurGear(**DESIGN).polyhedron()
    gw.Polyhedron(whole.vertices, whole.faces[1:]).save(file)
    outcome = run("check", file, "--against", design)
    assert outcome.code == 1
    assert "open edges" in outcome.out
    assert "off the design's, rms" in outcome.out
    assert "the faces bound no solid, so its volume cannot be compared" in outcome.out
