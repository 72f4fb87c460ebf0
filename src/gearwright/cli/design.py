"""Design files: an element of the catalog and its parameters as TOML."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import catalog
from ..disk import contents
from ..errors import FileError, Problem, ProblemsError
from ..parameters import FileName, did_you_mean
from .kinds import chosen, kinds_of, parameters_of
from .options import NOT_THIS_MEMBER

ELEMENT = "element"
"""The key that names the element's command; all others are parameters."""


@dataclass(frozen=True, kw_only=True)
class Design:
    """What a design file asks for. kinds   those the element's name stands for, kind the one that is meant"""

    kind: catalog.Element
    kinds: tuple[catalog.Element, ...]
    values: Mapping[str, Any]


def read_design(path: Path) -> Design:
    """The design in a TOML file; names of files in it are relative to it.

    Raises FileError where it is no TOML, with the line; ProblemsError where it names no element; MachineError.
    """
    table = _table(path)
    commands = list(dict.fromkeys(kind.command for kind in catalog.ELEMENTS))
    name = table.get(ELEMENT)
    if name not in commands:
        subject = f"{ELEMENT} = {name!r}" if ELEMENT in table else ELEMENT
        hint = did_you_mean(name, commands) if ELEMENT in table else f' at the top, such as {ELEMENT} = "{commands[0]}"'
        problem = Problem(subject, f"one of {', '.join(commands)} is needed{hint}")
        raise ProblemsError(f"{path}: this names no element", [problem, *_misnamed(table)])
    kinds = tuple(kinds_of(name))
    kind = chosen(kinds, table.get("teeth"))
    values = {key: _with_gaps(value) for key, value in table.items() if key != ELEMENT}
    return Design(kind=kind, kinds=kinds, values=_found_beside(path, kind, values))


def _with_gaps(value: Any) -> Any:
    """A value for each member of a pair, with nothing where it says so: TOML has no word of its own for that."""
    if not isinstance(value, list) or NOT_THIS_MEMBER not in value:
        return value
    return [None if one == NOT_THIS_MEMBER else one for one in value]


def _table(path: Path) -> dict[str, Any]:
    data = contents(path)
    try:
        return tomllib.loads(data.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        broken = data.count(b"\n", 0, error.start) + 1
        raise FileError(f"{path}: line {broken}: this is no text in UTF-8, which a TOML file is") from None
    except tomllib.TOMLDecodeError as error:
        last = data.count(b"\n") + (not data.endswith(b"\n"))
        found = re.fullmatch(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", str(error), re.DOTALL)
        what, line, column = found.groups() if found else (str(error), None, None)
        where = f"line {line or last}" + (f", column {column}" if column else ", the last")
        raise FileError(f"{path}: {where}: this is no TOML: {what}") from None
    except RecursionError:
        raise FileError(f"{path}: lists or tables are nested more deeply than any design") from None


def _misnamed(table: Mapping[str, Any]) -> list[Problem]:
    """Keys that nearly are the one that names the element."""
    return [
        Problem(key, f"there is no such key{hint}")
        for key in table
        if (hint := did_you_mean(key, [ELEMENT])) and key != ELEMENT
    ]


def _found_beside(path: Path, kind: catalog.Element, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values with names of files as seen from the design's folder."""
    files = {d.name for d in parameters_of(kind) if any(isinstance(form, FileName) for form in d.parameter.forms)}
    return {
        name: str(path.parent / value) if name in files and isinstance(value, str) and value else value
        for name, value in values.items()
    }
