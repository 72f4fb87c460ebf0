"""What docs/designs.md shows is built."""

import json
import re
import shlex
from pathlib import Path

import pytest

import gearwright as gw
from gearwright.cli import main

DOCS = Path(__file__).parents[1] / "docs"
PAGE = (DOCS / "designs.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", PAGE, flags=re.DOTALL)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with the files of the page, each named in its first line."""
    monkeypatch.chdir(tmp_path)
    for kind, text in BLOCKS:
        if kind in ("toml", "csv"):
            (tmp_path / re.match(r"# (\w+\.\w+)", text)[1]).write_text(text)
    return tmp_path


def test_every_command_runs(folder, capsys):
    commands = [line for kind, text in BLOCKS if kind == "sh" for line in text.splitlines()]
    assert len(commands) >= 8
    for command in commands:
        assert main(shlex.split(command)[1:]) == 0, capsys.readouterr().err
        assert capsys.readouterr().out
    assert {path.name for path in folder.glob("out/**/*.*")} >= {"pinion.stl", "pair.png", "post.stl", "spring.png"}


def test_every_design_is_built_by_a_command_of_the_page(folder):
    for path in folder.glob("*.toml"):
        assert f"gearwright build {path.name}" in PAGE


def test_the_bowl_is_what_the_page_says(folder, capsys):
    """Its radius is 20 (1 − z²/2000), 11 at the top; it leans by a tenth of the height."""
    main(["build", "bowl.toml", "--json", "-o", "bowl.stl"])
    assert json.loads(capsys.readouterr().out)["properties"]["bounding_box"][0][2] == 0
    corners = gw.Polyhedron.load("bowl.stl").vertices
    top = corners[corners[:, 2] > 29.9999]
    assert top[:, 0].max() == pytest.approx(14.0, abs=1e-4)
    assert top[:, 1].max() == pytest.approx(11.0, abs=1e-2)


@pytest.mark.parametrize("link", re.findall(r"\]\(([^)#:]+)\)", PAGE))
def test_links_lead_somewhere(link):
    assert (DOCS / link).exists()
