"""What the page on sweeps shows is what happens."""

import pytest

from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/sweeps.md"


def test_each_block_prints_what_stands_below_it(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bend.csv").write_text("x,y,z\n0,0,0\n40,0,0\n70,20,5\n80,60,10\n", encoding="utf-8")
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert (tmp_path / "spring.stl").exists()


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
