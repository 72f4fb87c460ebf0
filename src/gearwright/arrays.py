"""The array types that every kernel speaks."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

__all__ = ["Array", "ArrayLike", "Indices"]
