"""A design as texts that give it again: a TOML file, Python, a command line."""

from __future__ import annotations

import math
import shlex
from collections.abc import Mapping
from pathlib import PurePath
from typing import Any

from ..parameters import Declaration, call
from .design import ELEMENT, Design
from .kinds import NOT_THIS_MEMBER, option_name, parameters_of
from .toml_text import toml_text
from .uploaded import UPLOADED

FILE = "design.toml"
"""The file that the command names where a design cannot be typed."""

_COLUMNS = 88


def texts(design: Design, density: float | None = None, material: str | None = None) -> dict[str, str]:
    """{"toml": …, "python": …, "command": …}: only what differs from the defaults; uploaded files by their names.

    density, material   what the command weighs with, kg/m³ or a name; one of them at most
    """
    files = {name: _file_name(value) for name, value in design.file_names.items()}
    given = {name: files.get(name, value) for name, value in _differing(design).items()}
    return {
        "toml": toml_text({ELEMENT: design.kind.command, **given}),
        "python": _python(design, given),
        "command": shlex.join([*_command(design, given), *_weighing(density, material)]),
    }


def _differing(design: Design) -> dict[str, Any]:
    """The values that are not the default of their parameter, in the order in which parameters are declared."""
    declared = {d.name: d for d in parameters_of(design.kind)}
    order = [name for name in declared if name in design.values]
    order += [name for name in design.values if name not in declared]
    return {
        name: design.values[name]
        for name in order
        if name not in declared or not _is_default(declared[name], design.values[name])
    }


def _is_default(declaration: Declaration, value: Any) -> bool:
    if declaration.required or isinstance(value, bool):
        return value is None
    return bool(_plain(value) == declaration.default)


def _plain(value: Any) -> Any:
    return tuple(map(_plain, value)) if isinstance(value, list | tuple) else value


def _file_name(value: str) -> str:
    """A file's name as whoever has it knows it: of an upload, or a file of this machine, the last part alone."""
    return PurePath(value).name if value.startswith(UPLOADED) or PurePath(value).is_absolute() else value


def _python(design: Design, given: Mapping[str, Any]) -> str:
    name = design.kind.source.rpartition(":")[2]
    named = {**design.kind.settled, **given}
    arguments = {key: _Literal(value) for key, value in named.items() if key.isidentifier()}
    variable = "pair" if design.kind.members == 2 else "part"
    return f"import gearwright as gw\n\n{variable} = {call(f'gw.{name}', arguments, _COLUMNS)}\n"


class _Literal:
    """A value whose repr is Python that gives it, with lists as tuples."""

    def __init__(self, value: Any):
        self._value = value

    def __repr__(self) -> str:
        return _literal(self._value)


def _literal(value: Any) -> str:
    match value:
        case list() | tuple():
            inside = ", ".join(map(_literal, value))
            return f"({inside},)" if len(value) == 1 else f"({inside})"
        case Mapping():
            return "{" + ", ".join(f"{_literal(key)}: {_literal(one)}" for key, one in value.items()) + "}"
        case float() if not math.isfinite(value):
            return f"float({str(value)!r})"
        case str():
            return _quoted(value)
        case _:
            return repr(value)


def _quoted(text: str) -> str:
    """As repr, but in double quotes where both do."""
    plain = repr(text)
    return plain if '"' in text or plain.startswith('"') else f'"{plain[1:-1]}"'


def _weighing(density: float | None, material: str | None) -> list[str]:
    options = {"density": None if density is None else _word(density, whole=False), "material": material}
    return [word for name, value in options.items() if value is not None for word in (option_name(name), value)]


def _command(design: Design, given: Mapping[str, Any]) -> list[str]:
    declared = {d.name: d for kind in design.kinds for d in parameters_of(kind)}
    words = ["gearwright", design.kind.command]
    for name, value in given.items():
        said = _words(declared[name], value) if name in declared else None
        if said is None:
            return ["gearwright", "build", FILE]
        words += [option_name(name), *said]
    return words


def _words(declaration: Declaration, value: Any) -> list[str] | None:
    """What is typed after the option; None where that cannot be."""
    parameter = declaration.parameter
    several = isinstance(value, list | tuple)
    if value is None or not parameter.typed or (parameter.kind == "form" and not isinstance(value, str)):
        return None
    if several and (not 1 <= len(value) <= 2 or (parameter.kind == "choice" and None in value)):
        return None
    found = [_word(one, whole=parameter.kind == "integer") for one in (value if several else [value])]
    return [word for word in found if word is not None] if None not in found else None


def _word(value: Any, *, whole: bool) -> str | None:
    """A single value as one word; None where there is none that is read as that value, and as no option."""
    match value:
        case None:
            return NOT_THIS_MEMBER
        case bool():
            return None
        case int():
            return str(value)
        case float():
            return repr(value) if whole or not value.is_integer() else repr(value).removesuffix(".0")
        case str() if value and not value.startswith("-"):
            return value
        case _:
            return None
