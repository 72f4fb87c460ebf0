"""The body of a bevel gear: what carries its teeth, by its half-section."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...curves.arc import Arc
from ...curves.curve import Curve
from ...curves.line import Line, lines_through
from ...motions.ends import between
from ...motions.revolution import FULL_TURN, Revolution
from ...sections.loop import Loop
from ...sections.plane import Section
from ...solids.solid import Solid
from ...solids.swept import Swept
from ..blanks.blank import Blank
from ..blanks.pieces import Piece, Zone, assembled, zones
from .tooth_ends import ToothEnds

Point = tuple[float, float]
_CLEAR = 1.02  # of the circle around a keyway: what is left of the front face outside it
_SAME = 1e-9  # of the mounting distance: levels so near to each other were meant to be one


@dataclass(frozen=True, kw_only=True)
class BevelBody:
    """A ring under the teeth and a body of revolution in it.

    ends                of the teeth
    root_angle          least polar angle of the roots, radians. Front and back cones go on below it as far as the teeth
                        are deep, or halfway to the bore
    depth               whole depth of the teeth at their outer end
    blank               bore, keyway, hub, web (`hub_offset` is not used)
    mounting_distance   z of the back face; if not given, where the back cone ends, or what the hub's length makes it

    Inside the front cone the front face is plane, and so is the back face inside the back cone, which ends there: a
    hub stands on it. With spherical ends there is but a bore. Whether such a body exists, `body_problems` says.
    """

    ends: ToothEnds
    root_angle: float
    depth: float
    blank: Blank
    mounting_distance: float | None = None

    @property
    def plain(self) -> bool:
        """Whether the teeth's section goes on to the axis: spherical ends without a bore."""
        return self.ends.kind == "spherical" and self.blank.bore is None

    @cached_property
    def front_angle(self) -> float:
        """Polar angle at which the front cone ends, radians."""
        bore = 0.0 if self.blank.bore is None else self.blank.bore / 2.0
        wanted = max(self.root_angle - float(np.arctan(self.depth / self.ends.outer)), self._halfway_to(bore))
        # a keyway changes nothing but what it takes, unless it reaches so far
        reached = self.ends.polar_at_radius(_CLEAR * self.blank.core_radius, self.ends.inner)
        return wanted if reached < wanted else self._halfway_to(self.blank.core_radius)

    def _halfway_to(self, radius: float) -> float:
        """Polar angle on the front cone, halfway from the roots to a distance from the axis."""
        return (self.root_angle + self.ends.polar_at_radius(radius, self.ends.inner)) / 2.0

    @cached_property
    def back_angle(self) -> float:
        """Polar angle at which the back cone ends, radians."""
        if self.ends.kind != "conical" or self.mounting_distance is None or self.blank.hub_diameter is not None:
            return self.front_angle
        return self.ends.polar_at_height(self.mounting_distance, self.ends.outer)

    @property
    def ring_angle(self) -> float:
        """Polar angle of the cone within the body along which the teeth's ring is glued to the rest, radians."""
        return (self.root_angle + max(self.front_angle, self.back_angle)) / 2.0

    @property
    def front_edge(self) -> Point:
        """(ρ, z) where the plane front face begins."""
        return self.ends.point(self.front_angle, self.ends.inner)

    @property
    def back_edge(self) -> Point:
        """(ρ, z) where the plane back face begins."""
        return self.ends.point(self.back_angle, self.ends.outer)

    @property
    def front(self) -> float:
        """z of the front face."""
        return self.front_edge[1]

    @property
    def back(self) -> float:
        """z of the mounting face: that of the hub, or the back face itself."""
        own = self.back_edge[1]
        if self.blank.hub_diameter is None:
            return own
        if self.mounting_distance is not None:
            return own if abs(self.mounting_distance - own) <= _SAME * own else self.mounting_distance
        return own if self.blank.hub_length is None else self.front + self.blank.hub_length

    @property
    def hub_start(self) -> float:
        """z at which the hub begins, towards the apex."""
        return self.front if self.blank.hub_length is None else self.back - self.blank.hub_length

    @property
    def room(self) -> float:
        """Radius of the largest cylinder inside the cones that ends on plane faces at both ends."""
        return min(self.front_edge[0], self.back_edge[0])

    @property
    def _hub_radius(self) -> float:
        return 0.0 if self.blank.hub_diameter is None else self.blank.hub_diameter / 2.0

    @property
    def hub_is_wide(self) -> bool:
        """Whether the hub is wider than the front face."""
        return self._hub_radius >= self.room

    @property
    def web_levels(self) -> Point:
        """From which to which z the web reaches, or the body where there is none."""
        low, high = self.front, self.back_edge[1]
        if not self.blank.has_web or self.blank.web_thickness is None:
            return low, high
        middle, half = (low + high) / 2.0, self.blank.web_thickness / 2.0
        return middle - half, middle + half

    @property
    def zones(self) -> tuple[Zone, ...]:
        """What is inside the ring, between cylinders."""
        bounds = [(self.room, (self.front, self.back if self.hub_is_wide else self.back_edge[1]))]
        if self.blank.has_web and self.blank.rim_diameter is not None:
            bounds.append((self.blank.rim_diameter / 2.0, self.web_levels))
        if self.blank.hub_diameter is not None and not self.hub_is_wide:
            bounds.append((self._hub_radius, (self.hub_start, self.back)))
        return zones(bounds, 0.0 if self.blank.bore is None else self.blank.bore / 2.0)

    def solid(self, teeth: Callable[[float | None], Solid]) -> Solid:
        """The whole gear from its teeth, which reach down to a cone of a polar angle (None: to the axis)."""
        if self.plain:
            return teeth(None)
        holes = self.blank.hole_circle if self.blank.has_web else None
        return assembled(
            lambda radius: [Piece(teeth(self.ring_angle)), self._rim(radius or 0.0)],
            self.zones,
            holes,
            self.blank.keyed_bore,
        )

    def _rim(self, radius: float) -> Piece:
        """The body of revolution between the ring's cone and a cylinder (0: the axis)."""
        curves = self._spherical_rim(radius) if self.ends.kind == "spherical" else self._plane_rim(radius)
        section = Section(loops=(Loop(curves=tuple(curves)),))
        swept = Swept(section=section, motion=Revolution(), ends=between(-FULL_TURN, 0.0))
        after = 2 if self.ends.kind == "conical" else 1
        return Piece(swept, outer_wall="loop 1.1", inner_wall=f"loop 1.{len(curves) - after}")

    def _plane_rim(self, radius: float) -> list[Curve]:
        """The cone first, counter-clockwise in (ρ, z); the inner wall is the one before the plane front face."""
        ring_front, ring_back = (self.ends.point(self.ring_angle, at) for at in (self.ends.inner, self.ends.outer))
        (_, front), (_, level) = self.front_edge, self.back_edge
        conical = self.ends.kind == "conical"
        back = [self.back_edge] if conical else []
        if self.hub_is_wide and self.back != level:
            back += [(self._hub_radius, level), (self._hub_radius, self.back)]
        top = self.back if self.hub_is_wide else level
        ahead = [self.front_edge] if conical else []
        return list(lines_through([ring_front, ring_back, *back, (radius, top), (radius, front), *ahead, ring_front]))

    def _spherical_rim(self, radius: float) -> list[Curve]:
        """The same between spheres, which have no plane faces."""
        inner, outer = self.ends.inner, self.ends.outer
        cone = np.pi / 2.0 - self.ring_angle  # polar angle from +z, as an angle from the radius axis
        top, bottom = (float(np.sqrt(r**2 - radius**2)) for r in (outer, inner))
        return [
            Line(first=self.ends.point(self.ring_angle, inner), last=self.ends.point(self.ring_angle, outer)),
            Arc(radius=outer, interval=(cone, float(np.arctan2(top, radius)))),
            Line(first=(radius, top), last=(radius, bottom)),
            Arc(radius=inner, interval=(float(np.arctan2(bottom, radius)), cone)),
        ]
