"""DXF files: the entities of model space that are outlines, blocks taken apart."""

from __future__ import annotations

import io
import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import FileError, MachineError
from .dxf_curves import OUTLINES, curves_of
from .sheet import Sheet, Tally

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

_UNITS = {
    1: "in", 2: "ft", 3: "mi", 4: "mm", 5: "cm", 6: "m", 7: "km", 8: "microinch", 9: "mil", 10: "yd",
    13: "µm", 14: "dm",
}  # fmt: skip
"""$INSUNITS of the header; 0 and what is not here is no unit."""

_DEEPEST = 32
"""Blocks within blocks; more is a block that holds itself."""

_BROKEN = (
    ArithmeticError, AttributeError, LookupError, RuntimeError, StopIteration, TypeError, ValueError, struct.error,
)  # fmt: skip
"""What ezdxf raises besides its own errors at a file whose tags are not what their codes promise."""

_BINARY = b"AutoCAD Binary DXF\r\n\x1a\x00"


def read(source: str, data: bytes, layer: str | None) -> Sheet:
    """The curves of model space on one layer or on all that are not off or frozen, in the drawing's own units.

    Raises FileError where the file is cut off or no DXF, or an outline does not lie in a plane z = constant;
    MachineError where ezdxf is not installed.
    """
    document = _document(source, data)
    with _refused(source):
        return _sheet(source, document, layer)


def _sheet(source: str, document: Document, layer: str | None) -> Sheet:
    hidden = {entry.dxf.name.casefold() for entry in document.layers if entry.is_off() or entry.is_frozen()}
    tally, heights = Tally(source=source, layer=layer), set[float]()
    for entity, own_layer in _entities(tally, document.modelspace(), (), None):
        kind = entity.dxftype()
        if kind not in OUTLINES or (kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)):
            tally.passed_over[kind] += 1
        elif layer is None and own_layer.casefold() in hidden:
            tally.passed_over[f"{kind} on hidden layer {own_layer}"] += 1
        elif tally.wants(own_layer):
            curves, z = curves_of(source, entity)
            heights.update(z)
            tally.add(curves)
        else:
            tally.passed_over[f"{kind} on layer {own_layer}"] += 1
    _refuse_steps(source, heights)
    return tally.sheet(_UNITS.get(document.header.get("$INSUNITS", 0)))


def _entities(tally: Tally, holder: Any, blocks: tuple[str, ...], layer: str | None) -> Iterator[tuple[Any, str]]:
    """Entities and their layers, inserts replaced by what they show; on layer 0 of a block, the insert's layer."""
    for entity in holder:
        tally.step()
        own = layer if layer is not None and entity.dxf.layer == "0" else entity.dxf.layer
        if entity.dxftype() != "INSERT":
            yield entity, own
            continue
        name = entity.dxf.name
        if name in blocks or len(blocks) >= _DEEPEST:
            raise FileError(f"{tally.source}: the block {name!r} holds itself; draw it again without the inner copy")
        if entity.block() is None or entity.block().block.is_xref:
            tally.passed_over["INSERT of another file"] += 1
            continue
        for copy in entity.multi_insert() if entity.mcount > 1 else (entity,):
            tally.step()
            shown = copy.virtual_entities(skipped_entity_callback=partial(_skipped, tally, name))
            yield from _entities(tally, shown, (*blocks, name), own)


def _skipped(tally: Tally, block: str, entity: Any, reason: str) -> None:
    """Counts what ezdxf cannot show of a block. Raises FileError where it is an outline."""
    kind = entity.dxftype()
    if kind in OUTLINES or kind == "INSERT":
        raise FileError(
            f"{tally.source}: a {kind} of the block {block!r} cannot be shown ({reason}); explode the block"
        )
    tally.passed_over[kind] += 1


def _document(source: str, data: bytes) -> Document:
    """The whole file, unmended. Its end mark is asked for first: what is cut off between two entities parses."""
    try:
        from ezdxf.document import Drawing as Document
        from ezdxf.filemanagement import dxf_stream_info
        from ezdxf.lldxf.tagger import binary_tags_loader
    except ImportError:
        raise MachineError(
            f"{source}: DXF is read by ezdxf, which is missing: pip install 'gearwright[drawing]'"
        ) from None
    binary = data.startswith(_BINARY)
    if not binary and not re.match(rb"\s*(999|0)\s", data.removeprefix(b"\xef\xbb\xbf")):
        raise FileError(f"{source}: this is no DXF file; one begins with a group code, 0 or 999, on a line of its own")
    if not data.rstrip(b"\0\t\r\n \x1a").endswith(b"EOF"):
        raise FileError(f"{source}: this DXF file is cut off: its last mark, EOF, is missing; copy or export it again")
    with _refused(source):
        if binary:
            return Document.load(binary_tags_loader(data, errors="surrogateescape"))
        encoding = dxf_stream_info(io.StringIO(data.decode("latin-1"))).encoding
        return Document.read(io.TextIOWrapper(io.BytesIO(data), encoding=encoding, errors="surrogateescape"))


@contextmanager
def _refused(source: str) -> Iterator[None]:
    """Whatever the parser of a broken file raises, as a FileError."""
    from ezdxf.lldxf.const import DXFError

    try:
        yield
    except (DXFError, *_BROKEN) as e:
        reason = str(e).splitlines()[0][:160] if str(e) else type(e).__name__
        raise FileError(
            f"{source}: this DXF file is damaged ({reason}); export it again, as AutoCAD 2000 or later"
        ) from e


def _refuse_steps(source: str, heights: set[float]) -> None:
    """Outlines in different planes are no section; rounding is no difference."""
    levels = np.array(sorted(heights))
    if len(levels) and not np.ptp(levels) <= 1e-6 * max(1.0, float(np.max(np.abs(levels)))):
        raise FileError(
            f"{source}: the outlines lie at heights from z = {levels[0]:.9g} to {levels[-1]:.9g}; "
            "a section lies in one plane z = constant: flatten the drawing first"
        )
