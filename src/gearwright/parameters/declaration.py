"""Parameters as fields of an element: declared once, listed for the edges."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields
from typing import Any, Literal

from .parameter import Parameter

Members = Literal["one", "both", "each"]

_KEY = "parameter"


def declared(
    parameter: Parameter,
    *,
    default: Any = MISSING,
    members: Members = "one",
    only: Mapping[str, Sequence[str]] | None = None,
) -> Any:
    """A dataclass field for a parameter.

    members   "one": a single value; "both": one value for both members of a pair or two, of which one may be None
              where None is the default;
              "each": always two values, pinion first
    only      the choices of other parameters with which alone this one applies, by their names; it has a default
    """
    return field(default=default, metadata={_KEY: parameter, "members": members, "only": only or {}})


@dataclass(frozen=True)
class Declaration:
    """One declared field of an element, or entry of a table, as edges need it."""

    name: str
    parameter: Parameter
    default: Any
    members: Members = "one"
    only: Mapping[str, Sequence[str]] = field(default_factory=dict)

    def inapplicable(self, choices: Mapping[str, Any]) -> str | None:
        """Why the parameter does not apply beside the choices of others, by name; None where it does."""
        for name, words in self.only.items():
            if name in choices and choices[name] not in words:
                return f"does not apply with {name} = {choices[name]!r}, but with {' or '.join(words)}; leave it out"
        return None

    @property
    def required(self) -> bool:
        return self.default is MISSING

    def miscounted(self, value: object) -> str | None:
        """Why there are too many or too few values; None where there are as many as there should be."""
        several = isinstance(value, tuple | list)
        components = self.parameter.components
        if self.parameter.kind == "form":
            return None
        if components:
            counted = isinstance(value, tuple | list) and len(value) == len(components)
            return None if counted else f"{len(components)} numbers are needed: {', '.join(components)}"
        if self.members == "one" and several:
            return "one value is needed"
        if self.members == "each" and not several:
            return "two values are needed, pinion first"
        if isinstance(value, tuple | list) and len(value) != 2:
            return "give one value for each of the two members, pinion first"
        return None

    def problems(self, value: object) -> list[str]:
        """Why what was given, or not given, is not accepted; none where it is."""
        if value is None and self.default is None:
            return []
        miscounted = self.miscounted(value)
        if miscounted:
            return [miscounted]
        values = self._values(value)
        found = sorted({problem for one in values if (problem := self.parameter.problem(one)) is not None})
        return [problem + (" each" if len(values) > 1 and problem.startswith("at ") else "") for problem in found]

    def computable(self, value: object) -> bool:
        """Whether formulas make sense of what was given, or not given."""
        if value is None:
            return self.default is None
        return self.miscounted(value) is None and all(self.parameter.computable(one) for one in self._values(value))

    def _values(self, value: object) -> tuple[object, ...]:
        """The single values that were given; one member of a pair may be left without one that is not needed."""
        if self.parameter.kind == "form" or not isinstance(value, tuple | list):
            return (value,)
        optional = self.members == "both" and self.default is None
        return tuple(one for one in value if not (optional and one is None))


def entry(name: str, parameter: Parameter, *, default: Any = MISSING) -> Declaration:
    """The declaration of an entry of a table."""
    return Declaration(name, parameter, default)


def declarations(element: type) -> tuple[Declaration, ...]:
    """The declared parameters of an element class, in order."""
    return tuple(
        Declaration(f.name, f.metadata[_KEY], f.default, f.metadata["members"], f.metadata["only"])
        for f in fields(element)
        if _KEY in f.metadata
    )


def member_value(value: Any, member: int) -> Any:
    """The value that belongs to one member (0 pinion, 1 gear) of a parameter given once or twice."""
    return value[member] if isinstance(value, tuple | list) else value
