"""What the page on the thesis's examples shows is what happens."""

import pytest

from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/thesis.md"


def test_each_block_prints_what_stands_below_it(capsys):
    assert_blocks_print_what_stands_below(PAGE, capsys)


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
