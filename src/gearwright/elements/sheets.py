"""Sheets of elements: views, data, mass and notes come together, and are written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..errors import ParameterError, Problem
from ..materials import density as density_of
from ..materials import material as material_of
from ..sheets import Content, Row, Sheet, TitleBlock, sheet
from ..sheets.lettering import strange
from ..sheets.numbers import decimal

if TYPE_CHECKING:
    from .element import Element

NOTES = (
    "Nominal sizes of the geometry as modelled; tolerances as agreed.",
    "Outlines that are drawn are true to shape; tips and roots of other teeth are lines.",
)


@dataclass(frozen=True, kw_only=True)
class SheetLabels:
    """What a sheet says besides what the part is.

    paper     "A3" or "A4", landscape
    name      of the part, as the title block has it
    material  one that `gearwright.materials` lists: stated, and the mass follows from it
    density   kg/m³ instead
    date      as it is to be printed; none by default, so that the same part gives the same file
    notes     further general notes
    """

    paper: str = "A3"
    name: str | None = None
    material: str | None = None
    density: float | None = None
    date: str | None = None
    notes: Sequence[str] = ()

    def require_letters(self) -> None:
        """Raises ParameterError, all problems together, for texts that are none or that the sheet's font lacks."""
        texts: dict[str, object] = {
            "name": self.name,
            "date": self.date,
            **{f"notes[{i}]": text for i, text in enumerate(self.notes)},
        }
        problems = []
        for label, text in texts.items():
            if text is not None and not isinstance(text, str):
                problems.append(Problem(f"{label} = {text!r}", "a text is needed"))
            elif isinstance(text, str) and (found := strange(text)):
                wanted = (
                    f"the sheet's font, DejaVu Sans, has no {found!r}; take other letters, and a note for each line"
                )
                problems.append(Problem(f"{label} = {text!r}", wanted))
        if problems:
            raise ParameterError("The sheet", problems)

    def kilograms(self, length_unit: str) -> float | None:
        """Mass of a cubed length unit; None where nothing is known. Raises ParameterError."""
        if self.material is not None and self.density is not None:
            wanted = "give either a material or a density, not both"
            raise ParameterError("The sheet", [Problem(f"material = {self.material!r}", wanted)])
        given = self.material if self.material is not None else self.density
        return None if given is None else density_of(given, length_unit=length_unit)


def element_sheet(
    element: Element, labels: SheetLabels, *, title: str, more: Sequence[Row] = (), number: tuple[int, int] = (1, 1)
) -> Sheet:
    """The sheet of one part. more   rows of the data table: what is to be said of its mate"""
    from .. import __version__

    labels.require_letters()
    unit, each = element.length_unit, labels.kilograms(element.length_unit)
    volume = element.properties().volume
    cubed = Row(name="Volume", symbol="V", value=f"{decimal(volume, 2 if unit == 'mm' else 4)} {unit}³")
    content = Content(
        title=title,
        description=element.description,
        length_unit=unit,
        views=element.views(),
        rows=(*element.data_rows(), *more, cubed),
        tables=element.tables(),
        notes=(*(NOTES if hasattr(element, "teeth") else NOTES[:1]), *labels.notes),
    )
    block = TitleBlock(
        paper=labels.paper,
        name=labels.name,
        material=None if labels.material is None else material_of(labels.material).name,
        mass=None if each is None else f"{decimal(each * volume, 3)} kg",
        date=labels.date,
        made_by=f"Gearwright {__version__}",
        sheet=number,
    )
    return sheet(content, block)


def spoken(class_name: str) -> str:
    """The name of a class as words: "Spur gear"."""
    return "".join(f" {c.lower()}" if c.isupper() else c for c in class_name).strip().capitalize()
