"""Sheets as DXF, in millimetres of paper, one below another: dimensions are DIMENSION entities with a block each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array
from ..sections.drawings.dxf_writing import add, document_bytes, new_document
from .line_kinds import LINE_KINDS, THIN
from .marks import Dimension, Filled, Hatch, Mark, Sheet, Stroke, Text

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts.base import BaseLayout

_BETWEEN = 10.0  # mm, from sheet to sheet
_STYLE = "lettering"
_HUNDREDTHS = 100.0  # of a millimetre, in which DXF counts the widths of lines
_BLOCK_ONLY = 32  # of the type of a DIMENSION: its block is its own
_KINDS = {"linear": 0, "angular": 5}


def encoded(source: str, sheets: Sequence[Sheet], title: str) -> bytes:
    """The bytes of a DXF file. Raises MachineError where ezdxf is not installed."""
    del title
    document = new_document(source, "mm")
    _set_up(document)
    space, top = document.modelspace(), 0.0
    for sheet in sheets:
        shift = np.array([0.0, top - sheet.size[1]])
        for mark in sheet.marks:
            _add(document, space, mark, shift)
        top -= sheet.size[1] + _BETWEEN
    width, height = max(sheet.size[0] for sheet in sheets), -top - _BETWEEN
    space.reset_extents((0.0, -height, 0.0), (width, 0.0, 0.0))
    document.set_modelspace_vport(height=1.05 * height, center=(width / 2.0, -height / 2.0))
    return document_bytes(document)


def _set_up(document: Drawing) -> None:
    """Layers with the widths and dashes of the kinds of lines, and a style of lettering."""
    document.header["$LTSCALE"] = 1.0
    document.header["$MEASUREMENT"] = 1
    document.styles.add(_STYLE, font="arial.ttf")
    for kind in LINE_KINDS:
        if kind.dashes:
            signed = [length * (-1) ** k for k, length in enumerate(kind.dashes)]
            document.linetypes.add(kind.name, pattern=[sum(kind.dashes), *signed], description=kind.name)
        pattern = kind.name if kind.dashes else "Continuous"
        document.layers.add(kind.name, lineweight=round(kind.width * _HUNDREDTHS), linetype=pattern)
    for name in ("text", "hatching", "dimensions"):
        document.layers.add(name, lineweight=round(THIN.width * _HUNDREDTHS))


def _dimension_style(document: Drawing, factor: float) -> str:
    """Name of the style of dimensions where so many millimetres on paper are one of the part's length units."""
    name = f"scale_{factor:.9g}".replace(".", "_")
    if name not in document.dimstyles:
        style = document.dimstyles.add(name)
        for variable, value in {**_STYLED, "dimlfac": 1.0 / factor}.items():
            style.dxf.set(variable, value)
    return name


_STYLED: Mapping[str, Any] = {
    "dimtxt": 2.5,
    "dimasz": 2.5,
    "dimexe": 1.5,
    "dimexo": 0.8,
    "dimgap": 0.8,
    "dimtad": 1,
    "dimtih": 0,
    "dimtoh": 0,
    "dimdec": 4,
    "dimzin": 8,
    "dimtxsty": _STYLE,
}
"""Variables of dimensions as they are drawn here: ISO 129-1, for programs that draw them anew."""


def _add(document: Drawing, space: BaseLayout, mark: Mark, shift: Array) -> None:
    match mark:
        case Stroke():
            for one in mark.chain:
                add(space, one.moved(0.0, shift), {"layer": mark.kind.name})
        case Text():
            for text in mark.lines:
                _add_text(space, text, shift)
        case Filled():
            corners = [_xy(p + shift) for p in mark.corners]
            space.add_solid([*corners, corners[-1]], dxfattribs={"layer": "dimensions"})
        case Hatch():
            hatch = space.add_hatch(color=256, dxfattribs={"layer": "hatching"})
            hatch.set_pattern_fill("ANSI31", scale=mark.distance / _ANSI31)
            for path in (mark.outline, *mark.holes):
                hatch.paths.add_polyline_path([_xy(p + shift) for p in path], is_closed=True)
        case Dimension():
            _add_dimension(document, space, mark, shift)


_ANSI31 = 3.175
"""Distance of the lines of the pattern ANSI31 in millimetres."""


def _add_text(space: BaseLayout, text: Text, shift: Array) -> None:
    """Fitted between two points, so that it takes its room in any font."""
    from ezdxf.enums import TextEntityAlignment

    if not text.text.strip():
        return
    start = text.at + shift
    entity = space.add_text(text.text, height=text.height, dxfattribs={"layer": "text", "style": _STYLE})
    end = start + text.width * text.along
    entity.set_placement(_xy(start), _xy(end), align=TextEntityAlignment.FIT)


def _add_dimension(document: Drawing, space: BaseLayout, mark: Dimension, shift: Array) -> None:
    block = document.blocks.new_anonymous_block(type_char="D")
    for part in (*mark.marks, mark.text):
        _add(document, block, part, shift)
    first, second, through, *vertex = (_xy(p + shift) for p in mark.points)
    attributes: dict[str, Any] = {
        "layer": "dimensions",
        "dimstyle": _dimension_style(document, mark.factor),
        "dimtype": _KINDS[mark.kind] | _BLOCK_ONLY,
        "geometry": block.name,
        "text": mark.text.text,
        "text_midpoint": _xy(mark.text.at + shift),
        "defpoint": through,
        "defpoint2": first,
        "defpoint3": second,
        "actual_measurement": np.radians(mark.value) if mark.kind == "angular" else mark.value,
    }
    if vertex:
        attributes["defpoint4"] = vertex[0]
    else:
        attributes["angle"] = mark.angle
    space.new_entity("DIMENSION", attributes)


def _xy(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])
