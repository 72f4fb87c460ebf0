"""STEP files out, through Open CASCADE: smooth solids with names, colours and places, as AP214 or AP242."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from ... import __version__, disk
from ...errors import FileError, MachineError
from ...placement import Placement
from ..assembly import Assembly, Part, Smooth
from ..text.written import one_line
from .brep.edges import transform
from .brep.shape import shape
from .kernel import kernel

SCHEMAS: Mapping[str, str] = {"AP214": "AP214IS", "AP242": "AP242DIS"}
"""Application protocols of ISO 10303 by their numbers, and Open CASCADE's names for them."""

_UNITS = {
    "um": ("UM", 1e-6),
    "mm": ("MM", 1e-3),
    "cm": ("CM", 1e-2),
    "m": ("M", 1.0),
    "in": ("INCH", 0.0254),
    "ft": ("FT", 0.3048),
}
"""Open CASCADE's names of length units, and metres."""


def write(path: str | Path, assembly: Assembly[Smooth], *, schema: str = "AP214") -> None:
    """Writes the parts where they stand as smooth solids, whole or not at all; several as an assembly.

    Faces are within the parts' tolerances of their boundaries. The header says them.
    Raises GeometryError where a tolerance cannot be met; FileError without a unit, for a schema that is none of STEP's
    or a name that is not a file's; MachineError without the extra `step` or if the disk does not take it.
    """
    unit = assembly.length_unit
    if unit is None:
        raise FileError(f"{path}: STEP files state a unit of length, and none is known; give a length_unit")
    if schema not in SCHEMAS:
        raise FileError(f"{path}: {schema} is no schema of STEP files that is written; choose {' or '.join(SCHEMAS)}")
    kernel()
    document = _document(assembly, unit)
    data = _written(document, assembly, schema, _UNITS[unit][0], str(path))
    with disk.written_whole(path) as stream:
        stream.write(data)


def _document(assembly: Assembly[Smooth], unit: str) -> Any:
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(TCollection_ExtendedString("gearwright"))
    XCAFDoc_DocumentTool.SetLengthUnit_s(document, _UNITS[unit][1])
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    labels = []
    for part in assembly.parts:
        label = shapes.AddShape(shape(part.shape.boundary, part.shape.tolerance), False)
        _name(label, part.name)
        _paint(colours, label, part)
        labels.append(label)
    alone = len(labels) == 1 and np.array_equal(assembly.parts[0].placement, np.eye(4))
    if not alone:
        whole = shapes.NewShape()
        _name(whole, assembly.name)
        for label, part in zip(labels, assembly.parts, strict=True):
            place = transform(Placement.of(part.placement[:3, :3], part.placement[:3, 3]))
            _name(shapes.AddComponent(whole, label, TopLoc_Location(place)), part.name)
        shapes.UpdateAssemblies()
    return document


def _name(label: Any, name: str) -> None:
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name

    TDataStd_Name.Set_s(label, TCollection_ExtendedString(one_line(name), True))


def _paint(colours: Any, label: Any, part: Part[Smooth]) -> None:
    from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
    from OCP.XCAFDoc import XCAFDoc_ColorType

    if part.colour is not None:
        colour = Quantity_Color(*part.colour, Quantity_TypeOfColor.Quantity_TOC_sRGB)
        colours.SetColor(label, colour, XCAFDoc_ColorType.XCAFDoc_ColorGen)


def _written(document: Any, assembly: Assembly[Smooth], schema: str, unit: str, path: str) -> bytes:
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.STEPCAFControl import STEPCAFControl_Writer

    stream = io.BytesIO()
    with _settings({"write.step.schema": SCHEMAS[schema], "write.step.unit": unit}):
        writer = STEPCAFControl_Writer()
        writer.SetColorMode(True)
        writer.SetNameMode(True)
        done = writer.Transfer(document)
        _head(writer, assembly)
        if not done or writer.WriteStream(stream) != IFSelect_RetDone:
            raise MachineError(f"{path}: Open CASCADE does not write this solid; a coarser tolerance may do")
    return _in_ascii(stream.getvalue())


def _in_ascii(data: bytes) -> bytes:
    """With letters beyond ASCII as ISO 10303-21 has them, \\X2\\…\\X0\\ in UTF-16; the kernel leaves them."""
    if data.isascii():
        return data

    def spelled(found: re.Match[str]) -> str:
        return "\\X2\\" + found[0].encode("utf-16-be").hex().upper() + "\\X0\\"

    return re.sub(r"[^\x00-\x7f]+", spelled, data.decode(errors="replace")).encode()


@contextmanager
def _settings(values: Mapping[str, str]) -> Iterator[None]:
    """Settings of Open CASCADE for a while: they are the whole process's, and other programs in it have their own."""
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_Controller

    STEPControl_Controller.Init_s()
    before = {name: Interface_Static.CVal_s(name) for name in values}
    try:
        for name, value in values.items():
            Interface_Static.SetCVal_s(name, value)
        yield
    finally:
        for name, value in before.items():
            Interface_Static.SetCVal_s(name, value)


def _head(writer: Any, assembly: Assembly[Smooth]) -> None:
    from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
    from OCP.TCollection import TCollection_HAsciiString

    within = max(part.shape.tolerance for part in assembly.parts)
    head = APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
    for put, text in (
        (head.SetName, one_line(assembly.name)),
        (head.SetOriginatingSystem, f"Gearwright {__version__}"),
        (head.SetPreprocessorVersion, "Open CASCADE"),
    ):
        put(TCollection_HAsciiString(text))
    for put in (head.SetAuthorValue, head.SetOrganizationValue):
        put(1, TCollection_HAsciiString(""))
    said = f"smooth faces within {within:.3g} {assembly.length_unit} of the exact surfaces"
    head.SetDescriptionValue(1, TCollection_HAsciiString(said))
