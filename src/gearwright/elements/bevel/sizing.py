"""Sizing systems of bevel gears by the names that parameters have for them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, get_args

import numpy as np

from ...errors import ParameterError
from ...parameters import Problems
from ..standards.bevels.depth_data import DepthData, depth_data_of
from ..standards.bevels.design import BevelDesign
from ..standards.bevels.equal_addendum import equal_addendum
from ..standards.bevels.gleason import gleason_spiral, gleason_straight
from ..standards.bevels.iso_23509 import Method, iso_23509
from ..standards.bevels.proportions import DepthTaper, Pair, Proportions

if TYPE_CHECKING:
    from .bevel_gear import BevelGear
    from .bevel_pair import BevelPair

EXPLICIT = ("explicit",)
SYSTEMS = ("equal-addendum", "gleason-straight", "gleason-spiral", "iso-23509")
SHIFTED = ("equal-addendum", "iso-23509")
"""Systems with a profile shift to choose; the others settle it themselves."""
TAPERED = ("explicit", "equal-addendum", "iso-23509")
"""Systems with a taper to choose."""
ISO = ("iso-23509",)

_METHODS: tuple[Method, ...] = get_args(Method)
_TAPERS: tuple[DepthTaper, ...] = get_args(DepthTaper)


def taper_of(name: str | None) -> DepthTaper | None:
    """The taper of a name; None for none."""
    return next((taper for taper in _TAPERS if taper == name), None)


@dataclass(frozen=True, kw_only=True)
class Sizing:
    """A standard, and what it leaves to choose.

    profile_shift, thickness_modification   of the first member; None: what the standard suggests
    taper, method                           None: the standard's own
    """

    standard: str
    profile_shift: float | None = None
    thickness_modification: float = 0.0
    taper: DepthTaper | None = None
    method: Method | None = None

    @classmethod
    def of(cls, element: BevelGear | BevelPair) -> Sizing:
        """What an element was given of it."""
        return cls(
            standard=element.standard,
            profile_shift=element.profile_shift,
            thickness_modification=element.thickness_modification or 0.0,
            taper=taper_of(element.taper),
            method=next((one for one in _METHODS if one == element.iso_method), None),
        )

    def proportions(self, design: BevelDesign) -> Pair:
        """Of both members. Raises ParameterError where the standard has none for this design."""
        shift, modification = self.profile_shift, self.thickness_modification
        match self.standard:
            case "equal-addendum":
                pair = equal_addendum(design, profile_shift=shift or 0.0, thickness_modification=modification)
                return tapered(pair[0], self.taper), tapered(pair[1], self.taper)
            case "gleason-straight":
                return gleason_straight(design, thickness_modification=modification)
            case "gleason-spiral":
                return gleason_spiral(design, thickness_modification=modification)
            case _:
                return iso_23509(design, method=self.method or 0, taper=self.taper, depths=self._depths(design))

    def _depths(self, design: BevelDesign) -> DepthData | None:
        if self.profile_shift is None and not self.thickness_modification:
            return None
        usual = depth_data_of(self.method or 0, design)
        shift = usual.profile_shift if self.profile_shift is None else self.profile_shift
        return replace(usual, profile_shift=shift, thickness_modification=self.thickness_modification)


def tapered(proportions: Proportions, taper: DepthTaper | None) -> Proportions:
    """Proportions that go with the cone distance, or those of the same outer heights that do not."""
    return replace(proportions, addendum_angle=0.0, dedendum_angle=0.0) if taper == "uniform" else proportions


def giving_depths(element: BevelGear | BevelPair) -> str:
    """The parameter from which an element with a standard has its depths."""
    return "standard" if element.profile_shift is None else "profile_shift"


def explicit(
    addendum: float, dedendum: float, thickness: float, cone_distance: float, taper: DepthTaper | None
) -> Proportions:
    """Proportions of outer heights as given, tan θ = h/R_e or θ = 0. Source: Al-Daccak 1989, table 3.1."""
    found = Proportions(
        addendum=addendum,
        dedendum=dedendum,
        addendum_angle=float(np.arctan2(addendum, cone_distance)),
        dedendum_angle=float(np.arctan2(dedendum, cone_distance)),
        thickness=thickness,
    )
    return tapered(found, taper)


def require_standard(problems: Problems, standard: str, spiral_angle: float, taper: str | None) -> None:
    """Adds a problem where the system is for teeth with a spiral angle and these have none, or the reverse, and where
    the taper is another system's."""
    if standard == "gleason-straight" and spiral_angle != 0.0:
        problems.add("standard", 'is for teeth without spiral angle; "gleason-spiral" is for those with one')
    if standard == "gleason-spiral" and spiral_angle == 0.0:
        ways = '"gleason-straight" for those without, zerol ones too'
        problems.add("standard", f"is for teeth with a spiral angle, usually 35°; {ways}")
    if standard in ("explicit", "equal-addendum") and taper in ("duplex", "tilted"):
        problems.add("taper", 'is found by standard = "iso-23509"; with this one it is "standard" or "uniform"')


def design_of(element: BevelGear | BevelPair, teeth: tuple[int, int], shaft_angle: float) -> BevelDesign:
    """What an element gives a standard to size, for members with numbers of teeth and a shaft angle, radians."""
    return BevelDesign(
        teeth=teeth,
        module=element.outer_module,
        shaft_angle=shaft_angle,
        face_width=element.face_width,
        pressure_angle=float(np.radians(element.pressure_angle)),
        spiral_angle=float(np.radians(element.spiral_angle)),
        cutter_radius=element.cutter_radius,
        blade_groups=element.blade_groups,
    )


def is_sized(problems: Problems, element: BevelGear | BevelPair) -> bool:
    """Whether its standard has proportions for an element; adds what it refuses to the parameters it names."""
    try:
        return bool(element.proportions)
    except ParameterError as error:
        for problem in error.problems:
            name = problem.subject.split(" ")[0]
            problems.add(name if problems.has(name) else "standard", problem.message)
        return False
