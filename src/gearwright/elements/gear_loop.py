"""The outline of a gear: one symmetric tooth and its space, repeated about the axis."""

from __future__ import annotations

from collections.abc import Sequence

from ..curves.curve import Curve, mapped, turn
from ..sections.loop import Loop

NEXT_TO_NOTHING = 1e-10
"""Height of a radial piece of flank, relative to the base circle or cone, that is left out: within a loop's closure."""


def gear_loop(rising: Sequence[Curve], tip: Curve | None, root: Curve | None, teeth: int) -> Loop:
    """The loop of all teeth, the first one centred on +x.

    rising   curves of the flank on the clockwise side of the first tooth, from root to tip; the other
             flank is its mirror image
    tip      from flank to flank across the tooth; None where they meet
    root     from the tooth to the next one; None where their flanks meet

    The curves lie in the plane or on the unit sphere.
    """
    mirror = turn(0.0, rising[0].start.size, mirrored=True)
    falling = [mapped(curve, mirror).reversed() for curve in reversed(rising)]
    chain = (*rising, tip, *falling, root)
    return Loop(curves=tuple(curve for curve in chain if curve is not None), copies=teeth)
