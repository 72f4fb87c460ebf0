"""The loops of faces, as the parts of edges they run along."""

from __future__ import annotations

from ....boundary.edge import EdgeUse
from ....boundary.faces import CapLoop, Patch
from .rounds import Ref


def side(use: EdgeUse, k: int = 0) -> Ref:
    """A side of image k of a patch."""
    return Ref(edge=use.edge, image=(k + use.turn) % use.edge.pattern.order, reverse=use.reverse)


def sides(patch: Patch) -> list[list[Ref]]:
    """The loops of a patch as a face on a surface that is known, so that it need not meet itself.

    One around it; where it begins and ends at the same edge that edge is inside the face, and there are two loops.
    """
    first, right, second, left = patch.sides
    if first.edge is second.edge and first.turn == second.turn:
        loops = [[right], [left]]
    elif right.edge is left.edge and patch.pattern.order == 1:
        loops = [[first], [second]]
    else:
        loops = [[first, right, second, left]]
    whole = ([side(use) for use in loop if not use.edge.degenerate] for loop in loops)
    return [loop for loop in whole if loop]


def around(loop: CapLoop) -> list[Ref]:
    """A cap's loop with all images, in its sense."""
    onward = -1 if loop.uses[-1].edge.end_turn < 0 else 1
    refs = [side(use, onward * k) for k in range(loop.pattern.order) for use in loop.uses]
    return [ref._replace(reverse=not ref.reverse) for ref in reversed(refs)] if loop.reverse else refs
