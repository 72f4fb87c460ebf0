"""Mass properties as the inertial elements of robot descriptions have them: in kg and m."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import GeometryError
from ..files.inertial import Inertial
from ..parameters import LENGTH_UNITS
from .properties import MassProperties


def inertial_of(
    name: str, body: MassProperties, length_unit: str, *, axes: Array | None = None, inertia: Array | None = None
) -> Inertial:
    """Of properties in kg and a length unit.

    axes, inertia   (3, 3) other axes than the frame's as columns, and the central tensor along them

    Raises GeometryError where no body can have such properties.
    """
    problems = body.validity()
    if problems:
        raise GeometryError(f"{name}: no body can have these properties", problems)
    metres = LENGTH_UNITS[length_unit] / 1e3
    tensor = body.central_inertia if inertia is None else inertia
    return Inertial(
        name=name,
        mass=body.mass,
        centroid=body.centroid * metres,
        axes=np.eye(3) if axes is None else axes,
        inertia=tensor * metres**2,
    )
