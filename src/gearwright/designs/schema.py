"""What a design may hold, as JSON Schema (draft 2020-12)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .. import catalog
from ..parameters import MOST, Declaration, FileName, Form, Numbers, Parameter, Points, Several, Table, Text
from .design import ELEMENT
from .kinds import NOT_THIS_MEMBER, kinds_of, parameters_of

Schema = dict[str, Any]

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_UNITS = {"length": "length_unit", "angle": "deg", "mm": "mm", "per inch": "1/in"}
_NUMBER: Schema = {"type": "number"}


def design_schema(elements: Sequence[str]) -> Schema:
    """The schema of designs of the named elements."""
    kinds = [_kind(kind) for name in elements for kind in kinds_of(name)]
    if len(kinds) == 1:
        return {"$schema": _DIALECT, **kinds[0]}
    return {"$schema": _DIALECT, "title": "design of an element", "oneOf": kinds}


def _kind(kind: catalog.Element) -> Schema:
    entries = parameters_of(kind)
    table = _table(entries)
    return {
        "title": kind.name,
        "description": kind.summary,
        **table,
        "properties": {ELEMENT: {"const": kind.command}, **table["properties"]},
        "required": [ELEMENT, *table["required"]],
    }


def _table(entries: tuple[Declaration, ...]) -> Schema:
    return {
        "type": "object",
        "properties": {entry.name: _declaration(entry) for entry in entries},
        "required": [entry.name for entry in entries if entry.required],
        "additionalProperties": False,
    }


def _declaration(declaration: Declaration) -> Schema:
    parameter = declaration.parameter
    found: Schema = {"description": parameter.meaning + (f", {parameter.symbol}" if parameter.symbol else "")}
    if parameter.unit:
        found["x-unit"] = _UNITS[parameter.unit]
    if not declaration.required and declaration.default is not None:
        found["default"] = declaration.default
    one = _values(parameter)
    either = one if declaration.default is not None else {"anyOf": [one, {"const": NOT_THIS_MEMBER}]}
    items = either if declaration.members == "both" else one
    two = {"type": "array", "items": items, "minItems": 2, "maxItems": 2}
    return {"one": one, "each": two, "both": {"anyOf": [one, two]}}[declaration.members] | found


def _values(parameter: Parameter) -> Schema:
    match parameter.kind:
        case "choice":
            return {"enum": list(parameter.choices)}
        case "form":
            forms = [_form(form) for form in parameter.forms]
            return forms[0] if len(forms) == 1 else {"anyOf": forms}
    count = len(parameter.components)
    one = {"type": parameter.kind, **_limits(parameter)}
    return {"type": "array", "items": one, "minItems": count, "maxItems": count} if count else one


def _limits(parameter: Parameter) -> Schema:
    maximum = MOST if parameter.maximum is None and parameter.is_length else parameter.maximum
    named: Mapping[str, float | None] = {
        "exclusiveMinimum": parameter.above,
        "minimum": -MOST if parameter.is_length and parameter.is_signed else parameter.minimum,
        "maximum": maximum,
        "exclusiveMaximum": parameter.below,
    }
    return {name: limit for name, limit in named.items() if limit is not None}


def _form(form: Form) -> Schema:
    match form:
        case FileName():
            return {"type": "string", "minLength": 1, "description": form.words}
        case Text():
            return {"type": "string", "minLength": 1}
        case Points():
            count = len(form.coordinates)
            point = {
                "type": "array",
                "items": {"type": "number", "minimum": -MOST, "maximum": MOST},
                "minItems": count,
                "maxItems": count,
            }
            return {"type": "array", "items": point, "minItems": form.least, "description": form.words}
        case Numbers():
            return {"type": "array", "items": _NUMBER, "minItems": 1, "maxItems": form.most, "description": form.words}
        case Several():
            return {"type": "array", "items": _form(form.of)}
        case Table():
            return _table(form.entries)
        case _:
            raise TypeError(f"no schema is known for {form!r}")
