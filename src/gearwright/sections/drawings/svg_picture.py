"""A section as a small SVG picture, for notebooks: the region filled, and how wide and high it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .contours import Profile, contours
from .svg_writing import HAND, path_data

if TYPE_CHECKING:
    from ..plane import Section

_TOLERANCE = 1e-4  # of the section's size: less than a pixel
_SIDE, _TEXT = 360.0, 20.0  # pixels: the longer side, the line below
_INK = "#3a78c9"  # seen on white and on black
_LEAST = 0.02  # of the longer side, so that a thin section still has an area on the page

_PICTURE = """<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{tall:.0f}" \
viewBox="0 0 {width:.0f} {tall:.0f}" role="img" aria-label="{said}">
<title>{said}</title>
<path transform="translate({x:.6g} {y:.6g}) scale({scale:.9g})" d="{path}" fill="{ink}" fill-opacity="0.22" \
fill-rule="evenodd" stroke="{ink}" stroke-width="1.4" vector-effect="non-scaling-stroke" stroke-linejoin="round"/>
<text x="{middle:.0f}" y="{line:.0f}" font-family="sans-serif" font-size="12" text-anchor="middle" fill="{ink}">{size}\
</text>
</svg>"""


def svg_picture(section: Section) -> str:
    """An SVG image of a plane section on its true curves, in lengths of its own unit."""
    drawn = contours(Profile(section=section), _TOLERANCE * section.size, HAND)
    points = np.concatenate([one.samples() for contour in drawn for one in contour])
    low, high = points.min(axis=0), points.max(axis=0)
    sides = np.maximum(high - low, _LEAST * np.max(high - low))
    scale = _SIDE / float(np.max(sides))
    width, height = sides * scale + 8.0
    size = " × ".join(f"{side:.6g}" for side in high - low)
    return _PICTURE.format(
        width=max(width, 120.0),
        tall=height + _TEXT,
        said=f"section, {size}",
        x=(max(width, 120.0) - scale * (low[0] + high[0])) / 2.0,
        y=(height + scale * (low[1] + high[1])) / 2.0,  # y points up in the section, down on the page
        scale=scale,
        path=" ".join(map(path_data, drawn)),
        ink=_INK,
        middle=max(width, 120.0) / 2.0,
        line=height + 14.0,
        size=size,
    )
