"""Files and streams of bodies, read in the format that their name or their contents show."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

from .. import disk
from ..errors import FileError, MachineError
from ..sources import load
from .contents import Contents
from .formats import format_of
from .recognition import recognise

MOST_BYTES = 4 * 2**30
"""The most that is read from a stream, whose length nobody knows before its end."""

_BLOCK = 1 << 22


def read(path: str | Path) -> Contents:
    """What a file holds, in the format of its suffix.

    Raises FileError where the suffix is of no known format or the file is not whole; MachineError if the disk does
    not give it.
    """
    if not Path(path).suffix:
        with disk.opened(path):  # a name that is no file's is refused as that
            pass
    parse = load(format_of(path, "read").parser or "")
    return parse(disk.contents(path), str(path))


def read_stream(stream: BinaryIO, name: str = "standard input") -> Contents:
    """What a stream of bytes holds, read to its end, in the format that its contents show.

    Raises FileError where they show none, are not whole or are more than MOST_BYTES; MachineError if the stream
    cannot be read.
    """
    data = _all_bytes(stream, name)
    return load(recognise(data, name).parser or "")(data, name)


def _all_bytes(stream: BinaryIO, name: str) -> bytes:
    blocks, size = [], 0
    try:
        while block := stream.read(_BLOCK):
            blocks.append(block)
            size += len(block)
            if size > MOST_BYTES:
                raise FileError(
                    f"{name}: more than {MOST_BYTES} bytes, the most that is read from a stream; save them as a"
                    " file and name that"
                )
    except OSError as error:
        raise MachineError(f"{name}: cannot be read ({error.strerror or error})") from error
    return b"".join(blocks)
