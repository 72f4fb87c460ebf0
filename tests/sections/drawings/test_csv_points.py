"""Lists of points: separators, headings, loops and refusals by line."""

import pytest

import gearwright as gw

from .drawn import csv, polygon_moments, section_moments

TRIANGLE = [(0.0, 0.0), (6.0, 1e-3), (2.5, 3.0)]


def load(folder, text, **options):
    return gw.Section.load(csv(folder, text), **options)


@pytest.mark.parametrize("separator", [",", ";", " ", "\t", " , ", "  "])
@pytest.mark.parametrize("heading", ["", "x,y\n", "# corners\nX [mm]; Y [mm]\n", "\ufeffx y\n"])
def test_any_separator_and_heading(tmp_path, separator, heading):
    text = heading + "\n".join(f"{x!r}{separator}{y!r} # a corner" for x, y in TRIANGLE)
    assert section_moments(load(tmp_path, text)) == pytest.approx(polygon_moments(TRIANGLE), rel=1e-13)


def test_the_first_corner_may_close_the_loop_and_the_sense_means_nothing(tmp_path):
    text = "\r\n".join(f"{x!r},{y!r}" for x, y in [*TRIANGLE[::-1], TRIANGLE[-1]])
    section = load(tmp_path, text)
    assert section.moments[0, 0] == pytest.approx(polygon_moments(TRIANGLE)[0], rel=1e-14)
    assert len(section.loops[0].curves) == 3


def test_an_empty_line_begins_the_next_loop_and_a_comment_does_not(tmp_path):
    text = "0 0\n9 0\n# halfway\n9 9\n0 9\n\n\n1 1\n3 1\n3 3\n"
    section = load(tmp_path, text)
    assert [len(loop.curves) for loop in section.loops] == [4, 3]
    assert section.moments[0, 0] == pytest.approx(81 - 2, rel=1e-14)


def test_all_wrong_lines_are_named(tmp_path):
    with pytest.raises(gw.FileError) as error:
        load(tmp_path, "x,y\n0,0\n1,nan\n2,inf\n3\n4,5,6\n7,b\n8,9\n1,5 2,5\n")
    named = [line.split(":")[0].strip() for line in str(error.value).splitlines()[1:]]
    assert named == ["line 3", "line 4", "line 5", "line 6", "line 7", "line 9"]


def test_a_second_heading_is_a_wrong_line(tmp_path):
    with pytest.raises(gw.FileError, match=r"line 2: 'u,v'"):
        load(tmp_path, "x,y\nu,v\n0,0\n1,0\n0,1\n")


@pytest.mark.parametrize("second", ["4 4\n5 5", "4 4\n5 5\n4 4", "4 4\n4 4\n4 4"])
def test_a_loop_of_less_than_three_corners_is_refused_with_its_line(tmp_path, second):
    with pytest.raises(gw.FileError, match=r"line 5: a loop of [12] different corners"):
        load(tmp_path, f"0 0\n9 0\n9 9\n\n{second}\n")


def test_what_is_no_text_is_refused(tmp_path):
    path = tmp_path / "noise.csv"
    path.write_bytes(bytes(range(256)))
    with pytest.raises(gw.FileError, match="no text of points"):
        gw.Section.load(path)


def test_points_have_no_layers(tmp_path):
    with pytest.raises(gw.FileError, match="no layers"):
        load(tmp_path, "0 0\n1 0\n0 1\n", layer="0")


def test_a_list_without_end_is_refused_before_it_is_read(tmp_path):
    with pytest.raises(gw.FileError, match="more than 200000 lines"):
        load(tmp_path, "1,2\n" * 200_001)
