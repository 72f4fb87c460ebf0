"""What the page on drawings shows of writing them is what happens."""

import re
from itertools import pairwise

import gearwright as gw

from .pages import ROOT, blocks

PAGE = ROOT / "docs/drawings.md"


def test_the_blocks_on_writing_print_what_stands_below_them(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    names = {}
    exec("import gearwright as gw\nfrom gearwright.sections import drawings", names)  # noqa: S102  as above on the page
    shown = [
        (code, text) for (kind, code), (after, text) in pairwise(blocks(PAGE)) if (kind, after) == ("python", "text")
    ]
    assert len(shown) == 2
    for code, text in shown:
        exec(compile(code, PAGE.name, "exec"), names)  # noqa: S102  our own example
        assert capsys.readouterr().out == text
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fine.svg", "gear.dxf", "pair.dxf"]


def test_the_sheet_on_the_page_is_what_its_block_writes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (code,) = [text for kind, text in blocks(PAGE) if kind == "python" and "save_sheet" in text]
    exec(compile(code, PAGE.name, "exec"), {"gw": gw})  # noqa: S102  our own example
    drawn = (tmp_path / "wheel.svg").read_text("utf-8")
    shown = (ROOT / "docs/images/wheel-sheet.svg").read_text("utf-8")
    assert outline(drawn) == outline(shown)


def outline(svg):
    """Text and kinds of elements of a sheet, one by one; last digits may differ between machines."""
    return re.findall(r"<(\w+)|>([^<>]+)</text>", svg)
