"""What Open CASCADE finds in a STEP file: solids, faces, edges, properties; nothing of it is our own."""

from __future__ import annotations

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepTools import BRepTools
from OCP.Geom import Geom_BSplineSurface, Geom_SurfaceOfLinearExtrusion, Geom_SurfaceOfRevolution
from OCP.GProp import GProp_GProps
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

from gearwright.files.step.kernel import kernel

FREE = (Geom_BSplineSurface, Geom_SurfaceOfLinearExtrusion, Geom_SurfaceOfRevolution)


def read(path):
    """The shape in a file, lengths in millimetres."""
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)).value == 1
    reader.TransferRoots()
    return reader.OneShape()


def subshapes(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def solids(shape):
    return list(subshapes(shape, TopAbs_SOLID))


def faces(shape):
    return [TopoDS.Face(face) for face in subshapes(shape, TopAbs_FACE)]


def surfaces(shape):
    """Of each face."""
    return [BRep_Tool.Surface_s(face) for face in faces(shape)]


def is_valid(shape):
    return BRepCheck_Analyzer(shape).IsValid()


def edge_uses(shape):
    """How often each edge is used by faces; a seam or a pole, which one face has alone, as often as it has it."""
    known, counts = kernel().shape_map(), {}
    for edge in subshapes(shape, TopAbs_EDGE):
        number = known.Add(edge)
        counts[number] = counts.get(number, 0) + 1
    return [(TopoDS.Edge(known.FindKey(number)), count) for number, count in counts.items()]


def properties(shape):
    """Volume, centroid (3,) and central inertia (3, 3) by the plain Gauss rule that most programs call."""
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, found)
    centre, matrix = found.CentreOfMass(), found.MatrixOfInertia()
    inertia = np.array([[matrix.Value(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)])
    return found.Mass(), np.array([centre.X(), centre.Y(), centre.Z()]), inertia


def points_of(surface, u, v):
    """Points (n, 3) at parameters (n,)."""
    found = [surface.Value(a, b) for a, b in zip(u.tolist(), v.tolist(), strict=True)]
    return np.array([(p.X(), p.Y(), p.Z()) for p in found])


def free_points(shape, most, random):
    """Points (n, 3) on faces that are nothing elementary, a few each, of at most so many faces."""
    free = [face for face in faces(shape) if isinstance(BRep_Tool.Surface_s(face), FREE)]
    chosen = random.permutation(len(free))[:most]
    parts = [np.empty((0, 3))]
    for k in chosen.tolist():
        u0, u1, v0, v1 = BRepTools.UVBounds_s(free[k])
        u, v = random.random((2, 12))
        parts.append(points_of(BRep_Tool.Surface_s(free[k]), u0 + u * (u1 - u0), v0 + v * (v1 - v0)))
    return np.concatenate(parts)
