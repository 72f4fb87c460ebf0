"""A folder that is there and the server's own, also where something that tidies up has removed it."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path


def made_sure(folder: Path) -> Path:
    """The folder, made with the one above it where they are gone, so that only their owner reads them.

    Raises OSError: PermissionError where another user has put something in their place.
    """
    for one in (folder.parent, folder):
        try:
            one.mkdir(mode=0o700)
        except FileExistsError:
            _require_own(one)
    return folder


def _require_own(folder: Path) -> None:
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode) or (os.name == "posix" and found.st_uid != os.geteuid()):
        raise PermissionError(errno.EACCES, "this has been put in place of the server's folder", str(folder))
