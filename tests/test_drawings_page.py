"""What the page on drawings shows of writing them is what happens."""

from itertools import pairwise

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
