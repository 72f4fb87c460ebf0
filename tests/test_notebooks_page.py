"""What the page on notebooks says and shows is so."""

import atexit

import numpy as np
import pytest
from IPython.core.displayhook import CapturingDisplayHook
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

import gearwright as gw
from gearwright.elements.element import Element
from gearwright.elements.pair import Pair
from gearwright.solids import summaries
from gearwright.solids.solid import Solid
from gearwright.viewer import document
from gearwright.viewer.surface import SHARP

from .pages import ROOT, assert_blocks_print_what_stands_below, blocks, links

PAGE = ROOT / "docs/notebooks.md"
TEXT = " ".join(PAGE.read_text(encoding="utf-8").split())


def test_the_blocks_print_what_stands_below_them(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert "<title>Gear pair: 17/38 teeth, helical" in (tmp_path / "pair.html").read_text(encoding="utf-8")


@pytest.fixture
def notebook(monkeypatch):
    """A function that runs a cell and gives what it shows, by kind."""
    monkeypatch.delenv("VIRTUAL_ENV", raising=False)  # another one that is active is nothing to warn of
    shell = InteractiveShell.instance(config=Config({"HistoryManager": {"enabled": False}}))

    def run(cell):
        shown = []
        shell.display_trap.hook = CapturingDisplayHook(shell, shown)
        shell.run_cell(cell, store_history=False).raise_error()
        return shown[-1]["data"] if shown else {}

    yield run
    InteractiveShell.clear_instance()
    atexit.unregister(shell.atexit_operations)


def test_a_notebook_shows_what_stands_last_in_a_cell(notebook, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code = next(text for kind, text in blocks(PAGE) if kind == "python")
    assert notebook(code) == {}
    assert notebook("pair.show()")["text/html"].startswith("<iframe" if document.built() else "<figure")
    assert "<table>" in notebook("pair")["text/html"]
    assert notebook("pair.pinion.profile")["image/svg+xml"].startswith("<svg")
    assert set(notebook("pair.gear.properties()")) == {"text/html", "text/plain"}
    assert "<table>" in notebook("pair.gear.polyhedron()")["text/html"]


@pytest.mark.parametrize(
    "said",
    [
        f"meet at more than {np.degrees(SHARP):.0f}°",
        f"up to {summaries.MOST_TRIANGLES:,} triangles",
        f"more than {summaries.MOST_EXAMINED:,} faces",
    ],
)
def test_limits_are_those_of_the_code(said):
    assert said in TEXT


def test_every_kind_of_body_has_every_way():
    for kind in (gw.Polyhedron, Solid, Element, Pair):
        for way in ("show", "to_trimesh", "to_pyvista", "_repr_html_"):
            assert callable(getattr(kind, way)), (kind, way)


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
