"""How a binary STL file is laid out: a header, how many triangles there are, and a record a triangle."""

from __future__ import annotations

import re

import numpy as np

HEADER = 80
START = HEADER + 4
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
UNIT = re.compile(rb"lengths in (um|mm|cm|m|in|ft)\b")
"""What headers of files that Gearwright wrote say."""
