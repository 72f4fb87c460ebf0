"""Which kind of element is meant by an element's name and values, and that element."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .. import catalog
from ..errors import ParameterError, Problem
from ..parameters import Declaration, declarations, from_mapping

NOT_THIS_MEMBER = "none"
"""Stands for the value of the member of a pair that is to have none."""


def option_name(name: str) -> str:
    """The option of a parameter, as it is typed: "--face-width"."""
    return "--" + name.replace("_", "-")


def commands() -> list[str]:
    """The names that elements are built by, in the catalog's order."""
    return list(dict.fromkeys(kind.command for kind in catalog.ELEMENTS))


def teeth_given(kind: catalog.Element, name_of: Callable[[str], str]) -> str:
    """What chooses a kind among those of one command; name_of gives what the user knows a parameter by."""
    return f"{name_of('teeth')} with {'one number' if kind.members == 1 else 'two numbers'}"


def kinds_of(command: str) -> list[catalog.Element]:
    """The catalog's elements that a command builds, pairs first."""
    return sorted((kind for kind in catalog.ELEMENTS if kind.command == command), key=lambda kind: -kind.members)


def parameters_of(kind: catalog.Element) -> tuple[Declaration, ...]:
    """The parameters that are left for a person to give, once the command has settled some."""
    return tuple(
        d
        for d in declarations(catalog.load(kind.source))
        if d.name not in kind.settled and d.inapplicable(kind.settled) is None
    )


def parameter_names(kind: catalog.Element) -> set[str]:
    """The names of the parameters of a kind."""
    return {d.name for d in parameters_of(kind)}


def chosen(kinds: Sequence[catalog.Element], teeth: object) -> catalog.Element:
    """The single part where one number of teeth is given, the pair where there are two (or none)."""
    given = (1, 2) if teeth is None else teeth
    members = len(given) if isinstance(given, list | tuple) else 1
    return next((kind for kind in kinds if kind.members == members), kinds[0])


def said(kind: catalog.Element, kinds: Sequence[catalog.Element], name_of: Callable[[str], str]) -> str:
    """A kind in words, with what chooses it where there are several."""
    return f"{kind.name} ({teeth_given(kind, name_of)})" if len(kinds) > 1 else kind.name


def article(words: str) -> str:
    """ "a" or "an", as the words need it."""
    return "an" if words[:1] in "aeiou" else "a"


def element_of(
    kind: catalog.Element, kinds: Sequence[catalog.Element], values: Mapping[str, Any], name_of: Callable[[str], str]
) -> tuple[Any, list[Problem]]:
    """The element of a kind, None where it cannot be built, and what is wrong with the values.

    name_of   what the user knows a parameter by, where another kind has it that is not built
    """
    own = parameter_names(kind)
    others = {name: other for other in kinds if other != kind for name in parameter_names(other) - own}
    problems = [
        Problem(name, f"applies to {article(others[name].name)} {said(others[name], kinds, name_of)}")
        for name in values
        if name in others
    ]
    problems += [
        Problem(f"{name} = {values[name]!r}", f"the element's name, {kind.command}, says so already; leave it out")
        for name in kind.settled
        if name in values
    ]
    own_values = {name: value for name, value in values.items() if name not in others}
    try:
        element = from_mapping(catalog.load(kind.source), {**own_values, **kind.settled})
    except ParameterError as error:
        return None, [*problems, *error.problems]
    return element, problems
