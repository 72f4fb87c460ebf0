"""Sheets as files, in the format of the name's suffix, whole or not at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from .. import disk
from ..errors import FileError
from . import dxf_writing, pdf_writing, svg_writing
from .marks import Sheet

_WRITERS: Mapping[str, Callable[[str, Sequence[Sheet], str], bytes]] = {
    ".dxf": dxf_writing.encoded,
    ".svg": svg_writing.encoded,
    ".pdf": pdf_writing.encoded,
}

WRITTEN = tuple(_WRITERS)
"""Suffixes of the sheets that are written."""


def require_suffix(path: str | Path) -> str:
    """The suffix of a sheet's file. Raises FileError where it is another."""
    suffix = Path(path).suffix.lower()
    if suffix not in _WRITERS:
        raise FileError(f"{path}: sheets are drawn as {', '.join(_WRITERS)}; end the name in one of these")
    return suffix


def write(path: str | Path, sheets: Sequence[Sheet], title: str) -> None:
    """Writes sheets to one file: pages of a PDF, one below another in DXF and SVG.

    Raises FileError where the name is not such a file's or there is no such folder; MachineError where the disk does
    not take it or the writer is not installed.
    """
    data = _WRITERS[require_suffix(path)](f"{path}", sheets, title)
    with disk.written_whole(path) as stream:
        stream.write(data)
