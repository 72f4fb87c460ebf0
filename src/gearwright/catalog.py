"""ELEMENTS, MOTIONS, FILE_FORMATS: the lists to extend. Listing them loads none of what they name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from .files.formats import FILE_FORMATS, FileFormat
from .sources import Source, load

__all__ = ["ELEMENTS", "FILE_FORMATS", "MOTIONS", "Element", "FileFormat", "Motion", "Plot", "Source", "load"]


@dataclass(frozen=True, kw_only=True)
class Plot:
    """A chart that is made of an element. source   a function of the element that gives a Chart"""

    name: str
    title: str
    source: Source


@dataclass(frozen=True, kw_only=True)
class Element:
    """A kind of part, or a pair of them, that is built from parameters.

    command   the subcommand of the command line that builds it
    members   how many parts it has: 1, or 2 for a pair
    mate      what people call a pair's second member, whose name for programs is "gear"
    diagram   what draws the diagram of its motion: a function of the element and a path, if there is one
    running   what tells how it runs: a function of the element that gives values by name, if there is one
    origin    what is at the origin of a part's frame
    settled   choices that the command makes by itself, by the parameters' names
    lines     what tells the lines along which a pair touches over a pitch: a function of the element
    start     values of a good example, to begin a design with
    plane     whether it has a plane section, which can be drawn
    plots     the charts that a page shows of it
    """

    name: str
    summary: str
    source: Source
    command: str
    origin: str
    members: Literal[1, 2] = 1
    mate: str = "gear"
    settled: Mapping[str, str] = field(default_factory=dict)
    start: Mapping[str, Any] = field(default_factory=dict)
    plane: bool = False
    diagram: Source | None = None
    running: Source | None = None
    plots: tuple[Plot, ...] = ()
    lines: Source | None = None


@dataclass(frozen=True, kw_only=True)
class Motion:
    """A way in which a section sweeps out a solid."""

    name: str
    summary: str
    source: Source


_CONVERGENCE = Plot(
    name="convergence", title="Errors of polyhedra", source="gearwright.elements.convergence_chart:convergence"
)
_TEETH = (
    Plot(name="profile", title="Transverse profile", source="gearwright.elements.cylindrical.charts:profile"),
    _CONVERGENCE,
)
_BEVEL_TEETH = (
    Plot(
        name="profile", title="Tooth profile on the mean back cone", source="gearwright.elements.bevel.charts:profile"
    ),
    Plot(name="spiral-angle", title="Spiral angle along the face", source="gearwright.elements.bevel.charts:spiral"),
)
_RUNNING = (
    Plot(name="transmission-error", title="Transmission error", source="gearwright.contact.charts:errors"),
    Plot(name="contact-lines", title="Lines of contact", source="gearwright.contact.charts:contact_lines"),
    Plot(name="contact-length", title="Length of the lines of contact", source="gearwright.contact.charts:lengths"),
)
_CAM = (
    Plot(name="profile", title="Disk and follower", source="gearwright.elements.cams.charts:profile"),
    Plot(name="cam-displacement", title="Displacement", source="gearwright.elements.cams.charts:displacement"),
    Plot(name="cam-velocity", title="Velocity", source="gearwright.elements.cams.charts:velocity"),
    Plot(name="cam-acceleration", title="Acceleration", source="gearwright.elements.cams.charts:acceleration"),
    Plot(name="pressure-angle", title="Pressure angle", source="gearwright.elements.cams.charts:pressure_angle"),
    Plot(name="curvature-radius", title="Radius of curvature", source="gearwright.elements.cams.charts:curvature"),
)
_SIZES = {"module": 2.0, "face_width": 16.0}
"""Of the gears that designs begin with."""

ELEMENTS = (
    Element(
        name="bevel gear",
        summary="one bevel gear",
        source="gearwright.elements.bevel.bevel_gear:BevelGear",
        command="bevel",
        origin="the apex of the part's cones; +z is its axis, towards the body",
        plots=(*_BEVEL_TEETH, _CONVERGENCE),
        start={"teeth": 16, "mate_teeth": 24, "module": 4.0, "face_width": 20.0},
    ),
    Element(
        name="bevel pair",
        summary="a pair in mesh",
        source="gearwright.elements.bevel.bevel_pair:BevelPair",
        command="bevel",
        origin="the apex of the part's cones; +z is its axis, towards the body",
        start={"teeth": (16, 24), "module": 4.0, "face_width": 20.0, "trace": "logarithmic", "spiral_angle": 35.0},
        members=2,
        diagram="gearwright.contact.diagram:draw",
        running="gearwright.contact.running:running",
        plots=(*_BEVEL_TEETH, *_RUNNING, _CONVERGENCE),
        lines="gearwright.contact.lines:lines_over_a_pitch",
    ),
    *(
        Element(
            name=f"{kind} pair" if kind != "rack" else "rack and pinion",
            mate="gear" if kind != "rack" else "rack",
            summary=summary,
            source="gearwright.elements.cylindrical.gear_pair:GearPair",
            command=kind,
            origin="on the part's axis, +z, at one end of the teeth; of a rack as for one alone",
            members=2,
            settled={"kind": kind},
            start={**_SIZES, **start},
            plane=True,
            plots=_TEETH,
            lines="gearwright.contact.plane_of_action:lines_over_a_pitch",
        )
        for kind, summary, start in (
            ("spur", "two spur gears in mesh", {"teeth": (17, 40), "bore": (8.0, 16.0)}),
            ("helical", "two helical gears in mesh", {"teeth": (17, 40), "helix_angle": 20.0, "bore": (8.0, 16.0)}),
            ("herringbone", "two herringbone gears in mesh", {"teeth": (17, 40), "helix_angle": 30.0}),
            ("internal", "a pinion in an internal gear", {"teeth": (18, 54), "bore": (8.0, None)}),
            ("rack", "a pinion on a rack", {"teeth": (18, 14), "bore": (8.0, None)}),
        )
    ),
    Element(
        name="herringbone gear",
        summary="a herringbone gear",
        source="gearwright.elements.cylindrical.herringbone_gear:HerringboneGear",
        command="herringbone",
        origin="on the axis, +z, at one end of the teeth",
        start={**_SIZES, "teeth": 24, "helix_angle": 30.0, "bore": 12.0},
        plane=True,
        plots=_TEETH,
    ),
    Element(
        name="helical gear",
        summary="a helical gear",
        source="gearwright.elements.cylindrical.helical_gear:HelicalGear",
        command="helical",
        origin="on the axis, +z, at one end of the teeth",
        start={**_SIZES, "teeth": 24, "helix_angle": 20.0, "bore": 12.0},
        plane=True,
        plots=_TEETH,
    ),
    Element(
        name="internal gear",
        summary="an internal gear, straight or helical",
        source="gearwright.elements.cylindrical.internal_gear:InternalGear",
        command="internal",
        origin="on the axis, +z, at one end of the teeth",
        start={**_SIZES, "teeth": 54},
        plane=True,
        plots=_TEETH,
    ),
    Element(
        name="rack",
        summary="a rack, straight or helical",
        source="gearwright.elements.cylindrical.rack:Rack",
        command="rack",
        origin="on the pitch plane, below the tip of the first tooth, at one end of the teeth; +x is up",
        start={**_SIZES, "teeth": 14},
        plane=True,
        plots=_TEETH,
    ),
    Element(
        name="spur gear",
        summary="an involute spur gear",
        source="gearwright.elements.cylindrical.spur_gear:SpurGear",
        command="spur",
        origin="on the axis, +z, at one end of the teeth",
        start={**_SIZES, "teeth": 24, "bore": 12.0},
        plane=True,
        plots=_TEETH,
    ),
    Element(
        name="sweep",
        summary="a plane section extruded, swept along a path in space, or revolved",
        source="gearwright.elements.sweep:Sweep",
        command="sweep",
        origin="the section's, where a straight sweep along +z starts; that of the path's points; for a revolution on"
        " its axis, +z",
        start={"section": {"rectangle": (30.0, 12.0)}, "length": 60.0, "twist": 90.0},
        plane=True,
        plots=(
            Plot(name="profile", title="Section at the start", source="gearwright.elements.outline_chart:section"),
            _CONVERGENCE,
        ),
    ),
    Element(
        name="cam",
        summary="a plane disk cam for a follower with a flat face or a roller",
        source="gearwright.elements.cams.cam:Cam",
        command="cam",
        origin="on the axis, +z, at one face of the disk; the follower starts on +x",
        start={
            "programme": "dwell 36, rise 72, dwell 144, return 108",
            "follower": "translating-roller",
            "lift": 12.0,
            "base_radius": 25.0,
            "roller_radius": 8.0,
            "offset": 4.0,
            "law": "4-5-6-7",
            "thickness": 12.0,
            "bore": 16.0,
        },
        diagram="gearwright.elements.cams.diagram:draw",
        plane=True,
        plots=(*_CAM, _CONVERGENCE),
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
