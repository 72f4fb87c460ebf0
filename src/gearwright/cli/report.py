"""Results as tables for a person."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Mapping, Sequence

import numpy as np
from rich import box
from rich.console import Console, RenderableType
from rich.table import Table

from ..arrays import Array
from ..parameters import Size
from ..solids.properties import MassProperties
from .built import Built, Units

WIDTH = 100
"""Columns of text that is not written to a terminal."""

_POWERS = {2: "²", 3: "³", 5: "⁵"}
_UNITS = {"angle": "°", "microradian": "µrad", "mm": "mm", "per inch": "1/in", "": ""}


def show(*renderables: RenderableType) -> None:
    """Writes tables and texts to stdout."""
    terminal = sys.stdout.isatty()
    console = Console(
        width=shutil.get_terminal_size((WIDTH, 24)).columns if terminal else WIDTH,
        highlight=False,
        no_color="NO_COLOR" in os.environ or not terminal,
    )
    # captured, so that a reader who leaves early is seen by the caller and not by rich
    with console.capture() as text:
        for renderable in renderables:
            console.print(renderable)
    sys.stdout.write("\n".join(line.rstrip() for line in text.get().splitlines()) + "\n")


def show_built(built: Built) -> None:
    """Sizes and volumetric properties of all parts side by side, and the sizes of the pair."""
    names = list(built.parts)
    sizes = [part.gear.sizes() for part in built.parts.values()]
    tables = [_sizes_table(built.kind, names, sizes, built.units)]
    if built.pair_sizes:
        tables.append(_sizes_table("pair", [""], [built.pair_sizes], built.units))
    if built.running:
        tables.append(_sizes_table("running", [""], [built.running], built.units))
    columns: dict[str, MassProperties] = {}
    for name, part in built.parts.items():
        columns |= {name: part.properties, **part.beside}
    show(*tables, properties_table("volumetric properties", list(columns), list(columns.values()), built.units))
    show(properties_note(built.units), f"The origin: {built.origin}.")


def plain_table(title: str) -> Table:
    """An empty table in the common style."""
    return Table(title=title, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD, pad_edge=False)


def properties_table(title: str, names: Sequence[str], properties: Sequence[MassProperties], units: Units) -> Table:
    """Volume, centroid and inertia of several bodies side by side, saying about which point."""
    table = plain_table(title)
    for heading in ("", "unit"):
        table.add_column(heading, style="dim" if heading else "")
    for name in names:
        table.add_column(name, justify="right")
    columns = [_property_values(one, units) for one in properties]
    for label, (unit, _) in columns[0].items():
        table.add_row(label, unit, *(column[label][1] for column in columns))
    return table


def properties_note(units: Units) -> str:
    """What a reader of the properties must know: the sign of the tensors, and the density if there is none."""
    density = "" if units.has_mass else f"Density 1 per {_power(units.length, 3)}. "
    return density + "Off the diagonal, tensors hold minus the products: Ixy = −∫xy dm."


def _property_values(properties: MassProperties, units: Units) -> dict[str, tuple[str, str]]:
    """Unit and text of every property by its label."""
    length = units.length
    inertia = f"kg·{length}²" if units.has_mass else _power(length, 5)
    rows = {"volume": (_power(length, 3), number(properties.volume))}
    if units.has_mass:
        rows["mass"] = ("kg", number(properties.mass))
    if properties.area is not None and np.isfinite(properties.area):
        rows["surface area"] = (_power(length, 2), number(properties.area))
    for axis, value in zip("xyz", _without_noise(properties.centroid, _reach(properties)), strict=True):
        rows[f"centroid {axis}"] = (length, number(value))
    for about, inertia_about in (("centroid", properties.central_inertia), ("origin", properties.inertia)):
        tensor = _without_noise(inertia_about, float(np.linalg.norm(inertia_about)))
        for name, (i, j) in _COMPONENTS.items():
            rows[f"{name} about the {about}"] = (inertia, number(tensor[i, j]))
    for index, value in enumerate(properties.principal_moments, start=1):
        rows[f"principal moment {index}"] = (inertia, number(value))
    rows["found by"] = ("", properties.method)
    rows["relative error at most"] = ("", number(properties.error_bound, digits=1))
    return rows


def _reach(properties: MassProperties) -> float:
    """A length of the body: its farthest radius of gyration or its distance from the origin."""
    return float(max(np.max(properties.radii_of_gyration), np.max(np.abs(properties.centroid))))


def _without_noise(values: Array, scale: float) -> Array:
    """Values with those nought that are only rounding, measured by a scale of theirs."""
    return np.where(np.abs(values) <= _NOISE * scale, 0.0, values)


_NOISE = 1e-14  # no more than some roundings of the largest value
_COMPONENTS = {"Ixx": (0, 0), "Iyy": (1, 1), "Izz": (2, 2), "Ixy": (0, 1), "Iyz": (1, 2), "Izx": (2, 0)}


def _sizes_table(title: str, names: Sequence[str], sizes: Sequence[Mapping[str, Size]], units: Units) -> Table:
    table = plain_table(title)
    for heading in ("", "symbol", "unit"):
        table.add_column(heading, style="dim" if heading else "")
    for name in names:
        table.add_column(name, justify="right")
    for name, size in {name: size for one in reversed(sizes) for name, size in one.items()}.items():
        texts = (number(one[name].value, digits=7) if name in one else "" for one in sizes)
        unit = {"length": units.length, "area": _power(units.length, 2)}.get(size.unit) or _UNITS[size.unit]
        table.add_row(name.replace("_", " "), size.symbol, unit, *texts)
    return table


def number(value: float, digits: int = 10) -> str:
    """A number to so many significant digits."""
    return f"{value:.{digits}g}"


def _power(unit: str, exponent: int) -> str:
    return unit + _POWERS[exponent]
