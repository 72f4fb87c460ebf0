"""Forms of values that are more than numbers or words: file names, lists of points and of numbers, tables."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from .declaration import Declaration
from .parameter import Form, did_you_mean, is_number
from .units import MOST, named


@dataclass(frozen=True, kw_only=True)
class FileName:
    """The name of a file. suffixes   of the kinds of file that are read, as a help page shows them"""

    suffixes: tuple[str, ...]
    keys: tuple[str, ...] = ()

    @property
    def word(self) -> str:
        return "FILE" + (self.suffixes[0] if len(self.suffixes) == 1 else "")

    @property
    def words(self) -> str:
        return f"the name of a file ({', '.join(self.suffixes)})"

    def fits(self, value: object) -> bool:
        return isinstance(value, str)

    def problem(self, value: object) -> str | None:
        return None if value else f"{self.words} is needed"


@dataclass(frozen=True, kw_only=True)
class Text:
    """Any words, such as the name of a layer. words   what they are"""

    words: str
    word: str = "NAME"
    keys: tuple[str, ...] = ()

    def fits(self, value: object) -> bool:
        return isinstance(value, str)

    def problem(self, value: object) -> str | None:
        return None if value else f"{self.words} is needed"


@dataclass(frozen=True, kw_only=True)
class Points:
    """A list of at least so many points, each a list of the named coordinates."""

    coordinates: tuple[str, ...]
    least: int
    word: str = ""
    keys: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        return f"points [[{', '.join(self.coordinates)}], …]"

    def fits(self, value: object) -> bool:
        return isinstance(value, list | tuple)

    def problem(self, value: object) -> str | None:
        if not isinstance(value, list | tuple) or len(value) < self.least:
            return f"at least {self.least} {self.words} are needed"
        for i, point in enumerate(value):
            right = isinstance(point, list | tuple) and len(point) == len(self.coordinates)
            if not right or not all(is_number(x) and math.isfinite(x) and abs(x) <= MOST for x in point):
                needed = f"{len(self.coordinates)} numbers {', '.join(self.coordinates)}"
                return f"{named(f'point {i}', point, '', '')}: {needed} of at most {MOST:g} are needed"
        return None


@dataclass(frozen=True, kw_only=True)
class Numbers:
    """A list of one number to so many."""

    most: int
    words: str = "a list of numbers"
    word: str = ""
    keys: tuple[str, ...] = ()

    def fits(self, value: object) -> bool:
        return isinstance(value, list | tuple)

    def problem(self, value: object) -> str | None:
        counted = isinstance(value, list | tuple) and 1 <= len(value) <= self.most
        good = counted and all(is_number(x) and math.isfinite(x) for x in value)  # type: ignore[attr-defined]
        return None if good else f"{self.words}, is needed: 1 to {self.most} finite numbers"


@dataclass(frozen=True, kw_only=True)
class Several:
    """A list, which may be empty, of values of one form."""

    of: Form
    word: str = ""
    keys: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        return f"a list, each of them {self.of.words}"

    def fits(self, value: object) -> bool:
        return isinstance(value, list | tuple)

    def problem(self, value: object) -> str | None:
        if not isinstance(value, list | tuple):
            return f"{self.words} is needed"
        problems = [(i, self.of.problem(one)) for i, one in enumerate(value)]
        return next((f"number {i + 1} of the list: {problem}" for i, problem in problems if problem), None)


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table of named entries, known from other tables by the name of its first if that is required."""

    entries: tuple[Declaration, ...]
    word: str = ""

    @property
    def words(self) -> str:
        return "a table {" + ", ".join(f"{entry.name} = …" for entry in self.entries) + "}"

    @property
    def keys(self) -> tuple[str, ...]:
        return (self.entries[0].name,) if self.entries[0].required else ()

    def fits(self, value: object) -> bool:
        return isinstance(value, Mapping) and all(key in value for key in self.keys)

    def problem(self, value: object) -> str | None:
        """All that is wrong with the entries, in one line."""
        if not isinstance(value, Mapping):
            return f"{self.words} is needed"
        known = {entry.name: entry for entry in self.entries}
        found = [
            f"{name}: there is no such entry, but {', '.join(known)}{did_you_mean(name, known)}"
            for name in value
            if name not in known
        ]
        for name, entry in known.items():
            if name in value:
                subject = named(name, value[name], entry.parameter.unit, "")
                found += [f"{subject}: {problem}" for problem in entry.problems(value[name])]
            elif entry.required:
                found.append(f"{name} is needed: {entry.parameter.meaning}")
        return "; ".join(found) or None
