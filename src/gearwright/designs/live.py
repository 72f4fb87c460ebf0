"""What a page is told of a design, bit by bit, what is wanted first before the rest: job of a worker."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from .. import catalog
from ..errors import GeometryError
from .approximation import approximations
from .document import built_document, plain
from .drawn import drawn
from .overlays import overlays
from .requested import requested
from .texts import texts

Answer = bytes | dict[str, Any]


def answers(request: Mapping[str, Any]) -> Iterator[Answer]:
    """The shape, as `viewer.frame` has it; then sizes and properties, properties of the polyhedron, what is drawn over.

    request   "design": names and values; "density": kg/m³, or "material": its name; "have": keys of topologies that
              the page has already; "id": what the shape is told with, by which the page knows what it answers;
              "part": "shape" for that alone, "rest" for the others

    What has no shape to be drawn, or no polyhedron, at the tolerances that these have, is told without.

    Raises GearwrightError where the design cannot be built, or the density is none.
    """
    wanted = requested(request)
    kind, element = wanted.design.kind, wanted.element
    part = request.get("part")
    if part != "rest":
        yield _shape(kind, element, request)
    if part == "shape":
        return
    built = wanted.built()
    yield {
        "answer": "values",
        "document": plain(built_document(built)),
        "origin": kind.origin,
        "remarks": list(element.remarks),
        "texts": texts(wanted.design, request.get("density"), request.get("material")),
    }
    yield {"answer": "overlays", **overlays(kind, built)}
    try:
        yield {"answer": "approximation", **plain(approximations(built, wanted.kilograms))}
    except GeometryError as error:
        yield {"answer": "approximation", "parts": {}, "errors": {}, "triangles": {}, "missing": str(error)}


def _shape(kind: catalog.Element, element: Any, request: Mapping[str, Any]) -> Answer:
    try:
        return drawn(kind, element, request.get("id"), frozenset(request.get("have", ())))
    except GeometryError as error:
        return {"answer": "undrawn", "text": f"This cannot be drawn, only computed. {error}"}
