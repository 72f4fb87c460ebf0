"""glTF files, written here number by number: what their scenes hold, and everything that can be wrong with one."""

from __future__ import annotations

import base64
import copy
import json
import struct

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gearwright.errors import FileError
from gearwright.files import instances
from gearwright.files.gltf import accessors, buffers
from gearwright.files.gltf.scene import parse
from gearwright.moments.faces import Corners
from gearwright.solids.model import Model
from gearwright.solids.polyhedron import Polyhedron

# volume 1, centroid (1/4, 1/2, 3/4): legs 1, 2, 3
VERTICES = np.array([(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)])
TRIANGLES = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
TYPES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}


class Scene:
    """A document that is put together piece by piece; `data` is its one buffer."""

    def __init__(self):
        self.data = b""
        self.document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"name": "corner", "primitives": []}], "accessors": [], "bufferViews": [],
        }  # fmt: skip

    def view(self, data, **more):
        self.data += b"\0" * (-len(self.data) % 4)
        self.document["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more}
        )
        self.data += data
        return len(self.document["bufferViews"]) - 1

    def accessor(self, array, kind="f4", **more):
        array = np.asarray(array).astype("<" + kind)
        entry = {
            "bufferView": self.view(array.tobytes()), "componentType": TYPES[kind], "count": len(array),
            "type": "SCALAR" if array.ndim == 1 else "VEC3", **more,
        }  # fmt: skip
        self.document["accessors"].append(entry)
        return len(self.document["accessors"]) - 1

    def primitive(self, positions, indices=None, **more):
        found = {"attributes": {"POSITION": positions}, **({} if indices is None else {"indices": indices}), **more}
        self.document["meshes"][0]["primitives"].append(found)
        return self

    def text(self, uri=None):
        document = copy.deepcopy(self.document)
        if self.data:
            inside = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
            document["buffers"] = [{"byteLength": len(self.data), "uri": uri or inside}]
        return json.dumps(document).encode()

    def binary(self):
        document = json.dumps({**self.document, "buffers": [{"byteLength": len(self.data)}]}).encode()
        document += b" " * (-len(document) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        size = 12 + 8 + len(document) + 8 + len(data)
        head = struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(document), b"JSON")
        return head + document + struct.pack("<I4s", len(data), b"BIN\0") + data


def corner(kind="u2", **more):
    scene = Scene()
    return scene.primitive(scene.accessor(VERTICES), scene.accessor(TRIANGLES.ravel(), kind), **more)


def changed(found, **members):
    found.document.update(members)
    return found


def one_body(data):
    (body,) = parse(data, "scene.gltf").bodies
    return body


def properties(body):
    return Polyhedron(body.vertices, Corners(body.indices, body.offsets)).properties()


def assert_corner(body):
    np.testing.assert_array_equal(body.vertices[body.indices], VERTICES[TRIANGLES.ravel()])
    assert len(body.vertices) == 4


def refused(data, *said):
    with pytest.raises(FileError) as caught:
        parse(data if isinstance(data, bytes) else data.text(), "some/scene.gltf")
    assert str(caught.value).startswith("some/scene.gltf: ")
    for words in said:
        assert words in str(caught.value)


@pytest.mark.parametrize("kind", ["u1", "u2", "u4"])
def test_text_and_binary(kind, tmp_path):
    scene = corner(kind)
    (tmp_path / "part.GLB").write_bytes(scene.binary())
    (tmp_path / "part.gltf").write_bytes(scene.text())
    for name in ("part.GLB", "part.gltf"):
        model = Model.load(tmp_path / name)
        assert (list(model.bodies), model.length_unit, model.remarks) == (["corner"], "m", ())
    assert_corner(one_body(scene.binary()))
    assert_corner(one_body(scene.text()))
    assert one_body(scene.text()).rounding == 2.0**-23


def test_points_split_at_normals_are_joined():
    scene = Scene()
    assert_corner(one_body(scene.primitive(scene.accessor(VERTICES[TRIANGLES.ravel()])).text()))


def test_all_primitives_of_a_mesh_are_one_body():
    scene = Scene()
    positions = scene.accessor(VERTICES)
    for triangle in TRIANGLES:
        scene.primitive(positions, scene.accessor(triangle, "u1"))
    assert_corner(one_body(scene.text()))


def test_strips_and_fans():
    """The strip 0 2 1 3 0 2 is the tetrahedron 021 231 130 320; a linked one repeats corners between its pieces."""
    scene = Scene()
    positions = scene.accessor(VERTICES)
    strip = scene.primitive(positions, scene.accessor([0, 2, 1, 3, 0, 2], "u2"), mode=5)
    assert properties(one_body(strip.text())).volume == pytest.approx(1, rel=1e-15)
    linked = changed(scene, meshes=[{"primitives": []}]).primitive(
        positions, scene.accessor([0, 2, 1, 1, 2, 2, 1, 3, 0, 2], "u2"), mode=5
    )
    assert len(one_body(linked.text()).offsets) - 1 == 4
    assert properties(one_body(linked.text())).volume == pytest.approx(1, rel=1e-15)
    # seen from the corner at 0, its three faces are a fan; the fourth closes them
    fan = changed(scene, meshes=[{"primitives": []}]).primitive(
        positions, scene.accessor([0, 1, 3, 2, 1], "u1"), mode=6
    )
    fan.primitive(positions, scene.accessor([1, 2, 3], "u1"))
    assert properties(one_body(fan.text())).volume == pytest.approx(1, rel=1e-15)


@pytest.mark.parametrize(("mode", "what"), [(0, "points"), (1, "lines"), (2, "lines"), (3, "lines")])
def test_points_and_lines_are_left_out(mode, what):
    scene = corner()
    contents = parse(scene.primitive(0, mode=mode).text(), "x")
    assert len(contents.bodies) == 1
    assert contents.remarks == (f"{what} left out",)
    alone = Scene()
    refused(alone.primitive(alone.accessor(VERTICES), mode=mode), "without a body", f"{what} left out")


def test_strides_and_offsets():
    rows = np.zeros((5, 6), "<f4")
    rows[1:, 1:4] = VERTICES
    scene = Scene()
    view = scene.view(rows.tobytes(), byteStride=24)
    scene.document["accessors"].append(
        {"bufferView": view, "byteOffset": 28, "componentType": 5126, "count": 4, "type": "VEC3"}
    )
    assert_corner(one_body(scene.primitive(0, scene.accessor(TRIANGLES.ravel(), "u1")).text()))
    scene.document["accessors"][0]["byteOffset"] = 40
    refused(scene, "accessors[0]: 4 elements of 12 bytes, 24 apart from byte 40, do not fit into the 120 bytes")


@pytest.mark.parametrize("based", [True, False])
def test_sparse_accessors(based):
    """Either zeros or another array, with some elements replaced."""
    scene = Scene()
    places, values = scene.view(np.array([1, 3], "<u2").tobytes()), scene.view(VERTICES[[1, 3]].astype("<f4").tobytes())
    base = np.array([(0, 0, 0), (9, 9, 9), (0, 2, 0), (9, 9, 9)])
    position = scene.accessor(base)
    sparse = {"count": 2, "indices": {"bufferView": places, "componentType": 5123}, "values": {"bufferView": values}}
    entry = scene.document["accessors"][position]
    entry["sparse"] = sparse
    if not based:
        del entry["bufferView"]
    scene.primitive(position, scene.accessor(TRIANGLES.ravel(), "u1"))
    body = one_body(scene.text())
    expected = VERTICES * (1 if based else [[1], [1], [0], [1]])
    np.testing.assert_array_equal(body.vertices[body.indices], expected[TRIANGLES.ravel()])
    sparse["indices"]["byteOffset"] = 2
    refused(scene, "accessors[0].sparse.indices", "do not fit")
    sparse["indices"]["byteOffset"], sparse["count"] = 0, 5
    refused(scene, "accessors[0].sparse.count", "from 1 to 4")


@pytest.mark.parametrize(
    ("kind", "stored", "normalised"),
    [
        ("i1", 127, True),
        ("u1", 255, True),
        ("i2", 32767, True),
        ("u2", 65535, True),
        ("i2", 1, False),
        ("u1", 1, False),
    ],
)
def test_quantised_positions(kind, stored, normalised):
    """The largest whole number stands for 1, which the node scales to the size wanted."""
    scene = Scene()
    unit = (VERTICES > 0) * stored
    scene.primitive(scene.accessor(unit, kind, normalized=normalised), scene.accessor(TRIANGLES.ravel(), "u1"))
    scene.document["nodes"] = [{"mesh": 0, "scale": [1, 2, 3]}]
    scene.document["extensionsRequired"] = ["KHR_mesh_quantization"]
    body = one_body(scene.text())
    np.testing.assert_allclose(body.vertices[body.indices], VERTICES[TRIANGLES.ravel()], rtol=1e-15)
    assert body.rounding == pytest.approx(3 * 0.5 / stored, rel=1e-12)
    assert not parse(scene.text(), "x").remarks


def test_the_least_normalised_number_is_minus_one():
    scene = Scene()
    scene.primitive(scene.accessor(VERTICES * -64, "i1", normalized=True), scene.accessor([0, 1, 2], "u1"))
    assert one_body(scene.text()).vertices.min() == -1.0


def test_matrices_are_written_by_columns():
    turn_and_shift = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1]  # x goes to y
    body = one_body(changed(corner(), nodes=[{"mesh": 0, "matrix": turn_and_shift}]).text())
    expected = np.array([(10, 20, 30), (10, 21, 30), (8, 20, 30), (10, 20, 33)])
    np.testing.assert_array_equal(body.vertices[body.indices], expected[TRIANGLES.ravel()])


def test_children_stand_in_their_parents():
    nodes = [
        {"translation": [5, 0, 0], "scale": [2, 2, 2], "children": [1]},
        {"mesh": 0, "translation": [1, 0, 0], "children": [2], "name": "inner"},
        {"mesh": 0, "translation": [0, 1, 0]},
    ]
    first, second = parse(changed(corner(), nodes=nodes).text(), "x").bodies
    assert (first.name, second.name) == ("inner", "corner")
    np.testing.assert_array_equal(first.vertices[0], [7, 0, 0])
    np.testing.assert_array_equal(second.vertices[0], [7, 2, 0])
    assert properties(second).volume == pytest.approx(8, rel=1e-14)


def test_mirrored_nodes_stay_outward():
    body = one_body(changed(corner(), nodes=[{"mesh": 0, "scale": [-1, 1, 1]}]).text())
    assert properties(body).volume == pytest.approx(1, rel=1e-14)
    assert properties(body).centroid[0] == pytest.approx(-0.25, rel=1e-14)


finite = st.floats(-3, 3).map(lambda x: round(x, 3))


@settings(max_examples=60, deadline=None)
@given(*[st.lists(finite, min_size=n, max_size=n) for n in (3, 4, 3)])
def test_rotations_and_scales_against_scipy(translation, quaternion, scale):
    length = np.linalg.norm(quaternion)
    assume(length > 0.1)
    assume(min(map(abs, scale)) > 0.05)
    quaternion = [float(one / length) for one in quaternion]
    node = {"mesh": 0, "translation": translation, "rotation": quaternion, "scale": scale}
    found = properties(one_body(changed(corner(), nodes=[node]).text()))
    assert found.volume == pytest.approx(abs(np.prod(scale)), rel=1e-12)
    centroid = Rotation.from_quat(quaternion).apply(np.array([0.25, 0.5, 0.75]) * scale) + translation
    np.testing.assert_allclose(found.centroid, centroid, rtol=1e-12, atol=1e-12)


def test_scenes():
    nodes = [{"mesh": 0, "name": "first"}, {"mesh": 0, "name": "second"}]

    def names(scene):
        return [body.name for body in parse(scene.text(), "x").bodies]

    two = changed(corner(), nodes=nodes, scenes=[{"nodes": [0]}, {"nodes": [1]}], scene=1)
    assert names(two) == ["second"]
    assert parse(two.text(), "x").remarks == ("1 other scenes left out",)
    del two.document["scene"]
    assert names(two) == ["first"]
    del two.document["scenes"]
    assert names(two) == ["first", "second"]


@pytest.mark.parametrize("name", ["KHR_draco_mesh_compression", "EXT_meshopt_compression"])
def test_compressed_meshes(name):
    refused(changed(corner(), extensionsRequired=[name]), f"compressed ({name})", "without compression")
    assert_corner(one_body(changed(corner(), extensionsUsed=[name]).text()))


def test_other_extensions():
    refused(changed(corner(), extensionsRequired=["EXT_mesh_gpu_instancing"]), "one node for every instance")
    instanced = changed(corner(), nodes=[{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}}, "skin": 0}])
    assert len(parse(instanced.text(), "x").remarks) == 2
    harmless = ["KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization"]
    assert not parse(changed(corner(), extensionsRequired=harmless).text(), "x").remarks
    assert_corner(one_body(changed(corner(), extensionsUsed=["OWN_x"]).text()))


@pytest.mark.parametrize("name", ["OWN_x", "KHR_gaussian_splatting", "KHR_mesh_quantization_2", "x_KHR_materials_"])
def test_unknown_extensions_are_refused_where_they_are_required(name):
    refused(
        changed(corner(), extensionsRequired=["KHR_materials_unlit", name]),
        f"requires the glTF extension {name}, which is not known here", "export it without",
    )  # fmt: skip


def test_files_beside_it(tmp_path):
    scene = corner()
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "a b.bin").write_bytes(scene.data + b"more")
    path = tmp_path / "scene.gltf"
    path.write_bytes(scene.text("data/a%20b.bin"))
    assert_corner(*parse(path.read_bytes(), str(path)).bodies)
    (tmp_path / "data" / "a b.bin").write_bytes(scene.data[:-1])
    with pytest.raises(FileError, match=r"buffers\[0\]: announces 72 bytes, but 71 are there"):
        parse(path.read_bytes(), str(path))
    with pytest.raises(FileError, match="there is no such file"):
        parse(scene.text("missing.bin"), str(path))
    refused(scene.text("data/a%20b.bin"), 'data are in the file "data/a b.bin"', "without a folder", ".glb")
    with pytest.raises(FileError, match="without a folder it is not found"):
        parse(scene.text("data/a%20b.bin"), "standard input")


@pytest.mark.parametrize(
    "uri", ["../secret.bin", "/etc/passwd", "a/../../secret.bin", "%2e%2e/secret.bin", "file:///etc/passwd", "C:\\x",
            "http://example.com/x", "\\\\host\\x", "a\0b"]
)  # fmt: skip
def test_files_elsewhere(uri, tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "secret.bin").write_bytes(corner().data)
    path = tmp_path / "inner" / "scene.gltf"
    path.write_bytes(corner().text(uri))
    with pytest.raises(FileError, match="is no name of a file beside this one; save the scene as one file"):
        parse(path.read_bytes(), str(path))


def test_links_elsewhere(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "secret.bin").write_bytes(corner().data)
    (tmp_path / "inner" / "link.bin").symlink_to(tmp_path / "secret.bin")
    path = tmp_path / "inner" / "scene.gltf"
    path.write_bytes(corner().text("link.bin"))
    with pytest.raises(FileError, match="leads out of the folder"):
        parse(path.read_bytes(), str(path))


def test_cycles_and_depth(monkeypatch):
    refused(changed(corner(), nodes=[{"children": [0]}]), "node 0 holds itself;")
    loop = [{"children": [1]}, {"children": [2]}, {"children": [1]}]
    refused(changed(corner(), nodes=loop), "node 1 is held by nodes[0], too")
    refused(changed(corner(), nodes=[{"children": [1]}, {"children": [0]}]), "node 0 holds itself through node 1")
    deepest = [{"children": [k + 1]} for k in range(instances.MOST_DEPTH - 1)]
    assert len(parse(changed(corner(), nodes=[*deepest, {"mesh": 0}]).text(), "x").bodies) == 1
    deeper = [*deepest, {"children": [instances.MOST_DEPTH]}, {"mesh": 0}]
    refused(changed(corner(), nodes=deeper), "nested more than 128 deep")
    monkeypatch.setattr(instances, "MOST_NODES", 5)
    refused(changed(corner(), nodes=[{"children": [1, 2, 3, 4, 5]}, *[{}] * 5]), "more than 5 placed ones")


def test_huge_claims(monkeypatch):
    scene = corner()
    del scene.document["accessors"][0]["bufferView"]
    scene.document["accessors"][0]["count"] = 10**12
    refused(scene, "accessors[0]: accessors of more than 100000000 elements")
    monkeypatch.setattr(accessors, "MOST_ELEMENTS", 15)
    refused(corner(), "accessors of more than 15 elements")
    monkeypatch.undo()
    monkeypatch.setattr(buffers, "MOST_BYTES", 71)
    refused(corner(), "buffers of more than")


def member(scene, path, value):
    *way, last = path.split("/")
    found = scene.document
    for key in way:
        found = found[int(key) if key.isdigit() else key]
    found[int(last) if last.isdigit() else last] = value
    return scene


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("asset", {}, "that states no version"),
        ("asset/version", "1.0", "of version 1.0; version 2.0 is read"),
        ("nodes", 7, "nodes: a list is needed, not 7"),
        ("nodes/0", [], "nodes[0]: an object is needed"),
        ("nodes/0/mesh", 1, "nodes[0]: mesh is 1; there are 1 meshes"),
        ("nodes/0/mesh", -1, "nodes[0].mesh: needs a whole number from 0, not -1"),
        ("nodes/0/mesh", True, "nodes[0].mesh"),
        ("nodes/0/name", 5, "nodes[0].name: needs a text"),
        ("nodes/0/matrix", [1.0] * 15, "nodes[0].matrix: needs 16 numbers"),
        ("nodes/0/matrix", [1.0] * 16, "nodes[0]: the last row of its matrix"),
        ("nodes/0/rotation", [0, 0, 0, 2], "unit quaternion"),
        ("nodes/0/rotation", [1e300, 1e300, 0, 0], "unit quaternion"),
        ("nodes/0/scale", [1, 0, 1], 'the transform of the body "corner" is flat'),
        ("nodes/0/scale", [1, 10**400, 1], "nodes[0].scale: needs 3 numbers"),
        ("nodes/0/children", [9], "nodes[0].children[0]: there is no node 9"),
        ("scene", 3, "scene is 3; there are 1 scenes"),
        ("scenes/0/nodes", [], "its scene has no meshes"),
        ("meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode"),
        ("meshes/0/primitives/0/attributes/POSITION", 1, 'accessors[1]: is of type "SCALAR"; VEC3 is needed'),
        ("meshes/0/primitives/0/indices", 5, "indices is 5; there are 2 accessors"),
        ("accessors/0/componentType", 5125, "componentType is 5125"),
        ("accessors/0/count", 5, "do not fit into the 48 bytes"),
        ("accessors/0/count", 0, "accessors[0].count: needs a whole number from 1"),
        ("accessors/0/count", None, "it is missing"),
        ("accessors/1/count", 11, "11 corners, which make no whole triangles"),
        ("accessors/1/componentType", 5126, "componentType is 5126"),
        ("accessors/0/count", 3, "index 3 at place 5; there are 3 points"),
        ("bufferViews/0/byteLength", 500, "bufferViews[0]: takes bytes 0 to 500 of a buffer that has 72"),
        ("bufferViews/0/buffer", 1, "buffer is 1; there are 1 buffers"),
        ("bufferViews/0/byteStride", 4, "12 bytes, 4 apart"),
        ("extensionsRequired", [3], "extensionsRequired[0]: a text is needed"),
    ],
)
def test_refusals_in_the_document(path, value, said):
    refused(member(corner(), path, value), said)


def test_refusals_of_numbers_and_buffers():
    spoilt = corner()
    spoilt.data = np.array([np.nan], "<f4").tobytes() + spoilt.data[4:]
    refused(spoilt, "accessors[0]: point 0 is not finite", "nan")
    refused(corner().text("data:;base64,*"), "base64 data are damaged")
    refused(corner().text("data:text/plain,abc"), "base64 is needed")
    refused(corner().text("data:;base64,AAAA"), "announces 72 bytes, but 3 are there")
    without = json.loads(corner().text())
    del without["buffers"][0]["uri"]
    refused(json.dumps(without).encode(), "neither a uri nor the binary chunk")


def test_refusals_of_containers():
    refused(b"", "not a glTF file")
    refused(b"junk", "neither binary glTF nor JSON text")
    refused(b"[1]", "its JSON is [1], not an object")
    refused(b"[" * 100_000, "nested too deeply")
    refused(corner().text().replace(b'"scene": 0', b'"scene": NaN'), "NaN is no JSON number")
    refused(corner().text().replace(b'"scene": 0', b'"scene": ' + b"9" * 5000), "some/scene.gltf")
    whole = corner().binary()
    refused(whole[:-1], f"its header announces {len(whole)} bytes, but it has {len(whole) - 1}")
    refused(whole[:8], "8 bytes")
    refused(whole[:4] + b"\1" + whole[5:], "of version 1")
    refused(whole[:12] + b"\xff" * 4 + whole[16:], "a chunk announces")
    refused(whole[:16] + b"BIN\0" + whole[20:], "first chunk is not JSON")


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_any_bytes_give_bodies_or_a_file_error(data):
    content = bytearray(corner().binary() if data.draw(st.booleans()) else corner().text())
    for _ in range(data.draw(st.integers(0, 4))):
        place = data.draw(st.integers(0, len(content) - 1))
        width = data.draw(st.integers(0, 3))
        content[place : place + width] = data.draw(st.binary(min_size=width, max_size=width) | st.just(b"99"))
    try:
        contents = parse(bytes(content), "scene.gltf")
    except FileError as error:
        assert str(error).startswith("scene.gltf: ")  # noqa: PT017
    else:
        for body in contents.bodies:
            assert np.isfinite(body.vertices).all()
            assert 0 <= body.indices.min() <= body.indices.max() < len(body.vertices)
