"""The products of a STEP file: shapes by the labels of a document, their names, and how assemblies place them."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple, final

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ..text.places import shown
from .kernel import kernel

_SYNTAX = "Undefined Parsing: "
_LONGEST = 200  # characters of a name that are kept


class Part(NamedTuple):
    """A label of the document: of a shape, or of a place where an assembly holds one."""

    entry: str

    def __str__(self) -> str:
        return f"part {self.entry}"


@final
class Document:
    """A STEP file transferred into Open CASCADE. All lengths are millimetres, whatever the file's unit."""

    def __init__(self, data: bytes, file: str):
        """Raises FileError if Open CASCADE reads no shapes from the data; MachineError without it."""
        kernel()
        from OCP.IFSelect import IFSelect_RetDone
        from OCP.Interface import Interface_Static
        from OCP.Standard import Standard_Failure
        from OCP.STEPCAFControl import STEPCAFControl_Reader
        from OCP.TCollection import TCollection_ExtendedString
        from OCP.TDocStd import TDocStd_Document
        from OCP.XCAFDoc import XCAFDoc_DocumentTool

        reader = STEPCAFControl_Reader()
        Interface_Static.SetCVal_s("xstep.cascade.unit", "MM")
        Interface_Static.SetIVal_s("read.stepcaf.subshapes.name", 1)
        for unwanted in (reader.SetColorMode, reader.SetLayerMode, reader.SetPropsMode, reader.SetMatMode):
            unwanted(False)
        reader.SetNameMode(True)
        self._document = TDocStd_Document(TCollection_ExtendedString("STEP"))
        try:
            done = reader.ReadStream("STEP", io.BytesIO(data)) == IFSelect_RetDone
            self.faults = _faults(reader) if done else ()
            _refuse_syntax_errors(self.faults, file)
            done = done and reader.Transfer(self._document)
        except Standard_Failure as error:
            raise _unreadable(file, f" ({str(error)[:100]})") from None
        if not done:
            raise _unreadable(file, "")
        self.units = _length_units(reader)
        self._tool = XCAFDoc_DocumentTool.ShapeTool_s(self._document.Main())
        self._labels: dict[Part, Any] = {}

    def roots(self) -> list[tuple[Part, Array]]:
        """Shapes that no other one holds."""
        found = kernel().label_sequence()
        self._tool.GetFreeShapes(found)
        return [(self._part(found.Value(number)), np.eye(4)) for number in range(1, found.Length() + 1)]

    def children(self, part: Part) -> Sequence[tuple[Part, Array]]:
        """What an assembly holds, and its matrices (4, 4)."""
        label = self._shape_label(part)
        if not self._tool.IsAssembly_s(label):
            return ()
        found = kernel().label_sequence()
        self._tool.GetComponents_s(label, found)
        held = [found.Value(number) for number in range(1, found.Length() + 1)]
        return [(self._part(one), _matrix(self._tool.GetLocation_s(one))) for one in held]

    def shape_key(self, part: Part) -> str:
        """The same for all places of one shape."""
        return _entry(self._shape_label(part))

    def shape(self, part: Part) -> Any:
        """The shape of a part that is no assembly, where its own frame has it; None of one that is."""
        label = self._shape_label(part)
        return None if self._tool.IsAssembly_s(label) else self._tool.GetShape_s(label)

    def name(self, part: Part, solid: Any) -> str:
        """The name of a solid in a part; where it has none that of the part, or of its place."""
        from OCP.TDF import TDF_Label

        own, label = TDF_Label(), self._shape_label(part)
        named = [own] if self._tool.FindSubShape(label, solid, own) else []
        return next(filter(None, map(_name, [*named, label, self._labels[part]])), "")

    def _part(self, label: Any) -> Part:
        part = Part(_entry(label))
        self._labels[part] = label
        return part

    def _shape_label(self, part: Part) -> Any:
        from OCP.TDF import TDF_Label

        label, referred = self._labels[part], TDF_Label()
        return referred if self._tool.GetReferredShape_s(label, referred) else label


def _unreadable(file: str, reason: str) -> FileError:
    return FileError(
        f"{file}: Open CASCADE cannot read this STEP file{reason}; it is damaged or of a kind that has no shapes;"
        " export it again as AP203, AP214 or AP242"
    )


class Fault(NamedTuple):
    """What is wrong with an entity, by its number in the order of the file, 0 for the file itself."""

    entity: int
    text: str


def _faults(reader: Any) -> tuple[Fault, ...]:
    checks = reader.ChangeReader().WS().ModelCheckList(True)
    found: list[Fault] = []
    checks.Start()
    while checks.More():
        check = checks.Value()
        found.extend(Fault(checks.Number(), str(check.CFail(n))) for n in range(1, check.NbFails() + 1))
        checks.Next()
    return tuple(found)


def _refuse_syntax_errors(faults: tuple[Fault, ...], file: str) -> None:
    """Open CASCADE would leave out the entities concerned and go on."""
    for fault in faults:
        if fault.text.startswith(_SYNTAX):
            text = shown(fault.text.removeprefix(_SYNTAX), 160)
            raise FileError(f"{file}: not a whole STEP file: {text}; it is damaged; copy or export it again")


def _length_units(reader: Any) -> tuple[str, ...]:
    """Names of the length units in the file, lower case."""
    lengths, angles, solid_angles = (kernel().text_sequence() for _ in range(3))
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles)
    return tuple(dict.fromkeys(lengths.Value(n).ToCString().lower() for n in range(1, lengths.Length() + 1)))


def _entry(label: Any) -> str:
    from OCP.TCollection import TCollection_AsciiString
    from OCP.TDF import TDF_Tool

    text = TCollection_AsciiString()
    TDF_Tool.Entry_s(label, text)
    return str(text.ToCString())


def _name(label: Any) -> str:
    from OCP.TDataStd import TDataStd_Name

    found = TDataStd_Name()
    text = found.Get().ToExtString() if label.FindAttribute(TDataStd_Name.GetID_s(), found) else ""
    return "" if text.upper() in ("NONE", "") else str(text)[:_LONGEST]


def _matrix(location: Any) -> Array:
    """(4, 4) of a location, for points as columns."""
    map_ = location.Transformation()
    result = np.eye(4)
    result[:3] = [[map_.Value(row, column) for column in range(1, 5)] for row in range(1, 4)]
    return result


def subshapes(shape: Any, kind: Any) -> Iterator[Any]:
    """Faces, edges or other pieces of a shape, as often as it uses them, placed and turned as it does."""
    from OCP.TopExp import TopExp_Explorer

    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()
