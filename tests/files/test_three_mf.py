"""3MF files, written here part by part: what is built of them, and everything that can be wrong with one."""

from __future__ import annotations

import io
import zipfile

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gearwright.errors import FileError
from gearwright.files import instances
from gearwright.files.three_mf import package
from gearwright.files.three_mf.bodies import parse
from gearwright.moments.faces import Corners
from gearwright.solids.model import Model
from gearwright.solids.polyhedron import Polyhedron

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
RELATIONSHIPS = (
    '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r"'
    ' Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="{}"/></Relationships>'
)
# volume 1, centroid (1/4, 1/2, 3/4): legs 1, 2, 3
VERTICES = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
TRIANGLES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
MESH = (
    "<mesh><vertices>"
    + "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in VERTICES)
    + "</vertices><triangles>"
    + "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}" pid="5" p1="0"/>' for a, b, c in TRIANGLES)
    + "</triangles></mesh>"
)
OBJECT = f'<object id="1" name="corner">{MESH}</object>'
ITEM = '<item objectid="1"/>'


def model(resources=OBJECT, build=ITEM, attributes=""):
    return (
        f'<?xml version="1.0"?><model xmlns="{CORE}" xmlns:p="{PRODUCTION}" {attributes}>'
        f"<resources>{resources}</resources><build>{build}</build></model>"
    )


def packed(parts=None, start="/3D/3dmodel.model", **options):
    """A package; `parts` are texts by name, or the text of the usual one."""
    parts = {"3D/3dmodel.model": parts if parts is not None else model()} if not isinstance(parts, dict) else parts
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        if start:
            archive.writestr("_rels/.rels", RELATIONSHIPS.format(start))
        for name, text in parts.items():
            archive.writestr(name, text, **options)
    return stream.getvalue()


def properties(body):
    return Polyhedron(body.vertices, Corners(body.indices, body.offsets)).properties()


def refused(data, *said):
    with pytest.raises(FileError) as caught:
        parse(data, "some/part.3mf")
    assert str(caught.value).startswith("some/part.3mf: ")
    for words in said:
        assert words in str(caught.value)


def test_a_body_as_it_stands():
    contents = parse(packed(), "x")
    (body,) = contents.bodies
    assert (body.name, contents.length_unit, contents.remarks) == ("corner", "mm", ())
    np.testing.assert_array_equal(body.vertices, VERTICES)
    np.testing.assert_array_equal(body.indices.reshape(-1, 3), TRIANGLES)


@pytest.mark.parametrize(
    ("unit", "key", "millimetres"),
    [("micron", "um", 1e-3), ("millimeter", "mm", 1), ("centimeter", "cm", 10), ("meter", "m", 1000),
     ("inch", "in", 25.4), ("foot", "ft", 304.8)],
)  # fmt: skip
def test_units(unit, key, millimetres, tmp_path):
    (tmp_path / "part.3MF").write_bytes(packed(model(attributes=f'unit="{unit}"')))
    read = Model.load(tmp_path / "part.3MF")
    assert read.length_unit == key
    # 1 mm in that unit, written out here, has the same volume once its unit is applied
    scaled = f'<item objectid="1" transform="{1 / millimetres} 0 0 0 {1 / millimetres} 0 0 0 {1 / millimetres} 0 0 0"/>'
    body = parse(packed(model(build=scaled, attributes=f'unit="{unit}"')), "x").bodies[0]
    assert properties(body).volume * millimetres**3 == pytest.approx(1, rel=1e-13)


def test_transforms_multiply_rows():
    """A quarter turn about z takes x to y; rows of the matrix are the images of the axes, the last one the shift."""
    item = '<item objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 20 30"/>'
    body = parse(packed(model(build=item)), "x").bodies[0]
    np.testing.assert_array_equal(body.vertices, [(10, 20, 30), (10, 21, 30), (8, 20, 30), (10, 20, 33)])
    assert properties(body).volume == pytest.approx(1, rel=1e-14)


def test_mirrored_bodies_stay_outward():
    mirrored = '<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>'
    body = parse(packed(model(build=mirrored)), "x").bodies[0]
    assert properties(body).volume == pytest.approx(1, rel=1e-14)
    assert properties(body).centroid[0] == pytest.approx(-0.25, rel=1e-14)
    inner = '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>'
    twice = f'<object id="2"><components>{inner}</components></object>'
    body = parse(packed(model(OBJECT + twice, mirrored.replace('"1"', '"2"', 1))), "x").bodies[0]
    assert properties(body).centroid[0] == pytest.approx(0.25, rel=1e-14)


def test_components_place_inside_what_places_them():
    """Scaled by 2 inside, shifted outside: the shift stays as it is; the other way it would be doubled."""
    holder = (
        '<object id="2" name="holder"><components><component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>'
        '<component objectid="1"/></components></object>'
    )
    build = '<item objectid="2" transform="1 0 0 0 1 0 0 0 1 5 0 0"/><item objectid="1"/>'
    bodies = parse(packed(model(OBJECT + holder, build)), "x").bodies
    assert [properties(body).volume for body in bodies] == pytest.approx([8, 1, 1], rel=1e-13)
    assert [body.vertices[0, 0] for body in bodies] == [5, 5, 0]
    assert [body.vertices[1, 0] for body in bodies] == [7, 6, 1]


def test_names():
    unnamed = OBJECT.replace(' name="corner"', "")
    holder = '<object id="2" name="holder"><components><component objectid="1"/></components></object>'
    build = '<item objectid="1" partnumber="A"/><item objectid="1" partnumber="B"/><item objectid="2"/>' + ITEM
    assert [b.name for b in parse(packed(model(unnamed + holder, build)), "x").bodies] == ["A", "B", "holder", ""]
    numbered = OBJECT.replace("name=", "partnumber=")
    assert [b.name for b in parse(packed(model(numbered, build.split('<item objectid="2"')[0])), "x").bodies] == [
        "corner",
        "corner",
    ]


def test_other_parts_of_the_package():
    holder = '<object id="7"><components><component objectid="1" p:path="/3D/parts/A.model"/></components></object>'
    parts = {"3D/main.model": model(holder, '<item objectid="7"/>'), "3D/Parts/a.model": model(build="")}
    assert parse(packed(parts, start="3D/main.model"), "x").bodies[0].name == "corner"
    refused(packed({**parts, "3D/Parts/a.model": model(build="", attributes='unit="inch"')}, start="3D/main.model"),
            "3D/parts/A.model are in in", "in mm", "one unit is needed")  # fmt: skip
    refused(packed({"3D/main.model": parts["3D/main.model"]}, start="3D/main.model"), 'no part "3D/parts/A.model"')


@pytest.mark.parametrize(
    "path", ["../outside.model", "/3D/../../etc/passwd", "..\\\\x", "%2e%2e/x", "file:/etc/passwd", ""]
)
def test_paths_out_of_the_package(path):
    holder = f'<object id="7"><components><component objectid="1" p:path="{path}"/></components></object>'
    refused(packed(model(holder, '<item objectid="7"/>')), "is no path inside the package")


@pytest.mark.parametrize("kind", ["support", "solidsupport", "surface", "other"])
def test_what_is_no_model_is_left_out(kind):
    other = OBJECT.replace('id="1"', f'id="2" type="{kind}"')
    contents = parse(packed(model(OBJECT + other, ITEM + '<item objectid="2"/>')), "x")
    assert len(contents.bodies) == 1
    assert contents.remarks == (f'1 object(s) of type "{kind}" left out',)
    refused(packed(model(other, '<item objectid="2"/>')), "builds no body", f'of type "{kind}" left out')


SHAPING = {
    "beamlattice": "beam lattices",
    "slice": "slice stacks",
    "booleanoperations": "Boolean",
    "volumetric": "volum",
}


@pytest.mark.parametrize("extension", SHAPING)
def test_extensions_that_change_shapes(extension):
    uri = f"http://schemas.microsoft.com/3dmanufacturing/{extension}/2099/01"
    refused(
        packed(model(attributes=f'requiredextensions="b" xmlns:b="{uri}"')), SHAPING[extension], uri, "plain meshes"
    )
    used = OBJECT.replace("</mesh>", "<b:any><b:vertex/></b:any></mesh>")
    contents = parse(packed(model(used, attributes=f'xmlns:b="{uri}"')), "x")
    assert len(contents.remarks) == 1
    assert SHAPING[extension] in contents.remarks[0]


def test_other_extensions_pass():
    material = 'xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"'
    colours = '<m:colorgroup id="5"><m:color color="#9e9e9e"/></m:colorgroup>'
    assert not parse(packed(model(colours + OBJECT, attributes=f'requiredextensions="m p" {material}')), "x").remarks
    assert not parse(packed(model(attributes='xmlns:q="urn:own"')), "x").remarks


@pytest.mark.parametrize("uri", ["urn:own", "http://schemas.microsoft.com/3dmanufacturing/carving/2030/01"])
def test_unknown_extensions_are_refused_where_they_are_required(uri):
    required = packed(model(attributes=f'requiredextensions="p q" xmlns:q="{uri}"'))
    refused(required, f"requires the 3MF extension {uri}, which is not known here", "export plain meshes")
    refused(packed(model(attributes='requiredextensions="z"')), "requires the 3MF extension z,")


def spoilt(old, new, *said):
    text = model()
    assert old in text
    refused(packed(text.replace(old, new, 1)), "3D/3dmodel.model, line 1", *said)


def test_refusals_in_a_part():
    spoilt('x="1"', 'x="nan"', "vertex 1 of object 1 is not finite", "nan")
    spoilt('x="1"', 'x="1e999"', "not finite")
    spoilt('x="1"', 'x="1_0"', 'numbers x, y and z, and has x="1_0"')
    spoilt('x="1"', 'x="1,5"', 'x="1,5"')
    spoilt('x="1"', 'x="١"', "numbers x, y and z")
    spoilt('x="1" ', "", "numbers x, y and z")
    spoilt('v1="0"', 'v1="4"', "triangle 0 of object 1", "[4, 2, 1]", "4 vertices")
    spoilt('v1="0"', 'v1="-1"', "[-1, 2, 1]")
    spoilt('v1="0"', f'v1="{2**63}"', "vertex numbers")
    spoilt('v1="0"', 'v1="0.0"', "vertex numbers")
    spoilt('v1="0"', 'v1="1_0"', "vertex numbers")
    spoilt('v1="0" ', "", "vertex numbers")
    spoilt("<model ", '<model unit="furlong" ', 'unit="furlong"', "millimeter")
    spoilt("<object ", '<object type="ghost" ', 'type="ghost"')
    spoilt('id="1"', 'id="one"', 'id="one"', "whole number")
    spoilt("<build>", "<build><vertex/>", "<vertex> stands in <build>, not in <vertices>")
    spoilt("</mesh>", f"</mesh>{MESH}", "two meshes")
    spoilt("</object>", f"</object>{OBJECT}", "second object has id 1")
    spoilt('<item objectid="1"', '<item objectid="1" transform="1 0 0"', "12 numbers")
    spoilt('<item objectid="1"', '<item objectid="1" transform="nan 0 0 0 1 0 0 0 1 0 0 0"', "12 numbers")
    refused(packed(model().replace("2015/02", "2013/01")), "begins with <model>, not with <model> of the namespace")
    refused(packed(model()[:-5]), "3D/3dmodel.model: not XML", "line 1")
    refused(packed(b"\xff\xfejunk"), "not XML")
    refused(packed('<?xml version="1.0" encoding="klingon"?><a/>'), "encoding")
    refused(packed(""), "not XML")


def test_refusals_of_what_is_built():
    refused(packed(model(build="")), "builds no body", "no items")
    refused(packed(model(build='<item objectid="9"/>')), "there is no object 9 of 3D/3dmodel.model")
    refused(packed(model('<object id="1"/>')), "builds no body")
    refused(packed(model('<object id="1"><mesh/></object>')), "1 object(s) without triangles left out")
    flat = '<item objectid="1" transform="1 0 0 0 1 0 0 0 0 0 0 0"/>'
    refused(packed(model(build=flat)), 'the transform of the body "corner" is flat')
    huge = flat.replace("1 0 0 0 1 0 0 0 0", "1e200 0 0 0 1e200 0 0 0 1e200")
    refused(packed(model(OBJECT.replace('z="3"', 'z="1e200"'), huge)), "beyond all numbers")


def test_cycles():
    def holder(number, held):
        return f'<object id="{number}"><components><component objectid="{held}"/></components></object>'

    refused(packed(model(holder(1, 1))), "object 1 of 3D/3dmodel.model holds itself;")
    refused(
        packed(model(holder(1, 2) + holder(2, 3) + holder(3, 1))), "holds itself through object 2 of", "object 3 of"
    )


def test_depth_and_number_of_what_is_placed(monkeypatch):
    def tower(levels, repeated):
        placed = (f'<component objectid="{k}"/>' * repeated for k in range(1, levels))
        holders = (f'<object id="{k}"><components>{held}</components></object>' for k, held in enumerate(placed, 2))
        return OBJECT + "".join(holders)

    deepest = instances.MOST_DEPTH - 1  # the item is one level, too
    assert len(parse(packed(model(tower(deepest, 1), f'<item objectid="{deepest}"/>')), "x").bodies) == 1
    refused(packed(model(tower(deepest + 1, 1), f'<item objectid="{deepest + 1}"/>')), "more than 128 deep")
    assert len(parse(packed(model(tower(7, 2), '<item objectid="7"/>')), "x").bodies) == 64
    refused(packed(model(tower(40, 10), '<item objectid="40"/>')), "more than 100000 placed ones")
    monkeypatch.setattr(instances, "MOST_FACES", 255)
    refused(packed(model(tower(7, 2), '<item objectid="7"/>')), "more than 255 triangles together")


def test_document_types_are_refused():
    laughs = '<!DOCTYPE a [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;">]>'
    refused(packed(model().replace("?>", f"?>{laughs}", 1)), "document type (DOCTYPE)", "line 1")
    outside = '<!DOCTYPE a SYSTEM "file:///etc/passwd">'
    refused(packed(model().replace("?>", f"?>{outside}", 1)), "document type")
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("_rels/.rels", laughs + RELATIONSHIPS.format("/3D/3dmodel.model"))
    refused(stream.getvalue(), "_rels/.rels, line 1", "document type")


def test_zip_bombs(monkeypatch):
    bomb = packed(model().replace("?>", "?>" + " " * 40_000_000))
    assert len(bomb) < 100_000
    refused(bomb, 'the part "3D/3dmodel.model" unpacks to more than 200 times the size of the file')
    monkeypatch.setattr(package, "MOST_BYTES", 1 << 20)
    refused(bomb, "unpacks to more than 1 MiB")


def test_a_header_that_claims_less_is_not_believed():
    """A part whose headers claim 10 bytes: no more are taken from it, and its checksum tells."""
    data = bytearray(packed())
    size = len(model()).to_bytes(4, "little")
    assert data.count(size) == 2
    refused(bytes(data.replace(size, (10).to_bytes(4, "little"))), "3D/3dmodel.model")


def test_refusals_of_packages():
    refused(b"", "not a 3MF file, which is a zip package")
    refused(b"junk" * 100, "not a 3MF file")
    whole = packed()
    refused(whole[: len(whole) // 2], "not a 3MF file")
    refused(packed({}, start=None), 'no part "3D/3dmodel.model"')
    assert len(parse(packed(start=None), "x").bodies) == 1
    refused(packed(start="../../x"), "no path inside the package")
    central = whole.rindex(b"PK\1\2")
    encrypted = bytearray(whole)
    encrypted[central + 8] |= 1
    refused(bytes(encrypted), "is encrypted")
    elsewhere = bytearray(whole)
    elsewhere[central + 34] = 1
    refused(bytes(elsewhere), "on another disk")
    refused(packed(compress_type=zipfile.ZIP_LZMA), "is packed by method 14")
    place = whole.index(b"3dmodel.model", 200) + 60
    damaged = whole[:place] + bytes([whole[place] ^ 255]) + whole[place + 1 :]
    refused(damaged, "3D/3dmodel.model")
    twice = packed({"3D/3dmodel.model": model(), "3D/3DMODEL.model": model()})
    refused(twice, 'two parts named "3D/3DMODEL.model"')


numbers = st.floats(-3, 3).map(lambda x: round(x, 3))


@settings(max_examples=60, deadline=None)
@given(st.lists(numbers, min_size=12, max_size=12), st.lists(numbers, min_size=12, max_size=12))
def test_any_two_transforms_scale_the_volume_by_their_determinants(inner, outer):
    first, second = (np.array(one).reshape(4, 3) for one in (inner, outer))
    ratio = np.linalg.det(first[:3]) * np.linalg.det(second[:3])
    assume(min(np.linalg.svd(one[:3], compute_uv=False).min() for one in (first, second)) > 0.05)
    words = [" ".join(map(repr, one)) for one in (inner, outer)]
    holder = f'<object id="2"><components><component objectid="1" transform="{words[0]}"/></components></object>'
    body = parse(packed(model(OBJECT + holder, f'<item objectid="2" transform="{words[1]}"/>')), "x").bodies[0]
    found = properties(body)
    assert found.volume == pytest.approx(abs(ratio), rel=1e-9)
    centroid = (np.array([0.25, 0.5, 0.75]) @ first[:3] + first[3]) @ second[:3] + second[3]
    np.testing.assert_allclose(found.centroid, centroid, rtol=1e-9, atol=1e-9)


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_any_bytes_give_bodies_or_a_file_error(data):
    content = bytearray(packed(model(), start=None) if data.draw(st.booleans()) else model().encode())
    is_package = content[:2] == b"PK"
    for _ in range(data.draw(st.integers(0, 4))):
        place = data.draw(st.integers(0, len(content) - 1))
        content[place : place + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=3))
    try:
        contents = parse(bytes(content) if is_package else packed(bytes(content)), "part.3mf")
    except FileError as error:
        assert str(error).startswith("part.3mf: ")  # noqa: PT017
    else:
        for body in contents.bodies:
            assert np.isfinite(body.vertices).all()
            assert 0 <= body.indices.min() <= body.indices.max() < len(body.vertices)
