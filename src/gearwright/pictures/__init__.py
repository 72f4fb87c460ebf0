"""Pictures of bodies: a small z-buffer renderer with studio light, and callouts. Knows arrays, not solids."""

from .camera import View
from .picture import Body, drawn, picture

__all__ = ["Body", "View", "drawn", "picture"]
