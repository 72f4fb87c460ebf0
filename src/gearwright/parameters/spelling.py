"""How what has declared parameters is spelled in Python."""

from __future__ import annotations

from dataclasses import MISSING, Field, fields
from typing import Any


def spelled(element: Any) -> str:
    """Its class with the parameters that differ from their defaults: "SpurGear(teeth=24, module=3, face_width=20)"."""
    given = [(field, getattr(element, field.name)) for field in fields(element) if field.init]
    said = ", ".join(f"{field.name}={value!r}" for field, value in given if not _is_default(field, value))
    return f"{type(element).__name__}({said})"


def _is_default(field: Field[Any], value: object) -> bool:
    if field.default is MISSING:
        return False
    return type(value) is type(field.default) and bool(value == field.default)
