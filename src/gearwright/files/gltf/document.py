"""Values of a JSON document that know where they stand, so that refusals can say it."""

from __future__ import annotations

import json
import math
from typing import Any, NoReturn, final

from ...errors import FileError

_LONGEST = 200  # characters of a text that are kept
_MOST = 2**53  # what any JSON reader has exactly
_DEEPEST = "nested too deeply to be read"


@final
class Value:
    """A JSON value and its place, such as `accessors[3].count`."""

    def __init__(self, given: Any, file: str, place: str = ""):
        self._given, self._file, self.place = given, file, place

    def __contains__(self, key: str) -> bool:
        return isinstance(self._given, dict) and key in self._given

    def error(self, text: str) -> FileError:
        """A refusal that says where."""
        return FileError(f"{self._file}: {self.place or 'the document'}: {text}")

    def member(self, key: str) -> Value:
        """A member of an object; an empty one where it is not there."""
        found = self._object().get(key, {})
        return Value(found, self._file, f"{self.place}.{key}".lstrip("."))

    def items(self, key: str) -> list[Value]:
        """The items of a list that is a member; none where it is not there."""
        place = f"{self.place}.{key}".lstrip(".")
        found = self._object().get(key, [])
        if not isinstance(found, list):
            raise Value(found, self._file, place).error(f"a list is needed, not {_shown(found)}")
        return [Value(one, self._file, f"{place}[{number}]") for number, one in enumerate(found)]

    def text(self, key: str, default: str = "") -> str:
        found = self._object().get(key, default)
        return found if isinstance(found, str) else self._refuse(key, "a text", found)

    def name(self) -> str:
        """Its `name`, cut to a length that a table can show."""
        return self.text("name")[:_LONGEST]

    def whole(self, key: str, default: int | None = None, *, least: int = 0, most: int = _MOST) -> int:
        """A whole number from least to most that is a member; without a default it must be there."""
        found = self._object().get(key, default)
        if isinstance(found, float) and found.is_integer():
            found = int(found)
        if not isinstance(found, int) or isinstance(found, bool) or not least <= found <= most:
            to_most = f" to {most}" if most < _MOST else ""
            return self._refuse(key, f"a whole number from {least}{to_most}", found)
        return found

    def flag(self, key: str) -> bool:
        found = self._object().get(key, False)
        return found if isinstance(found, bool) else self._refuse(key, "true or false", found)

    def numbers(self, key: str, default: list[float]) -> list[float]:
        """As many finite numbers as the default has."""
        found = self._object().get(key, default)
        whole = isinstance(found, list) and len(found) == len(default) and all(map(_is_finite, found))
        return [float(one) for one in found] if whole else self._refuse(key, f"{len(default)} numbers", found)

    def index(self) -> int:
        """This value itself, a whole number from 0."""
        if not isinstance(self._given, int) or isinstance(self._given, bool) or self._given < 0:
            raise self.error(f"a whole number from 0 is needed, not {_shown(self._given)}")
        return self._given

    def words(self, key: str) -> list[str]:
        """Texts of a list that is a member."""
        return [one.word() for one in self.items(key)]

    def word(self) -> str:
        """This value itself, a text."""
        if not isinstance(self._given, str):
            raise self.error(f"a text is needed, not {_shown(self._given)}")
        return self._given

    def _object(self) -> dict[str, Any]:
        if not isinstance(self._given, dict):
            raise self.error(f"an object is needed, not {_shown(self._given)}")
        return self._given

    def _refuse(self, key: str, wanted: str, found: Any) -> NoReturn:
        place = f"{self.place}.{key}".lstrip(".")
        what = "it is missing" if found is None else f"not {_shown(found)}"
        raise Value(found, self._file, place).error(f"needs {wanted}, {what}; write the file again")


def document(data: bytes, file: str) -> Value:
    """The JSON object in data. Raises FileError where it is none."""
    try:
        given = json.loads(data.decode("utf-8-sig"), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        reason = _DEEPEST if isinstance(error, RecursionError) else str(error)
        raise FileError(
            f"{file}: not a glTF file: neither binary glTF nor JSON text ({reason}); it is cut off or of"
            " another kind; write or copy it again"
        ) from None
    if not isinstance(given, dict):
        raise FileError(f"{file}: not a glTF file: its JSON is {_shown(given)}, not an object")
    return Value(given, file)


def _refuse_constant(word: str) -> NoReturn:
    raise ValueError(f"{word} is no JSON number")


def _is_finite(one: object) -> bool:
    try:
        return isinstance(one, int | float) and not isinstance(one, bool) and math.isfinite(float(one))
    except OverflowError:
        return False


def _shown(found: object) -> str:
    try:
        return repr(found)[:60]
    except (ValueError, RecursionError):  # whole numbers of thousands of digits
        return f"a {type(found).__name__}"
