"""What a model part of a 3MF file holds: its unit, its objects with meshes or components, and what is built."""

from __future__ import annotations

from dataclasses import dataclass

from ...arrays import Array, Indices


@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """An object placed: the part it is in, its number there, its matrix (4, 4) for points as columns."""

    part: str
    number: int
    matrix: Array
    name: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """Vertices (n, 3) and triangles (m, 3), counter-clockwise seen from outside."""

    vertices: Array
    triangles: Indices


@dataclass(frozen=True, kw_only=True, eq=False)
class Object:
    """A mesh, or other objects placed; `kind` is one of model, solidsupport, support, surface, other."""

    name: str
    kind: str
    mesh: Mesh | None = None
    components: tuple[Reference, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class ModelPart:
    """What a part holds. `length_unit` is a key of LENGTH_UNITS."""

    length_unit: str
    objects: dict[int, Object]
    items: tuple[Reference, ...]
    remarks: tuple[str, ...]
