"""Programs that know triangles alone find whole parts closed, every facet the right way around."""

import re
import subprocess

import lib3mf
import pytest
import trimesh

from gearwright.parameters import LENGTH_UNITS
from gearwright.solids.polyhedron import Polyhedron

from .parts import PARTS, built, solids

SINGLE = 1e-6
"""Relative error of a volume whose corners are rounded to single precision."""

SUMMED = 1e-4
"""The same where ADMesh has also summed tens of thousands of cones in single precision."""


def polyhedra(name: str) -> list[Polyhedron]:
    return [solid.element.polyhedron() for solid in solids(name)]


def volume(name: str) -> float:
    """Of its polyhedra, in the part's own unit."""
    return sum(one.properties().volume for one in polyhedra(name))


@pytest.mark.parametrize("name", PARTS)
def test_admesh_finds_nothing_to_mend(name, tmp_path):
    built(name).save(tmp_path / "part.stl")
    done = subprocess.run(["admesh", str(tmp_path / "part.stl")], check=True, capture_output=True, text=True)
    said = {label: float(number) for label, number in re.findall(r"([A-Z][a-z ]+?) *: +([\d.]+)", done.stdout)}
    assert said.pop("Volume") == pytest.approx(volume(name), rel=SUMMED)
    assert said.pop("Number of parts") == len(solids(name))
    assert said.pop("Number of facets") == sum(len(one.triangles()) for one in polyhedra(name))
    wrong = {"Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"}
    assert wrong <= set(said)
    assert {label: number for label, number in said.items() if number} == {}


@pytest.mark.parametrize("name", ["spiral bevel pair", "spur gear in inches"])
@pytest.mark.parametrize("suffix", [".stl", ".glb", ".obj", ".ply", ".off"])
def test_trimesh_finds_whole_parts_watertight(name, suffix, tmp_path):
    built(name).save(tmp_path / f"part{suffix}")
    found = trimesh.load(tmp_path / f"part{suffix}", force="scene").to_mesh()
    found.merge_vertices()
    assert found.is_watertight
    assert found.is_winding_consistent
    assert found.body_count == len(solids(name))
    metres = LENGTH_UNITS[built(name).length_unit] / 1000 if suffix == ".glb" else 1.0
    assert found.volume == pytest.approx(volume(name) * metres**3, rel=SINGLE)


@pytest.mark.parametrize("name", PARTS)
def test_lib3mf_reads_whole_parts_without_a_warning(name, tmp_path):
    built(name).save(tmp_path / "part.3mf")
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(tmp_path / "part.3mf"))
    assert reader.GetWarningCount() == 0
    meshes, counts = model.GetMeshObjects(), []
    while meshes.MoveNext():
        mesh = meshes.GetCurrentMeshObject()
        assert mesh.IsManifoldAndOriented()
        counts.append(mesh.GetTriangleCount())
    assert counts == [len(one.triangles()) for one in polyhedra(name)]
