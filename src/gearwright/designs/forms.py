"""The catalog as a page needs it to make forms: kinds of elements, their parameters and what they take."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from .. import catalog
from ..files.formats import FILE_FORMATS
from ..parameters import MILLIMETRES, Declaration, FileName, Form, Numbers, Points, Several, Table, Text
from .file_problems import DRAWINGS, SHEETS
from .kinds import parameters_of
from .plots import plots_of

Plain = dict[str, Any]


def elements() -> Plain:
    """Every kind of element, and the units that lengths may be given in."""
    return {"length_units": list(MILLIMETRES), "kinds": kind_forms()}


def kind_forms() -> list[Plain]:
    """Every kind of element in the catalog with its parameters."""
    return [_kind(kind) for kind in catalog.ELEMENTS]


def _kind(kind: catalog.Element) -> Plain:
    return {
        "name": kind.name,
        "summary": kind.summary,
        "command": kind.command,
        "members": kind.members,
        "mate": kind.mate,
        "origin": kind.origin,
        "plane": kind.plane,
        "start": {"element": kind.command, **kind.start},
        "plots": plots_of(kind),
        "formats": _formats(kind),
        "parameters": [parameter_form(one, kind.settled) for one in parameters_of(kind)],
    }


def parameter_form(declaration: Declaration, settled: Collection[str] = ()) -> Plain:
    """A declared parameter: what it means, which values it takes, with which choices of others it applies.

    settled   names of choices that are made already
    """
    parameter = declaration.parameter
    return {
        "name": declaration.name,
        "meaning": parameter.meaning,
        "symbol": parameter.symbol,
        "unit": parameter.unit,
        "kind": parameter.kind,
        "choices": list(parameter.choices),
        "above": parameter.above,
        "minimum": parameter.minimum,
        "maximum": parameter.maximum,
        "below": parameter.below,
        "components": list(parameter.components),
        "members": declaration.members,
        "required": declaration.required,
        "default": None if declaration.required else declaration.default,
        "only": {name: list(words) for name, words in declaration.only.items() if name not in settled},
        "topic": parameter.topic,
        "forms": [_form(form) for form in parameter.forms],
    }


def _form(form: Form) -> Plain:
    match form:
        case FileName():
            return {"form": "file", "suffixes": list(form.suffixes), "words": form.words}
        case Text():
            return {"form": "text", "words": form.words}
        case Points():
            return {"form": "points", "coordinates": list(form.coordinates), "least": form.least, "words": form.words}
        case Numbers():
            return {"form": "numbers", "most": form.most, "words": form.words}
        case Several():
            return {"form": "several", "of": _form(form.of), "words": form.words}
        case Table():
            entries = [parameter_form(entry) for entry in form.entries]
            return {"form": "table", "keys": list(form.keys), "entries": entries, "words": form.words}
        case _:
            raise TypeError(f"no form of a page is known for {form!r}")


def _formats(kind: catalog.Element) -> list[Plain]:
    """What a design of a kind is written as."""
    bodies = [
        {
            "what": "body",
            "suffix": suffix,
            "words": f"{one.name}: {one.summary}",
            "needs_density": one.holds == "mechanism",
            "has_clearance": one.holds == "polygons",
        }
        for one in FILE_FORMATS
        if one.writer
        for suffix in one.suffixes
    ]
    drawings = [("drawing", suffix, "plane section, true arcs and splines") for suffix in DRAWINGS]
    sheets = [("sheet", suffix, "drawing sheet for the shop") for suffix in SHEETS]
    others = [*(drawings if kind.plane else []), *sheets, ("design", ".toml", "the design, as a file")]
    return [
        *bodies,
        *(
            {"what": what, "suffix": suffix, "words": words, "needs_density": False, "has_clearance": False}
            for what, suffix, words in others
        ),
    ]
