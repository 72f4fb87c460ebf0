"""What the page on bevel gears shows is what happens."""

import shlex
from itertools import pairwise

import pytest

from gearwright.cli import main

from .pages import ROOT, assert_blocks_print_what_stands_below, assert_drawn_alike, blocks, links

PAGE = ROOT / "docs/bevels.md"
COMMANDS = [line for kind, text in blocks(PAGE) if kind == "sh" for line in text.replace("\\\n", " ").splitlines()]
PICTURES = ("bevel-gears", "tooth-traces", "depth-tapers", "bevel-bodies")


def test_each_block_prints_what_stands_below_it_and_draws_the_pictures(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert sorted(path.name for path in (tmp_path / "pair").iterdir()) == ["gear.stl", "pinion.stl"]
    for name in PICTURES:
        assert_drawn_alike(tmp_path / f"{name}.png", ROOT / f"docs/images/{name}.png")


@pytest.mark.parametrize("command", COMMANDS, ids=range(len(COMMANDS)))
def test_every_command_runs(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = shlex.split(command)
    assert main(words[1:]) == 0, capsys.readouterr().err
    assert capsys.readouterr().out
    for name, output in pairwise(words):
        if name == "-o":
            assert (tmp_path / output).exists()


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
