"""Files that the page has sent: kept under names that nobody guesses, in a folder that nobody else reads."""

from __future__ import annotations

import re
import secrets
import shutil
from collections import OrderedDict
from pathlib import Path
from typing import final

from .own_folder import made_sure

_MOST_FILES = 200
_MOST_BYTES = 200 << 20
MOST_BYTES_EACH = 20_000_000

_UNSAFE = re.compile(r"[^\w .()+-]|^[. ]+|[. ]+$")
_LONGEST = 100  # bytes: systems count those, not letters


def plain_name(name: str) -> str:
    """A file's name as it is kept: its last part, of letters, digits and a few signs."""
    last = re.split(r"[/\\]", name)[-1]
    stem, dot, suffix = last.rpartition(".")
    stem, suffix = _UNSAFE.sub("_", stem).encode()[:_LONGEST], re.sub(r"\W", "", suffix)[:10].lower()
    return f"{stem.decode(errors='ignore') or 'file'}{dot}{suffix}"


@final
class Uploads:
    """Files by random names in a folder, of which the oldest are forgotten when there are too many."""

    def __init__(self, folder: Path, most_files: int = _MOST_FILES, most_bytes: int = _MOST_BYTES):
        self.folder = folder
        self._most_files, self._most_bytes = most_files, most_bytes
        self._sizes: OrderedDict[Path, int] = OrderedDict()

    def keep(self, name: str, data: bytes) -> Path:
        """Writes a file of a name made by `plain_name`, and gives where; on any error nothing of it stays.

        Raises OSError.
        """
        home = made_sure(self.folder) / secrets.token_hex(16)
        home.mkdir(mode=0o700)
        path = home / name
        try:
            path.write_bytes(data)
        except BaseException:
            shutil.rmtree(home, ignore_errors=True)
            raise
        self._sizes[path] = len(data)
        while len(self._sizes) > self._most_files or sum(self._sizes.values()) > self._most_bytes:
            self.forget(next(iter(self._sizes)))
        return path

    def forget(self, path: Path) -> None:
        """Removes a file."""
        self._sizes.pop(path, None)
        shutil.rmtree(path.parent, ignore_errors=True)
