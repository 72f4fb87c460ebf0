"""The unit of lengths in files whose format has no place for it: a note near the beginning of those written here."""

from __future__ import annotations

import re

from ..parameters import LENGTH_UNITS

_NOTED = re.compile(rf"Gearwright [^\n]{{0,40}}lengths in ({'|'.join(LENGTH_UNITS)})\b".encode())
_SEARCHED = 400  # bytes


def unit_note(form: str, length_unit: str | None) -> str:
    """The note: what the file is, and its unit where it is known."""
    return f"Gearwright {form}, lengths in {length_unit or 'an unknown unit'}"


def noted_unit(data: bytes) -> str | None:
    """The key of LENGTH_UNITS that the note in a file says; None where there is none."""
    found = _NOTED.search(data[:_SEARCHED])
    return found[1].decode() if found else None
