"""Every format that is written is read back with the same moments, names and unit, by readers here and elsewhere."""

from __future__ import annotations

import json
import os
import resource
import signal
import struct
from contextlib import contextmanager
from itertools import pairwise

import lib3mf
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gearwright.colours import BRASS, STEEL
from gearwright.errors import FileError, GeometryError, MachineError
from gearwright.files.assembly import Assembly, Part
from gearwright.files.formats import FILE_FORMATS
from gearwright.files.reading import read
from gearwright.files.recognition import recognise
from gearwright.files.writing import save_polygons
from gearwright.parameters import LENGTH_UNITS
from gearwright.solids.polyhedron import Polyhedron

from . import random_polyhedra as written

WRITTEN = [one for one in FILE_FORMATS if one.writer and one.holds == "polygons"]
SUFFIXES = [suffix for one in WRITTEN for suffix in one.suffixes]
OF_POLYGONS, SINGLE, NAMED = {".obj", ".ply", ".off"}, {".stl", ".gltf", ".glb"}, {".3mf", ".gltf", ".glb", ".obj"}
NAMES = ("pinion", 'gear 2, "é" <&>')
UPRIGHT = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
"""What glTF makes of a body with z up."""

every_suffix = pytest.mark.parametrize("suffix", SUFFIXES)
CUBE = written.prism(4)


def polyhedron(shape):
    return Polyhedron(shape.vertices, shape.faces)


def two_parts(random, suffix, unit="mm"):
    """Any two bodies where they happen to stand; for single precision none that is small beside its distance."""
    parts = []
    for name, colour in zip(NAMES, (BRASS, None), strict=True):
        placement = np.eye(4)
        placement[:3, :3] = Rotation.random(random_state=int(random.integers(2**31))).as_matrix()
        placement[:3, 3] = random.normal(size=3) * 10.0 ** random.uniform(-2, 2)
        tame = written.prism(int(random.integers(3, 9)), float(10.0 ** random.uniform(-1, 2)))
        shape = polyhedron(tame if suffix in SINGLE else written.random_shape(random))
        parts.append(Part(name=name, shape=shape, placement=placement, colour=colour))
    return Assembly(name="a pair", parts=tuple(parts), length_unit=unit)


def placed(part):
    return part.shape.vertices @ part.placement[:3, :3].T + part.placement[:3, 3]


def integrals(vertices, indices, offsets):
    """∫ dV, ∫ r dV, ∫ r rᵀ dV from the tetrahedra of fans about the origin, and the area."""
    sums, area = np.zeros((4, 4)), 0.0
    for start, stop in pairwise(offsets):
        face = vertices[indices[start:stop]]
        for b, c in pairwise(face[1:]):
            corners = np.array([face[0], b, c, [0, 0, 0]])
            points = np.column_stack([np.ones(4), corners])
            total = points.sum(axis=0)
            volume = np.linalg.det(corners[:3]) / 6
            sums += volume * (np.outer(total, total) + points.T @ points) / 20
            area += np.linalg.norm(np.cross(b - face[0], c - face[0])) / 2
    return sums, area


@pytest.mark.parametrize("unit", LENGTH_UNITS)
@every_suffix
def test_what_is_written_is_read_with_the_same_moments_names_and_unit(suffix, unit, tmp_path):
    @settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
    @given(st.integers(0, 2**32 - 1))
    def check(seed):
        assembly = two_parts(np.random.default_rng(seed), suffix, unit)
        path = tmp_path / f"pair{suffix}"
        save_polygons(path, assembly)
        contents = read(path)
        in_metres = suffix in (".gltf", ".glb")
        assert contents.length_unit == ("m" if in_metres else unit)
        assert recognise(path.read_bytes(), "pair").name == next(f.name for f in WRITTEN if suffix in f.suffixes)
        assert [b.name for b in contents.bodies] == (list(NAMES) if suffix in NAMED else [""])
        scale = LENGTH_UNITS[unit] / 1000 if in_metres else 1.0
        turn = UPRIGHT if in_metres else np.eye(3)
        groups = [[part] for part in assembly.parts] if suffix in NAMED else [assembly.parts]
        for body, parts in zip(contents.bodies, groups, strict=True):
            wanted, area = np.zeros((4, 4)), 0.0
            for part in parts:
                found = integrals(scale * placed(part) @ turn.T, part.shape.indices, part.shape.offsets)
                wanted, area = wanted + found[0], area + found[1]
            reach = scale * max(np.linalg.norm(placed(p), axis=1).max() for p in parts)
            reach = max(reach, scale * max(np.linalg.norm(p.shape.vertices, axis=1).max() for p in parts))
            moved = (2.0**-22 if suffix in SINGLE else 2.0**-45) * reach
            found = integrals(body.vertices, body.indices, body.offsets)[0]
            size = np.array([1.0, reach, reach, reach])
            assert np.all(np.abs(found - wanted) <= area * moved * np.outer(size, size))

    check()


@every_suffix
def test_polygons_stay_polygons_where_the_format_has_them(suffix, tmp_path):
    for seed in range(20):
        assembly = two_parts(np.random.default_rng(seed), suffix)
        save_polygons(tmp_path / f"pair{suffix}", assembly)
        found = [face for body in read(tmp_path / f"pair{suffix}").bodies for face in written.faces_of(body)]
        if suffix in OF_POLYGONS:
            corners = (placed(p)[p.shape.indices] for p in assembly.parts)
            splits = (p.shape.offsets[1:-1] for p in assembly.parts)
            wanted = [f for c, s in zip(corners, splits, strict=True) for f in np.split(c, s)]
            assert [len(face) for face in found] == [len(face) for face in wanted]
            off = max(np.abs(np.array(f) - w).max() for f, w in zip(found, wanted, strict=True))
            assert off <= 2.0**-50 * max(np.abs(w).max() for w in wanted)
        else:
            assert {len(face) for face in found} == {3}


def test_numbers_of_unplaced_parts_come_back_to_the_last_bit(tmp_path):
    shape = written.random_shape(np.random.default_rng(7))
    for suffix in (".obj", ".ply", ".off", ".3mf"):
        polyhedron(shape).save(tmp_path / f"part{suffix}")
        assert read(tmp_path / f"part{suffix}").bodies[0].vertices.tolist() == [list(v) for v in shape.vertices]


def test_faces_of_more_corners_than_a_byte_counts(tmp_path):
    wheel = written.prism(300)
    for suffix in OF_POLYGONS:
        polyhedron(wheel).save(tmp_path / f"part{suffix}")
        assert written.faces_of(read(tmp_path / f"part{suffix}").bodies[0]) == written.expected(wheel)


def coloured_pair():
    first, second = (Part(name=n, shape=polyhedron(CUBE), colour=c) for n, c in zip(NAMES, (BRASS, STEEL), strict=True))
    away = np.eye(4)
    away[:3, :3], away[:3, 3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [50, 4, 2]
    return Assembly(
        name="pair & <more>",
        parts=(first, Part(name=second.name, shape=second.shape, colour=STEEL, placement=away)),
        length_unit="in",
    )


def test_lib3mf_reads_3mf_without_a_warning(tmp_path):
    save_polygons(tmp_path / "pair.3mf", coloured_pair())
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(tmp_path / "pair.3mf"))
    assert reader.GetWarningCount() == 0
    assert model.GetUnit() == lib3mf.ModelUnit.Inch
    assert model.GetMetaDataGroup().GetMetaDataByKey("", "Title").GetValue() == "pair & <more>"
    items, found = model.GetBuildItems(), []
    while items.MoveNext():
        item = items.GetCurrent()
        mesh = model.GetMeshObjectByID(item.GetObjectResource().GetResourceID())
        assert mesh.IsManifoldAndOriented()
        material, exists = mesh.GetObjectLevelProperty()[1:]
        assert exists
        group = model.GetBaseMaterialGroupByID(1)
        colour = group.GetDisplayColor(material)
        found.append((mesh.GetName(), [list(row) for row in item.GetObjectTransform().Fields], colour))
    (first, identity, brass), (second, moved, steel) = found
    assert (first, second) == NAMES
    assert identity == [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]
    # row vectors: x goes to y, y to −x
    assert moved == [[0, 1, 0], [-1, 0, 0], [0, 0, 1], [50, 4, 2]]
    assert (brass.Red, brass.Green, brass.Blue, brass.Alpha) == (204, 163, 92, 255)
    assert (steel.Red, steel.Green, steel.Blue, steel.Alpha) == (153, 168, 186, 255)


@pytest.mark.parametrize("suffix", [".stl", ".glb", ".gltf", ".obj", ".ply", ".off"])
def test_trimesh_reads_the_same_volume_and_box(suffix, tmp_path):
    assembly = coloured_pair()
    save_polygons(tmp_path / f"pair{suffix}", assembly)
    found = trimesh.load(tmp_path / f"pair{suffix}", force="scene").to_mesh()
    found.merge_vertices()
    assert found.is_watertight
    scale = 0.0254 if suffix in (".glb", ".gltf") else 1.0
    # each cube stands on a square with corners at distance 1 from its axis: side √2, height 1
    assert found.volume == pytest.approx(4 * scale**3, rel=1e-5)
    box = np.array([[-1, -1, 0], [51, 5, 3]]) * scale
    if suffix in (".glb", ".gltf"):
        box = np.array([[box[0, 0], box[0, 2], -box[1, 1]], [box[1, 0], box[1, 2], -box[0, 1]]])
    np.testing.assert_allclose(found.bounds, box, atol=1e-5 * scale)


def test_other_programs_see_the_colours(tmp_path):
    save_polygons(tmp_path / "pair.ply", coloured_pair())
    save_polygons(tmp_path / "pair.glb", coloured_pair())
    colours = trimesh.load(tmp_path / "pair.ply", process=False).visual.vertex_colors[:, :3]
    assert colours[:8].tolist() == [[204, 163, 92]] * 8
    assert colours[8:].tolist() == [[153, 168, 186]] * 8
    data = (tmp_path / "pair.glb").read_bytes()
    (size,) = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20 : 20 + size])
    factors = [one["pbrMetallicRoughness"]["baseColorFactor"] for one in document["materials"]]
    # 0.6 and 0.8 of sRGB are 0.318547 and 0.603827 of the light
    assert factors[0][0] == pytest.approx(0.603827, abs=1e-6)
    assert factors[1][0] == pytest.approx(0.318547, abs=1e-6)
    assert [mesh["primitives"][0]["material"] for mesh in document["meshes"]] == [0, 1]
    assert "NORMAL" not in json.dumps(document)


def test_binary_gltf_is_laid_out_in_fours(tmp_path):
    for name in ("a", "ab", "abc", "abcd"):
        polyhedron(CUBE).save(tmp_path / f"{name}.glb")
        data = (tmp_path / f"{name}.glb").read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        assert size % 4 == 0
        assert struct.unpack_from("<I4s", data, 20 + size)[1] == b"BIN\0"
        assert struct.unpack_from("<I", data, 8)[0] == len(data)


@every_suffix
def test_names_that_no_file_can_hold_are_written_as_near_as_can_be(suffix, tmp_path):
    part = Part(name="a\n\x07b\udcff c", shape=polyhedron(CUBE))
    save_polygons(tmp_path / f"part{suffix}", Assembly(name="\0", parts=(part,)))
    (body,) = read(tmp_path / f"part{suffix}").bodies
    assert body.name == ("a ?b? c" if suffix in NAMED else "")


@every_suffix
def test_equal_bodies_give_equal_files(suffix, tmp_path):
    save_polygons(tmp_path / f"one{suffix}", coloured_pair())
    save_polygons(tmp_path / f"two{suffix}", coloured_pair())
    assert (tmp_path / f"one{suffix}").read_bytes() == (tmp_path / f"two{suffix}").read_bytes()


def test_triangles_with_two_corners_at_one_vertex_are_no_triangles_of_3mf(tmp_path):
    # a square whose border goes along a spur and back: its fan holds the triangle 0 1 0
    spur = Polyhedron(CUBE.vertices, [[0, 1, 0, 3, 2, 1] if sorted(f) == [0, 1, 2, 3] else f for f in CUBE.faces])
    spur.save(tmp_path / "part.3mf")
    body = read(tmp_path / "part.3mf").bodies[0]
    triangles = body.indices.reshape(-1, 3)
    assert all(len(set(t)) == 3 for t in triangles.tolist())
    assert Polyhedron(body.vertices, triangles).properties().volume == pytest.approx(2, rel=1e-14)


@pytest.mark.parametrize("suffix", [".3mf", ".glb", ".gltf"])
def test_a_format_with_a_unit_needs_one(suffix, tmp_path):
    with pytest.raises(FileError, match="give one of um, mm, cm"):
        polyhedron(CUBE).save(tmp_path / f"part{suffix}", length_unit=None)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("suffix", sorted(SINGLE))
def test_what_single_precision_cannot_hold_is_refused(suffix, tmp_path):
    far = Polyhedron(np.array(CUBE.vertices) * 1e-3 + 1e5, CUBE.faces)
    with pytest.raises(FileError, match=r"single precision, all that (STL|glTF) has"):
        far.save(tmp_path / f"part{suffix}")
    assert not list(tmp_path.iterdir())
    place = np.eye(4)
    place[:3, 3] = 1e5
    small = Part(name="small", shape=Polyhedron(np.array(CUBE.vertices) * 1e-3, CUBE.faces), placement=place)
    assembly = Assembly(name="far", parts=(small,))
    if suffix == ".stl":
        with pytest.raises(FileError, match="single precision"):
            save_polygons(tmp_path / f"part{suffix}", assembly)
    else:  # it stands far away by its node, whose numbers are double
        save_polygons(tmp_path / f"part{suffix}", assembly)
        size = np.ptp(read(tmp_path / f"part{suffix}").bodies[0].vertices, axis=0)
        np.testing.assert_allclose(size, [2e-6, 1e-6, 2e-6], rtol=1e-4)


@pytest.mark.parametrize("suffix", [".stl", ".3mf", ".glb"])
def test_a_face_that_cannot_be_cut_leaves_the_old_file(suffix, tmp_path):
    # an H, of which no corner sees everything
    outline = np.array([[0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [3, 0], [3, 5], [2, 5], [2, 3], [1, 3], [1, 5], [0, 5]])
    count = len(outline)
    vertices = [(*p, z) for z in (0.0, 1.0) for p in outline.tolist()]
    around = [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    body = Polyhedron(vertices, [list(range(count))[::-1], list(range(count, 2 * count)), *around])
    path = tmp_path / f"part{suffix}"
    path.write_bytes(b"old")
    with pytest.raises(GeometryError, match="face 0 of 12 corners: no corner sees all of it"):
        body.save(path)
    assert path.read_bytes() == b"old"
    body.save(tmp_path / "part.obj")
    assert Polyhedron.load(tmp_path / "part.obj").properties().volume == pytest.approx(11)


@every_suffix
def test_bodies_without_faces_are_refused(suffix, tmp_path):
    with pytest.raises(FileError, match="holds faces, and part has none"):
        Polyhedron([], np.empty((0, 3), int)).save(tmp_path / f"part{suffix}")
    assert not list(tmp_path.iterdir())


@contextmanager
def at_most(size):
    """Files cannot grow beyond so many bytes, as on a disk that is full."""
    before, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


@every_suffix
@pytest.mark.parametrize("size", [0, 700])
def test_a_full_disk_leaves_the_old_file(suffix, size, tmp_path):
    path = tmp_path / f"part{suffix}"
    path.write_bytes(b"old")
    with at_most(size), pytest.raises(MachineError, match="nothing was changed"):
        polyhedron(written.prism(200)).save(path)
    assert path.read_bytes() == b"old"
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


@every_suffix
def test_names_that_are_no_files(suffix, tmp_path, monkeypatch):
    with pytest.raises(FileError, match="there is no folder"):
        polyhedron(CUBE).save(tmp_path / "nowhere" / f"part{suffix}")
    with pytest.raises(MachineError, match="cannot be written in this folder"):
        polyhedron(CUBE).save(f"/proc/part{suffix}")
    (tmp_path / f"part{suffix}").mkdir()
    with pytest.raises(FileError, match="folder or device"):
        polyhedron(CUBE).save(tmp_path / f"part{suffix}")

    def refused(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "fsync", refused)
    with pytest.raises(MachineError, match="Permission denied"):
        polyhedron(CUBE).save(tmp_path / f"other{suffix}")


def test_unknown_suffixes_are_refused_with_those_there_are():
    with pytest.raises(FileError, match=r"part.iges: .* cannot be written; known suffixes: .stl, .3mf, .gltf, .glb"):
        polyhedron(CUBE).save("part.iges")
