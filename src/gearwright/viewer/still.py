"""A still picture of an assembly, as the bytes of a PNG file."""

from __future__ import annotations

from base64 import b64encode
from html import escape

from ..colours import STEEL
from ..files.assembly import Assembly, Faceted, placed_vertices
from ..pictures import Body, View, drawn


def still(
    title: str, assembly: Assembly[Faceted], view: View | None, size: tuple[int, int], *, titled: bool = True
) -> bytes:
    """The parts where they stand, of size (width, height) in pixels, with their names where there are several."""
    named = len(assembly.parts) > 1 and titled
    bodies = [
        Body(
            vertices=placed_vertices(part),
            triangles=part.shape.simple_triangles(),
            colour=part.colour or STEEL,
            label=part.name if named else "",
        )
        for part in assembly.parts
    ]
    return drawn(bodies, title if titled else "", view, size, assembly.length_unit or "")


def image(png: bytes, title: str, width: int) -> str:
    """A picture as an HTML element."""
    data = b64encode(png).decode()
    return f'<img src="data:image/png;base64,{data}" alt="{escape(title)}" style="width:{width}px;max-width:100%">'
