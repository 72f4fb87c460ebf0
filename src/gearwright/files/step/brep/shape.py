"""A boundary as a solid of Open CASCADE: closed shells of faces that share edges, nothing sewn, nothing cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from ....arrays import Array
from ....boundary.boundary import Boundary
from ....boundary.pattern import ALONE, Pattern
from ....placement import Placement
from ..kernel import kernel
from .approximation import approximation
from .edges import Edges, Image, transform
from .faces import Use, face
from .seams import joined
from .shells import solid_of
from .templates import OnRound, Part, Template, of_cap, of_patch

_ON_CUT = 1e-12


def shape(boundary: Boundary, tolerance: float) -> Any:
    """The solid, its faces within a tolerance (length) of the boundary's; a compound where there are several.

    Raises GeometryError where the tolerance cannot be met; MachineError without the extra `step`.
    """
    kernel()
    found = approximation(boundary, tolerance)
    templates = [(of_patch(patch, found), patch.pattern) for patch in boundary.patches]
    templates += [(of_cap(cap, tolerance), ALONE) for cap in boundary.caps]
    edges = Edges(found, _cuts(template for template, _ in templates))
    return solid_of([made for template, pattern in templates for made in _images(template, pattern, edges)])


def together(shapes: Iterable[tuple[Any, Array]]) -> Any:
    """A compound of shapes put in their places by matrices (4, 4). Raises MachineError without the extra `step`."""
    kernel()
    from OCP.BRep import BRep_Builder
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS_Compound

    builder, whole = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(whole)
    for one, matrix in shapes:
        place = transform(Placement.of(matrix[:3, :3], matrix[:3, 3]))
        builder.Add(whole, one.Moved(TopLoc_Location(place)))
    return whole


def _cuts(templates: Iterable[Template]) -> dict[Image, list[float]]:
    """Where seams end inside edges."""
    cuts: dict[Image, list[float]] = {}
    for ref in (ref for template in templates for ref in template.refs):
        known = cuts.setdefault((ref.edge, ref.image), [])
        known += [f for f in (ref.first, ref.last) if 0.0 < f < 1.0 and f not in known]
    return cuts


def _images(template: Template, pattern: Pattern, edges: Edges) -> Iterator[Any]:
    """The faces of all images."""
    surface, loops = template.surface.made(), template.loops(edges)
    for k in range(pattern.order):
        placed = surface.Transformed(transform(pattern.image(k))) if k else surface
        wires = [[use for part in loop for use in _uses(part, k, edges)] for loop in loops]
        if isinstance(template, OnRound) and template.layout.seam is not None:
            count = len(template.layout.around)
            wires = [list(joined(template.layout, template.layout.seam, wires[:count], edges)), *wires[count:]]
        yield face(placed, wires, outward=template.outward)


def _uses(part: Part, k: int, edges: Edges) -> list[Use]:
    """The pieces of image k of a part of an edge, along the loop."""
    ref = part.ref
    if ref.edge.degenerate:
        if part.curve is None:
            return []
        point = edges.vertex(ref.edge.start, ref.image + k)
        return [Use(made=edges.at_a_point(point), reverse=ref.reverse, on_surface=part.curve)]
    pieces = [
        piece
        for piece in edges.pieces(ref.edge, ref.image + k)
        if piece.first >= ref.first - _ON_CUT and piece.last <= ref.last + _ON_CUT
    ]
    uses = [Use(made=p.made, reverse=ref.reverse, on_surface=part.curve, deviation=part.deviation) for p in pieces]
    return uses[::-1] if ref.reverse else uses
