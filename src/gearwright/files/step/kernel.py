"""What is used of Open CASCADE's Python binding that its versions 7.9 and 8 have under different names.

Version 8 moved arrays, lists and maps to OCP.collections and dropped "_s" from the casts of TopoDS. Everything else is
imported from OCP where it is used, after `kernel()` has said that it is there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

from ...errors import MachineError


@dataclass(frozen=True, kw_only=True)
class Kernel:
    """Types of collections, and the casts from a shape to what it is."""

    label_sequence: Any
    text_sequence: Any
    shape_map: Any
    points: Any
    points_2d: Any
    point_grid: Any
    numbers: Any
    counts: Any
    as_face: Any
    as_edge: Any
    as_vertex: Any


@cache
def kernel() -> Kernel:
    """Open CASCADE, silenced. Raises MachineError without the extra `step`."""
    try:
        casts = import_module("OCP.TopoDS").TopoDS
        messages = import_module("OCP.Message").Message
    except ImportError:
        raise MachineError(
            "STEP files are read and written by Open CASCADE, which is missing: pip install 'gearwright[step]'"
        ) from None
    messages.DefaultMessenger_s().ChangePrinters().Clear()  # it reports progress and errors on stdout
    return Kernel(
        label_sequence=_collection("Sequence_TDF_Label", "TDF", "TDF_LabelSequence"),
        text_sequence=_collection("Sequence_TCollection_AsciiString", "TColStd", "TColStd_SequenceOfAsciiString"),
        shape_map=_collection(
            "IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher", "TopTools", "TopTools_IndexedMapOfShape"
        ),
        points=_collection("Array1_gp_Pnt", "TColgp", "TColgp_Array1OfPnt"),
        points_2d=_collection("Array1_gp_Pnt2d", "TColgp", "TColgp_Array1OfPnt2d"),
        point_grid=_collection("Array2_gp_Pnt", "TColgp", "TColgp_Array2OfPnt"),
        numbers=_collection("Array1_double", "TColStd", "TColStd_Array1OfReal"),
        counts=_collection("Array1_int", "TColStd", "TColStd_Array1OfInteger"),
        as_face=getattr(casts, "Face_s", None) or casts.Face,
        as_edge=getattr(casts, "Edge_s", None) or casts.Edge,
        as_vertex=getattr(casts, "Vertex_s", None) or casts.Vertex,
    )


def _collection(name: str, old_module: str, old_name: str) -> Any:
    """A collection by its name in version 8, or else by that of 7.9."""
    try:
        return getattr(import_module("OCP.collections"), name)
    except ImportError:
        return getattr(import_module(f"OCP.{old_module}"), old_name)
