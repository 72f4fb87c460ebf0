"""What is built as plain values for programs: the document that JSON shows, every number in full."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..parameters import Size, Unit, declarations
from ..solids.properties import MassProperties
from .built import Built, Part, Units


def built_document(built: Built) -> dict[str, Any]:
    """{"pinion": {...}, "gear": {...}, "pair": {...}}; a single part without the first level."""
    parts = {name: _part(part, built.units) for name, part in built.parts.items()}
    if built.pair is None:
        (document,) = parts.values()
    else:
        pair = {"parameters": _parameters(built.pair), "sizes": _sizes(built.pair_sizes, built.units)}
        if built.running:
            pair["running"] = _sizes(built.running, built.units)
        document = {**parts, "pair": pair}
    return document


def properties_document(properties: MassProperties, units: Units) -> dict[str, Any]:
    """The properties with their units beside them."""
    return {"length_unit": units.length, "mass_unit": units.mass, **properties.to_dict()}


def _part(part: Part, units: Units) -> dict[str, Any]:
    document = {
        "parameters": _parameters(part.gear),
        "sizes": _sizes(part.gear.sizes(), units),
        "placement": part.placement,
        "properties": properties_document(part.properties, units),
    }
    if part.beside:
        document["beside"] = {name: properties_document(one, units) for name, one in part.beside.items()}
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


def plain(value: Any) -> Any:
    """A value with arrays as lists and what is not finite as None."""
    match value:
        case np.ndarray():
            return plain(value.tolist())
        case np.generic():
            return plain(value.item())
        case Mapping():
            return {key: plain(one) for key, one in value.items()}
        case list() | tuple():
            return [plain(one) for one in value]
        case float():
            return value if math.isfinite(value) else None
        case _:
            return value
