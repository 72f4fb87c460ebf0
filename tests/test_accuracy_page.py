"""What the page on accuracy shows is what happens."""

import matplotlib.image
import numpy as np
import pytest

from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/accuracy.md"


def test_the_code_prints_what_stands_below_it_and_draws_the_figure(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    drawn, figure = (
        matplotlib.image.imread(folder / "helical-convergence.png")[..., :3]
        for folder in (tmp_path, ROOT / "docs/images")
    )
    assert drawn.shape == figure.shape
    assert np.abs(drawn - figure).mean() < 1e-3  # releases of matplotlib differ in the edges of letters


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
