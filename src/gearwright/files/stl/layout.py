"""How a binary STL file is laid out: a header, how many triangles there are, and a record a triangle."""

from __future__ import annotations

import numpy as np

HEADER = 80
START = HEADER + 4
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
