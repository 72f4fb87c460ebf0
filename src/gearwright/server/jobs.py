"""What workers do for the page besides its answers and files: generators of one dict each, and designs admitted."""

from __future__ import annotations

import datetime as dt
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from .. import catalog
from ..designs import forms
from ..designs.design import ELEMENT, design_of
from ..designs.design_file import toml_table
from ..designs.document import built_document, plain
from ..designs.kinds import commands, parameters_of
from ..designs.requested import requested
from ..designs.schema import design_schema
from ..designs.texts import texts as texts_of
from ..designs.uploaded import UPLOADED
from ..errors import FileError, GearwrightError, GeometryError, MachineError, Problem, ProblemsError
from ..parameters import FileName
from ..sources import load
from .hidden_folders import error_without, folders_of, without
from .worker import Answer


def elements(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{"length_units", "kinds"}: every kind of element with its form."""
    del request
    yield plain(forms.elements())


def suffixes(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{"suffixes"} of the files that parameters take."""
    del request
    yield {"suffixes": sorted({suffix for form in _file_forms() for suffix in form.suffixes})}


def schema(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """The schema of designs of the "element", of all where that is None."""
    element = request["element"]
    yield plain(design_schema(commands() if element is None else [element]))


def read(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{"design"} in a "toml" text. Raises ProblemsError where it holds none, or numbers that are not finite."""
    where = "The text"
    try:
        table = toml_table(request["toml"].encode(), where)
    except FileError as error:
        text = str(error).removeprefix(f"{where}: ")
        place, _, words = text.partition(": ") if text.startswith("line ") else ("TOML", "", text)
        problem = Problem(place, words)
        raise ProblemsError("This is no design file", [problem]) from None
    design = design_of(table)
    if endless := [Problem(f"{name} = {value}", _ENDLESS) for name, value in table.items() if not _finite(value)]:
        raise ProblemsError("This design cannot be read", endless)
    yield {"design": _jsonable({ELEMENT: design.kind.command, **design.values})}


def texts(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{"toml", "python", "command"} of a "design"."""
    yield texts_of(design_of(request["design"]))


def build(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """The document of what is built from a "design", of a "density" or a "material"."""
    yield plain(built_document(requested(request).built()))


def check_upload(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{} where the file at "path" in "folder" is one of those that parameters take."""
    from ..sections.drawings import read as read_drawing

    path = Path(request["path"])
    try:
        if path.suffix.lower() == ".csv":
            _check_points(path)
        else:
            with suppress(GeometryError):  # one layer of it may be sound: the design says which
                read_drawing(path)
    except FileError as error:
        problem = Problem(path.name, without(str(error).removeprefix(f"{path}: "), folders_of(request)))
        raise ProblemsError("This file cannot be taken", [problem]) from error
    except GearwrightError as error:
        raise error_without(error, folders_of(request)) from error
    yield {}


def _check_points(path: Path) -> None:
    """Points of an outline, or of a path."""
    from ..curves.path_file import path_from_file
    from ..sections.drawings import read as read_drawing

    try:
        read_drawing(path)
    except GearwrightError as as_outline:
        try:
            path_from_file(path)
        except GearwrightError:
            raise as_outline from None


def admitted(request: Mapping[str, Any]) -> Iterator[Answer]:
    """The answers of the job "source" to "request", whose design's uploads are files in "folder".

    Raises ProblemsError where the design names any other file.
    """
    folder, inner = str(request["folder"]), dict(request["request"])
    try:
        inner["design"] = _with_files(inner["design"], folder)
    except NoUploadError:
        raise
    except ProblemsError:
        pass  # the job itself raises it, in its words
    try:
        for answer in load(request["source"])(inner):
            yield without(answer, [folder]) if isinstance(answer, dict) else answer
    except GearwrightError as error:
        raise error_without(error, folders_of(request)) from error
    except OSError as error:
        named = f"{error.filename}: " if error.filename else ""
        raise MachineError(without(f"{named}{error.strerror or error}", folders_of(request))) from error


def _file_forms() -> Iterator[FileName]:
    for kind in catalog.ELEMENTS:
        for declaration in parameters_of(kind):
            yield from (form for form in declaration.parameter.forms if isinstance(form, FileName))


def _with_files(table: Mapping[str, Any], folder: str) -> dict[str, Any]:
    """A design with the paths of its uploads. Raises ProblemsError."""
    named = design_of(table).file_names
    paths = {name: _path(folder, value) for name, value in named.items()}
    problems = [Problem(f"{name} = {named[name]!r}", _NOT_HERE) for name, path in paths.items() if path is None]
    if problems:
        raise NoUploadError("Files of the server cannot be named", problems)
    return {**table, **paths}


class NoUploadError(ProblemsError):
    """A design that names a file that was not uploaded."""


_NOT_HERE = "no such upload is here (they are forgotten after a while); choose the file again, to upload it"
_UPLOAD = re.compile(rf"{UPLOADED}([0-9a-f]{{32}})/([^/\\\0]+)")


def _path(folder: str, value: str) -> str | None:
    """Where an uploaded file lies; None for any other name, and for one that was forgotten."""
    found = _UPLOAD.fullmatch(value)
    path = Path(folder) / found[1] / found[2] if found else None
    return str(path) if path is not None and path.is_file() else None


_ENDLESS = "numbers are to be finite, below 1.8e308; give one that is, or leave the parameter out"


def _finite(value: Any) -> bool:
    """Whether every number in a value of TOML is one, and in the range of doubles."""
    match value:
        case dict():
            return all(map(_finite, value.values()))
        case list():
            return all(map(_finite, value))
        case _:
            return not isinstance(value, (int, float)) or abs(value) <= sys.float_info.max


def _jsonable(value: Any) -> Any:
    """A value of TOML, whose dates are no parameter's, for JSON."""
    match value:
        case dict():
            return {name: _jsonable(one) for name, one in value.items()}
        case list():
            return [_jsonable(one) for one in value]
        case dt.date() | dt.time():
            return value.isoformat()
        case _:
            return plain(value)
