"""The OpenAPI document of the server, from the table of operations and the schemas of designs."""

from __future__ import annotations

import re
from typing import Any

from .. import __version__
from .bodies import body_schema
from .operations import OPERATIONS, REFUSED, Operation

_TEXT = {"type": "string"}
_WORDS = {
    400: "not understood",
    401: "a token is needed",
    403: "another host or origin",
    404: "there is none",
    405: "no such method",
    408: "too slow",
    409: "not done yet",
    413: "too large",
    422: "cannot be built or read so",
    429: "too many requests",
    500: "a fault of the server",
    503: "busy, or stopped for taking too long",
    507: "no space on the disk",
}
_ALWAYS = (401, 403, 429)
_PROBLEM = {
    "type": "object",
    "properties": {
        "parameter": {"type": ["string", "null"], "description": "the parameter that it is about"},
        "member": {"enum": [0, 1, None], "description": "the member that it is about: pinion or gear"},
        "subject": _TEXT,
        "message": _TEXT,
    },
    "required": ["parameter", "member", "subject", "message"],
}
_REFUSAL = {
    "type": "object",
    "properties": {
        "headline": _TEXT,
        "problems": {"type": "array", "items": {"$ref": "#/components/schemas/Problem"}},
    },
    "required": ["headline", "problems"],
}


def document(designs: dict[str, Any]) -> dict[str, Any]:
    """The whole document. designs   the JSON Schema of a design"""
    paths: dict[str, Any] = {}
    for one in OPERATIONS:
        paths.setdefault(one.path, {})[one.method.lower()] = _operation(one)
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "Gearwright",
            "version": __version__,
            "description": "Gears, cams and swept solids: exact properties, plots and files. Answers to a design as"
            " it changes come by the WebSocket /api/live.",
        },
        "paths": paths,
        "components": {
            "schemas": {
                "Design": {key: value for key, value in designs.items() if key != "$schema"},
                "Problem": _PROBLEM,
                "Refusal": _REFUSAL,
            },
            "securitySchemes": {"token": {"type": "http", "scheme": "bearer"}},
        },
        "security": [{}, {"token": []}],
    }


def _operation(one: Operation) -> dict[str, Any]:
    found: dict[str, Any] = {"operationId": one.name, "summary": one.summary, "responses": _responses(one)}
    named = [(name, {"pattern": "^[0-9a-f]{32}$", **_TEXT}, True, "path") for name in re.findall(r"{(\w+)}", one.path)]
    named += [(name, schema, needed, "query") for name, (schema, needed) in one.query.items()]
    if named:
        found["parameters"] = [
            {"name": name, "in": where, "required": needed, "schema": schema} for name, schema, needed, where in named
        ]
    if one.body is not None:
        content = {"application/json": {"schema": body_schema(one.body)}}
        found["requestBody"] = {"required": True, "content": content}
    if one.raw:
        binary = {"schema": {"type": "string", "format": "binary"}}
        found["requestBody"] = {"required": True, "content": {"application/octet-stream": binary}}
    return found


def _responses(one: Operation) -> dict[str, Any]:
    done: dict[str, Any] = {"description": "done"}
    if one.answer is not None:
        done["content"] = {one.media: {"schema": one.answer}}
    elif one.status == 200:
        done["content"] = {one.media: {"schema": {"type": "string", "format": "binary"}}}
    own = REFUSED if one.body is not None or one.raw else set()
    statuses = sorted({*_ALWAYS, *own, *one.refusals, 405, 500, 503})
    refused = {"schema": {"$ref": "#/components/schemas/Refusal"}}
    return {
        str(one.status): done,
        **{
            str(status): {"description": _WORDS[status], "content": {"application/json": refused}}
            for status in statuses
        },
    }
