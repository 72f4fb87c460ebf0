"""Moments of a plane section moved in any way, by quadrature of its own moments along the motion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..arrays import Array
from ..moments.body import BodyMoments, about_centroid
from ..moments.quadrature import adaptive
from ..moments.sweep import plane_sweep
from ..sections.members import member_moments
from ..sections.plane import Section
from .motion import Motion

TOLERANCE = 1e-13
"""Default for the quadrature, relative to the volume times the body's extent."""
_ROUNDINGS = 8.0 * float(np.finfo(float).eps)
_LOOK = 33  # stations by which the extent is measured


def quadrature_moments(
    motion: Motion, section: Section, start: float, finish: float, tolerance: float = TOLERANCE
) -> BodyMoments:
    """Moments of the section moved from start to finish, where the volume element is linear in the section point.

    Adaptive Gauss–Legendre quadrature of (S1), in its form for planes that are not parallel. Of a section that varies,
    every station takes the moments of its own member.
    """
    size, centre = section.size, section.middle
    # three points that tell the linear volume element
    corners = centre + np.array([[0.0, 0.0], [size, 0.0], [0.0, size]])
    look = np.linspace(start, finish, _LOOK)
    middle = np.broadcast_to(centre, (_LOOK, 2))
    path = motion.place(middle, look)
    origin = (path.min(axis=0) + path.max(axis=0)) / 2.0
    widest = max(
        float(np.max(np.abs(motion.carry(middle, np.broadcast_to(axis, (_LOOK, 2)), look)))) for axis in np.eye(2)
    )
    extent = float(np.max(np.abs(path - origin))) + size * widest
    unit = np.outer([1.0, extent, extent, extent], [1.0, extent, extent, extent])

    section_errors = [section.moments_error]

    def moments(v: Array) -> Array:
        if not section.varies:
            return section.local_moments.values
        values, error = member_moments(section, v)
        section_errors.append(error)
        return values

    def integrand(v: Array) -> Array:
        point = np.broadcast_to(centre, (len(v), 2))
        axes = [motion.carry(point, np.broadcast_to(axis, (len(v), 2)), v) for axis in np.eye(2)]
        elements = np.stack([motion.jacobian(np.broadcast_to(corner, (len(v), 2)), v) for corner in corners], axis=1)
        slopes = np.concatenate([elements[:, :1], (elements[:, 1:] - elements[:, :1]) / size], axis=1)
        return plane_sweep(moments(v), motion.place(point, v) - origin, np.stack(axes, axis=-1), slopes) / unit

    breaks = np.array([start, *motion.panels(start, finish), finish])
    # places far off are rounded, and no refinement mends it
    noise = _ROUNDINGS * float(np.max(np.abs(path))) / extent
    matrix, error, evaluations = adaptive(integrand, breaks, max(tolerance, noise))
    body = about_centroid(matrix * unit, "exact", error + max(section_errors), origin)
    return replace(body, evaluations=evaluations)
