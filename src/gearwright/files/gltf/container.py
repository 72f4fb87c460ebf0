"""The two parts of a glTF file: its JSON document, and in binary files the bytes that go with it."""

from __future__ import annotations

import struct

from ...errors import FileError
from ..text.places import shown
from .document import Value, document

MAGIC = b"glTF"
HEADER = struct.Struct("<4sII")
CHUNK = struct.Struct("<I4s")
JSON, BINARY = b"JSON", b"BIN\0"


def opened(data: bytes, file: str) -> tuple[Value, bytes | None]:
    """The document of a file and its binary chunk, None where it has none.

    Raises FileError if the data are no glTF 2 file, or are cut off.
    """
    text, binary = _chunks(data, file) if data[:4] == MAGIC else (data, None)
    found = document(text, file)
    version = found.member("asset").text("version")
    if not version.startswith("2."):
        given = f"of version {shown(version, 20)}" if version else "that states no version"
        raise FileError(f"{file}: a glTF file {given}; version 2.0 is read; write it again in that version")
    return found, binary


def _chunks(data: bytes, file: str) -> tuple[bytes, bytes | None]:
    if len(data) < HEADER.size:
        raise FileError(f"{file}: a binary glTF file of {len(data)} bytes; it is cut off; write or copy it again")
    _, version, length = HEADER.unpack_from(data)
    if version != 2:
        raise FileError(f"{file}: a binary glTF file of version {version}; version 2 is read; write it again")
    if length != len(data):
        raise FileError(
            f"{file}: its header announces {length} bytes, but it has {len(data)}; it is cut off or has something"
            " attached; write or copy it again"
        )
    found: list[tuple[bytes, bytes]] = []
    place = HEADER.size
    while place < length and len(found) < 2:  # whatever follows these two is for extensions
        if place + CHUNK.size > length:
            raise FileError(f"{file}: ends inside the header of a chunk; write or copy it again")
        size, kind = CHUNK.unpack_from(data, place)
        place += CHUNK.size
        if place + size > length:
            raise FileError(
                f"{file}: a chunk announces {size} bytes where {length - place} are left; write or copy it again"
            )
        found.append((kind, data[place : place + size]))
        place += size
    if not found or found[0][0] != JSON:
        raise FileError(f"{file}: a binary glTF file whose first chunk is not JSON; write it again")
    return found[0][1], found[1][1] if len(found) == 2 and found[1][0] == BINARY else None
