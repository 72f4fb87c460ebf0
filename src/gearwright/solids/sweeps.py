"""Sweeps of a plane section by the names and conventions a person uses: degrees, the section's own origin."""

from __future__ import annotations

import math
from numbers import Real

import numpy as np

from ..errors import ParameterError, Problem
from ..motions.ends import between
from ..motions.extrusion import Extrusion
from ..motions.motion import Motion
from ..motions.revolution import Revolution
from ..motions.straight import Straight
from ..sections.plane import Section
from .swept import Swept


def extrude(
    section: Section,
    length: float,
    twist: float = 0.0,
    scale: tuple[float, float] = (1.0, 1.0),
    skew: tuple[float, float] = (0.0, 0.0),
) -> Swept:
    """The solid of a section moved along z from 0 to a length, about the section's origin.

    twist   angle of the far end against the near one, degrees, right-handed if positive
    scale   (s_x, s_y) of the far end against the near one, before the twist
    skew    offset (x, y) of the far end, a length

    A point p of the section goes to skew·z/L + R(twist·z/L) diag(1 + (s − 1) z/L) p at height z.
    Raises ParameterError with every problem found. Source: Al-Daccak 1989, eqs. (5.15)–(5.20).
    """
    problems = [
        *_unless(_finite(length) and length > 0, f"length = {length}", "a length greater than 0 is needed"),
        *_unless(_finite(twist), f"twist = {twist}", "a finite angle in degrees is needed"),
        *_unless(
            np.shape(scale) == (2,) and _finite(*scale) and min(scale) > 0,
            f"scale = {scale}",
            "two factors greater than 0 are needed; at 0 the solid would end in a line or point",
        ),
        *_unless(np.shape(skew) == (2,) and _finite(*skew), f"skew = {skew}", "two finite lengths are needed"),
    ]
    if problems:
        raise ParameterError("extrude", problems)
    motion: Motion = Straight()
    if twist or tuple(scale) != (1.0, 1.0) or tuple(skew) != (0.0, 0.0):
        across = (float(skew[0]), float(skew[1]))
        factors = (float(scale[0]), float(scale[1]))
        motion = Extrusion(length=float(length), twist=math.radians(twist), scale=factors, skew=across)
    return Swept(section=section, motion=motion, ends=between(0.0, float(length)))


def revolve(section: Section, angle: float = 360.0) -> Swept:
    """The solid of a section turned about its y axis, which becomes z; section x is the radius.

    angle   degrees, more than 0 and at most 360; the body lies from azimuth 0 to the angle

    Raises ParameterError for another angle, GeometryError if the section crosses the axis.
    """
    problems = _unless(
        _finite(angle) and 0.0 < angle <= 360.0, f"angle = {angle}", "more than 0° and at most 360° is needed"
    )
    if problems:
        raise ParameterError("revolve", problems)
    whole = 2.0 * np.pi if angle == 360.0 else math.radians(angle)
    return Swept(section=section, motion=Revolution(), ends=between(-float(whole), 0.0))


def _finite(*values: object) -> bool:
    return all(isinstance(v, Real) and math.isfinite(float(v)) for v in values)


def _unless(good: bool, subject: str, message: str) -> list[Problem]:
    return [] if good else [Problem(subject, message)]
