"""How wide text is on paper. Letters are those of DejaVu Sans, which comes with matplotlib."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.ft2font import FT2Font

FONT = "DejaVu Sans"
CAPITALS = 0.729
"""Height of capitals, which is the height of lettering by ISO 3098, in font sizes (em)."""

LOWERED, SMALLER = 0.3, 0.72
"""By how much a subscript lies lower, and its height, in heights of the text."""

_MEASURED = 64.0  # points: the size at which widths are taken


@cache
def _font() -> FT2Font:
    from matplotlib import get_data_path
    from matplotlib.ft2font import FT2Font

    font = FT2Font(str(Path(get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"))
    font.set_size(_MEASURED, 72)
    return font


@cache
def _advance(letter: str) -> float:
    """How far a letter takes the next one, in font sizes."""
    from matplotlib.ft2font import LoadFlags

    return float(_font().load_char(ord(letter), flags=LoadFlags.NO_HINTING).linearHoriAdvance / 65536.0 / _MEASURED)


def strange(text: str) -> str:
    """The characters of a text that the font of sheets does not have, each once, and line ends and tabs."""
    return "".join(dict.fromkeys(c for c in text if not c.isprintable() or not _font().get_char_index(ord(c))))


def width(text: str, height: float) -> float:
    """Width of a text whose capitals have a height; in the unit of the height."""
    return sum(map(_advance, text)) / CAPITALS * height
