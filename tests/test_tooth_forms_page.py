"""What the page that compares tooth forms shows is what happens."""

import pytest

from .pages import ROOT, assert_blocks_print_what_stands_below, assert_drawn_alike, links

PAGE = ROOT / "docs/tooth-forms.md"


def test_each_block_prints_what_stands_below_it_and_draws_the_pictures(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    for name in ("tooth-forms.png", "tooth-form-recipe.png"):
        assert_drawn_alike(tmp_path / name, ROOT / "docs/images" / name)


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
