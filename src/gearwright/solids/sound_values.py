"""Values that mass properties are made of: checked, and kept from change."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..arrays import Array, ArrayLike, numbers_in
from ..errors import GeometryError, ParameterError, Problem


def fixed_array(values: ArrayLike, shape: tuple[int, ...]) -> Array:
    """A read-only copy of values of that shape. Raises GeometryError where they have another."""
    array = np.array(values, dtype=float)
    if array.shape != shape:
        raise GeometryError(
            "This is not a vector or tensor in space", [Problem(f"shape {array.shape}", f"{shape} is needed")]
        )
    array.flags.writeable = False
    return array


def sound_density(density: object) -> float:
    """A density as a float. Raises ParameterError where it is no positive number."""
    (number,) = numbers_in(density) or [math.nan]
    if not number > 0.0:
        hint = "; density(name) gives that of a material" if isinstance(density, str) else ""
        message = f"a positive number is needed: mass per cubed length unit{hint}"
        raise ParameterError("MassProperties", [Problem(f"density = {density!r}", message)])
    return number


def require_finite(values: dict[str, Any]) -> None:
    """Refuses values by name that are not finite, all together. Raises ParameterError."""
    problems = [
        Problem(f"{name} = {value}", "finite numbers are needed; the boundary may be open or of no volume")
        for name, value in values.items()
        if value is not None and not np.all(np.isfinite(value))
    ]
    if problems:
        raise ParameterError("MassProperties", problems)
