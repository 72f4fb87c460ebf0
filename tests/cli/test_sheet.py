"""`--sheet FILE.dxf|svg|pdf`."""

from pathlib import Path

import pytest

from gearwright import catalog, sheets
from gearwright.cli import common_options
from gearwright.cli.output_problems import output_problems
from gearwright.designs import file_problems
from gearwright.sheets.papers import PAPERS

SPUR = "spur --teeth 18 --module 4 --face-width 20 --bore 14".split()
BEVEL = "bevel --teeth 16 24 --module 4 --face-width 15".split()


@pytest.mark.parametrize("suffix", sheets.WRITTEN)
@pytest.mark.parametrize("words", [SPUR, BEVEL], ids=["spur", "bevel pair"])
def test_a_sheet_is_drawn(run, tmp_path, words, suffix):
    path = tmp_path / "made" / f"sheet{suffix}"
    outcome = run(*words, "--sheet", path, "--json")
    assert (outcome.code, outcome.err.splitlines()[-1]) == (0, f"wrote {path}")
    assert path.stat().st_size > 10_000


def test_material_and_paper_are_stated(run, tmp_path):
    path = tmp_path / "sheet.svg"
    assert run(*SPUR, "--sheet", path, "--material", "brass", "--paper", "A4").code == 0
    text = path.read_text(encoding="utf-8")
    assert 'width="297mm"' in text
    assert ">brass<" in text
    assert " kg<" in text


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--sheet", "a.png"], "--sheet a.png: no such files are written here, but .pdf, .dxf, .svg"),
        (["--sheet", "."], "--sheet: a name is needed"),
        (["--sheet", "a.svg", "--paper", "A5"], "--paper A5: choose A3 or A4"),
        (["--paper", "A4"], "--paper: applies to a --sheet; none is asked for"),
        (["--sheet", "a.svg", "--drawing", "a.svg"], "--sheet a.svg: the file of --drawing, too"),
    ],
)
def test_what_cannot_be_drawn_is_refused_before_anything_is_written(run, words, text, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = run(*SPUR, *words)
    assert (outcome.code, outcome.out) == (2, "")
    assert text in outcome.err
    assert not list(tmp_path.iterdir())


def test_the_options_accept_what_is_written():
    kind = next(one for one in catalog.ELEMENTS if one.plane)
    for suffix in (*sheets.WRITTEN, ".png", ".stl"):
        refused = output_problems(common_options.Outputs(sheet=Path(f"a{suffix}")), kind)
        assert bool(refused) == (suffix not in sheets.WRITTEN)
    assert tuple(PAPERS) == file_problems.PAPERS
    assert set(sheets.WRITTEN) == set(file_problems.SHEETS)
