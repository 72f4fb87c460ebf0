"""What can be asked by HTTP: one table for the routes and for the OpenAPI document."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from .bodies import BUILD, FILES, PLOTS, READ, TEXTS, Field

Schema = dict[str, Any]

REFUSED = {400, 408, 413, 422}
"""Answers to a body that is not as it should be."""


@dataclass(frozen=True, kw_only=True)
class Operation:
    """One path and method. name   of the method of `Api` that does it

    body      fields of its JSON body
    query     parameters in its address, by name: schema and whether it is needed
    answer    schema of its answer, None where that is no JSON; status   of it; media   its type
    refusals  statuses of its refusals besides those of every operation
    """

    method: Literal["GET", "POST", "DELETE"]
    path: str
    name: str
    summary: str
    answer: Schema | None = None
    status: int = 200
    media: str = "application/json"
    body: Mapping[str, Field] | None = None
    raw: bool = False
    query: Mapping[str, tuple[Schema, bool]] = field(default_factory=dict)
    refusals: tuple[int, ...] = ()


def _object(properties: Schema, *optional: str) -> Schema:
    return {
        "type": "object",
        "properties": properties,
        "required": [name for name in properties if name not in optional],
    }


_TEXT: Schema = {"type": "string"}
_COUNT: Schema = {"type": "integer", "minimum": 0}
_ANY: Schema = {"type": "object"}
_ID = {"type": "string", "pattern": "^[0-9a-f]{32}$"}
_AXIS = _object({"label": _TEXT, "unit": _TEXT})
_NUMBERS = {"type": "array", "items": {"type": ["number", "null"]}}
_LINE = _object({"name": _TEXT, "x": _NUMBERS, "y": _NUMBERS, "style": {"enum": ["solid", "dashed", "points"]}})
_PLOT = _object(
    {
        "title": _TEXT,
        "x": _AXIS,
        "y": _AXIS,
        "equal": {"type": "boolean"},
        "lines": {"type": "array", "items": _LINE},
        "log": {"enum": ["none", "both"]},
        "notes": {"type": "array", "items": _TEXT},
        "window": {"type": ["array", "null"], "items": {"type": "number"}, "minItems": 4, "maxItems": 4},
    }
)
_FILE = _object(
    {
        "state": {"enum": ["waiting", "working", "done", "failed", "cancelled"]},
        "stage": _TEXT,
        "seconds": {"type": "number", "minimum": 0},
        "name": {"type": ["string", "null"]},
        "bytes": {"type": ["integer", "null"]},
        "headline": {"type": ["string", "null"]},
        "problems": {"type": "array", "items": {"$ref": "#/components/schemas/Problem"}},
    }
)
_WORKERS = _object(dict.fromkeys(("alive", "busy", "replaced", "waiting"), _COUNT))

OPERATIONS = (
    Operation(
        method="GET",
        path="/api/health",
        name="health",
        summary="Whether it runs, and what it does",
        answer=_object(
            {
                "status": {"const": "ok"},
                "version": _TEXT,
                "workers": _object({"quick": _WORKERS, "heavy": _WORKERS}),
                "connections": _COUNT,
            }
        ),
    ),
    Operation(method="GET", path="/api/openapi.json", name="openapi", summary="This document", answer=_ANY),
    Operation(
        method="GET",
        path="/api/elements",
        name="elements",
        summary="Kinds of elements and their parameters",
        answer=_object({"length_units": {"type": "array", "items": _TEXT}, "kinds": {"type": "array", "items": _ANY}}),
    ),
    Operation(
        method="GET",
        path="/api/materials",
        name="materials",
        summary="Materials and their densities in kg/m³",
        answer={"type": "array", "items": _object({"name": _TEXT, "density": {"type": "number"}})},
    ),
    Operation(
        method="GET",
        path="/api/schema",
        name="schema",
        summary="JSON Schema of designs, of one element or of all",
        answer=_ANY,
        query={"element": (_TEXT, False)},
        refusals=(400,),
    ),
    Operation(
        method="POST",
        path="/api/read",
        name="read",
        summary="The design in a text of TOML",
        body=READ,
        answer=_object({"design": _ANY}),
    ),
    Operation(
        method="POST",
        path="/api/texts",
        name="texts",
        summary="A design as TOML, Python and a command line",
        body=TEXTS,
        answer=_object({"toml": _TEXT, "python": _TEXT, "command": _TEXT}),
    ),
    Operation(
        method="POST",
        path="/api/build",
        name="build",
        summary="Sizes and exact properties, as `gearwright … --json` prints them",
        body=BUILD,
        answer=_ANY,
    ),
    Operation(method="POST", path="/api/plots", name="plots", summary="The lines of a plot", body=PLOTS, answer=_PLOT),
    Operation(
        method="POST",
        path="/api/files",
        name="begin_file",
        summary="Begins to make a file",
        body=FILES,
        answer=_object({"id": _ID, "url": _TEXT}),
        status=202,
        refusals=(507,),
    ),
    Operation(
        method="GET",
        path="/api/files/{id}",
        name="file",
        summary="How far a file is",
        answer=_FILE,
        refusals=(404,),
    ),
    Operation(
        method="GET",
        path="/api/files/{id}/content",
        name="content",
        summary="A file that is done",
        media="*/*",
        refusals=(404, 409),
    ),
    Operation(
        method="DELETE",
        path="/api/files/{id}",
        name="drop_file",
        summary="Cancels a file that is being made, forgets one that is not",
        status=204,
        refusals=(404,),
    ),
    Operation(
        method="POST",
        path="/api/uploads",
        name="upload",
        summary="Keeps a file for designs that name it by the value given back",
        raw=True,
        query={"name": ({**_TEXT, "minLength": 1}, True)},
        answer=_object({"value": _TEXT, "name": _TEXT, "bytes": _COUNT}),
        status=201,
        refusals=(507,),
    ),
)
