"""Parameters of elements: declared once, checked here; options, schema and forms are derived from them.

An element is a frozen keyword-only dataclass whose fields are made by `declared`. Nothing here
imports numpy, so that an edge can list every option without loading a kernel.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import MISSING, dataclass, field, fields
from numbers import Integral, Real
from typing import Any, Literal, TypeGuard, TypeVar

from .errors import ParameterError, Problem

Unit = Literal["length", "angle", "mm", "per inch", ""]
Kind = Literal["number", "integer", "choice"]
T = TypeVar("T")

MILLIMETRES = {"mm": 1.0, "in": 25.4}
"""Length units a person may choose, in millimetres."""

_KEY = "parameter"
_LEAST, _MOST = 1e-12, 1e12  # lengths, whose fifth powers must stay numbers


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """What one parameter means and which single values it takes.

    meaning     one line for help pages and forms
    unit        "length" (the element's length_unit), "angle" (degrees), "mm", "per inch" or "" (a number)
    symbol      the field's standard symbol
    above, minimum, maximum, below   limits, exclusive, inclusive, inclusive, exclusive
    choices     the words accepted, for kind "choice"
    """

    meaning: str
    kind: Kind = "number"
    unit: Unit = ""
    symbol: str = ""
    above: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    below: float | None = None
    choices: tuple[str, ...] = ()

    def problem(self, value: object) -> str | None:
        """Why this single value is not accepted; None where it is."""
        if self.kind == "choice":
            return None if value in self.choices else f"choose one of {', '.join(self.choices)}"
        if not _is_number(value):
            kind = {"str": "text", "NoneType": "nothing", "int": "one so large"}.get(
                type(value).__name__, type(value).__name__
            )
            return f"a {'whole ' if self.kind == 'integer' else ''}number is needed, not {kind}"
        if not math.isfinite(value):
            return "a finite number is needed"
        if self.unit in ("length", "mm", "per inch") and value > 0 and not _LEAST <= value <= _MOST:
            return f"between {_LEAST:g} and {_MOST:g} is possible; is it in the right unit?"
        if self.kind == "integer" and not _is_whole(value):
            return "a whole number is needed"
        return self._limit_problem(float(value))

    def computable(self, value: object) -> bool:
        """Whether formulas make sense of this value, though it may be beyond a limit."""
        if self.kind == "choice":
            return value in self.choices
        if not _is_number(value) or not math.isfinite(value):
            return False
        if self.unit in ("length", "mm", "per inch") and value > _MOST:
            return False
        lowest = self.above if self.above is not None else 0.0 if self.minimum is not None else -math.inf
        inside = value > lowest if self.above is not None or self.kind == "integer" else value >= lowest
        return inside and (self.unit != "angle" or self._limit_problem(float(value)) is None)

    def _limit_problem(self, value: float) -> str | None:
        if self.above is not None and not value > self.above:
            return f"must be greater than {self.above:g}"
        if self.minimum is not None and not value >= self.minimum:
            return f"at least {self.minimum:g}"
        if self.maximum is not None and not value <= self.maximum:
            return f"at most {self.maximum:g}"
        if self.below is not None and not value < self.below:
            return f"must be less than {self.below:g}"
        return None


def declared(
    parameter: Parameter,
    *,
    default: Any = MISSING,
    members: Literal["one", "both", "each"] = "one",
) -> Any:
    """A dataclass field for a parameter.

    members   "one": a single value; "both": one value for both members of a pair or two;
              "each": always two values, pinion first
    """
    return field(default=default, metadata={_KEY: parameter, "members": members})


@dataclass(frozen=True)
class Declaration:
    """One declared field of an element, as edges need it."""

    name: str
    parameter: Parameter
    default: Any
    members: Literal["one", "both", "each"]

    @property
    def required(self) -> bool:
        return self.default is MISSING

    def miscounted(self, value: object) -> str | None:
        """Why there are too many or too few values; None where there are as many as there should be."""
        several = isinstance(value, tuple | list)
        if self.members == "one" and several:
            return "one value is needed"
        if self.members == "each" and not several:
            return "two values are needed, pinion first"
        if isinstance(value, tuple | list) and len(value) != 2:
            return "give one value for each of the two members, pinion first"
        return None

    def computable(self, value: object) -> bool:
        """Whether formulas make sense of what was given, or not given."""
        if value is None:
            return self.default is None
        return self.miscounted(value) is None and all(self.parameter.computable(one) for one in _several(value))


def declarations(element: type) -> tuple[Declaration, ...]:
    """The declared parameters of an element class, in order."""
    return tuple(
        Declaration(f.name, f.metadata[_KEY], f.default, f.metadata["members"])
        for f in fields(element)
        if _KEY in f.metadata
    )


def rounded_down(value: float) -> str:
    """A limit to four digits, never above it, so that what is followed is accepted."""
    if value <= 0.0 or not math.isfinite(value):
        return f"{value:.4g}"
    step = 10.0 ** (math.floor(math.log10(value)) - 3)
    return f"{math.floor(value / step) * step:.4g}"


def in_words(value: object, unit: Unit, length_unit: str) -> str:
    """A value as a person reads it, with its unit: "90 mm", "(16, 2)", "35°"."""
    if isinstance(value, tuple | list):
        return "(" + ", ".join(in_words(one, unit, length_unit) for one in value) + ")"
    text = f"{value:.6g}" if isinstance(value, float) and unit else str(value)
    suffix = {"length": f" {length_unit}", "angle": "°", "mm": " mm", "per inch": " /in", "": ""}[unit]
    return text + suffix if isinstance(value, Real) else repr(value)


class Problems:
    """Collects what is wrong with one element's parameters, to raise it all together.

    First it makes the element's values plain: lists become tuples, numpy's numbers become Python's, whose
    arithmetic is always in double precision.
    """

    def __init__(self, element: Any):
        self._element = element
        self._declared = {d.name: d for d in declarations(type(element))}
        self._found: list[Problem] = []
        self._names: set[str] = set()
        for declaration in self._declared.values():
            object.__setattr__(element, declaration.name, _plain(getattr(element, declaration.name)))
            self._check_values(declaration)

    def _check_values(self, declaration: Declaration) -> None:
        value = getattr(self._element, declaration.name)
        if value is None and declaration.default is None:
            return
        miscounted = declaration.miscounted(value)
        if miscounted:
            self.add(declaration.name, miscounted)
            return
        values = _several(value)
        problems = {declaration.parameter.problem(one) for one in values}
        for problem in sorted(p for p in problems if p is not None):
            self.add(declaration.name, problem + (" each" if len(values) > 1 and problem.startswith("at ") else ""))

    def add(self, name: str, message: str) -> None:
        """Adds a problem of the named parameter, shown with its value and unit."""
        declaration = self._declared[name]
        unit = getattr(self._element, "length_unit", "mm")
        value = getattr(self._element, name)
        subject = name if value is None else f"{name} = {in_words(value, declaration.parameter.unit, str(unit))}"
        self._found.append(Problem(subject, message))
        self._names.add(name)

    def add_members(self, members: Mapping[str, Callable[[], object]], settled: Collection[str] = ()) -> None:
        """Builds members of the element and adds their problems, once where they share them.

        Problems of parameters that are already named here are left out, and so are `settled` ones, which
        the element itself sets from a parameter of its own.
        """
        known = {*self._names, *settled}
        found: dict[Problem, list[str]] = {}
        for member, build in members.items():
            try:
                build()
            except ParameterError as error:
                for problem in error.problems:
                    found.setdefault(problem, []).append(member)
        for problem, owners in found.items():
            name = problem.subject.split(" = ")[0]
            if name not in known:
                prefix = "" if len(owners) == len(members) else f"{owners[0]} "
                self._found.append(Problem(prefix + problem.subject, problem.message))
                self._names.add(name)

    def computable(self, *names: str) -> bool:
        """Whether the named parameters, as far as given, are finite numbers of the right sign or known words.

        Limits may still be exceeded; what follows from the values can be computed and checked.
        """
        return all(self._declared[name].computable(getattr(self._element, name)) for name in names)

    def counted(self) -> bool:
        """Whether every parameter has as many values as it should."""
        return not any(d.miscounted(getattr(self._element, name)) for name, d in self._declared.items())

    def sound(self, *names: str) -> bool:
        """Whether none of the named parameters (all, if none is named) has a problem yet."""
        return not (self._names & set(names) if names else self._names)

    def raise_any(self) -> None:
        """Raises ParameterError if there is any problem."""
        if self._found:
            raise ParameterError(type(self._element).__name__, self._found)


def from_mapping(element: type[T], values: Mapping[str, Any]) -> T:
    """Builds an element from names and values, refusing unknown and missing names together.

    Raises ParameterError.
    """
    known = {d.name: d for d in declarations(element)}
    found = [
        Problem(f"{name} = {value!r}", f"{element.__name__} has no such parameter; it has {', '.join(known)}")
        for name, value in values.items()
        if name not in known
    ]
    found += [
        Problem(d.name, f"is needed: {d.parameter.meaning}")
        for d in known.values()
        if d.required and d.name not in values
    ]
    if found:
        raise ParameterError(element.__name__, found)
    return element(**{name: tuple(v) if isinstance(v, list) else v for name, v in values.items()})


def _is_number(value: Any) -> TypeGuard[float]:
    """Whether a value is a real number, numpy's among them; True and False are not, nor what no float can hold."""
    if type(value) is bool or not isinstance(value, Real):
        return False
    try:
        float(value)
    except OverflowError:
        return False
    return True


def _plain(value: object) -> object:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, tuple | list):
        return tuple(_plain(one) for one in value)
    if not _is_number(value):
        return value
    return int(value) if _is_whole(value) else float(value)


def _is_whole(value: object) -> bool:
    return isinstance(value, Integral)


def _several(value: object) -> tuple[object, ...]:
    return tuple(value) if isinstance(value, tuple | list) else (value,)


def member_value(value: Any, member: int) -> Any:
    """The value that belongs to one member (0 pinion, 1 gear) of a parameter given once or twice."""
    return value[member] if isinstance(value, tuple | list) else value


@dataclass(frozen=True)
class Size:
    """A derived size: its value (degrees where an angle), unit and the field's symbol."""

    value: float
    unit: Unit
    symbol: str
    meaning: str
