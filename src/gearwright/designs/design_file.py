"""Design files: designs as TOML."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..disk import contents
from ..errors import FileError
from .design import Design, design_of
from .toml_bounds import table_problem, text_problem


def read_design(path: Path) -> Design:
    """The design in a TOML file; names of files in it are relative to it.

    Raises FileError where it is no TOML, with the line; ProblemsError where it names no element; MachineError.
    """
    design = design_of(toml_table(contents(path), str(path)), str(path))
    beside = {name: str(path.parent / value) for name, value in design.file_names.items()}
    return replace(design, values={**design.values, **beside})


def toml_table(data: bytes, where: str) -> dict[str, Any]:
    """The table that TOML in UTF-8 holds, within bounds that every design keeps.

    where   what a person knows it by, such as the file's path

    Raises FileError where it is none, with the line.
    """
    table = _parsed(data, where)
    if problem := table_problem(table):
        raise FileError(f"{where}: {problem}")
    return table


def _parsed(data: bytes, where: str) -> dict[str, Any]:
    try:
        text = data.decode("utf-8-sig")
        if problem := text_problem(text):
            raise FileError(f"{where}: {problem}")
        return tomllib.loads(text)
    except UnicodeDecodeError as error:
        broken = data.count(b"\n", 0, error.start) + 1
        raise FileError(f"{where}: line {broken}: this is no text in UTF-8, which a TOML file is") from None
    except tomllib.TOMLDecodeError as error:
        last = data.count(b"\n") + (not data.endswith(b"\n"))
        found = re.fullmatch(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", str(error), re.DOTALL)
        what, line, column = found.groups() if found else (str(error), None, None)
        at = f"line {line or last}" + (f", column {column}" if column else ", the last")
        raise FileError(f"{where}: {at}: this is no TOML: {what}") from None
    except RecursionError:
        raise FileError(f"{where}: lists or tables are nested more deeply than any design") from None
    except ValueError:
        raise FileError(f"{where}: a number or a date in it is none that a computer holds") from None
