"""Buffers of a glTF file: in the file itself, or in files of its own folder."""

from __future__ import annotations

import base64
import binascii
from pathlib import Path
from typing import final
from urllib.parse import unquote

from ... import disk
from ..text.places import shown
from .document import Value

MOST_BYTES = 1 << 31
"""Bytes of all buffers together."""

_DATA = "data:"
_BASE64 = ";base64"


@final
class Buffers:
    """Bytes of the buffers and buffer views of a document; each buffer is fetched once, when it is first needed."""

    def __init__(self, found: Value, binary: bytes | None, file: str):
        self._file, self._binary = file, binary
        self._buffers = found.items("buffers")
        self._views = found.items("bufferViews")
        self._contents: dict[int, memoryview] = {}
        self._total = 0

    def view(self, asking: Value, key: str = "bufferView") -> tuple[memoryview, int]:
        """Bytes of the view whose number is a member, and its stride, 0 where it states none.

        Raises FileError where there is no such view or it does not lie in its buffer.
        """
        view = chosen(self._views, asking, key, "buffer views")
        chosen(self._buffers, view, "buffer", "buffers")
        contents = self._content(view.whole("buffer"))
        start, length = view.whole("byteOffset", 0), view.whole("byteLength", least=1)
        if start + length > len(contents):
            raise view.error(
                f"takes bytes {start} to {start + length} of a buffer that has {len(contents)}; the file is damaged"
            )
        stride = view.whole("byteStride", 0, most=252)
        return contents[start : start + length], stride

    def _content(self, number: int) -> memoryview:
        if number not in self._contents:
            buffer = self._buffers[number]
            length = buffer.whole("byteLength", least=1)
            self._total += length
            if self._total > MOST_BYTES:
                raise buffer.error(
                    f"buffers of more than {MOST_BYTES >> 20} MiB, the most that is read; split the file"
                )
            found = self._fetched(buffer, number, length)
            if len(found) < length:
                raise buffer.error(
                    f"announces {length} bytes, but {len(found)} are there; it is cut off; copy it again"
                )
            self._contents[number] = memoryview(found)[:length]
        return self._contents[number]

    def _fetched(self, buffer: Value, number: int, length: int) -> bytes:
        if "uri" not in buffer:
            if number == 0 and self._binary is not None:
                return self._binary
            raise buffer.error(
                "has neither a uri nor the binary chunk of the file; it is compressed or damaged; export it again"
            )
        uri = buffer.text("uri")
        if uri.startswith(_DATA):
            return _decoded(buffer, uri)
        path = self._beside(buffer, unquote(uri))
        with disk.opened(path) as stream:
            return stream.read(length)

    def _beside(self, buffer: Value, given: str) -> Path:
        """The path of a file in the folder of this one, or below it."""
        way_out = "save the scene as one file, .glb, or with its data inside"
        relative = Path(given)
        if not given or any(sign in given for sign in ":\\\0") or relative.is_absolute() or ".." in relative.parts:
            raise buffer.error(f'its uri "{shown(given, 80)}" is no name of a file beside this one; {way_out}')
        own = Path(self._file)
        if self._file == "standard input" or not own.is_file():
            raise buffer.error(
                f'its data are in the file "{shown(given, 80)}", and without a folder it is not found; {way_out}'
            )
        folder = own.resolve().parent
        if not (folder / relative).resolve().is_relative_to(folder):
            raise buffer.error(f'its uri "{shown(given, 80)}" leads out of the folder of this file; {way_out}')
        return folder / relative


def chosen(listed: list[Value], asking: Value, key: str, what: str) -> Value:
    """The one of a list whose number is a member. Raises FileError where there is none."""
    number = asking.whole(key)
    if number >= len(listed):
        raise asking.error(f"{key} is {number}; there are {len(listed)} {what}, numbered from 0; write the file again")
    return listed[number]


def _decoded(buffer: Value, uri: str) -> bytes:
    head, found, text = uri.partition(",")
    if not found or not head.endswith(_BASE64):
        raise buffer.error(f'its data are given as "{shown(head)}"; base64 is needed; write the file again')
    try:
        return base64.b64decode(unquote(text) if "%" in text else text, validate=True)
    except (binascii.Error, ValueError) as error:
        raise buffer.error(f"its base64 data are damaged: {error}; write the file again") from None
