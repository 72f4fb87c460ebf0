"""How large a body is outside: surface area and bounding box."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..arrays import Array


class Extent(NamedTuple):
    """Surface area and bounding box (2, 3), lowest and highest coordinates; None where unknown."""

    area: float | None = None
    bounding_box: Array | None = None

    def moved(self, rotation: Array, shift: Array) -> Extent:
        """Of the body moved by r → R r + t; the box follows where R only exchanges axes."""
        if self.bounding_box is None or not np.all(np.isin(np.abs(rotation), (0.0, 1.0))):
            return Extent(self.area)
        return Extent(self.area, np.sort(self.bounding_box @ rotation.T + shift, axis=0))

    def joined(self, other: Extent) -> Extent:
        """Of two bodies as one; they may touch, so that the area is unknown."""
        if self.bounding_box is None or other.bounding_box is None:
            return Extent()
        low, high = zip(self.bounding_box, other.bounding_box, strict=True)
        return Extent(None, np.stack([np.min(low, axis=0), np.max(high, axis=0)]))

    def without(self, part: Extent) -> Extent:
        """Of the body without a part; the box stays where the part lies inside it."""
        box, inner = self.bounding_box, part.bounding_box
        if box is None or inner is None or np.any(inner[0] <= box[0]) or np.any(inner[1] >= box[1]):
            return Extent()
        return Extent(None, box)
