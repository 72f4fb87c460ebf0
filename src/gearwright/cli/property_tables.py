"""Volumetric properties as tables: bodies side by side, or one below the other where they are many."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from rich.markup import escape
from rich.table import Table

from ..arrays import Array
from ..designs.built import Units
from ..solids.properties import MassProperties
from .tables import number, plain_table, power
from .views import FILE_AXES, View

PLAIN = View()

_NOISE = 1e-14  # no more than some roundings of the largest value
COMPONENTS = {"Ixx": (0, 0), "Iyy": (1, 1), "Izz": (2, 2), "Ixy": (0, 1), "Iyz": (1, 2), "Izx": (2, 0)}
"""Components of tensors in the order in which they are shown."""


def properties_table(
    title: str, names: Sequence[str], properties: Sequence[MassProperties], units: Units, view: View = PLAIN
) -> Table:
    """Volume, centroid and inertia of several bodies side by side, saying about which point."""
    table = plain_table(escape(title))
    for heading in ("", "unit"):
        table.add_column(heading, style="dim" if heading else "")
    for name in names:
        table.add_column(escape(name), justify="right")
    columns = [_values(one, units, view, alone=len(properties) == 1) for one in properties]
    for label, (unit, _) in columns[0].items():
        table.add_row(label, unit, *(column[label][1] if label in column else "" for column in columns))
    return table


def bodies_list(title: str, bodies: Mapping[str, MassProperties], units: Units) -> Table:
    """A row a body: volume, mass, centroid and moments about the centroid, to fewer digits."""
    table = plain_table(escape(title))
    table.add_column("body")
    heads = {"volume": power(units.length, 3)} if units.has_volume else {}
    if units.has_mass:
        heads["mass"] = "kg"
    heads |= {f"centroid {axis}": units.length for axis in "xyz"}
    for head, unit in heads.items():
        table.add_column(f"{head}\n{unit}", justify="right")
    for name, body in bodies.items():
        values = {"volume": body.volume, "mass": body.mass, **_centroid(body)}
        table.add_row(escape(name), *(number(values[head], digits=7) for head in heads))
    return table


def properties_note(units: Units, view: View = PLAIN) -> str:
    """What a reader of the properties must know: the signs, the axes, and the density if there is none."""
    said = [] if units.has_mass else [f"Density 1 per {power(units.length, 3)}."]
    if view.name != FILE_AXES:
        said.append(f"Tensors are along {view.words}.")
    if view.about is not None:
        said.append(f"The point: ({', '.join(number(value) for value in view.about)}) {units.length}.")
    return " ".join([*said, "Off the diagonal, tensors hold minus the products: Ixy = −∫xy dm, and xy = +∫xy dm."])


def _values(properties: MassProperties, units: Units, view: View, *, alone: bool) -> dict[str, tuple[str, str]]:
    """Unit and text of every property by its label; of a body that is alone the principal axes, too."""
    length = units.length
    rows = {"volume": (power(length, 3), number(properties.volume))} if units.has_volume else {}
    if units.has_mass:
        rows["mass"] = ("kg", number(properties.mass))
    if properties.area is not None and np.isfinite(properties.area):
        rows["surface area"] = (power(length, 2), number(properties.area))
    rows |= {label: (length, number(value)) for label, value in _centroid(properties).items()}
    rows |= _tensors(properties, f"kg·{length}²" if units.has_mass else power(length, 5), view)
    for index, axis in enumerate(properties.principal_axes.T if alone else (), start=1):  # too wide side by side
        rows[f"principal axis {index}"] = ("x, y, z", ", ".join(f"{value:.6f}" for value in _without_noise(axis, 1.0)))
    for index, value in enumerate(properties.radii_of_gyration, start=1):
        rows[f"radius of gyration {index}"] = (length, number(value))
    rows["found by"] = ("", properties.method)
    rows["relative error at most"] = ("", _bound(properties))
    return rows


def _bound(properties: MassProperties) -> str:
    return number(properties.error_bound, digits=1) if np.isfinite(properties.error_bound) else "unknown"


def _tensors(properties: MassProperties, unit: str, view: View) -> dict[str, tuple[str, str]]:
    turned = view.turned(properties)
    tensors = {"centroid": turned.central_inertia, "origin": turned.inertia}
    if view.about is not None:
        tensors["point"] = view.inertia_about(properties)
    rows: dict[str, tuple[str, str]] = {}
    for about, tensor in tensors.items():
        clean = _without_noise(tensor, float(np.abs(tensor).max()))
        rows |= {f"{name} about the {about}": (unit, number(clean[i, j])) for name, (i, j) in COMPONENTS.items()}
    for index, value in enumerate(properties.principal_moments, start=1):
        rows[f"principal moment {index}"] = (unit, number(value))
    return rows


def _centroid(properties: MassProperties) -> dict[str, Any]:
    values = _without_noise(properties.centroid, _reach(properties))
    return {f"centroid {axis}": value for axis, value in zip("xyz", values, strict=True)}


def _reach(properties: MassProperties) -> float:
    """A length of the body: its farthest radius of gyration or its distance from the origin."""
    return float(max(np.max(properties.radii_of_gyration), np.max(np.abs(properties.centroid))))


def _without_noise(values: Array, scale: float) -> Array:
    """Values with those nought that are only rounding, measured by a scale of theirs."""
    return np.where(np.abs(values) <= _NOISE * scale, 0.0, values)
