"""Results as JSON: every number in full, none of them NaN."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..parameters import Size, Unit, declarations
from ..solids.properties import MassProperties
from .built import Built, Part, Units


def built_json(built: Built) -> str:
    """{"pinion": {...}, "gear": {...}, "pair": {...}}; a single part without the first level."""
    parts = {name: _part(part, built.units) for name, part in built.parts.items()}
    if built.pair is None:
        (document,) = parts.values()
    else:
        pair = {"parameters": _parameters(built.pair), "sizes": _sizes(built.pair_sizes, built.units)}
        if built.running:
            pair["running"] = _sizes(built.running, built.units)
        document = {**parts, "pair": pair}
    return json_line(document, indent=2)


def properties_json(properties: MassProperties, units: Units) -> dict[str, Any]:
    """The properties with their units beside them."""
    return {"length_unit": units.length, "mass_unit": units.mass, **properties.to_dict()}


def json_line(document: Mapping[str, Any], indent: int | None = None) -> str:
    """JSON text; arrays as lists, what is not finite as null, Greek letters escaped where stdout has none."""
    has_greek = (sys.stdout.encoding or "").lower().replace("-", "") == "utf8"
    return json.dumps(_plain(document), indent=indent, ensure_ascii=not has_greek, allow_nan=False)


def _part(part: Part, units: Units) -> dict[str, Any]:
    document = {
        "parameters": _parameters(part.gear),
        "sizes": _sizes(part.gear.sizes(), units),
        "placement": part.placement,
        "properties": properties_json(part.properties, units),
    }
    if part.beside:
        document["beside"] = {name: properties_json(one, units) for name, one in part.beside.items()}
    document |= part.gear.findings
    if part.convergence:
        document["convergence"] = {name: study.to_dict() for name, study in part.convergence.items()}
    return document


def _parameters(element: Any) -> dict[str, Any]:
    return {d.name: getattr(element, d.name) for d in declarations(type(element))}


def _sizes(sizes: Mapping[str, Size], units: Units) -> dict[str, Any]:
    return {
        name: {"value": size.value, "unit": _unit(size.unit, units), "symbol": size.symbol}
        for name, size in sizes.items()
    }


def _unit(unit: Unit, units: Units) -> str:
    return {
        "length": units.length,
        "angle": "deg",
        "microradian": "urad",
        "mm": "mm",
        "per inch": "1/in",
        "area": f"{units.length}^2",
        "": "",
    }[unit]


def _plain(value: Any) -> Any:
    match value:
        case np.ndarray():
            return _plain(value.tolist())
        case np.generic():
            return _plain(value.item())
        case Mapping():
            return {key: _plain(one) for key, one in value.items()}
        case list() | tuple():
            return [_plain(one) for one in value]
        case float():
            return value if math.isfinite(value) else None
        case _:
            return value
