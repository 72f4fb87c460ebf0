"""The page on CAD programs: the blocks of a section run in the environment of that program."""

from pathlib import Path
from typing import Any

PAGE = Path(__file__).parents[1] / "docs/cad.md"


def assert_section_prints_what_stands_below(heading: str, capsys: Any) -> None:
    """Runs the Python blocks of a section one after another, each followed by the text that it prints."""
    (section,) = (one for one in PAGE.read_text(encoding="utf-8").split("\n## ") if one.startswith(f"{heading}\n"))
    pieces = [piece.split("\n```", 1)[0] for piece in section.split("\n```python\n")[1:]]
    shown = [piece.split("\n```", 1)[0] for piece in section.split("\n```text\n")[1:]]
    names: dict[str, Any] = {}
    assert pieces, heading
    for code, text in zip(pieces, shown, strict=True):
        exec(compile(code, f"{PAGE.name}, {heading}", "exec"), names)
        assert capsys.readouterr().out.rstrip("\n") == text
