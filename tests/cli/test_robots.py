"""`-o file.urdf|.sdf|.xml`: what Python writes, and refusals."""

import json

import pytest

import gearwright as gw

PAIR = "spur --teeth 13 17 --module 2 --face-width 6 --tolerance 0.5".split()
GEAR = "spur --teeth 13 --module 2 --face-width 6 --tolerance 0.5".split()

every_suffix = pytest.mark.parametrize("suffix", [".urdf", ".sdf", ".xml", ".mjcf", ".URDF"])


def files(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@every_suffix
@pytest.mark.parametrize("density", [["--material", "steel"], ["--density", "7850"]], ids=" ".join)
def test_a_pair_is_written_as_python_writes_it(run, tmp_path, suffix, density):
    path = tmp_path / "new" / f"pair{suffix}"
    outcome = run(*PAIR, "-o", path, *density)
    assert outcome.code == 0, outcome.err
    meshes = [tmp_path / f"new/pair_meshes/{name}.stl" for name in ("pinion", "gear")]
    assert [line for line in outcome.err.splitlines() if line.startswith("wrote")] == [
        f"wrote {one}" for one in (path, *meshes)
    ]
    (tmp_path / "python").mkdir()
    pair = gw.GearPair(kind="spur", teeth=(13, 17), module=2.0, face_width=6.0)
    pair.save(tmp_path / f"python/pair{suffix}", 0.5, density="steel")
    assert files(tmp_path / "new") == files(tmp_path / "python")


@every_suffix
def test_a_part_is_written_as_python_writes_it(run, tmp_path, suffix):
    outcome = run(*GEAR, "-o", tmp_path / f"gear{suffix}", "--material", "brass", "--json")
    assert outcome.code == 0, outcome.err
    assert json.loads(outcome.out)["properties"]["mass_unit"] == "kg"
    (tmp_path / "python").mkdir()
    gear = gw.SpurGear(teeth=13, module=2.0, face_width=6.0)
    gear.save(tmp_path / f"python/gear{suffix}", 0.5, density="brass")
    assert (tmp_path / f"gear{suffix}").read_bytes() == (tmp_path / f"python/gear{suffix}").read_bytes()
    mesh = "gear_meshes/part.stl"
    assert (tmp_path / mesh).read_bytes() == (tmp_path / "python" / mesh).read_bytes()


def test_the_turn_is_where_the_joints_are_at_0(run, tmp_path):
    assert run(*PAIR, "-o", tmp_path / "pair.urdf", "--material", "steel", "--turn", "90").code == 0
    assert 'rpy="0.0 0.0 1.5707963267948966"' in (tmp_path / "pair.urdf").read_text()


@every_suffix
@pytest.mark.parametrize("words", [PAIR, GEAR], ids=["pair", "part"])
def test_without_a_density_nothing_is_written(run, tmp_path, words, suffix):
    outcome = run(*words, "-o", tmp_path / f"x{suffix}")
    assert outcome.code == 2
    assert outcome.out == ""
    assert f"--output {tmp_path / 'x'}{suffix}: " in outcome.err
    assert "holds masses; give a --material NAME, or a --density in kg/m³" in outcome.err
    assert files(tmp_path) == {}


def test_a_wrong_density_is_all_that_is_said(run, tmp_path):
    outcome = run(*PAIR, "-o", tmp_path / "x.urdf", "--density", "-1")
    assert outcome.code == 2
    assert "--density = -1" in outcome.err
    assert "holds masses" not in outcome.err
    assert files(tmp_path) == {}


def test_a_density_and_a_shape_go_together_at_the_command_line(run, tmp_path):
    """There the density is of what is printed."""
    assert run(*PAIR, "-o", tmp_path / "x.stl", "--material", "steel").code == 0


def test_a_design_is_written(run, tmp_path):
    (tmp_path / "gear.toml").write_text('element = "spur"\nteeth = 13\nmodule = 2\nface_width = 6\n')
    outcome = run("build", tmp_path / "gear.toml", "-o", tmp_path / "gear.xml", "--material", "PA66")
    assert outcome.code == 0, outcome.err
    assert set(files(tmp_path)) == {"gear.toml", "gear.xml", "gear_meshes/part.stl"}
