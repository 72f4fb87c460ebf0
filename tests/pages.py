"""What pages of documentation hold: blocks of code and text, and links."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]


def blocks(page):
    """Kind and text of every fenced block of a page."""
    return re.findall(r"```(\w+)\n(.*?)```", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def links(page):
    """Files that a page refers to, by their paths."""
    return [page.parent / link for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8"))]
