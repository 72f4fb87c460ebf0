"""Reading a whole file and writing one whole or not at all, with errors that say whose fault it is."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import stat
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from .errors import FileError, GearwrightError, MachineError

_PATH_ERRORS = (FileNotFoundError, FileExistsError, IsADirectoryError, NotADirectoryError, ValueError)
"""What another file name mends; ValueError is a name with a null character."""


def contents(path: str | Path) -> bytes:
    """All bytes of a regular file. Raises FileError, MachineError as `opened`."""
    with opened(path) as stream:
        return stream.read()


@contextmanager
def opened(path: str | Path) -> Iterator[BinaryIO]:
    """A stream of the bytes of a regular file.

    Raises FileError if there is no such file or it is a folder or device; MachineError if it cannot be read.
    """
    try:
        mode = Path(path).stat().st_mode
        if stat.S_ISDIR(mode):
            raise FileError(f"{path}: this is a folder; the name of a file is needed")
        if not stat.S_ISREG(mode):
            raise FileError(f"{path}: this is a device or pipe; copy what it gives into a file first")
        with Path(path).open("rb") as stream:
            yield stream
    except FileNotFoundError:
        raise FileError(f"{path}: there is no such file; check the name and the folder") from None
    except _PATH_ERRORS as error:
        raise FileError(f"{path}: this cannot be a file ({_reason(error)})") from None
    except OSError as error:
        _refuse_long_name(path, error)
        raise MachineError(f"{path}: cannot be read ({_reason(error)}); check its permissions and the disk") from error


def folder(path: str | Path) -> Path:
    """The folder of a name, made with those above it if it is not there yet.

    Raises FileError if the name cannot be a folder's; MachineError if the disk or the permissions do not allow it.
    """
    try:
        Path(path).mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise FileError(f"{path}: cannot be a folder, a file stands in its way; name another one") from None
    except ValueError as error:
        raise FileError(f"{path}: this cannot be a folder ({_reason(error)})") from None
    except OSError as error:
        raise MachineError(f"{path}: the folder cannot be made ({_reason(error)}); name another one") from error
    return Path(path)


@contextmanager
def written_whole(path: str | Path) -> Iterator[BinaryIO]:
    """A stream whose bytes become the file when the block ends; on any error an old file stays as it was.

    They go to a temporary name in the same folder, which is renamed at the end. A link is followed.
    Raises FileError if there is no such folder or the name is not a file's; MachineError if the disk
    or the permissions do not allow it.
    """
    try:
        target = Path(os.path.realpath(path))
        if target.exists() and not target.is_file():
            raise FileError(f"{path}: this is a folder or device; the name of a file is needed")
        temporary = target.with_name(f".{target.name[:100]}.{secrets.token_hex(8)}.part")
        with _removed_on_error(temporary):
            with temporary.open("xb") as stream:
                yield stream
                stream.flush()
                os.fsync(stream.fileno())
            if target.exists():
                temporary.chmod(stat.S_IMODE(target.stat().st_mode))
            temporary.replace(target)
    except FileNotFoundError as error:
        if Path(path).parent.is_dir():
            raise MachineError(f"{path}: cannot be written in this folder; name another one") from error
        raise FileError(f"{path}: there is no folder {Path(path).parent}; make it first") from None
    except _PATH_ERRORS as error:
        raise FileError(f"{path}: this cannot be a file ({_reason(error)})") from None
    except OSError as error:
        _refuse_long_name(path, error)
        raise MachineError(
            f"{path}: cannot be written ({_reason(error)}); nothing was changed; check permissions and free space"
        ) from error


@contextmanager
def written_together(folder: str | Path) -> Iterator[Path]:
    """A folder for files that get into the given folder, under the same relative names, when the block ends.

    On any error all files there are as they were; what else lies there stays. The files are written to a folder of
    their own beside those that they replace, and renamed one by one at the end; if one cannot be, those before it are
    taken back. Raises FileError if there is no such folder or a name is not a file's; MachineError if the disk or the
    permissions do not allow it. Errors of these kinds in the block name the file that was to be.
    """
    home = Path(os.path.realpath(folder))
    staged = home / f".{secrets.token_hex(8)}.part"
    try:
        staged.mkdir()
        new, old = staged / "new", staged / "old"
        new.mkdir()
        old.mkdir()
        yield new
        _exchange(new, old, home)
        shutil.rmtree(old, ignore_errors=True)
    except (FileError, MachineError) as error:
        raise type(error)(str(error).replace(str(staged / "new"), str(home))) from error
    except GearwrightError:
        raise
    except FileNotFoundError:
        raise FileError(f"{folder}: there is no such folder; make it first") from None
    except _PATH_ERRORS as error:
        raise FileError(f"{folder}: files cannot be put there ({_reason(error)})") from None
    except OSError as error:
        _refuse_long_name(error.filename or folder, error)
        raise MachineError(
            f"{folder}: cannot be written to ({_reason(error)}); nothing was changed; check permissions and free space"
        ) from error
    finally:
        shutil.rmtree(staged / "new", ignore_errors=True)
        _without_error((staged / "old").rmdir)  # not empty where an old file could not be put back
        _without_error(staged.rmdir)


def _renamed(path: Path, target: Path) -> None:
    """Renames a file; moves it where a link has led to another disk."""
    try:
        path.replace(target)
    except OSError as error:
        if error.errno != errno.EXDEV:
            raise
        shutil.move(path, target)


def _exchange(new: Path, old: Path, home: Path) -> None:
    """Moves every file of one folder to its place in another, and what stood there to a third; all or none."""
    names = [path.relative_to(new) for path in sorted(new.rglob("*")) if path.is_file()]
    for name in names:
        place = home / name
        if place.exists() and not place.is_file():
            raise FileError(f"{place}: this is a folder or device; the name of a file is needed")
        if place.parent.exists() and not place.parent.is_dir():
            raise FileError(f"{place.parent}: cannot be a folder, a file stands in its way; move it away")
    with ExitStack() as undo:
        for name in names:
            place, kept = Path(os.path.realpath(home / name)), old / name  # a link is followed
            for path in (place, kept):
                if not path.parent.exists():
                    path.parent.mkdir()
                    undo.callback(_without_error, path.parent.rmdir)
            if place.exists():
                (new / name).chmod(stat.S_IMODE(place.stat().st_mode))
                _renamed(place, kept)
                undo.callback(_renamed, kept, place)
            _renamed(new / name, place)
            undo.callback(_without_error, place.unlink)
        undo.pop_all()


def _without_error(step: Callable[[], object]) -> None:
    with suppress(OSError):
        step()


@contextmanager
def _removed_on_error(temporary: Path) -> Iterator[None]:
    try:
        yield
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def _refuse_long_name(path: str | Path, error: OSError) -> None:
    if error.errno == errno.ENAMETOOLONG:
        raise FileError(f"{str(path)[:60]}…: the name is too long; take a shorter one") from None


def _reason(error: Exception) -> str:
    return (error.strerror if isinstance(error, OSError) else None) or str(error)
