"""Loaded once by the process that workers are copies of, so that they share it."""

import numba  # noqa: F401
import numpy as np  # noqa: F401
import scipy  # noqa: F401
import shapely  # noqa: F401

from ..designs import built, design, document  # noqa: F401
