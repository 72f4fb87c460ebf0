"""The zip package of a 3MF file: its parts by name, unpacked within limits."""

from __future__ import annotations

import io
import posixpath
import struct
import zipfile
import zlib
from collections.abc import Iterator
from typing import final
from urllib.parse import unquote

from ...errors import FileError
from ..contents import Data
from ..text.places import shown

MOST_BYTES = 1 << 30
"""Bytes of all parts read, unpacked: some 10 million triangles."""

MOST_RATIO = 200
"""Unpacked bytes for a packed one, over all parts read. XML of meshes has 5 to 30, deflate can reach 1032."""

_ALWAYS = 1 << 24
"""Bytes that may be unpacked whatever the ratio."""

_CHUNK = 1 << 16
_ENCRYPTED = 1
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_FAULTS = (
    zipfile.BadZipFile, zlib.error, struct.error, NotImplementedError, RuntimeError, EOFError, OSError, ValueError,
    IndexError, OverflowError,
)  # fmt: skip
"""What zipfile raises on damaged data."""


@final
class Package:
    """Parts of a package by name: without the first "/", upper and lower case alike, as the packaging standard says."""

    def __init__(self, data: Data, name: str):
        """Raises FileError if the data are no zip package, or one in a form that 3MF does not have."""
        self.name = name
        self._size = len(data)
        self._unpacked = 0
        try:
            self._zip = zipfile.ZipFile(io.BytesIO(data))
            members = self._zip.infolist()
        except _FAULTS as error:
            raise FileError(
                f"{name}: not a 3MF file, which is a zip package: {shown(str(error), 160)}; it is cut off or of"
                " another kind; write or copy it again"
            ) from None
        self._members: dict[str, zipfile.ZipInfo] = {}
        for member in members:
            key = member.filename.lower()
            if key in self._members:
                raise FileError(
                    f'{name}: its package has two parts named "{shown(member.filename)}"; one of them would be'
                    " lost; write the file again"
                )
            self._members[key] = member

    def __contains__(self, part: str) -> bool:
        return part.lower() in self._members

    def chunks(self, part: str) -> Iterator[bytes]:
        """The bytes of a part, piece by piece; limits are held while it is unpacked, whatever its header claims.

        Raises FileError if there is no such part, it is damaged or encrypted, or it unpacks to too much.
        """
        member = self._members.get(part.lower())
        if member is None:
            raise FileError(f'{self.name}: its package has no part "{shown(part)}"; it is not whole; write it again')
        self._require_readable(member)
        try:
            with self._zip.open(member) as stream:
                while chunk := stream.read(_CHUNK):
                    self._count(len(chunk), part)
                    yield chunk
        except _FAULTS as error:
            raise FileError(
                f'{self.name}: the part "{shown(part)}" is damaged: {shown(str(error), 160)}; write or copy the file'
                " again"
            ) from None

    def _require_readable(self, member: zipfile.ZipInfo) -> None:
        wrong = (
            "is encrypted; save the file without protection"
            if member.flag_bits & _ENCRYPTED
            else "lies on another disk of a split package; join the package again"
            if member.volume
            else f"is packed by method {member.compress_type}; 3MF has 0 (stored) and 8 (deflated); pack it again"
            if member.compress_type not in _METHODS
            else None
        )
        if wrong:
            raise FileError(f'{self.name}: the part "{shown(member.filename)}" {wrong}')

    def _count(self, size: int, part: str) -> None:
        self._unpacked += size
        if self._unpacked > MOST_BYTES:
            raise FileError(
                f'{self.name}: the part "{shown(part)}" unpacks to more than {MOST_BYTES >> 20} MiB, with those before'
                " it: the most that is read; split the file or write coarser meshes"
            )
        if self._unpacked > max(_ALWAYS, MOST_RATIO * self._size):
            raise FileError(
                f'{self.name}: the part "{shown(part)}" unpacks to more than {MOST_RATIO} times the size of the file;'
                " meshes do not, but files made to fill a memory do; unpack and pack it again if you trust it"
            )


def part_name(target: str, file: str) -> str:
    """The name of a part as `Package` takes it, from a path in the package. Raises FileError if it leads out of it."""
    path = unquote(target).lstrip("/")
    if not path or "\\" in path or "\0" in path or ":" in path or posixpath.normpath(path).startswith(".."):
        raise FileError(f'{file}: "{shown(target, 80)}" is no path inside the package; write the file again')
    return posixpath.normpath(path)
