"""The array types that every kernel speaks."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

__all__ = ["Array", "ArrayLike", "Indices", "numbers_in"]


def numbers_in(values: object, count: int | None = None, most: float = math.inf) -> list[float] | None:
    """So many finite numbers of at most some size, as floats; None where a person gave something else.

    count   None for one number that is no list
    """
    try:
        found = np.array(values, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None
    right = found.shape == (() if count is None else (count,)) and not isinstance(values, bool | str)
    sound = right and bool(np.all(np.isfinite(found)) and np.all(np.abs(found) <= most))
    return found.reshape(-1).tolist() if sound else None
