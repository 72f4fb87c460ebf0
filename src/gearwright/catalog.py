"""ELEMENTS, MOTIONS, FILE_FORMATS: the lists to extend. Listing them loads none of what they name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from .files.formats import FILE_FORMATS, FileFormat
from .sources import Source, load

__all__ = ["ELEMENTS", "FILE_FORMATS", "MOTIONS", "Element", "FileFormat", "Motion", "Source", "load"]


@dataclass(frozen=True, kw_only=True)
class Element:
    """A kind of part, or a pair of them, that is built from parameters.

    command   the subcommand of the command line that builds it
    members   how many parts it has: 1, or 2 for a pair
    diagram   what draws the diagram of its motion: a function of the element and a path, if there is one
    running   what tells how it runs: a function of the element that gives values by name, if there is one
    origin    what is at the origin of a part's frame
    settled   choices that the command makes by itself, by the parameters' names
    plane     whether it has a plane section, which can be drawn
    """

    name: str
    summary: str
    source: Source
    command: str
    origin: str
    members: Literal[1, 2] = 1
    settled: Mapping[str, str] = field(default_factory=dict)
    plane: bool = False
    diagram: Source | None = None
    running: Source | None = None


@dataclass(frozen=True, kw_only=True)
class Motion:
    """A way in which a section sweeps out a solid."""

    name: str
    summary: str
    source: Source


ELEMENTS = (
    Element(
        name="bevel gear",
        summary="one bevel gear",
        source="gearwright.elements.bevel.bevel_gear:BevelGear",
        command="bevel",
        origin="the apex of the part's cones; +z is its axis, towards the body",
    ),
    Element(
        name="bevel pair",
        summary="a pair in mesh",
        source="gearwright.elements.bevel.bevel_pair:BevelPair",
        command="bevel",
        origin="the apex of the part's cones; +z is its axis, towards the body",
        members=2,
        diagram="gearwright.contact.diagram:draw",
        running="gearwright.contact.running:running",
    ),
    *(
        Element(
            name=f"{kind} pair" if kind != "rack" else "rack and pinion",
            summary=summary,
            source="gearwright.elements.cylindrical.gear_pair:GearPair",
            command=kind,
            origin="on the part's axis, +z, at one end of the teeth; of a rack as for one alone",
            members=2,
            settled={"kind": kind},
            plane=True,
        )
        for kind, summary in {
            "spur": "two spur gears in mesh",
            "helical": "two helical gears in mesh",
            "herringbone": "two herringbone gears in mesh",
            "internal": "a pinion in an internal gear",
            "rack": "a pinion on a rack",
        }.items()
    ),
    Element(
        name="herringbone gear",
        summary="a herringbone gear",
        source="gearwright.elements.cylindrical.herringbone_gear:HerringboneGear",
        command="herringbone",
        origin="on the axis, +z, at one end of the teeth",
        plane=True,
    ),
    Element(
        name="helical gear",
        summary="a helical gear",
        source="gearwright.elements.cylindrical.helical_gear:HelicalGear",
        command="helical",
        origin="on the axis, +z, at one end of the teeth",
        plane=True,
    ),
    Element(
        name="internal gear",
        summary="an internal gear, straight or helical",
        source="gearwright.elements.cylindrical.internal_gear:InternalGear",
        command="internal",
        origin="on the axis, +z, at one end of the teeth",
        plane=True,
    ),
    Element(
        name="rack",
        summary="a rack, straight or helical",
        source="gearwright.elements.cylindrical.rack:Rack",
        command="rack",
        origin="on the pitch plane, below the tip of the first tooth, at one end of the teeth; +x is up",
        plane=True,
    ),
    Element(
        name="spur gear",
        summary="an involute spur gear",
        source="gearwright.elements.cylindrical.spur_gear:SpurGear",
        command="spur",
        origin="on the axis, +z, at one end of the teeth",
        plane=True,
    ),
    Element(
        name="sweep",
        summary="a plane section extruded, swept along a path in space, or revolved",
        source="gearwright.elements.sweep:Sweep",
        command="sweep",
        origin="the section's, where a straight sweep along +z starts; that of the path's points; for a revolution on"
        " its axis, +z",
        plane=True,
    ),
    Element(
        name="cam",
        summary="a plane disk cam for a follower with a flat face or a roller",
        source="gearwright.elements.cams.cam:Cam",
        command="cam",
        origin="on the axis, +z, at one face of the disk; the follower starts on +x",
        diagram="gearwright.elements.cams.diagram:draw",
        plane=True,
    ),
)

MOTIONS = (
    Motion(
        name="straight",
        summary="a plane section extruded along its normal",
        source="gearwright.motions.straight:Straight",
    ),
    Motion(
        name="extrusion",
        summary="a plane section extruded with twist, scaling and skew",
        source="gearwright.motions.extrusion:Extrusion",
    ),
    Motion(
        name="herringbone",
        summary="a plane section twisted to the middle of the length and back",
        source="gearwright.motions.herringbone:Herringbone",
    ),
    Motion(
        name="transforming",
        summary="a plane section extruded while any smooth transform maps its plane",
        source="gearwright.motions.transforming:Transforming",
    ),
    Motion(
        name="along",
        summary="a plane section swept along a path in space",
        source="gearwright.motions.along:Along",
    ),
    Motion(
        name="revolution",
        summary="a section of the half-plane revolved about its axis",
        source="gearwright.motions.revolution:Revolution",
    ),
    Motion(
        name="radial",
        summary="a section of the sphere swept from the apex, turning as a tooth trace says",
        source="gearwright.motions.radial:Radial",
    ),
)
