"""What the page on contact shows is what happens."""

import shlex

import pytest

from gearwright.cli import main

from .pages import ROOT, assert_blocks_print_what_stands_below, assert_drawn_alike, blocks, links

PAGE = ROOT / "docs/contact.md"


def test_each_block_prints_what_stands_below_it(capsys):
    assert_blocks_print_what_stands_below(PAGE, capsys)


def test_the_command_draws_the_picture(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (command,) = [text for kind, text in blocks(PAGE) if kind == "sh"]
    assert main(shlex.split(command)[1:]) == 0, capsys.readouterr().err
    assert_drawn_alike(tmp_path / "out/contact.png", ROOT / "docs/images/bevel-contact.png")


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
