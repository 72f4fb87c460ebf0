"""Drawings in: DXF, SVG and CSV files become closed loops of true curves."""

from .drawing import Drawing, read

__all__ = ["Drawing", "read"]
