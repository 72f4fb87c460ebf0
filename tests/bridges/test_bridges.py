"""Meshes of other libraries are the same bodies: their volumes, places and names are ours."""

import sys

import numpy as np
import pytest

import gearwright as gw
from gearwright.colours import BRASS, STEEL

GEAR = gw.SpurGear(teeth=17, module=2, face_width=10, bore=12)
PAIR = gw.GearPair(teeth=(17, 30), module=2, face_width=10, kind="helical", helix_angle=15)
PRISM = gw.extrude(gw.Section.polygon([[0, 0], [9, 0], [9, 2], [2, 2], [2, 7], [0, 7]]), 5)
FIVE_SIDED = gw.Polyhedron(
    [[x, y, z] for z in (0, 3) for x, y in ((0, 0), (4, 0), (4, 2), (2, 5), (0, 2))],
    [[4, 3, 2, 1, 0], [5, 6, 7, 8, 9], *([k, (k + 1) % 5, 5 + (k + 1) % 5, 5 + k] for k in range(5))],
)
"""A house: 8 + 6 square units, 3 high."""


def test_the_house_keeps_its_pentagons_in_pyvista_and_has_its_volume_everywhere():
    mesh = FIVE_SIDED.to_pyvista(name="house", length_unit="in")
    assert sorted(mesh.get_cell(k).n_points for k in range(mesh.n_cells)) == [4, 4, 4, 4, 4, 5, 5]
    assert mesh.volume == pytest.approx(42.0, rel=1e-13)
    assert FIVE_SIDED.to_trimesh().volume == pytest.approx(42.0, rel=1e-13)
    assert mesh.user_dict["name"] == "house"
    assert mesh.user_dict["length_unit"] == "in"
    assert mesh.points.dtype == np.float64
    np.testing.assert_array_equal(mesh.points, FIVE_SIDED.vertices)


@pytest.mark.parametrize("body", [GEAR, PRISM], ids=["element", "solid"])
def test_volumes_are_those_of_the_polyhedron(body):
    polyhedron = body.polyhedron(0.05).properties()
    mesh = body.to_trimesh(0.05)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(polyhedron.volume, rel=1e-12)
    np.testing.assert_allclose(mesh.center_mass, polyhedron.centroid, atol=1e-11)
    assert body.to_pyvista(0.05).volume == pytest.approx(polyhedron.volume, rel=1e-12)


def test_an_element_brings_its_name_unit_and_colour():
    mesh, surface = GEAR.to_trimesh(), GEAR.to_pyvista()
    assert mesh.metadata["name"] == surface.user_dict["name"] == GEAR.description
    assert mesh.units == surface.user_dict["length_unit"] == "mm"
    shade = np.rint(np.array(BRASS) * 255)
    assert np.all(mesh.visual.face_colors == [*shade, 255])
    assert np.all(surface.cell_data["RGB"] == shade)
    np.testing.assert_allclose(surface.user_dict["colour"], BRASS)


def test_a_pair_is_a_scene_of_placed_members():
    scene = PAIR.to_trimesh(turn=11.0)
    assert sorted(scene.geometry) == ["gear", "pinion"]
    for name, placement in zip(("pinion", "gear"), PAIR.placements(11.0), strict=True):
        matrix, geometry = scene.graph[name]
        assert geometry == name
        np.testing.assert_allclose(matrix, placement, atol=1e-14)
    expected = sum(part.polyhedron.properties().volume for part in PAIR.parts())
    assert scene.to_mesh().volume == pytest.approx(expected, rel=1e-12)
    assert np.all(scene.geometry["gear"].visual.face_colors[:, :3] == np.rint(np.array(STEEL) * 255))


def test_blocks_of_a_pair_stand_in_mesh():
    blocks = PAIR.to_pyvista(turn=11.0)
    assert blocks.keys() == ["pinion", "gear"]
    for block, part in zip(blocks, PAIR.parts(turn=11.0), strict=True):
        placed = part.placed.properties()
        assert block.volume == pytest.approx(placed.volume, rel=1e-12)
        np.testing.assert_allclose(np.ptp(block.points, axis=0), np.ptp(part.placed.vertices, axis=0), rtol=1e-12)
        np.testing.assert_allclose(block.points.mean(axis=0), part.placed.vertices.mean(axis=0), atol=1e-10)
        np.testing.assert_allclose(block.user_dict["placement"], part.placement, atol=0)


@pytest.mark.parametrize(
    ("library", "convert", "extra"),
    [("trimesh", FIVE_SIDED.to_trimesh, "mesh"), ("pyvista", FIVE_SIDED.to_pyvista, "notebook")],
)
def test_a_missing_library_is_the_machines_fault_and_says_what_to_install(monkeypatch, library, convert, extra):
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(gw.MachineError, match=rf"pip install 'gearwright\[{extra}\]'"):
        convert()


def test_a_face_that_cannot_be_cut_is_named_for_trimesh_and_kept_for_pyvista():
    # a comb: from no corner are all of its teeth seen
    comb = [(0, 0), (9, 0), (9, 4), (8, 1), (7, 4), (6, 4), (5, 1), (4, 4), (3, 4), (2, 1), (1, 4), (0, 4)]
    count = len(comb)
    faces = [list(range(count))[::-1], [count + k for k in range(count)]]
    faces += [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    body = gw.Polyhedron([[x, y, z] for z in (0, 1) for x, y in comb], faces)
    with pytest.raises(gw.GeometryError, match="face 0 of 12 corners"):
        body.to_trimesh()
    assert body.to_pyvista().volume == pytest.approx(body.properties().volume, rel=1e-12)
