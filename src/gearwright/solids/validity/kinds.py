"""What can be wrong with the faces of a polyhedron: names, texts, and what an answer all the same would mean."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal, NamedTuple, get_args

from ...errors import ParameterError, Problem

ProblemKind = Literal["open", "flipped", "one-sided", "repeated", "inward", "nested", "nonplanar"]
"""Problems that `Polyhedron.properties` can be told to allow."""

PROBLEM_KINDS: tuple[ProblemKind, ...] = get_args(ProblemKind)


class Text(NamedTuple):
    """What is said of a kind: usual cause and cure, programs that mend it, what allowing it means."""

    cause: str
    mends: str
    allowed: str = ""

    @property
    def message(self) -> str:
        return f"{self.cause}; {self.mends}" if self.mends else self.cause


_CONE = "the boundary is closed by triangles from its unpaired edges to the centre of the bounding box"

PROBLEMS: dict[str, Text] = {
    "open": Text(
        "every edge needs a face on both sides; usual causes are missing faces and corners that should share a vertex"
        " but are written with different coordinates",
        "MeshLab: Filters > Cleaning and Repairing > Merge Close Vertices, then Filters > Remeshing, Simplification and"
        " Reconstruction > Close Holes; Blender: Mesh > Merge > By Distance, then Mesh > Clean Up > Fill Holes",
        f"{_CONE}: another point would give another volume",
    ),
    "flipped": Text(
        "neighbouring faces must run along their common edge in opposite senses; the usual cause is single faces turned"
        " the other way; reverse the order of their corners",
        "Blender: Mesh > Normals > Recalculate Outside; FreeCAD: Meshes > Analyze > Evaluate and Repair Mesh",
        f"each counts as it is turned; {_CONE}",
    ),
    "one-sided": Text(
        "they cannot be turned so that neighbours agree: along them one comes round to the other side, as on a Möbius"
        " strip; the usual cause is faces joined crosswise",
        "take out the faces that cross, and close the hole anew (Blender: Mesh > Clean Up > Fill Holes)",
        f"each face counts as it is turned; {_CONE}",
    ),
    "repeated": Text(
        "an earlier face has the same corners in the same order, and their volume counts twice; the usual cause is a"
        " body exported twice; leave one of them out",
        "MeshLab: Filters > Cleaning and Repairing > Remove Duplicate Faces",
        "each counts as often as it is there",
    ),
    "inward": Text(
        "corners must run counter-clockwise seen from outside; the usual cause is a mirrored body; reverse the order of"
        " the corners in all its faces (faces[:, ::-1])",
        "Blender: Mesh > Normals > Recalculate Outside",
        "their volume is taken away; where all turn inward, they are taken the other way round",
    ),
    "nested": Text(
        "their volume would count twice; a void must be turned inward (faces[:, ::-1]), bodies that overlap or lie in"
        " one another must be united first",
        "Blender: Mesh > Normals > Flip for a void, the Boolean modifier for bodies",
        "what lies in several bodies counts once for each",
    ),
    "nonplanar": Text(
        "such a face has no single volume; split it into triangles",
        "Blender: Face > Triangulate Faces; Mesh > Clean Up > Split Non-Planar Faces",
        "each is the fan of triangles from the mean of its corners",
    ),
    "flat": Text("must be positive; its faces lie in one plane or cancel", ""),
    "empty": Text("at least 4 are needed", ""),
}

REMARKS: dict[str, Text] = {
    "non-manifold": Text(
        "more than two faces meet there, as where bodies touch along an edge; properties are right, but programs that"
        " need one neighbour an edge refuse",
        "move the bodies apart, or unite them",
    ),
    "pinched": Text(
        "faces round them form more than one fan, as where bodies touch at a point; properties are right",
        "give each fan a vertex of its own",
    ),
    "back-to-back": Text(
        "an earlier face has the same corners in the opposite order: a wall without thickness; properties are right",
        "leave both out (Blender: Mesh > Delete > Only Faces) where bodies should be one",
    ),
    "degenerate": Text(
        "they have no area, or one corner twice in a row; properties are right",
        "MeshLab: Filters > Cleaning and Repairing > Remove Zero Area Faces; Blender: Mesh > Clean Up > Degenerate"
        " Dissolve",
    ),
    "unused": Text(
        "no face has them; properties are right",
        "MeshLab: Filters > Cleaning and Repairing > Remove Unreferenced Vertices; Blender: Mesh > Clean Up > Delete"
        " Loose",
    ),
}


def require_kinds(allow: Collection[str]) -> tuple[ProblemKind, ...]:
    """The kinds that are allowed, in the order of the table. Raises ParameterError if a name is none of them."""
    names = [allow] if isinstance(allow, str) else list(allow)
    unknown = [name for name in names if name not in PROBLEM_KINDS]
    if unknown or isinstance(allow, str):
        raise ParameterError(
            "Properties", [Problem(f"allow = {allow!r}", f"a tuple of some of {', '.join(PROBLEM_KINDS)} is needed")]
        )
    return tuple(kind for kind in PROBLEM_KINDS if kind in names)
