"""Binary STL files of any size, a few triangles at a time."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ... import disk
from ...errors import FileError
from ..noted_unit import noted_unit
from .layout import HEADER, RECORD, START


@dataclass(frozen=True, kw_only=True)
class Records:
    """The triangles of a binary STL file, read when they are asked for.

    length_unit   where the header says it, as files of ours do
    """

    path: Path
    count: int
    length_unit: str | None

    def corners(self, start: int, stop: int) -> NDArray[np.float32]:
        """Corners (m, 3, 3) of triangles `start` to `stop`. Raises FileError, MachineError."""
        with disk.opened(self.path) as stream:
            stream.seek(START + start * RECORD.itemsize)
            data = stream.read((stop - start) * RECORD.itemsize)
        if len(data) < (stop - start) * RECORD.itemsize:
            raise FileError(f"{self.path}: the file became shorter while it was read; read it when it is complete")
        return np.asarray(np.frombuffer(data, RECORD)["corners"])


def records(path: str | Path) -> Records:
    """The triangles of a binary STL file.

    Raises FileError if it is not a whole one, or a text STL file; MachineError if the disk does not give it.
    """
    with disk.opened(path) as stream:
        start = stream.read(START)
        size = stream.seek(0, 2)
    count = int.from_bytes(start[HEADER:], "little")
    if len(start) < START or size != START + count * RECORD.itemsize or not count:
        raise FileError(
            f"{path}: not a whole binary STL file: {size} bytes, where {count} triangles take"
            f" {START + count * RECORD.itemsize}; only binary STL files can be read in passing, others must be loaded"
        )
    return Records(path=Path(path), count=count, length_unit=noted_unit(start[:HEADER]))
