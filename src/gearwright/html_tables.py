"""Tables as HTML, for notebooks: escaped, in the page's own colours, with headings that screen readers know."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape


def table(caption: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table with a caption and a heading over each column, none where heads are all empty; the first of a row is its
    heading."""
    columns = "".join(f'<th scope="col" style="text-align:left">{escape(head)}</th>' for head in heads)
    head = f"<thead><tr>{columns}</tr></thead>" if any(heads) else ""
    body = "".join(f"<tr>{_row(row)}</tr>" for row in rows)
    title = f'<caption style="text-align:left;font-weight:bold">{escape(caption)}</caption>' if caption else ""
    return f"<table>{title}{head}<tbody>{body}</tbody></table>"


def _row(texts: Sequence[str]) -> str:
    first, *others = texts
    cells = "".join(f'<td style="text-align:left">{escape(text)}</td>' for text in others)
    return f'<th scope="row" style="text-align:left">{escape(first)}</th>{cells}'


def number(value: float, digits: int = 7) -> str:
    """A number to so many significant digits."""
    return f"{value:.{digits}g}"


def numbers(values: Iterable[float], digits: int = 7) -> str:
    """Several numbers to so many significant digits of the largest: what is below is rounding."""
    values = [float(value) for value in values]
    largest = max(map(abs, values))
    return ", ".join(number(value if abs(value) > 1e-14 * largest else 0.0, digits) for value in values)


def beside(*parts: str) -> str:
    """Pieces of HTML beside one another where there is room; empty ones are left out."""
    shown = "".join(f"<div>{part}</div>" for part in parts if part)
    return f'<div style="display:flex;flex-wrap:wrap;gap:1.5em;align-items:flex-start">{shown}</div>'
