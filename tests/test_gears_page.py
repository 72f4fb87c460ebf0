"""What the page on cylindrical gears shows is what happens."""

import shlex
from itertools import pairwise

import pytest

from gearwright.cli import main
from gearwright.sections import drawings

from .pages import ROOT, assert_blocks_print_what_stands_below, assert_drawn_alike, blocks, links

PAGE = ROOT / "docs/gears.md"
COMMANDS = [line for kind, text in blocks(PAGE) if kind == "sh" for line in text.splitlines()]


def test_each_block_prints_what_stands_below_it_and_draws_the_pictures(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert drawings.read("pair.dxf").layers == ("pinion", "gear")
    for name in ("herringbone-gear.png", "internal-pair.png"):
        assert_drawn_alike(tmp_path / name, ROOT / "docs/images" / name)


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.split()[1])
def test_every_command_runs(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split(command)[1:]) == 0, capsys.readouterr().err
    assert capsys.readouterr().out
    words = shlex.split(command)
    for name, output in pairwise(words):
        if name in ("-o", "--drawing"):
            assert (tmp_path / output).exists()


def test_every_kind_of_gear_has_a_command():
    assert {line.split()[1] for line in COMMANDS} == {"spur", "helical", "herringbone", "internal", "rack"}


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
