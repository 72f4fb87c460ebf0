"""Names of files as they are typed: files, folders, lists of files, and what is piped in."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ..disk import contents
from ..errors import FileError, GearwrightError
from ..files import formats
from .exits import explained
from .measuring import STANDARD_INPUT, Failure


def named_files(names: Iterable[Path]) -> list[Path | Failure]:
    """Files in the order of their names; a failure stands where a folder or a list gives none.

    A folder stands for the files in it that can be read, by name, not for those in folders in it; @LIST for the files
    that a text file names, one a line, relative to it; - for what is piped in.
    """
    found: list[Path | Failure] = []
    for name in names:
        try:
            found += _files(name)
        except (GearwrightError, OSError) as error:
            code, message = explained(error, "gearwright properties", subject=str(name))
            found.append(Failure(code=code, message=message))
    return found


def _files(name: Path) -> list[Path]:
    if name == STANDARD_INPUT:
        return [name]
    if str(name).startswith("@"):
        return _listed(Path(str(name)[1:]))
    if not name.is_dir():
        return [name]
    suffixes = [suffix for one in formats.FILE_FORMATS if one.parser for suffix in one.suffixes]
    found = sorted(path for path in name.iterdir() if path.suffix.lower() in suffixes and path.is_file())
    if not found:
        raise FileError(f"{name}: this folder holds no file whose name ends in {', '.join(suffixes)}")
    return found


def _listed(path: Path) -> list[Path]:
    """Files that a list names; empty lines do not count."""
    try:
        lines = contents(path).decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise FileError(f"{path}: a list of files is text in UTF-8, one name a line") from None
    found = [path.parent / line.strip() for line in lines if line.strip()]
    if not found:
        raise FileError(f"{path}: this list names no file")
    return found
