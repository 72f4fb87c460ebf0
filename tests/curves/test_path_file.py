"""Paths from files of points."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.curves.path import path_through
from gearwright.curves.path_file import path_from_file

POINTS = ((0.0, 0.0, 0.0), (0.0, 1.5, 30.0), (20.0, -10.0, 6e1))


@pytest.mark.parametrize(
    "text",
    [
        "0,0,0\n0,1.5,30\n20,-10,60",
        "x,y,z\n0,0,0\n0,1.5,30\n20,-10,60\n",
        "# from a sketch\nx [mm]; y [mm]; z [mm]\n\n0; 0; 0\n0; 1.5; 30 # bend\n20; -10; 6e1\n",
        "\ufeff0 0 0\r\n0\t1.5\t30\r\n  20   -10  60  ",
    ],
)
def test_points_are_read(tmp_path, text):
    (tmp_path / "path.CSV").write_text(text, encoding="utf-8", newline="")
    found = path_from_file(tmp_path / "path.CSV")
    u = np.linspace(0.0, 1.0, 9)
    np.testing.assert_array_equal(found.point(u), path_through(POINTS).point(u))


def test_a_path_whose_last_point_is_the_first_is_closed(tmp_path):
    (tmp_path / "ring.csv").write_text("1,0,0\n0,1,0\n-1,0,0\n0,-1,0\n1,0,0\n")
    assert path_from_file(tmp_path / "ring.csv").closed


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ("holds 0 points", "at least two")),
        ("x,y,z\n1,2,3\n", ("holds 1 points",)),
        ("0,0,0\n1,2\n3,4,five\n6,7,8\n", ("line 2: '1,2'", "line 3: '3,4,five'")),
        ("0,0,0\nx,y,z\n1,1,1\n", ("line 2: 'x,y,z'",)),
        ("0,0,0\n1,nan,2\n1,1_0,1\n", ("line 2", "line 3")),
        ("0,0\n1,1\n", ("line 1: '0,0'",)),
        ("0,0,0,0\n" * 20, ("line 5", "and 12 lines more")),
        ("1,5;2,5;3,5\n", ("decimal sign",)),
    ],
)
def test_what_is_no_point_is_named_with_its_line(tmp_path, text, words):
    (tmp_path / "path.csv").write_text(text)
    with pytest.raises(gw.FileError) as refused:
        path_from_file(tmp_path / "path.csv")
    assert str(refused.value).startswith(str(tmp_path / "path.csv"))
    assert all(word in str(refused.value) for word in words), str(refused.value)


def test_what_is_no_file_of_points_is_refused(tmp_path):
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00")
    for name, words in (("binary.csv", "no text"), ("missing.csv", "no such file"), ("path.dxf", ".csv file")):
        with pytest.raises(gw.FileError, match=words):
            path_from_file(tmp_path / name)


def test_points_without_a_smooth_path_are_refused_with_the_file(tmp_path):
    (tmp_path / "path.csv").write_text("0,0,0\n1,1,1\n1,1,1\n")
    with pytest.raises(gw.GeometryError, match=r"path.csv.*\n.*coincide"):
        path_from_file(tmp_path / "path.csv")


@pytest.mark.parametrize("kind", [str, lambda path: path])
def test_sweep_along_takes_a_file(tmp_path, kind):
    (tmp_path / "path.csv").write_text("0,0,0\n0,1.5,30\n20,-10,60")
    section = gw.Section.circle(2.0)
    by_file = gw.sweep_along(section, kind(tmp_path / "path.csv")).properties()
    assert np.array_equal(by_file.inertia, gw.sweep_along(section, POINTS).properties().inertia)
