"""`gearwright materials`: the names that --material takes."""

from __future__ import annotations

import sys
from dataclasses import asdict
from typing import Annotated

from cyclopts import Parameter as Option

from ..materials import MATERIALS
from .exits import DONE
from .json_output import json_line
from .tables import number, plain_table, show


def materials(
    *, json: Annotated[bool, Option(help="Print one line of JSON.", negative=(), show_default=False)] = False
) -> int:
    """List materials with their densities, typical values as handbooks give them, and what else they are called."""
    if json:
        sys.stdout.write(json_line({"materials": [{**asdict(one), "unit": "kg/m^3"} for one in MATERIALS]}) + "\n")
        return DONE
    table = plain_table("materials")
    for head in ("name", "kg/m³", "which", "also"):
        table.add_column(head, justify="right" if head == "kg/m³" else "left")
    for one in MATERIALS:
        table.add_row(one.name, number(one.density), one.remark, ", ".join(one.aliases))
    show(table)
    return DONE
