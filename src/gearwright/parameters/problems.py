"""What is wrong with an element's parameters, collected and raised all together."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Mapping
from typing import Any, TypeVar

from ..errors import ParameterError, Problem, ProblemsError
from .declaration import declarations
from .parameter import did_you_mean, is_number, is_whole
from .units import named

T = TypeVar("T")


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
            value = _plain(getattr(element, declaration.name))
            object.__setattr__(element, declaration.name, value)
            for problem in declaration.problems(value):
                self.add(declaration.name, problem)
        self._add_inapplicable()

    def _add_inapplicable(self) -> None:
        """Adds parameters that were given but do not apply beside what others were given as."""
        choices = {name: getattr(self._element, name) for name in self._declared}
        for name, declaration in self._declared.items():
            reason = declaration.inapplicable(choices) if choices[name] != declaration.default else None
            if reason:
                self.add(name, reason)

    def add(self, name: str, message: str) -> None:
        """Adds a problem of the named parameter, shown with its value and unit."""
        unit = getattr(self._element, "length_unit", "mm")
        parameter = self._declared[name].parameter
        subject = named(name, getattr(self._element, name), parameter.unit, str(unit))
        self._found.append(Problem(subject, message))
        self._names.add(name)

    def add_of(self, name: str, error: ProblemsError) -> None:
        """Adds what was found wrong with the thing that the named parameter gives; of several, under their headline."""
        if len(error.problems) > 1:
            self._found.append(Problem(name, f"{error.headline}:"))
        start = f"{name}: " if len(error.problems) == 1 else "  "
        self._found += [Problem(start + problem.subject, problem.message) for problem in error.problems]
        self._names.add(name)

    def add_members(
        self,
        members: Mapping[str, Callable[[], object]],
        settled: Collection[str] = (),
        said_here: Mapping[str, Mapping[str, str]] | None = None,
    ) -> None:
        """Builds members of the element and adds their problems, once where they share them.

        Problems of parameters that are already named here are left out, and so are `settled` ones, which
        the element itself sets from a parameter of its own.

        said_here   by a member's parameter that the element does not have: the one it follows from, for each member
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
            if name in known:
                continue
            prefix = "" if len(owners) == len(members) else f"{owners[0]} "
            own = (said_here or {}).get(name, {}).get(owners[0])
            if own is None:
                self._found.append(Problem(prefix + problem.subject, problem.message))
            elif own not in self._names:
                self.add(own, f"it makes {prefix}{problem.subject.replace('_', ' ')}: {problem.message}")
            self._names.add(name)

    def computable(self, *names: str) -> bool:
        """Whether the named parameters, as far as given, are finite numbers of the right sign or known words.

        Limits may still be exceeded; what follows from the values can be computed and checked.
        """
        return all(self._declared[name].computable(getattr(self._element, name)) for name in names)

    def has(self, name: str) -> bool:
        """Whether the element declares a parameter of this name."""
        return name in self._declared

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
    """Builds an element from names and values, naming the unknown, the missing and the wrong together.

    Raises ParameterError.
    """
    known = {d.name: d for d in declarations(element)}
    own = {name: _plain(value) for name, value in values.items() if name in known}
    found = [
        Problem(
            named(name, value, "", ""),
            f"there is no such parameter{did_you_mean(name, known) or '; `gearwright schema` lists all'}",
        )
        for name, value in values.items()
        if name not in known
    ]
    missing = {d.name: None for d in known.values() if d.required and d.name not in own}
    found += [Problem(name, f"is needed: {known[name].parameter.meaning}") for name in missing]
    try:
        built = element(**own, **missing)
    except ParameterError as error:
        others = [problem for problem in error.problems if problem.subject not in missing]
        raise ParameterError(element.__name__, [*found, *others]) from None
    if found:
        raise ParameterError(element.__name__, found)
    return built


def _plain(value: object) -> object:
    """A value made of Python's own numbers, tuples, tables and texts."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {name: _plain(one) for name, one in value.items()}
    if isinstance(value, tuple | list):
        return tuple(_plain(one) for one in value)
    if not is_number(value):
        return value
    return int(value) if is_whole(value) else float(value)
