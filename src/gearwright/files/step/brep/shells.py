"""Solids from faces that share edges: each connected set of faces is a shell, a shell inside another one its void."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from ..kernel import kernel

_INSIDE = 1e-6


def solid_of(faces: Sequence[Any]) -> Any:
    """The solid that faces bound, or a compound of several; edges and corners take the tolerances of what they join."""
    from OCP.BRep import BRep_Builder
    from OCP.BRepLib import BRepLib
    from OCP.TopoDS import TopoDS_Compound

    solids = _solids([_shell(group) for group in _connected(faces)])
    whole = solids[0]
    if len(solids) > 1:
        builder, whole = BRep_Builder(), TopoDS_Compound()
        builder.MakeCompound(whole)
        for solid in solids:
            builder.Add(whole, solid)
    BRepLib.UpdateTolerances_s(whole, False)
    return whole


def _connected(faces: Sequence[Any]) -> list[list[Any]]:
    """Faces in groups that edges hold together."""
    from OCP.TopAbs import TopAbs_EDGE
    from OCP.TopExp import TopExp

    numbered = kernel().shape_map()
    pairs = []
    for number, one in enumerate(faces):
        own = kernel().shape_map()
        TopExp.MapShapes_s(one, TopAbs_EDGE, own)
        pairs += [(number, numbered.Add(own.FindKey(i))) for i in range(1, own.Extent() + 1)]
    rows, columns = np.array(pairs).T
    size = len(faces) + numbered.Extent() + 1
    graph = coo_array((np.ones(len(rows)), (rows, len(faces) + columns)), shape=(size, size))
    _, labels = connected_components(graph, directed=False)
    groups: dict[int, list[Any]] = {}
    for number, one in enumerate(faces):
        groups.setdefault(int(labels[number]), []).append(one)
    return list(groups.values())


def _shell(faces: Sequence[Any]) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Shell

    builder, shell = BRep_Builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    for one in faces:
        builder.Add(shell, one)
    shell.Closed(True)
    return shell


def _solids(shells: Sequence[Any]) -> list[Any]:
    """Solids of shells that face outward, each with the voids in it."""
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Solid

    builder = BRep_Builder()
    found: list[tuple[float, Any]] = []
    voids: list[Any] = []
    for shell in shells:
        volume = 1.0 if len(shells) == 1 else _volume(shell)
        if volume < 0.0:
            voids.append(shell)
            continue
        solid = TopoDS_Solid()
        builder.MakeSolid(solid)
        builder.Add(solid, shell)
        found.append((volume, solid))
    found.sort(key=lambda one: one[0])
    for void in voids:
        builder.Add(next(solid for _, solid in found if _holds(solid, void)), void)
    return [solid for _, solid in found]


def _volume(shell: Any) -> float:
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shell, found)
    return float(found.Mass())


def _holds(solid: Any, void: Any) -> bool:
    """Whether a corner of the void is in the solid."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepClass3d import BRepClass3d_SolidClassifier
    from OCP.TopAbs import TopAbs_IN, TopAbs_VERTEX
    from OCP.TopExp import TopExp

    corners = kernel().shape_map()
    TopExp.MapShapes_s(void, TopAbs_VERTEX, corners)
    point = BRep_Tool.Pnt_s(kernel().as_vertex(corners.FindKey(1)))
    return bool(BRepClass3d_SolidClassifier(solid, point, _INSIDE).State() == TopAbs_IN)
