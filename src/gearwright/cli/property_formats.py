"""Measured files as text: tables, JSON, CSV, and inertial elements of robot descriptions."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..designs.built import Units
from ..files.inertial import WRITERS, Inertial
from ..solids.inertial import inertial_of
from ..solids.properties import MassProperties
from .json_output import json_line
from .measuring import Measured, Question
from .property_tables import COMPONENTS, bodies_list, properties_note, properties_table
from .tables import shown
from .views import PRINCIPAL_AXES, View

_SIDE_BY_SIDE = 4
"""Bodies up to which tables have a column for each."""

_SIZES = ("volume", "mass", "area", "centroid_x", "centroid_y", "centroid_z")
_TENSOR = tuple(name.lower() for name in COMPONENTS)
_MOMENTS = ("principal_moment_1", "principal_moment_2", "principal_moment_3")
_COLUMNS = [
    *("file", "body", "length_unit", "mass_unit", *_SIZES),
    *(f"central_{name}" for name in _TENSOR),
    *(*_TENSOR, *_MOMENTS, "error_bound"),
]


def heading(written: str) -> str:
    """What stands before all results."""
    return _row(_COLUMNS) if written == "csv" else ""


def result(found: Measured, written: str, view: View, question: Question) -> str:
    """A measured file in a format. Raises GeometryError where the format takes no such properties."""
    if written == "json":
        return json_line(_document(found, view, question)) + "\n"
    if written == "csv":
        return _rows(found, view)
    if written in WRITERS:
        return _inertials(found, written, view)
    return _tables(found, view)


def _title(found: Measured) -> str:
    return "all together" if found.file is None else found.file


def _several(found: Measured) -> bool:
    return len(found.bodies) > 1


def _tables(found: Measured, view: View) -> str:
    title, note = _title(found), properties_note(found.units, view)
    if not _several(found):
        return shown(properties_table(title, [""], [found.together], found.units, view), note)
    if len(found.bodies) <= _SIDE_BY_SIDE:
        columns = {**found.bodies, "together": found.together}
        return shown(properties_table(title, list(columns), list(columns.values()), found.units, view), note)
    apart = bodies_list(title, found.bodies, found.units)
    return shown(apart, properties_table("together", [""], [found.together], found.units, view), note)


def _document(found: Measured, view: View, question: Question) -> dict[str, Any]:
    document = {"file": found.file, **_properties(found.together, found.units, view)}
    if question.thickness is not None or question.surface_density is not None:
        document["shell"] = {"thickness": question.thickness, "surface_density": question.surface_density}
    if question.subtracted:
        document["subtracted"] = [str(file) for file in question.subtracted]
    if _several(found):
        document["bodies"] = {name: _properties(body, found.units, view) for name, body in found.bodies.items()}
    if found.remarks:
        document["remarks"] = found.remarks
    return document


def _properties(body: MassProperties, units: Units, view: View) -> dict[str, Any]:
    values = {"length_unit": units.length, "mass_unit": units.mass, **view.to_dict(body)}
    return values if units.has_volume else {**values, "volume": None, "density": None}


def _rows(found: Measured, view: View) -> str:
    """A row for each body, and one without a body's name for all together where there are several."""
    bodies = {**(found.bodies if _several(found) else {}), "": found.together}
    return "".join(_row(_cells(_title(found), name, body, found.units, view)) for name, body in bodies.items())


def _cells(file: str, name: str, body: MassProperties, units: Units, view: View) -> list[Any]:
    turned = view.turned(body)
    tensors = [tensor[i, j] for tensor in (turned.central_inertia, turned.inertia) for i, j in COMPONENTS.values()]
    volume = body.volume if units.has_volume else ""
    area = "" if body.area is None else body.area
    sizes = [volume, body.mass, area, *body.centroid, *tensors, *body.principal_moments, body.error_bound]
    return [file, name, units.length, units.mass, *(one if isinstance(one, str) else float(one) for one in sizes)]


def _row(cells: list[Any]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(cells)
    return text.getvalue()


def _inertials(found: Measured, written: str, view: View) -> str:
    bodies: Mapping[str, MassProperties] = found.bodies if _several(found) else {"": found.together}
    return "".join(
        WRITERS[written](_inertial(": ".join(filter(None, (_title(found), name))), body, found.units, view))
        for name, body in bodies.items()
    )


def _inertial(name: str, body: MassProperties, units: Units, view: View) -> Inertial:
    principal = view.name == PRINCIPAL_AXES
    tensor = np.diag(body.principal_moments) if principal else view.turned(body).central_inertia
    return inertial_of(name, body, units.length, axes=view.axes_of(body), inertia=tensor)
