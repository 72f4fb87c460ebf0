"""What notebooks show of elements and pairs: sizes, properties, and a small picture where that is quick."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..boundary.extent import rough_diagonal
from ..html_tables import beside, number, table
from ..parameters import Size, unit_text
from ..solids.summaries import COARSE, assembly_picture, property_rows
from .assembly import alone

if TYPE_CHECKING:
    from .element import Element
    from .pair import Pair


def kind_of(element: Element | Pair) -> str:
    """What kind of thing it is: "Spur gear"."""
    return re.sub(r"(?<!^)(?=[A-Z])", " ", type(element).__name__).capitalize()


def title_of(element: Element | Pair) -> str:
    """Kind and description: "Spur gear: z = 24, m = 3 mm"."""
    return f"{kind_of(element)}: {element.description}"


def element_summary(element: Element) -> str:
    """Sizes, properties and a picture."""
    title = title_of(element)
    picture = assembly_picture(title, element.assembly(_tolerance(element)), alone(element.upward))
    properties = table("properties", ("", "about", "value"), property_rows(element.properties(), element.length_unit))
    sizes = _sizes_table(title, {"": element.sizes()}, element.length_unit)
    return beside(sizes, f"{picture}{properties}")


def pair_summary(pair: Pair) -> str:
    """Sizes of the pair and of its members, and a picture of them in mesh."""
    title, unit = title_of(pair), pair.length_unit
    members = {name: member.sizes() for name, member in pair.members.items()}
    tolerance = max(_tolerance(member) for member in pair.members.values())
    picture = assembly_picture(title, pair.assembly(tolerance))
    return beside(f"{_sizes_table(title, {'': pair.sizes()}, unit)}{picture}", _sizes_table("members", members, unit))


def _tolerance(element: Element) -> float:
    """How finely (length) a small picture needs it."""
    return COARSE * rough_diagonal(element.boundary)


def _sizes_table(title: str, sizes: Mapping[str, Mapping[str, Size]], length_unit: str) -> str:
    """Sizes side by side; the order is that of the last part, which has them all."""
    rows = [
        (
            name.replace("_", " "),
            size.symbol,
            *(number(one[name].value) if name in one else "" for one in sizes.values()),
            unit_text(size.unit, length_unit),
        )
        for name, size in {name: size for one in reversed([*sizes.values()]) for name, size in one.items()}.items()
    ]
    return table(title, ("", "symbol", *(name or "value" for name in sizes), "unit"), rows)
