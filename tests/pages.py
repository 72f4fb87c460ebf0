"""What pages of documentation hold: blocks of code and text, and links."""

import re
from pathlib import Path

import matplotlib.image
import numpy as np

ROOT = Path(__file__).parents[1]


def blocks(page):
    """Kind and text of every fenced block of a page."""
    return re.findall(r"```(\w+)\n(.*?)```", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def links(page):
    """Files that a page refers to, by their paths."""
    return [page.parent / link for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8"))]


def assert_blocks_print_what_stands_below(page, capsys):
    """Runs the Python blocks of a page one after another, each followed by the text that it prints."""
    shown = blocks(page)
    codes, printed = ([text for kind, text in shown if kind == wanted] for wanted in ("python", "text"))
    names = {}
    for code, text in zip(codes, printed, strict=True):
        exec(compile(code, page.name, "exec"), names)  # noqa: S102  our own example
        assert capsys.readouterr().out.rstrip("\n") == text.rstrip("\n")


def assert_drawn_alike(drawn, shown):
    """Two pictures of one size with as much in them; fonts and the side of a view may differ between machines."""
    one, other = (matplotlib.image.imread(path)[..., :3] for path in (drawn, shown))
    assert one.shape == other.shape
    np.testing.assert_allclose(one.mean(axis=(0, 1)), other.mean(axis=(0, 1)), atol=4e-3)
