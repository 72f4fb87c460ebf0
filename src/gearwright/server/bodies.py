"""What requests hold: one table for the checks and for the OpenAPI document."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..designs.file_problems import PAPERS, STEP_SCHEMAS, WHATS
from ..parameters import did_you_mean
from .refusals import told

_TYPES: Mapping[str, tuple[type, ...]] = {
    "object": (dict,),
    "string": (str,),
    "number": (int, float),
    "integer": (int,),
    "boolean": (bool,),
    "array": (list,),
    "null": (type(None),),
}


@dataclass(frozen=True, kw_only=True)
class Field:
    """An entry of a body.

    types     of JSON
    choices   the texts accepted, any where there are none
    items     types of what a list holds, any where there are none
    """

    types: tuple[str, ...]
    words: str
    choices: tuple[str, ...] = ()
    items: tuple[str, ...] = ()
    required: bool = False

    @property
    def schema(self) -> dict[str, Any]:
        """As JSON Schema."""
        one: dict[str, Any] = {"type": self.types[0] if len(self.types) == 1 else list(self.types)}
        if self.choices:
            one["enum"] = [*self.choices, *([None] if "null" in self.types else [])]
        if self.types == ("object",):
            one = {"$ref": "#/components/schemas/Design"}
        return {**one, "description": self.words}

    def problem(self, value: object) -> str | None:
        """Why a value is not accepted; None where it is."""
        if not _fits(value, self.types):
            return f"{' or '.join(self.types)} is needed: {self.words}"
        if self.items and isinstance(value, list) and not all(_fits(one, self.items) for one in value):
            return f"each of {self.words} is {' or '.join(self.items)}"
        if self.choices and isinstance(value, str) and value not in self.choices:
            return f"choose one of {', '.join(self.choices)}{did_you_mean(value, self.choices)}"
        return None


def _fits(value: object, types: tuple[str, ...]) -> bool:
    """Whether a value is of one of these types; True and False are no numbers."""
    fitting = any(isinstance(value, _TYPES[one]) for one in types)
    return fitting and ("boolean" in types or not isinstance(value, bool))


_DESIGN = Field(types=("object",), words="a design, by the keys of design files", required=True)
_DENSITY = Field(types=("number", "null"), words="density in kg/m³")
_MATERIAL = Field(types=("string", "null"), words="the name of a material in place of a density")

READ = {"toml": Field(types=("string",), words="the text of a design file", required=True)}
TEXTS = {"design": _DESIGN}
BUILD = {"design": _DESIGN, "density": _DENSITY, "material": _MATERIAL}
PLOTS = {"design": _DESIGN, "plot": Field(types=("string",), words="the name of a plot of its kind", required=True)}
FILES = {
    **BUILD,
    "suffix": Field(types=("string",), words="suffix of the file, with the dot", required=True),
    "what": Field(types=("string",), words="what the file shows of the design", choices=WHATS, required=True),
    "tolerance": Field(types=("number", "null"), words="how far written faces may lie from the part's (length)"),
    "clearance": Field(types=("number", "null"), words="gap between printed surfaces that would touch (length)"),
    "placed": Field(types=("boolean",), words="of members apart: each where it meshes"),
    "separate": Field(types=("boolean",), words="one file a member, in a zip"),
    "step_schema": Field(types=("string", "null"), words="schema of STEP files", choices=STEP_SCHEMAS),
    "paper": Field(types=("string", "null"), words="paper of a sheet", choices=PAPERS),
}
ASK = {
    "ask": Field(types=("string",), words="what is asked for", choices=("design",), required=True),
    "id": Field(types=("integer",), words="number that answers come with", required=True),
    **BUILD,
    "have": Field(types=("array",), words="keys of topologies that are kept", items=("string",)),
}


def body_problems(fields: Mapping[str, Field], body: object) -> list[dict[str, Any]]:
    """What is wrong with a body that should hold these fields."""
    if not isinstance(body, dict):
        return [told(f"an object is needed: {{{', '.join(fields)}}}")]
    found = [
        told(f"there is no such entry, but {', '.join(fields)}{did_you_mean(name, fields)}", name)
        for name in body
        if name not in fields
    ]
    for name, field in fields.items():
        if name in body and (problem := field.problem(body[name])):
            found.append(told(problem, name))
        elif name not in body and field.required:
            found.append(told(f"is needed: {field.words}", name))
    return found


def body_schema(fields: Mapping[str, Field]) -> dict[str, Any]:
    """The schema of a body that holds these fields."""
    return {
        "type": "object",
        "properties": {name: field.schema for name, field in fields.items()},
        "required": [name for name, field in fields.items() if field.required],
        "additionalProperties": False,
    }
