"""Drawings in and out: DXF, SVG and CSV files become closed loops of true curves, and these DXF and SVG files."""

from .contours import Profile
from .drawing import Drawing, read
from .writing import WRITTEN, write

__all__ = ["WRITTEN", "Drawing", "Profile", "read", "write"]
