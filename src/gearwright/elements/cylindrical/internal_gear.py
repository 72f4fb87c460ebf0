"""Internal gears."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ...motions.ends import between
from ...parameters import Problems, Size, declared
from ...sections.plane import Section
from ...sheets.views import View
from ...solids.solid import Solid
from ...solids.swept import Swept
from .. import declarations as d
from .. import refusals
from .cylindrical_gear import CylindricalGear
from .gear_views import internal_views
from .internal_tooth import InternalTooth
from .sizes import in_unit
from .tooth_checks import check_internal

_RIM = 3.0  # modules from the roots to the outside
_ROOM = 0.999  # of the largest fillet that fits, where the basic rack's does not


@dataclass(frozen=True, kw_only=True, repr=False)
class InternalGear(CylindricalGear):
    """A ring with teeth that point to the axis, straight or helical.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0. Teeth count positive;
    addendum is towards the axis; a positive profile shift makes teeth thicker, tips and roots move towards the axis.
    The fillet is a circular arc (see `InternalTooth`). Raises ParameterError with every problem found.
    Source: ISO 21771, with z < 0 written as a positive number.
    """

    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None)
    helix_angle: float = declared(d.HELIX_ANGLE, default=0.0)
    hand: str = declared(d.HELIX_HAND, default="right")
    fillet_radius: float | None = declared(d.FILLET_RADIUS, default=None)
    outer_diameter: float | None = declared(d.OUTER_DIAMETER, default=None)

    def _check_given(self, problems: Problems) -> None:
        super()._check_given(problems)
        if self.root == "radial" and self.fillet_radius is not None:
            problems.add("fillet_radius", refusals.NO_FILLET)

    def _check_teeth(self, problems: Problems) -> None:
        for name, message in check_internal(self.tooth, self.nominal_thickness, self.length_unit):
            problems.add("tip_diameter" if name == "addendum" and self.tip_diameter is not None else name, message)
        limit = 2.0 * self.toothing.root_radius
        if problems.computable("outer_diameter") and self.outer_radius <= self.toothing.root_radius:
            problems.add("outer_diameter", refusals.thin_ring(limit, self.length_unit))

    @property
    def is_internal(self) -> bool:
        return True

    @property
    def outer_radius(self) -> float:
        if self.outer_diameter is not None:
            return self.outer_diameter / 2.0
        return self.toothing.root_radius + _RIM * self.normal_module

    @cached_property
    def tooth(self) -> InternalTooth:
        bare = InternalTooth(toothing=self.toothing, relief=self.relief, chamfer=self.tip_chamfer)
        if self.root == "radial":
            return bare
        usual = self.rack.tip_radius * self.normal_module
        fitting = min(usual, _ROOM * max(0.0, bare.largest_fillet_radius))
        radius = fitting if self.fillet_radius is None else self.fillet_radius
        return InternalTooth(toothing=self.toothing, fillet_radius=radius, relief=self.relief, chamfer=self.tip_chamfer)

    @property
    def profile(self) -> Section:
        """The transverse section at z = 0, without crowning."""
        return self.tooth.section(self.outer_radius)

    @cached_property
    def solid(self) -> Solid:
        section = self.tooth.section(self.outer_radius, self.crown)
        return Swept(section=section, motion=self.motion, ends=between(0.0, self.face_width))

    def sizes(self) -> dict[str, Size]:
        """Derived sizes by name, with the symbols of ISO 21771."""
        lengths = {
            "outer_diameter": (2.0 * self.outer_radius, "d_rim", "outer diameter of the ring"),
            "fillet_radius": (self.tooth.fillet_radius, "ρ_f", "radius of the fillets, transverse"),
        }
        return {**super().sizes(), **in_unit(lengths, "length")}

    def views(self) -> tuple[View, ...]:
        return internal_views(self)
