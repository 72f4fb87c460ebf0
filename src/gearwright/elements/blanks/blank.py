"""The body of a gear inside its teeth: bore, keyway, hub, and a web with holes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property

from ...parameters import MILLIMETRES, Size
from ...sections.loop import Loop
from ...solids.solid import Solid
from ..standards.din_6885 import parallel_key
from .keyway import KeyedBore
from .pieces import HoleCircle, Piece, Zone, assembled, circle, zones


@dataclass(frozen=True, kw_only=True)
class Blank:
    """What is inside the teeth of a gear whose teeth lie between z = 0 and the face width; None: absent.

    bore                          diameter
    keyway                        "din-6885": the one that the standard has for the bore; centred on +x, as the first
                                  tooth is
    keyway_width, keyway_depth    instead of the standard's: b, and t₂ from the bore to the floor
    hub_diameter, hub_length      of a cylinder about the bore; the length is the face width if not given
    hub_offset                    the hub reaches from z = −hub_offset to hub_length − hub_offset
    rim_diameter, web_thickness   between rim and hub (or bore) there is only a web, in the middle of the face width
    web_holes, web_hole_diameter, web_hole_circle   round holes through the web, the first one centred on +x, their
                                  middles on a circle of that diameter; midway between hub and rim if not given

    Lengths are in the length unit. Whether a body has these sizes, `blank_problems` says.
    """

    bore: float | None = None
    keyway: str | None = None
    keyway_width: float | None = None
    keyway_depth: float | None = None
    hub_diameter: float | None = None
    hub_length: float | None = None
    hub_offset: float = 0.0
    rim_diameter: float | None = None
    web_thickness: float | None = None
    web_holes: int | None = None
    web_hole_diameter: float | None = None
    web_hole_circle: float | None = None
    length_unit: str = "mm"

    @classmethod
    def of(cls, element: object) -> Blank:
        """The blank of an element that declares parameters of these names."""
        return cls(**{name: getattr(element, name) for name in cls.names()})

    @classmethod
    def names(cls) -> tuple[str, ...]:
        """Names of the parameters."""
        return tuple(field.name for field in fields(cls))

    @cached_property
    def keyed_bore(self) -> KeyedBore | None:
        """The bore where it has a keyway, as far as there is one of that size."""
        if self.bore is None:
            return None
        if self.keyway == "din-6885":
            millimetres = MILLIMETRES[self.length_unit]
            key = parallel_key(self.bore * millimetres)
            size = None if key is None else (key.width / millimetres, key.hub_depth / millimetres)
        elif self.keyway_width is not None and self.keyway_depth is not None:
            size = self.keyway_width, self.keyway_depth
        else:
            return None
        if size is None or size[0] >= self.bore:
            return None
        return KeyedBore(radius=self.bore / 2.0, width=size[0], depth=size[1])

    @property
    def core_radius(self) -> float:
        """Of the circle around the bore and its keyway; 0 where there is none."""
        if self.keyed_bore is not None:
            return self.keyed_bore.corner_radius
        return 0.0 if self.bore is None else self.bore / 2.0

    @property
    def has_web(self) -> bool:
        return self.rim_diameter is not None and self.web_thickness is not None

    @property
    def hole_circle(self) -> HoleCircle | None:
        """The holes in the web, as far as they are given."""
        if self.web_holes is None or self.web_hole_diameter is None or self.rim_diameter is None:
            return None
        inner = 2.0 * self.core_radius if self.hub_diameter is None else self.hub_diameter
        middle = (inner + self.rim_diameter) / 2.0 if self.web_hole_circle is None else self.web_hole_circle
        return HoleCircle(count=self.web_holes, radius=self.web_hole_diameter / 2.0, circle=middle / 2.0)

    def web_levels(self, face_width: float) -> tuple[float, float]:
        """From which to which z all of the body reaches: the faces of the web, or the ends of the teeth."""
        thickness = self.web_thickness if self.has_web and self.web_thickness is not None else face_width
        return (face_width - thickness) / 2.0, (face_width + thickness) / 2.0

    def hub_levels(self, face_width: float) -> tuple[float, float]:
        """From which to which z the hub reaches."""
        return -self.hub_offset, (face_width if self.hub_length is None else self.hub_length) - self.hub_offset

    def holes(self) -> tuple[Loop, ...]:
        """Outlines of the bore with its keyway and of the web's holes, clockwise, across the axis."""
        web = () if self.hole_circle is None else self.hole_circle.loops()
        if self.keyed_bore is not None:
            return (self.keyed_bore.loop(), *web)
        return web if self.bore is None else (circle(self.bore / 2.0, -1), *web)

    def sizes(self) -> dict[str, Size]:
        """Sizes that follow from others: of the standard's keyway, and of the circle of the holes."""
        rows = {}
        if self.keyed_bore is not None:
            rows["keyway_width"] = (self.keyed_bore.width, "b_k", "width of the keyway")
            rows["keyway_depth"] = (self.keyed_bore.depth, "t_2", "depth of the keyway from the bore to its floor")
        if self.hole_circle is not None:
            rows["web_hole_circle"] = (
                2.0 * self.hole_circle.circle,
                "d_c",
                "diameter of the circle of the web's holes",
            )
        return {name: Size(float(value), "length", symbol, meaning) for name, (value, symbol, meaning) in rows.items()}

    def zones(self, root_radius: float, face_width: float) -> tuple[Zone, ...]:
        """The body as rings of constant height, from the outside in."""
        bounds = [(root_radius, (0.0, face_width))]
        if self.has_web and self.rim_diameter is not None:
            bounds.append((self.rim_diameter / 2.0, self.web_levels(face_width)))
        if self.hub_diameter is not None:
            bounds.append((self.hub_diameter / 2.0, self.hub_levels(face_width)))
        return zones(bounds, 0.0 if self.bore is None else self.bore / 2.0)

    def solid(self, ring: Callable[[float | None], Solid], root_radius: float, face_width: float) -> Solid:
        """The whole gear: the teeth's ring, with a round hole of a radius (None: full), and what is inside it.

        The ring's teeth lie between z = 0 and the face width, its hole is the second loop of its section. Where there
        is but a bore it is the ring itself; else coaxial pieces are glued along cylinders that vanish.
        """
        holes = self.hole_circle if self.has_web else None
        body = self.zones(root_radius, face_width)
        return assembled(lambda radius: [Piece(ring(radius))], body, holes, self.keyed_bore)
