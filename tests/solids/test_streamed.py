"""Binary STL files in passing: what loading gives, in constant memory."""

from __future__ import annotations

import re
import subprocess
import sys

import numpy as np
import pytest

import gearwright as gw
from gearwright import Polyhedron
from gearwright.moments.summation import CHUNK

from .. import shapes


@pytest.fixture(scope="module")
def torus(tmp_path_factory):
    vertices, triangles = shapes.torus(300, 200)
    path = tmp_path_factory.mktemp("stl") / "torus.stl"
    Polyhedron(vertices, triangles).save(path, length_unit="in")
    return path


def test_it_equals_what_loading_gives(torus):
    loaded, found = gw.Polyhedron.load(torus).properties(3.0), gw.stream_properties(torus, 3.0)
    assert found.mass == pytest.approx(loaded.mass, rel=1e-15)
    np.testing.assert_allclose(found.central_inertia, loaded.central_inertia, rtol=0, atol=1e-14 * loaded.inertia.max())
    np.testing.assert_array_equal(found.bounding_box, loaded.bounding_box)
    assert found.area == pytest.approx(loaded.area, rel=1e-14)
    assert found.method == "polyhedron"
    assert 0.0 < found.error_bound < 1e-13


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_change_no_bit(torus, threads):
    alone, found = gw.stream_properties(torus), gw.stream_properties(torus, threads=threads)
    assert 3 * CHUNK < 120_000
    assert found.volume == alone.volume
    np.testing.assert_array_equal(found.central_second, alone.central_second)


def rewritten(path, tmp_path, change):
    data = bytearray(path.read_bytes())
    change(data)
    changed = tmp_path / "changed.stl"
    changed.write_bytes(data)
    return changed


def corner(data, triangle, number):
    start = 84 + 50 * triangle + 12 + 12 * number
    return slice(start, start + 12)


def test_holes_flips_and_numbers_that_are_none_are_refused(torus, tmp_path):
    def flip(data):
        first, second = data[corner(data, 7, 1)], data[corner(data, 7, 2)]
        data[corner(data, 7, 1)], data[corner(data, 7, 2)] = second, first

    def collapse(data):
        data[corner(data, 100_000, 1)] = data[corner(data, 100_000, 2)]

    def not_a_number(data):
        data[corner(data, 40_000, 0)] = np.full(3, np.nan, "<f4").tobytes()

    for change in (flip, collapse, not_a_number):
        path = rewritten(torus, tmp_path, change)
        with pytest.raises(gw.GeometryError, match=re.escape(f"{path} does not bound a solid:\n  closure residual ")):
            gw.stream_properties(path)


def test_inward_faces_are_refused(tmp_path):
    vertices, triangles = shapes.torus(20, 10)
    Polyhedron(vertices, triangles[:, ::-1]).save(tmp_path / "in.stl")
    with pytest.raises(gw.GeometryError, match=r"volume -3\d\.\d+: must be positive; all faces are turned inward"):
        gw.stream_properties(tmp_path / "in.stl")


def test_what_is_no_whole_binary_file_is_refused(torus, tmp_path):
    text = tmp_path / "text.stl"
    text.write_text("solid x\nendsolid x\n" * 20)
    cut = rewritten(torus, tmp_path, lambda data: data.__delitem__(slice(-10, None)))
    empty = tmp_path / "empty.stl"
    empty.write_bytes(b" " * 80 + bytes(4))
    for path in (text, cut, empty):
        with pytest.raises(gw.FileError, match=f"{path.name}: not a whole binary STL file"):
            gw.stream_properties(path)


def test_the_density_is_checked(torus):
    with pytest.raises(gw.ParameterError, match="density = -1"):
        gw.stream_properties(torus, -1.0)


def test_memory_does_not_grow_with_the_file(tmp_path):
    """Peak of a process that looks at 25 times more triangles is that of one that looks at few."""
    few, many = shapes.torus(200, 100), shapes.torus(1000, 500)
    peaks = []
    for name, (vertices, triangles) in (("few", few), ("many", many)):
        path = tmp_path / f"{name}.stl"
        Polyhedron(vertices, triangles).save(path)
        # VmHWM is this program's; what getrusage tells includes the process that started it
        code = (
            "import sys, gearwright as gw; gw.stream_properties(sys.argv[1], threads=2);"
            "print(next(line.split()[1] for line in open('/proc/self/status') if line.startswith('VmHWM')))"
        )
        out = subprocess.run([sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=True)
        peaks.append(int(out.stdout) / 1024)
    assert peaks[1] - peaks[0] < 20  # MiB; the larger file has 48
