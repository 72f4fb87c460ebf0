"""What a command has built: parts with their placements and properties, and the pair they make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol

from .. import catalog
from ..arrays import Array
from ..boundary.boundary import Boundary
from ..elements.assembly import PlacedPart, placed_parts
from ..files.robots.mechanism import Mechanism
from ..materials import density as kernel_density
from ..parameters import Size
from ..solids.convergence import ApproximationError
from ..solids.polyhedron import Polyhedron
from ..solids.properties import MassProperties
from .members import members, placements


class Gear(Protocol):
    """An element that is one part."""

    @property
    def length_unit(self) -> str: ...
    @property
    def upward(self) -> Literal[1, -1]: ...
    @property
    def description(self) -> str: ...
    @property
    def boundary(self) -> Boundary: ...
    @property
    def findings(self) -> dict[str, Any]: ...
    @property
    def smooth_tolerance(self) -> float | None: ...
    def sizes(self) -> dict[str, Size]: ...
    def beside(self, density: float = 1.0) -> dict[str, MassProperties]: ...
    def properties(self, density: float = 1.0) -> MassProperties: ...
    def polyhedron(self, tolerance: float | None = None) -> Polyhedron: ...
    def mechanism(self, name: str, density: str | float, tolerance: float | None = None) -> Mechanism: ...


class Pair(Protocol):
    """An element that is two gears in mesh."""

    @property
    def description(self) -> str: ...
    @property
    def pinion(self) -> Gear: ...
    @property
    def gear(self) -> Gear: ...
    def sizes(self) -> dict[str, Size]: ...
    def placements(self, turn: float = 0.0) -> tuple[Array, Array]: ...


@dataclass(frozen=True, kw_only=True)
class Units:
    """Units of what is shown. Without a density mass is volume, in cubed length units.

    has_volume   False of surfaces that have a mass per area, but no thickness
    """

    length: str
    mass: str
    has_volume: bool = True

    @property
    def has_mass(self) -> bool:
        return self.mass == "kg"


def units_and_density(length_unit: str, density: float | None) -> tuple[Units, float]:
    """Units of the properties and density in mass per cubed length unit, from kg/m³ or None."""
    if density is None:
        return Units(length=length_unit, mass=f"{length_unit}^3"), 1.0
    return Units(length=length_unit, mass="kg"), kernel_density(density, length_unit=length_unit)


@dataclass(frozen=True, kw_only=True)
class Part:
    """One part. placement (4, 4) puts it in mesh; the identity for a single part.

    beside        properties of approximations by name, shown beside its own
    convergence   errors of its polyhedra by what is refined, where they are asked for
    """

    gear: Gear
    placement: Array
    properties: MassProperties
    beside: Mapping[str, MassProperties] = field(default_factory=dict)
    convergence: Mapping[str, ApproximationError] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Built:
    """Parts by name, pinion first, and the pair they make, None for a single part.

    kind     the catalog's name
    origin   what is at the origin of each part's frame
    running  how the pair runs, where that is asked for: values by name
    """

    kind: str
    origin: str
    parts: Mapping[str, Part]
    pair: Any
    pair_sizes: Mapping[str, Size]
    units: Units
    running: Mapping[str, Size] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """What a picture of it says."""
        (first, *_) = self.parts.values()
        element: Gear | Pair = first.gear if self.pair is None else self.pair
        return f"{self.kind}: {element.description}"

    def placed(self, tolerance: float | None = None, clearance: float = 0.0) -> list[PlacedPart]:
        """Its parts to be written or drawn, as of `elements.assembly.placed_parts`."""
        gears = {name: part.gear for name, part in self.parts.items()}
        return placed_parts(gears, [part.placement for part in self.parts.values()], tolerance, clearance)


def built_from(kind: catalog.Element, element: Any, density: float | None, turn: float = 0.0) -> Built:
    """What an element of the catalog is made of, with density in kg/m³ or None, a pair's pinion turned by degrees."""
    gears: dict[str, Gear] = members(kind, element)
    units, own_density = units_and_density(element.length_unit, density)
    parts = {
        name: Part(
            gear=gear,
            placement=placement,
            properties=gear.properties(own_density),
            beside=gear.beside(own_density),
        )
        for (name, gear), placement in zip(gears.items(), placements(kind, element, turn), strict=True)
    }
    pair = element if kind.members == 2 else None
    return Built(
        kind=kind.name,
        origin=kind.origin,
        parts=parts,
        pair=pair,
        pair_sizes=pair.sizes() if pair else {},
        units=units,
    )
