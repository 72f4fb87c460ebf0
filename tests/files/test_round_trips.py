"""Any polyhedron, written in any style that a format allows, is read with the same faces."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.errors import FileError
from gearwright.files.obj import reader as obj
from gearwright.files.off import reader as off
from gearwright.files.ply import reader as ply
from gearwright.files.recognition import recognise
from gearwright.files.stl import reader as stl

from . import random_polyhedra as written

seeds = given(st.integers(0, 2**32 - 1))
many = settings(max_examples=60, deadline=None)


def the_body(parse, data):
    (body,) = parse(data, "part").bodies
    assert body.vertices.dtype == np.float64
    assert body.indices.dtype == body.offsets.dtype == np.int64
    assert len(np.unique(body.indices)) == len(body.vertices)
    return body


@many
@seeds
def test_obj(seed):
    random = np.random.default_rng(seed)
    shape = written.random_shape(random)
    data = written.obj(shape, random)
    body = the_body(obj.parse, data)
    assert written.faces_of(body) == written.expected(shape)
    assert body.vertices.tolist() == [list(v) for v in shape.vertices]
    assert body.rounding == 0.0
    assert recognise(data, "part").name == "OBJ"


@many
@seeds
def test_off(seed):
    random = np.random.default_rng(seed)
    shape = written.random_shape(random)
    data = written.off(shape, random)
    assert written.faces_of(the_body(off.parse, data)) == written.expected(shape)
    assert recognise(data, "part").name == "OFF"


@many
@seeds
def test_off_binary(seed):
    random = np.random.default_rng(seed)
    shape = written.in_single(written.random_shape(random))
    data = written.off_binary(shape, random)
    body = the_body(off.parse, data)
    assert written.faces_of(body) == written.expected(shape)
    largest = np.float32(np.abs(body.vertices).max())
    assert body.rounding == (np.nextafter(largest, np.float32(np.inf)).astype(float) - float(largest)) / 2
    assert recognise(data, "part").name == "OFF"


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("type_", ["float", "double", "short"])
def test_ply(form, type_):
    @many
    @seeds
    def check(seed):
        random = np.random.default_rng(seed)
        shape = written.random_shape(random)
        if type_ == "float":
            shape = written.in_single(shape)
        if type_ == "short":
            shape = written.Shape(
                [tuple(map(float, random.integers(-999, 999, 3))) for _ in shape.vertices], shape.faces
            )
        data = written.ply(shape, random, form, type_)
        contents = ply.parse(data, "part")
        (body,) = contents.bodies
        assert written.faces_of(body) == written.expected(shape)
        assert (body.rounding > 0) == (type_ == "float")
        assert all("edge" in remark for remark in contents.remarks)
        assert recognise(data, "part").name == "PLY"

    check()


@many
@seeds
def test_stl_text(seed):
    random = np.random.default_rng(seed)
    shape = written.random_shape(random)
    data = written.stl_text(shape, random)
    body = the_body(stl.parse, data)
    found = np.array(written.faces_of(body))
    wanted = np.array([[shape.vertices[k] for k in t] for t in written.triangles(shape)])
    np.testing.assert_allclose(found, wanted, rtol=0, atol=2.0**-45 * np.abs(wanted).max())
    far = np.abs(wanted) > 2.0**-45 * np.abs(wanted).max()
    assert np.array_equal(found[far], wanted[far])
    assert body.name == "part of many words"
    assert recognise(data, "part").name == "STL"


@settings(max_examples=300, deadline=None)
@given(
    st.one_of(
        st.floats(allow_nan=False, allow_infinity=False).map(repr),
        st.floats(allow_nan=False, allow_infinity=False).map(lambda x: f"{x:.25e}"),
        st.from_regex(r"[+-]?([0-9]{1,25}(\.[0-9]{0,25})?|\.[0-9]{1,25})([eE][+-]?[0-9]{1,3})?", fullmatch=True),
    )
)
def test_every_number_is_rounded_as_python_does(text):
    value = float(text)
    data = f"v {text} 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n".encode()
    if np.isfinite(value):
        found = obj.parse(data, "part").bodies[0].vertices[0, 0]
        assert found == value
        assert np.signbit(found) == np.signbit(value)
    else:
        with pytest.raises(FileError, match="not finite"):
            obj.parse(data, "part")


def test_numbers_about_the_limits_of_exact_powers_and_integers():
    texts = [
        f"{mantissa}e{place}"
        for mantissa in (1, 3, 7, 2**53 - 1, 2**53, 2**53 + 1, 10**18 - 1)
        for place in range(-30, 31)
    ]
    lines = "".join(f"v {text} 0 0\n" for text in texts)
    face = "f " + " ".join(str(k + 1) for k in range(len(texts)))
    (body,) = obj.parse((lines + face).encode(), "part").bodies
    assert body.vertices[:, 0].tolist() == [float(text) for text in texts]
