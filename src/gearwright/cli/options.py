"""Options of the command line, derived from the declared parameters of elements."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any

from cyclopts import Group
from cyclopts import Parameter as Option

from ..designs.kinds import NOT_THIS_MEMBER, option_name
from ..parameters import Declaration, FileName, Parameter, in_words

_TOPICS = 3  # after what all elements have

NEEDED = Group("Needed", sort_key=1)
SHAPE = Group("Shape", sort_key=2)
OUTPUT = Group("Output", sort_key=5)

_METAVARS = {"length": "LENGTH", "angle": "DEG", "mm": "MM", "per inch": "PER-INCH", "": "NUMBER"}


@dataclass(frozen=True, kw_only=True)
class Offered:
    """A parameter that a command offers. only   the one kind of element that has it, "" if all have."""

    declaration: Declaration
    only: str


def offered(kinds: Mapping[str, Sequence[Declaration]]) -> dict[str, Offered]:
    """The parameters of several kinds of elements that can be typed, by name, as in the first kind that has each."""
    found: dict[str, Offered] = {}
    for name in dict.fromkeys(d.name for own in kinds.values() for d in own if d.parameter.typed):
        owners = {kind: d for kind, own in kinds.items() for d in own if d.name == name}
        first = next(iter(owners.values()))
        if len({d.members for d in owners.values()}) > 1:
            first = replace(first, members="both")
        found[name] = Offered(declaration=first, only="" if len(owners) == len(kinds) else next(iter(owners)))
    return found


def signature_parameters(parameters: Mapping[str, Offered]) -> list[inspect.Parameter]:
    """A keyword-only function parameter for each declaration, annotated for cyclopts.

    Options arrive as lists of words, None where not given; `given_values` reads them. What is
    missing or out of range is left to the element, which names all problems together.
    """
    return [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=_annotation(one))
        for name, one in parameters.items()
    ]


def given_values(parameters: Mapping[str, Offered], words: Mapping[str, Sequence[str] | None]) -> dict[str, Any]:
    """The values of the options that were given: one, or a tuple of several, by parameter name."""
    return {name: _value(parameters[name].declaration.parameter, given) for name, given in words.items() if given}


def _annotation(one: Offered) -> Any:
    declaration = one.declaration
    option = Option(
        name=option_name(declaration.name),
        group=_group(one),
        help=_help(declaration),
        metavar=_metavar(declaration),
        consume_multiple=(1, 2),
        negative_iterable=(),
        show_default=_default(declaration),
    )
    return Annotated[list[str] | None, option]


def _group(one: Offered) -> Group:
    if one.only:
        return Group(f"Of a {one.only} only", sort_key=4)
    if one.declaration.required:
        return NEEDED
    topic = one.declaration.parameter.topic
    return Group(topic, sort_key=_TOPICS) if topic else SHAPE


def _help(declaration: Declaration) -> str:
    parameter = declaration.parameter
    text = parameter.meaning.rstrip(".")
    if parameter.symbol:
        text += f", {parameter.symbol}"
    suffixes = [suffix for form in parameter.forms if isinstance(form, FileName) for suffix in form.suffixes]
    limits = ", ".join(_limits(parameter) or parameter.choices or suffixes)
    return text + (f" ({limits})" if limits else "")


def _limits(parameter: Parameter) -> list[str]:
    named = ((">", parameter.above), ("≥", parameter.minimum), ("≤", parameter.maximum), ("<", parameter.below))
    return [f"{sign} {limit:g}" for sign, limit in named if limit is not None]


def _metavar(declaration: Declaration) -> str:
    parameter = declaration.parameter
    if parameter.kind == "form":
        return next(form.word for form in parameter.forms if form.word)
    one = "WORD" if parameter.kind == "choice" else _METAVARS[parameter.unit]
    if parameter.components:
        return " ".join([one] * len(parameter.components))
    return {"one": one, "both": f"{one} [{one}]", "each": f"{one} {one}"}[declaration.members]


def _default(declaration: Declaration) -> str | bool:
    if declaration.required or declaration.default is None:
        return False
    parameter = declaration.parameter
    if parameter.kind == "choice":
        return str(declaration.default)
    if parameter.components:
        return " ".join(f"{one:g}" for one in declaration.default)
    return in_words(declaration.default, parameter.unit, "")


def _value(parameter: Parameter, words: Sequence[str]) -> Any:
    alone = len(words) == 1 or parameter.kind == "choice"
    values = [None if word == NOT_THIS_MEMBER and not alone else _one_value(parameter, word) for word in words]
    return values[0] if len(values) == 1 else tuple(values)


def _one_value(parameter: Parameter, word: str) -> Any:
    """A word as the number it stands for; words that stand for none stay, for the element to refuse."""
    if parameter.kind in ("choice", "form") or "_" in word:
        return word  # Python would read 1_0 as 10
    try:
        return int(word) if parameter.kind == "integer" else float(word)
    except ValueError:
        pass
    try:
        return float(word)
    except ValueError:
        return word
