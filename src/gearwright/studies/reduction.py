"""Moments of one huge file on Dask: the reduction of threads, spread over workers.

Every chunk gives two sums a row whose exact value is high + low; they are merged in the order of the file, as those
of threads are, so that the answer is the same to the last bit however many workers there are.
"""

from __future__ import annotations

from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from ..arrays import Array
from ..errors import MachineError
from ..files.stl.records import Records, records
from ..moments.soup import Look, Soup, joined
from ..moments.summation import CHUNK
from ..solids.properties import MassProperties
from ..solids.streamed import soup_properties

if TYPE_CHECKING:
    from dask.distributed import Client

_CHUNKS = 32
"""Chunks a task: about a million triangles, 52 MB of a file."""


def stream_properties_on_dask(path: str | Path, client: Client, density: float = 1.0) -> MassProperties:
    """Volume, centroid and inertia of a binary STL file that all workers can read by this name.

    As `stream_properties`, which says what is checked, and equal to it to the last bit.
    Raises FileError, MachineError, GeometryError; MachineError without the extra `study`.
    """
    source = records(path)
    soup = Soup(corners=source.corners, count=source.count, threads=1)
    tasks = [
        client.submit(_looks, source, start, soup.middle, pure=False)
        for start in range(0, source.count, CHUNK * _CHUNKS)
    ]
    try:
        looks = client.gather(tasks)  # type: ignore[no-untyped-call]
    except OSError as error:
        raise MachineError(f"the workers did not answer ({error}); start them again") from error
    return soup_properties(source, soup, joined(chain.from_iterable(looks)), density)


def _looks(source: Records, start: int, origin: Array) -> list[Look]:
    """The looks at the chunks of one task."""
    soup = Soup(corners=source.corners, count=source.count, threads=1)
    stop = min(start + CHUNK * _CHUNKS, source.count)
    return [soup.part(first, min(first + CHUNK, stop), origin) for first in range(start, stop, CHUNK)]
