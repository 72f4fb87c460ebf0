"""How what has declared parameters is spelled in Python."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, Field, fields
from typing import Any


def spelled(element: Any) -> str:
    """Its class with the parameters that differ from their defaults: "SpurGear(teeth=24, module=3, face_width=20)"."""
    given = [(field, getattr(element, field.name)) for field in fields(element) if field.init]
    return call(type(element).__name__, {field.name: value for field, value in given if not _is_default(field, value)})


def call(name: str, arguments: Mapping[str, Any], most: int | None = None) -> str:
    """A call with named arguments in one line, or with an argument a line where that is longer than so many columns."""
    said = [f"{argument}={value!r}" for argument, value in arguments.items()]
    line = f"{name}({', '.join(said)})"
    if most is None or len(line) <= most:
        return line
    return f"{name}(\n" + "".join(f"    {one},\n" for one in said) + ")"


def _is_default(field: Field[Any], value: object) -> bool:
    if field.default is MISSING:
        return False
    return type(value) is type(field.default) and bool(value == field.default)
