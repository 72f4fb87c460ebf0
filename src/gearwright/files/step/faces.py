"""Triangles of a solid: its faces cut to a tolerance, with the points of common edges and vertices shared.

The cut of an edge is decided once for both faces, which hold it as lists of their own nodes. These lists, not
distances, say which nodes are one point: seams join a face with itself, degenerate edges make a pole of many nodes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from ...arrays import Array, Indices
from .document import subshapes
from .kernel import kernel

DEFLECTION = 1e-4
"""Largest distance of a chord from its edge or of a triangle from its face, in diagonals of the bounding box."""

_TURN = 0.5
"""Largest angle between neighbouring chords, in radians: small fillets keep a few chords."""


class Triangulated(NamedTuple):
    """Vertices (n, 3), triangles (m, 3), the tolerance in millimetres, faces that could not be cut."""

    vertices: Array
    triangles: Indices
    tolerance: float
    missing: int


class _Joints:
    """Pairs of numbers that are one point: nodes of faces from 0 up, points of edges and vertices from −1 down."""

    def __init__(self) -> None:
        self.pairs: list[tuple[int, int]] = []
        self._points: dict[tuple[int, int], int] = {}

    def point(self, owner: int, place: int) -> int:
        return self._points.setdefault((owner, place), -1 - len(self._points))


def triangulated(solid: Any) -> Triangulated:
    """A solid's triangles, counter-clockwise seen from outside where the solid is; closed where the solid is."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.BRepTools import BRepTools
    from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_REVERSED, TopAbs_VERTEX
    from OCP.TopExp import TopExp
    from OCP.TopLoc import TopLoc_Location

    tolerance = DEFLECTION * _diagonal(solid)
    BRepTools.Clean_s(solid)  # what the file may bring, cut by other rules
    BRepMesh_IncrementalMesh(solid, tolerance, False, _TURN, False)
    numbered = kernel().shape_map()
    TopExp.MapShapes_s(solid, TopAbs_EDGE, numbered)
    TopExp.MapShapes_s(solid, TopAbs_VERTEX, numbered)
    nodes: list[tuple[float, float, float]] = []
    triangles: list[Indices] = []
    joints, missing = _Joints(), 0
    for shape in subshapes(solid, TopAbs_FACE):
        location = TopLoc_Location()
        cut = BRep_Tool.Triangulation_s(kernel().as_face(shape), location)
        if cut is None or not cut.NbTriangles():
            missing += 1
            continue
        first = len(nodes) - 1  # its nodes are numbered from 1
        for edge in subshapes(shape, TopAbs_EDGE):
            _join(joints, numbered, kernel().as_edge(edge), cut, location, first)
        map_ = location.Transformation()
        points = (cut.Node(number).Transformed(map_) for number in range(1, cut.NbNodes() + 1))
        nodes.extend((point.X(), point.Y(), point.Z()) for point in points)
        corners = np.array([cut.Triangle(number).Get() for number in range(1, cut.NbTriangles() + 1)]) + first
        turned = (shape.Orientation() == TopAbs_REVERSED) != map_.IsNegative()
        triangles.append(corners[:, ::-1] if turned else corners)
    if not triangles:
        return Triangulated(np.empty((0, 3)), np.empty((0, 3), np.int64), tolerance, missing)
    vertices, shared = _shared(np.array(nodes), joints.pairs, np.concatenate(triangles))
    return Triangulated(vertices, shared, tolerance, missing)


def _join(joints: _Joints, numbered: Any, edge: Any, cut: Any, location: Any, first: int) -> None:
    """Notes which points of an edge the nodes of a face along it are."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_FORWARD
    from OCP.TopExp import TopExp

    along = BRep_Tool.PolygonOnTriangulation_s(edge, cut, location)
    if along is None:
        return
    forward = kernel().as_edge(edge.Oriented(TopAbs_FORWARD))
    ends = [numbered.FindIndex(end(forward)) for end in (TopExp.FirstVertex_s, TopExp.LastVertex_s)]
    owner, count, degenerate = numbered.FindIndex(edge), along.NbNodes(), BRep_Tool.Degenerated_s(edge)
    for place in range(1, count + 1):
        if degenerate or place == 1:
            point = joints.point(ends[0], 0)
        else:
            point = joints.point(ends[1], 0) if place == count else joints.point(owner, place)
        joints.pairs.append((first + along.Node(place), point))


def _shared(nodes: Array, pairs: list[tuple[int, int]], triangles: Indices) -> tuple[Array, Indices]:
    """Vertices and triangles in which nodes that are one point are one vertex; triangles that this closes are gone."""
    joined = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    joined[:, 1] = len(nodes) - 1 - joined[:, 1]
    size = len(nodes) + len(pairs)
    graph = coo_array((np.ones(len(joined), bool), (joined[:, 0], joined[:, 1])), shape=(size, size))
    _, group = connected_components(graph, directed=False)
    corners = group[triangles]
    closed = (corners == np.roll(corners, 1, axis=1)).any(axis=1)
    used, shared = np.unique(corners[~closed], return_inverse=True)
    _, member = np.unique(group[: len(nodes)], return_index=True)
    representative = np.zeros(group.max() + 1, np.int64)
    representative[group[member]] = member
    return nodes[representative[used]], shared.reshape(-1, 3)


def _diagonal(solid: Any) -> float:
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.Add_s(solid, box, False)
    return 0.0 if box.IsVoid() else float(box.SquareExtent()) ** 0.5
