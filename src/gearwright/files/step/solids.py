"""Solids of a STEP file, and how often it places each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, final

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ...moments.faces import triangle_vectors
from ...moments.polyhedron import polyhedron_moments
from ..contents import Body
from ..instances import expanded
from ..text.places import shown
from .document import Document, Part, subshapes
from .exchange import Found
from .faces import DEFLECTION, triangulated
from .quadrature import smooth_properties

_MILLIMETRES = ("millimetre", "millimeter", "mm")


def found_in(data: bytes, name: str) -> Found:
    """The solids of a STEP file. Raises FileError if it has none; MachineError without the extra `step`."""
    solids = _Solids(Document(data, name), name)
    placements = tuple(solids.placements())
    if not placements:
        raise FileError(
            f"{name}: a STEP file without a solid: {', '.join(solids.remarks()) or 'no shapes'}; join its surfaces to a"
            " solid and export it again"
        )
    return Found(bodies=tuple(solids.bodies), placements=placements, remarks=solids.remarks())


@final
class _Solids:
    """Solids of a document, each cut once however often it is placed."""

    def __init__(self, document: Document, name: str):
        self._document, self._name = document, name
        self.bodies: list[Body] = []
        self._numbers: dict[str, range] = {}
        self._tolerance = 0.0
        self._remarks: list[str] = []
        if document.faults:
            self._remarks.append(
                f"{len(document.faults)} faults in the file, the first is: {document.faults[0].text[:100]}; what needs"
                " the entities concerned may be missing or misplaced"
            )
        other = [unit for unit in document.units if unit not in _MILLIMETRES]
        if other:
            self._remarks.append(f"lengths in {', '.join(other)} converted to millimetres")

    def placements(self) -> Iterator[tuple[int, Array]]:
        """Numbers of solids with their matrices, in the order of the file."""
        for path, matrix in expanded(self._name, self._document.roots(), self._document.children):
            for number in self._of(path[-1]):
                yield number, matrix

    def remarks(self) -> tuple[str, ...]:
        read = f"smooth faces read as triangles within {self._tolerance:.3g} mm ({DEFLECTION:g} of a body's diagonal)"
        return (read, *self._remarks) if self._tolerance else tuple(self._remarks)

    def _of(self, part: Part) -> range:
        """Numbers of the solids of a part."""
        key = self._document.shape_key(part)
        if key not in self._numbers:
            first = len(self.bodies)
            self.bodies.extend(self._bodies_of(part))
            self._numbers[key] = range(first, len(self.bodies))
        return self._numbers[key]

    def _bodies_of(self, part: Part) -> Iterator[Body]:
        from OCP.TopAbs import TopAbs_SOLID

        shape = self._document.shape(part)
        if shape is None:
            return
        solids = list(subshapes(shape, TopAbs_SOLID))
        self._remark_free_faces(shape)
        for solid in solids:
            body = self._body(solid, self._document.name(part, solid))
            if body is not None:
                yield body

    def _remark_free_faces(self, shape: Any) -> None:
        from OCP.TopAbs import TopAbs_FACE, TopAbs_SOLID
        from OCP.TopExp import TopExp_Explorer

        free, count = TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID), 0
        while free.More():
            count += 1
            free.Next()
        if count:
            self._remarks.append(f"{count} faces of no solid left out")

    def _body(self, solid: Any, name: str) -> Body | None:
        cut = triangulated(solid)
        self._tolerance = max(self._tolerance, cut.tolerance)
        if cut.missing:
            self._remarks.append(f'{cut.missing} faces of "{name}" could not be cut into triangles and are missing')
        if not len(cut.triangles):
            return None
        body = Body(
            name=name,
            vertices=cut.vertices,
            indices=cut.triangles.reshape(-1),
            offsets=np.arange(0, cut.triangles.size + 1, 3),
        )
        return self._with_smooth_properties(body, solid, cut.tolerance)

    def _with_smooth_properties(self, body: Body, solid: Any, tolerance: float) -> Body:
        """The body with its smooth properties, unless these differ by more than a layer of the tolerance all over."""
        smooth = smooth_properties(solid)
        volume = polyhedron_moments(body.vertices, body.indices, body.offsets).body.volume
        area = float(np.linalg.norm(triangle_vectors(body.vertices, body.indices.reshape(-1, 3)), axis=1).sum())
        if smooth is None or not abs(smooth.volume - volume) <= tolerance * area:
            found = "none" if smooth is None else f"{smooth.volume:.9g}"
            self._remarks.append(
                f'Open CASCADE\'s quadrature gives "{shown(body.name)}" the volume {found} mm³, its triangles'
                f" {volume:.9g}: a difference that the tolerance does not explain; the quadrature is not used"
            )
            return body
        return replace(body, smooth=smooth)
