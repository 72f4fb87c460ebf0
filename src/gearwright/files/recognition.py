"""Which format the bytes of a file have, where no suffix says it."""

from __future__ import annotations

import re

from ..errors import FileError
from .formats import FILE_FORMATS, FileFormat
from .text.places import MARK, with_line_feeds

_SAMPLE = 4096
_OFF = re.compile(rb"\s*+(?:#[^\n]*+\n\s*+)*+(?:ST)?C?N?4?n?OFF(?![^\s#])")
_STEP = re.compile(rb"\s*+(?>/\*.*?\*/\s*+)*+ISO-10303-21\s*;", re.DOTALL)
_ASSET = re.compile(rb'"asset"\s*:')
_OBJ = re.compile(rb"^[ \t]*(?:v[ \t]+[-+.\d]|f[ \t]+[-+\d])", re.MULTILINE)
_STL_START, _STL_RECORD = 84, 50


def recognise(data: bytes | memoryview, name: str) -> FileFormat:
    """The format that the bytes have, by how they begin and by what every file of a format contains.

    name   for messages
    Raises FileError where they look like none, or like one that is not read.
    """
    data = bytes(data)
    if not data.strip():
        raise FileError(f"{name}: there is nothing to read, {len(data)} bytes; a file of bodies is needed")
    readable = [one for one in FILE_FORMATS if one.parser]
    names = ", ".join(one.name for one in readable)
    found = _name_of(data)
    for one in readable:
        if one.name == found:
            return one
    if found:
        raise FileError(f"{name}: this looks like {found}, which is not read here; convert it to one of {names}")
    raise FileError(f"{name}: its {len(data)} bytes begin like no file of bodies that is read here: {names}")


def _name_of(data: bytes) -> str | None:
    """The name in FILE_FORMATS of what the bytes look like."""
    text = with_line_feeds(data).removeprefix(MARK)
    if data.startswith(b"PK\x03\x04"):
        return "3MF"
    if data.startswith(b"glTF"):
        return "glTF"
    if re.match(rb"ply\s", text, re.IGNORECASE):
        return "PLY"
    if _STEP.match(text):
        return "STEP"
    if _OFF.match(text):
        return "OFF"
    if _is_stl(data, text):
        return "STL"
    if text.lstrip()[:1] == b"{" and _ASSET.search(text):
        return "glTF"
    if b"\0" not in data[:_SAMPLE] and _OBJ.search(text):
        return "OBJ"
    return None


def _is_stl(data: bytes, text: bytes) -> bool:
    count = int.from_bytes(data[_STL_START - 4 : _STL_START], "little")
    if len(data) > _STL_START and len(data) == _STL_START + count * _STL_RECORD:
        return True
    return text.lstrip()[:5].lower() == b"solid"
