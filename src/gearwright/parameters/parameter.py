"""What one parameter means, and which values it takes."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any, Literal, Protocol, TypeGuard

from .units import LEAST, MOST, Unit

Kind = Literal["number", "integer", "choice", "form"]


class Form(Protocol):
    """One of several ways to give a value that is more than a number or a word: a file name, points, a table.

    words   what a person gives, as in "a file name"
    word    what stands for it on a command line, such as "FILE"; "" where it cannot be typed as one word
    keys    the names by which a table of this form is known from others, none where any will do
    """

    @property
    def words(self) -> str: ...
    @property
    def word(self) -> str: ...
    @property
    def keys(self) -> tuple[str, ...]: ...
    def fits(self, value: object) -> bool:
        """Whether the value is meant to be of this form, sound or not."""

    def problem(self, value: object) -> str | None:
        """Why a value meant to be of this form is not accepted; None where it is."""


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """What one parameter means and which single values it takes.

    meaning     one line for help pages and forms
    unit        "length" (the element's length_unit), "angle" (degrees), "mm", "per inch" or "" (a number)
    symbol      the field's standard symbol
    above, minimum, maximum, below   limits, exclusive, inclusive, inclusive, exclusive
    components  names of the numbers that always make up one value, such as x and y; each is within the limits
    choices     the words accepted, for kind "choice"
    forms       the forms accepted, for kind "form"
    topic       under which help pages and forms list it, where a kind of element has many
    """

    meaning: str
    kind: Kind = "number"
    unit: Unit = ""
    symbol: str = ""
    above: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    below: float | None = None
    components: tuple[str, ...] = ()
    choices: tuple[str, ...] = ()
    forms: tuple[Form, ...] = ()
    topic: str = ""

    @property
    def typed(self) -> bool:
        """Whether a person can type it on a command line."""
        return self.kind != "form" or any(form.word for form in self.forms)

    @property
    def is_length(self) -> bool:
        return self.unit in ("length", "mm", "per inch")

    @property
    def is_signed(self) -> bool:
        """Whether a number may be negative as well as positive."""
        return self.above is None and self.minimum is None

    def problem(self, value: object) -> str | None:
        """Why this single value is not accepted; None where it is."""
        if self.kind == "choice":
            if value in self.choices:
                return None
            return f"choose one of {', '.join(self.choices)}{did_you_mean(value, self.choices)}"
        if self.kind == "form":
            return self._form_problem(value)
        if not is_number(value):
            kind = {"str": "text", "NoneType": "nothing", "int": "one so large", "dict": "a table"}.get(
                type(value).__name__, type(value).__name__
            )
            return f"a {'whole ' if self.kind == 'integer' else ''}number is needed, not {kind}"
        if not math.isfinite(value):
            return "a finite number is needed"
        if self.is_length and ((0 < value < LEAST and not self.is_signed) or abs(value) > MOST):
            return f"between {LEAST:g} and {MOST:g} is possible; is it in the right unit?"
        if self.kind == "integer" and not is_whole(value):
            return "a whole number is needed"
        return self._limit_problem(float(value))

    def computable(self, value: object) -> bool:
        """Whether formulas make sense of this value, though it may be beyond a limit."""
        if self.kind == "choice":
            return value in self.choices
        if self.kind == "form":
            return self.problem(value) is None
        if not is_number(value) or not math.isfinite(value):
            return False
        if abs(value) > MOST or (self.kind == "integer" and not is_whole(value)):
            return False
        from_nought = self.minimum is not None and self.minimum >= 0
        lowest = self.above if self.above is not None else 0.0 if from_nought else -math.inf
        counts = self.kind == "integer" and self.minimum != 0  # of something there must be one of
        inside = value > lowest if self.above is not None or counts else value >= lowest
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

    def _form_problem(self, value: object) -> str | None:
        for form in self.forms:
            if form.fits(value):
                return form.problem(value)
        known = [key for form in self.forms for key in form.keys]
        hints = [did_you_mean(key, known) for key in value] if isinstance(value, Mapping) else []
        return f"give {' or '.join(form.words for form in self.forms)}{next(filter(None, hints), '')}"


def did_you_mean(given: object, known: Iterable[str]) -> str:
    """What to add to a refusal of a name that nearly is a known one: "; did you mean length?"."""
    nearest = difflib.get_close_matches(given, list(known), n=1) if isinstance(given, str) else []
    return f"; did you mean {nearest[0]}?" if nearest else ""


def is_number(value: Any) -> TypeGuard[float]:
    """Whether a value is a real number, numpy's among them; True and False are not, nor what no float can hold."""
    if type(value) is bool or not isinstance(value, Real):
        return False
    try:
        float(value)
    except OverflowError:
        return False
    return True


def is_whole(value: object) -> bool:
    """Whether a number is of an integer type."""
    return isinstance(value, Integral)
