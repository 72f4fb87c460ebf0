"""What a command has built, as tables for a person."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rich.table import Table

from ..designs.built import Built, Units
from ..parameters import Size, unit_text
from ..solids.properties import MassProperties
from .property_tables import properties_note, properties_table
from .tables import number, plain_table, show


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


def _sizes_table(title: str, names: Sequence[str], sizes: Sequence[Mapping[str, Size]], units: Units) -> Table:
    table = plain_table(title)
    for heading in ("", "symbol", "unit"):
        table.add_column(heading, style="dim" if heading else "")
    for name in names:
        table.add_column(name, justify="right")
    for name, size in {name: size for one in reversed(sizes) for name, size in one.items()}.items():
        texts = (number(one[name].value, digits=7) if name in one else "" for one in sizes)
        table.add_row(name.replace("_", " "), size.symbol, unit_text(size.unit, units.length), *texts)
    return table
