"""Sweeps of a plane section by the names and conventions a person uses: degrees, the section's own origin."""

from __future__ import annotations

import math
import os
from collections.abc import Callable

import numpy as np

from ..arrays import Array, ArrayLike, numbers_in
from ..curves.frames import FRAMES
from ..curves.path import Path, path_of, path_through
from ..curves.path_file import path_from_file
from ..errors import ParameterError, Problem
from ..motions.along import Along
from ..motions.ends import between
from ..motions.extrusion import Extrusion
from ..motions.motion import Motion
from ..motions.plane_quadrature import TOLERANCE
from ..motions.revolution import Revolution
from ..motions.straight import Straight
from ..motions.transform import transform_of
from ..motions.transforming import Transforming
from ..sections.plane import Section
from .swept import Swept

_LEAST, _MOST = 1e-12, 1e12  # lengths, whose fifth powers must stay numbers
_LENGTH = f"a length greater than 0 is needed, from {_LEAST:g} to {_MOST:g}"
_LEAST_ANGLE = 1e-4  # degrees: the wedge of a thinner one could hardly be told from nothing
_LEAST_TOLERANCE, _MOST_TOLERANCE = 1e-14, 1e-3
_SHARE = 10.0  # the transform is known so much better than the moments are asked for


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
        *_no_section(section),
        *_unless(_within(length, _LEAST, _MOST), f"length = {length}", _LENGTH),
        *_unless(numbers_in(twist) is not None, f"twist = {twist}", "a finite angle in degrees is needed"),
        *_unless(
            min(numbers_in(scale, 2, _MOST) or [0.0]) > 0,
            f"scale = {scale}",
            "two factors greater than 0 are needed; at 0 the solid would end in a line or point",
        ),
        *_unless(numbers_in(skew, 2, _MOST) is not None, f"skew = {skew}", "two finite lengths are needed"),
    ]
    if problems:
        raise ParameterError("extrude", problems)
    section.require_simple()
    motion: Motion = Straight()
    if twist or tuple(scale) != (1.0, 1.0) or tuple(skew) != (0.0, 0.0):
        across = (float(skew[0]), float(skew[1]))
        factors = (float(scale[0]), float(scale[1]))
        motion = Extrusion(length=float(length), twist=math.radians(twist), scale=factors, skew=across)
    return Swept(section=section, motion=motion, ends=between(0.0, float(length)))


def sweep(
    section: Section, transform: Callable[[float], ArrayLike], length: float, tolerance: float = TOLERANCE
) -> Swept:
    """The solid of a section moved along z from 0 to a length while its plane is mapped by any smooth transform.

    transform   ξ → [[f₁, g₁, h₁], [f₂, g₂, h₂], [0, 0, 1]], for one ξ between 0 and the length at a time
    tolerance   of the transform's values and of the quadrature of the moments, relative; what was reached is the
                `error_bound` of the solid's properties, their `evaluations` the stations of the quadrature

    A point (x, y) goes to (f₁x + g₁y + h₁, f₂x + g₂y + h₂) at height ξ: (S1). f₁g₂ − f₂g₁ must stay greater than 0.
    Raises ParameterError; GeometryError where the transform is not smooth or turns the section inside out.
    Source: Al-Daccak 1989, eqs. (5.3)–(5.13).
    """
    problems = [
        *_no_section(section),
        *_unless(_within(length, _LEAST, _MOST), f"length = {length}", _LENGTH),
        *_unless(callable(transform), f"transform = {transform!r}", "a function of ξ is needed"),
        *_unless(
            _within(tolerance, _LEAST_TOLERANCE, _MOST_TOLERANCE),
            f"tolerance = {tolerance}",
            f"between {_LEAST_TOLERANCE:g} and {_MOST_TOLERANCE:g} is possible",
        ),
    ]
    if problems:
        raise ParameterError("sweep", problems)
    section.require_simple()
    found = transform_of(transform, float(length), tolerance / _SHARE)
    return Swept(
        section=section, motion=Transforming(transform=found, tolerance=tolerance), ends=between(0.0, float(length))
    )


def sweep_along(
    section: Section,
    path: Path | ArrayLike | Callable[[Array], ArrayLike] | str | os.PathLike[str],
    frame: str = "rotation-minimising",
    transform: Callable[[float], ArrayLike] | None = None,
) -> Swept:
    """The solid of a section moved along a path in space, its plane across it and its origin on it.

    path        points (n, 3) of a cubic spline, or a function u → point for u from 0 to 1, or a `helix`; closed
                where its ends meet; or the name of a CSV file of points
    frame       "rotation-minimising", "frenet" (section x towards the centre of curvature) or "fixed-up" (section y
                as near as possible to +z); at the start section y is as near as possible to +z, else to +x
    transform   as for `sweep`, of the fraction of the path's length from 0 to 1, inside the section's plane

    Raises ParameterError; GeometryError where the path is not smooth, the frame not defined, or where the section
    reaches beyond the path's centre of curvature, with the radius of curvature that would do; FileError, MachineError
    where a file of points cannot be used.
    """
    problems = _no_section(section) + _unless(
        frame in FRAMES, f"frame = {frame!r}", f"choose one of {', '.join(FRAMES)}"
    )
    if problems:
        raise ParameterError("sweep_along", problems)
    section.require_simple()
    found = _path(path)
    mapping = None if transform is None else transform_of(transform, 1.0, TOLERANCE / _SHARE)
    return Swept(section=section, motion=Along(frame=FRAMES[frame](found), transform=mapping), ends=between(0.0, 1.0))


def revolve(section: Section, angle: float = 360.0) -> Swept:
    """The solid of a section turned about its y axis, which becomes z; section x is the radius.

    angle   degrees, more than 0 and at most 360; the body lies from azimuth 0 to the angle

    Raises ParameterError for another angle, GeometryError if the section crosses the axis.
    """
    problems = _no_section(section) + _unless(
        _within(angle, _LEAST_ANGLE, 360.0),
        f"angle = {angle}",
        f"at least {_LEAST_ANGLE:g}° and at most 360° is needed",
    )
    if problems:
        raise ParameterError("revolve", problems)
    section.require_simple()
    whole = 2.0 * np.pi if angle == 360.0 else math.radians(angle)
    return Swept(section=section, motion=Revolution(), ends=between(-float(whole), 0.0))


def _path(given: Path | ArrayLike | Callable[[Array], ArrayLike] | str | os.PathLike[str]) -> Path:
    if isinstance(given, Path):
        return given
    if isinstance(given, str | os.PathLike):
        return path_from_file(os.fspath(given))
    return path_of(given) if callable(given) else path_through(given)


def _within(value: object, least: float, most: float) -> bool:
    found = numbers_in(value, most=most)
    return found is not None and found[0] >= least


def _no_section(section: object) -> list[Problem]:
    return _unless(isinstance(section, Section), f"section = {section!r}", "a plane section is needed: gw.Section.…")


def _unless(good: bool, subject: str, message: str) -> list[Problem]:
    return [] if good else [Problem(subject, message)]
