"""DXF files of profiles: lines, arcs, circles, ellipses and splines on one layer a profile."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import MachineError
from .contours import Contour
from .primitives import Free, Primitive, Round, Straight, degrees
from .strokes import Hand

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts.base import BaseLayout

HAND = Hand(degree=10, rational=True)
"""Splines of a higher degree are refused by AutoCAD."""

_UNITS: Mapping[str, int] = {"mm": 4, "in": 1}
"""$INSUNITS of the header."""

_VERSION = "R2010"


def encoded(source: str, layers: Mapping[str, Sequence[Contour]], corners: Array, length_unit: str) -> bytes:
    """The bytes of a DXF file of contours by layer; corners (2, 2) are the least and largest x and y of them all.

    Raises MachineError where ezdxf is not installed.
    """
    document = new_document(source, length_unit)
    space = document.modelspace()
    for layer, drawn in layers.items():
        if layer not in document.layers:
            document.layers.add(layer)
        for contour in drawn:
            for one in contour:
                add(space, one, {"layer": layer})
    low, high = ((float(x), float(y)) for x, y in corners)
    space.reset_extents((*low, 0.0), (*high, 0.0))
    middle = (low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0
    document.set_modelspace_vport(height=1.1 * max(high[0] - low[0], high[1] - low[1]), center=middle)
    return document_bytes(document)


def new_document(source: str, length_unit: str) -> Drawing:
    """An empty document for a file. Raises MachineError where ezdxf is not installed."""
    try:
        from ezdxf.filemanagement import new
    except ImportError:
        raise MachineError(
            f"{source}: DXF is written by ezdxf, which is missing: pip install 'gearwright[drawing]'"
        ) from None
    return new(_VERSION, units=_UNITS[length_unit])


def document_bytes(document: Drawing) -> bytes:
    """What a document's file holds."""
    text = io.StringIO()
    document.write(text)
    return document.encode(text.getvalue())


def add(space: BaseLayout, one: Primitive, attributes: dict[str, Any]) -> None:
    """Adds a primitive as the entity it is, with DXF attributes such as its layer."""
    match one:
        case Straight():
            space.add_line(_xy(one.start), _xy(one.end), attributes)
        case Round():
            _add_round(space, one, attributes)
        case Free():
            spline = space.add_spline(degree=one.degree, dxfattribs=attributes)
            knots, control = clamped(one)
            spline.control_points = [(*_xy(point), 0.0) for point in control]
            spline.knots = knots.tolist()
            if one.weights is not None:
                spline.weights = one.weights.tolist()


def _add_round(space: BaseLayout, arc: Round, attributes: dict[str, Any]) -> None:
    """DXF runs counter-clockwise; an arc that runs the other way is written from its end to its start."""
    first, last = (arc.first, arc.first + arc.sweep)[:: 1 if arc.sweep > 0.0 else -1]
    centre = _xy(arc.centre)
    if not arc.circular:
        first = 0.0 if arc.whole else first % (2.0 * np.pi)
        last = 2.0 * np.pi if arc.whole else first + abs(arc.sweep)
        space.add_ellipse(centre, _xy(arc.major), arc.ratio, first, last, attributes)
    elif arc.whole:
        space.add_circle(centre, float(arc.major[0]), attributes)
    else:
        space.add_arc(centre, float(arc.major[0]), degrees(first), degrees(last), dxfattribs=attributes)


def clamped(free: Free) -> tuple[Array, Array]:
    """Knots and control points (n, 2) of the B-spline that a chain of Bézier curves is.

    Joints lie on the line between the control points before and after them, and follow from these by the lengths
    of the knot intervals, which are in the proportion of the handles: the B-spline is continuously differentiable.
    """
    p, control = free.degree, free.control
    before = np.linalg.norm(control[:-1, -1] - control[:-1, -2], axis=1)
    after = np.linalg.norm(control[1:, 1] - control[1:, 0], axis=1)
    first = float(np.linalg.norm(np.diff(control[0], axis=0), axis=1).sum())
    ends = np.cumsum(first * np.cumprod([1.0, *(after / before)]))
    knots = np.concatenate([np.zeros(p + 1), np.repeat(ends[:-1], p - 1), np.repeat(ends[-1], p + 1)])
    return knots, np.concatenate([control[0, :1], *control[:, 1:-1], control[-1, -1:]])


def _xy(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])
