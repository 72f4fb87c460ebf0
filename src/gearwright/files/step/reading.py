"""Reading a STEP file in a process of its own: on damaged files Open CASCADE crashes or runs without end."""

from __future__ import annotations

import os
import re
import subprocess
import sys

from ...errors import FileError
from ..contents import Contents, Data
from ..instances import placed
from .exchange import Found, unpacked

_START = re.compile(rb"\s*ISO-10303-21\s*;")
_COMMENT = re.compile(rb"/\*.*?\*/", re.DOTALL)
_END = b"END-ISO-10303-21"
_SAMPLE = 4096

LEAST_SECONDS = 60.0
"""How long any file may take; honest ones take 1 to 2 s to start and about 1 s a MB."""

BYTES_A_SECOND = 20_000
"""By how much larger a file must be to be given one more second."""


def parse(data: Data, name: str) -> Contents:
    """The solids of a STEP file as polyhedra, in millimetres, assemblies expanded, with their smooth properties.

    A polyhedron's points lie on the smooth faces, its triangles within `faces.DEFLECTION` of the solid's bounding
    diagonal. Neighbouring faces share their points, so it is closed wherever the solid is. Colours and surfaces that
    bound no solid are left out.
    Raises FileError if the data are no whole STEP file with a solid, or Open CASCADE crashes on them or takes longer
    than LEAST_SECONDS + size / BYTES_A_SECOND; MachineError without the extra `step`.
    """
    data = bytes(data)
    _require_whole(data, name)
    found = _run(data, name)
    bodies = tuple(placed(name, ((found.bodies[number], matrix) for number, matrix in found.placements)))
    return Contents(bodies=bodies, length_unit="mm", remarks=found.remarks)


def _require_whole(data: bytes, name: str) -> None:
    if not _START.match(_COMMENT.sub(b"", data[:_SAMPLE].removeprefix(b"\xef\xbb\xbf"))):
        raise FileError(
            f'{name}: not a STEP file, which begins with "ISO-10303-21;"; it is of another kind or damaged;'
            " export it again"
        )
    if _END not in data[-_SAMPLE:]:
        raise FileError(
            f'{name}: a STEP file that does not end with "END-ISO-10303-21;"; it is cut off; copy or export it again'
        )


def _run(data: bytes, name: str) -> Found:
    limit = LEAST_SECONDS + len(data) / BYTES_A_SECOND
    command = [sys.executable, "-P", "-m", "gearwright.files.step.worker", name.replace("\0", "?")]
    paths = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    try:
        done = subprocess.run(  # noqa: S603 - this interpreter, on this package
            command, input=data, capture_output=True, timeout=limit, env=paths, check=False
        )
    except subprocess.TimeoutExpired:
        raise FileError(
            f"{name}: Open CASCADE was not done with this STEP file after {limit:.0f} s; it is damaged or too large;"
            " export it again, or in parts"
        ) from None
    try:
        return unpacked(done.stdout)
    except (ValueError, KeyError, OSError, EOFError):
        last = done.stderr.decode(errors="replace").strip().rpartition("\n")[2][:200]
        raise FileError(
            f"{name}: Open CASCADE crashed on this STEP file (exit code {done.returncode}{': ' if last else ''}{last});"
            " it is damaged, or has shapes that are none; export it again"
        ) from None
