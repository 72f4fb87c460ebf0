"""A design: an element of the catalog and the values of its parameters, by names as a file or a request gives them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .. import catalog
from ..errors import Problem, ProblemsError
from ..parameters import FileName, did_you_mean
from .kinds import NOT_THIS_MEMBER, chosen, commands, element_of, kinds_of, parameters_of

ELEMENT = "element"
"""The key that names the element; all others are parameters."""


@dataclass(frozen=True, kw_only=True)
class Design:
    """What is asked for. kinds   those the element's name stands for, kind the one that is meant"""

    kind: catalog.Element
    kinds: tuple[catalog.Element, ...]
    values: Mapping[str, Any]

    @property
    def file_names(self) -> dict[str, str]:
        """The parameters that name a file, with that name."""
        files = (d.name for d in parameters_of(self.kind) if any(isinstance(f, FileName) for f in d.parameter.forms))
        return {name: value for name in files if isinstance(value := self.values.get(name), str) and value}

    def element(self) -> tuple[Any, list[Problem]]:
        """The element, None where it cannot be built, and what is wrong with the values."""
        return element_of(self.kind, self.kinds, self.values, str)


def design_of(table: Mapping[str, Any], where: str = "This design") -> Design:
    """The design that a table of names and values describes. Raises ProblemsError where it names no element."""
    known = commands()
    name = table.get(ELEMENT)
    if name not in known:
        subject = f"{ELEMENT} = {name!r}" if ELEMENT in table else ELEMENT
        hint = did_you_mean(name, known) if ELEMENT in table else f' at the top, such as {ELEMENT} = "{known[0]}"'
        problem = Problem(subject, f"one of {', '.join(known)} is needed{hint}")
        raise ProblemsError(f"{where}: this names no element", [problem, *_misnamed(table)])
    kinds = tuple(kinds_of(name))
    kind = chosen(kinds, table.get("teeth"))
    values = {key: _with_gaps(value) for key, value in table.items() if key != ELEMENT}
    return Design(kind=kind, kinds=kinds, values=values)


def _with_gaps(value: Any) -> Any:
    """A value for each member of a pair, with nothing where it says so: TOML has no word of its own for that."""
    if not isinstance(value, list) or NOT_THIS_MEMBER not in value:
        return value
    return [None if one == NOT_THIS_MEMBER else one for one in value]


def _misnamed(table: Mapping[str, Any]) -> list[Problem]:
    """Keys that nearly are the one that names the element."""
    return [
        Problem(key, f"there is no such key{hint}")
        for key in table
        if (hint := did_you_mean(key, [ELEMENT])) and key != ELEMENT
    ]
