"""OBJ files: what is kept, what makes bodies, and every refusal."""

from __future__ import annotations

import pytest

from gearwright.errors import FileError
from gearwright.files.obj import reader as obj

TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def parse(text):
    return obj.parse(text.encode() if isinstance(text, str) else text, "part.obj")


def faces(body):
    return [body.indices[a:b].tolist() for a, b in zip(body.offsets[:-1], body.offsets[1:], strict=True)]


def bodies(text):
    return {body.name: (body.vertices.tolist(), faces(body)) for body in parse(text).bodies}


def test_bodies_are_objects_and_a_name_that_comes_again_goes_on():
    text = (
        "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 4\no  the   hub \nf 3 4 5\ng rim\nf -1 -2 -3 -4\n"
        "o empty\no ring\nf 5 4 3\no the hub\nf 4 3 2\n"
    )
    o, x, y, z = [0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]
    assert bodies(text) == {
        "": ([o, x, y], [[0, 1, 2]]),
        "the hub": ([o, x, y, z], [[1, 2, 3], [3, 2, 1, 0], [2, 1, 0]]),
        "ring": ([x, y, z], [[2, 1, 0]]),
    }


def test_bodies_are_groups_where_there_are_no_objects():
    text = TETRAHEDRON.replace("f 1 3 2", "g a b\nf 1 3 2").replace("f 2 3 4", "g\nf 2 3 4")
    found = bodies(text)
    assert list(found) == ["a b", ""]
    assert found["a b"][1] == [[0, 2, 1], [0, 1, 3]]
    assert found[""] == ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[1, 2, 3], [2, 0, 3]])
    assert list(bodies(text.replace("g\n", "g\no all\n"))) == ["", "all"]


def test_negative_numbers_count_back_from_the_vertices_so_far():
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nf -3 -2 -1\n"
    assert faces(parse(text).bodies[0]) == [[0, 1, 2], [1, 2, 3]]


def test_faces_may_name_vertices_that_come_later():
    assert faces(parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").bodies[0]) == [[0, 1, 2]]


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("\n", "\r\n"),
        lambda t: t.replace("\n", "\r"),
        lambda t: "\ufeff" + t,
        lambda t: t.replace("v 1 0 0", "v 1 \\\n 0 \\\r\n 0 0.5"),
        lambda t: t.replace("f 1 2 4", "f 1/2 2/2/ \\\n4//3"),
        lambda t: t.replace("f 1 2 4", "# a comment \\\nf 1 2 4 # and one here"),
        lambda t: t.replace("v 1 0 0", "  v\t1 0 0 nan nan nan"),
        lambda t: t.replace("f 1 3 2", "mtllib a\\b.mtl\nusemtl x\ns 1\nvt 0 0\nvn 0 0 1\nvp 1 2\n\n \nf 1 3 2"),
        lambda t: t.rstrip(),
    ],
)
def test_ways_of_writing(change):
    assert bodies(change(TETRAHEDRON)) == bodies(TETRAHEDRON)


def test_what_bounds_no_body_is_left_out_with_a_remark():
    contents = parse("cstype bezier\n" + TETRAHEDRON + "l 1 2\np 1\nl 2 3 \\\n 4\n")
    assert contents.remarks == ("left out, as they are no faces of bodies: statements p (1), l (2), cstype (1)",)
    assert not parse(TETRAHEDRON).remarks


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "the file is empty"),
        (" \n\n", "the file is empty"),
        ("v 0 0 0\n", "without faces"),
        (TETRAHEDRON.replace("v 1 0 0", "v 1 0"), 'line 2 has its end where a number is expected'),
        (TETRAHEDRON.replace("v 1 0 0", "v 1,5 0 0"), 'line 2 has "1,5" where a number is expected'),
        (TETRAHEDRON.replace("v 1 0 0", "v 1 \\\n x 0"), 'line 3 has "x" where a number is expected'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 NaN 0"), 'line 2 has "NaN" where a finite number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 -inf 0"), 'line 2 has "-inf" where a finite number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 1e999"), 'line 2 has "1e999" where a finite number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 1_0"), 'line 2 has "1_0" where a number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 0x1"), 'line 2 has "0x1" where a number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 1e"), 'line 2 has "1e" where a number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 ."), 'line 2 has "." where a number'),
        (TETRAHEDRON.replace("v 1 0 0", "v 0 0 " + "1" * 65), "where a number is expected"),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2"), "line 6 has a face of fewer than 3 corners where one of at least 3"),
        (TETRAHEDRON.replace("f 1 2 4", "f"), "line 6 has a face of fewer than 3 corners"),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 0 2"), 'line 6 has "0" where the number of a vertex, 1 to 4 or negative'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2 5"), 'line 6 has "5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2 -5"), 'line 6 has "-5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2 4294967297"), 'line 6 has "4294967297" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2 99999999999999999999999"), "line 6 has"),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2.0 4"), 'line 6 has "2.0" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 /2 4"), 'line 6 has "/2" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2/1.5 4"), 'line 6 has "2/1.5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2/1,5 4"), 'line 6 has "2/1,5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2/1:5 4"), 'line 6 has "2/1:5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "f 1 2 4#5"), 'line 6 has "4#5" where'),
        (TETRAHEDRON.replace("f 1 2 4", "face 1 2 4"), 'line 6 has "face" where a statement of OBJ files, as v or f'),
        ("\r\n\r\nfacet normal\r\n", 'line 3 has "facet"'),
        ("f 1 2 3\n", 'line 1 has "1" where no face before there are vertices'),
        (b"\x00\x01\x02", 'has "???"'),
    ],
)  # fmt: skip
def test_refusals(text, said):
    with pytest.raises(FileError) as caught:
        parse(text)
    assert str(caught.value).startswith("part.obj: ")
    assert said in str(caught.value)


QUIET = "vt vn vp s usemtl mtllib usemap maplib bevel c_interp d_interp lod shadow_obj trace_obj mg"
LEFT_OUT = (
    "p l curv curv2 surf parm trim hole scrv sp end con cstype deg bmat step ctech stech bsp bzp cdc cdp res call csh"
)


def test_every_statement_of_the_format_is_known():
    text = TETRAHEDRON + "".join(f"{word} 1\n" for word in QUIET.split())
    assert not parse(text).remarks
    (remark,) = parse(text + "".join(f"{word} 1 2\n" * (k + 1) for k, word in enumerate(LEFT_OUT.split()))).remarks
    assert remark.partition("statements ")[2] == ", ".join(
        f"{word} ({k + 1})" for k, word in enumerate(LEFT_OUT.split())
    )


@pytest.mark.parametrize("word", ["_interp", "xc_interp", "vv", "ff", "ol", "usemtll", "c_inters", "V", "F", "w" * 300])
def test_words_that_only_look_like_statements_are_refused(word):
    with pytest.raises(FileError, match="where a statement of OBJ files"):
        parse(f"{TETRAHEDRON}{word} 1 2 3\n")
