"""Bodies that may overlap: those whose boxes do."""

from __future__ import annotations

import numpy as np

from ..arrays import Indices
from ..moments.components import component_boxes
from .validity.report import PolyhedronValidity

_CONTACT = 1e-6
"""How far boxes may reach into each other, relative to the smaller of their sides, where bodies only touch."""


def close_bodies(validity: PolyhedronValidity) -> Indices:
    """Pairs (k, 2) of bodies whose boxes overlap by more than a contact; whether the bodies do, their faces say."""
    if validity.bodies < 2:
        return np.empty((0, 2), np.int64)
    from .box_tree import overlapping_pairs

    boxes = component_boxes(
        validity.vertices, validity.indices, validity.offsets, validity.body_labels, validity.bodies
    )
    sides = np.minimum.reduce(boxes[:, 1] - boxes[:, 0], axis=1)
    found = [np.empty((0, 2), np.int64)]
    for pairs in overlapping_pairs(boxes):
        low = np.maximum(boxes[pairs[:, 0], 0], boxes[pairs[:, 1], 0])
        high = np.minimum(boxes[pairs[:, 0], 1], boxes[pairs[:, 1], 1])
        slack = _CONTACT * np.minimum(sides[pairs[:, 0]], sides[pairs[:, 1]])
        found.append(np.sort(pairs[np.all(high - low > slack[:, None], axis=1)], axis=1))
    return np.concatenate(found)
