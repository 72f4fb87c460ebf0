"""What the page on volumetric properties shows is what happens."""

import re
import shlex

import pytest

from gearwright.cli import main
from gearwright.cli.property_options import Wanted
from gearwright.solids.polyhedron import Polyhedron

from .cli.bodies import CORNERS, FACES, box, put
from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/volumetric-properties.md"
COMMANDS = re.findall(r"^    (gearwright .*)$", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)


def test_each_block_prints_what_stands_below_it(capsys):
    assert_blocks_print_what_stands_below(PAGE, capsys)


def test_the_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    put(monkeypatch, **{"wheel.3mf": [box("shaft", [2, 2, 10]), box("rim", [4, 4, 1], [5, 0, 0])]})
    (tmp_path / "parts").mkdir()
    for name in ("bracket.stl", "parts/one.stl", "more.stl"):
        Polyhedron(CORNERS, FACES).save(tmp_path / name)
    (tmp_path / "more.txt").write_text("more.stl\n")
    assert len(COMMANDS) == 3
    for command in COMMANDS:
        assert main(shlex.split(command.partition(" >")[0])[1:]) == 0, command
        assert capsys.readouterr().out


def test_every_option_is_on_the_page():
    page = PAGE.read_text(encoding="utf-8")
    for option in Wanted.__dataclass_fields__:
        assert f"--{option.replace('_', '-')}" in page


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
