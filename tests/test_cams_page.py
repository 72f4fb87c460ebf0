"""What the page on cams shows is what happens."""

import shlex

import pytest

from gearwright.cli import main

from .pages import ROOT, assert_blocks_print_what_stands_below, blocks, links

PAGE = ROOT / "docs/cams.md"


def test_each_block_prints_what_stands_below_it(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert (tmp_path / "cam.png").stat().st_size > 50_000


def test_the_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    commands = [text.replace("\\\n", " ") for kind, text in blocks(PAGE) if kind == "sh"]
    assert commands
    for command in commands:
        assert main(shlex.split(command)[1:]) == 0, capsys.readouterr().err
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"cam.png", "cam.stl"}


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
