"""What the page on files for simulators shows happens."""

import re
import shlex

import pytest

from gearwright.cli import main
from gearwright.files.formats import FILE_FORMATS
from gearwright.files.robots import mjcf, sdf
from gearwright.solids.solid import DEFAULT_TOLERANCE

from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/robots.md"
TEXT = PAGE.read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    (gearwright .*)$", TEXT, flags=re.MULTILINE)


def test_the_block_prints_what_stands_below_it_and_the_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert len(COMMANDS) == 3
    for command in COMMANDS:
        assert main(shlex.split(command)[1:]) == 0, command
        assert command.split()[-1] in {path.name for path in tmp_path.iterdir()}


def test_every_format_has_a_row_with_its_suffixes():
    rows = dict(re.findall(r"^\| (URDF|SDFormat|MJCF)[^|]* \| ([^|]*) \|", TEXT, flags=re.MULTILINE))
    mechanisms = [one for one in FILE_FORMATS if one.holds == "mechanism"]
    assert {name: set(row.split(", ")) for name, row in rows.items()} == {
        one.name: {f"`{suffix}`" for suffix in one.suffixes} for one in mechanisms
    }


@pytest.mark.parametrize(
    "said",
    [
        f"SDFormat {sdf.VERSION} ",
        f"up to {mjcf.MOST_TRIANGLES:,} triangles",
        f"masses above {mjcf.LEAST_MASS:g} kg and moments above {mjcf.LEAST_MOMENT:g} kg m²",
        f"group {mjcf.VISUAL} and to collide with others in group {mjcf.COLLISION}",
        f"within {DEFAULT_TOLERANCE:.0e} × the bounding diagonal".replace("e-04", "e-4"),
    ],
)
def test_limits_are_those_of_the_code(said):
    assert said in " ".join(TEXT.split())


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
