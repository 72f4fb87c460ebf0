"""Where the first of several edges, faces or vertices is, in words; empty where there is none."""

from __future__ import annotations

from ...arrays import Array, Indices

_PLURALS = {"vertex": "vertices"}


def counted(count: int, noun: str, first: str) -> str:
    """How many there are and the first: "3 faces, the first 7 near (0, 0, 1)"."""
    if not count:
        return ""
    if count == 1:
        return f"1 {noun}, {first}"
    head, _, last = noun.rpartition(" ")
    return f"{count} {head} {_PLURALS.get(last, last + 's')}, the first {first}".replace("  ", " ")


def edge_place(vertices: Array, edges: Indices) -> str:
    """Ends and middle of the first of edges (k, 2)."""
    if not len(edges):
        return ""
    a, b = edges[0]
    return f"between vertices {a} and {b}, near {_point(vertices[a] / 2.0 + vertices[b] / 2.0)}"


def face_place(vertices: Array, indices: Indices, offsets: Indices, faces: Indices) -> str:
    """Number of the first of faces (k,) and the mean of its corners."""
    if not len(faces):
        return ""
    corners = vertices[indices[offsets[faces[0]] : offsets[faces[0] + 1]]]
    return f"{faces[0]} near {_point(corners[0] + (corners - corners[0]).mean(axis=0))}"


def vertex_place(vertices: Array, chosen: Indices) -> str:
    """Number and coordinates of the first of vertices (k,)."""
    return f"{chosen[0]} at {_point(vertices[chosen[0]])}" if len(chosen) else ""


def _point(point: Array) -> str:
    x, y, z = point
    return f"({x:.6g}, {y:.6g}, {z:.6g})"
