"""What the README shows is what happens."""

import re
import shlex

import pytest

from gearwright.cli import main

from .pages import ROOT, blocks, links

README = ROOT / "README.md"
BLOCKS = blocks(README)
COMMANDS = [
    line.strip()
    for kind, text in BLOCKS
    if kind == "sh"
    for line in text.replace("\\\n", " ").splitlines()
    if line.startswith("gearwright")
]


def test_the_python_example_prints_what_stands_below_it(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    kinds = [kind for kind, _ in BLOCKS]
    code, printed = BLOCKS[kinds.index("python")][1], BLOCKS[kinds.index("text")][1]
    exec(compile(code, "README.md", "exec"), {})  # noqa: S102  our own example
    assert capsys.readouterr().out == printed
    assert sorted(path.name for path in (tmp_path / "out/pair").iterdir()) == ["gear.stl", "pinion.stl"]
    assert (tmp_path / "bevel-pair.png").stat().st_size > 100_000


def test_the_commands_run_in_their_order(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for text in (text for kind, text in BLOCKS if kind == "toml"):
        (tmp_path / re.match(r"# (\w+\.toml)", text)[1]).write_text(text)
    assert len(COMMANDS) >= 5
    for command in COMMANDS:
        assert main(shlex.split(command)[1:]) == 0, command
        written = capsys.readouterr()
        assert written.out or "wrote" in written.err


@pytest.mark.parametrize("file", links(README), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
