"""Views of a rack: its teeth, and the section across them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...sections.drawings.contours import Contour
from ...sheets.line_kinds import CENTRE, THIN, VISIBLE
from ...sheets.marks import Stroke, line, polyline
from ...sheets.views import Span, View
from ..drafting import box, cut, drawn, outlines

if TYPE_CHECKING:
    from .rack import Rack

_FEW = 12  # teeth, up to which all are drawn
_SHOWN = 3  # at either end, where there are more


def rack_views(rack: Rack) -> tuple[View, ...]:
    """The view across the teeth, tips up, and the section along them."""
    tooth, b, back = rack.tooth, rack.face_width, rack.back
    length = rack.teeth * tooth.circular_pitch
    drawn_teeth = min(rack.teeth, _FEW)
    (chain,) = outlines(tooth.section(drawn_teeth, back), np.pi / 2.0)
    left, right = -length + tooth.circular_pitch / 2.0, tooth.circular_pitch / 2.0
    shown = drawn((chain,))
    if rack.teeth > _FEW:
        shown = _few_teeth(rack, chain, left, right)
    more = 0.02 * length
    front = View(
        title="Seen along the teeth, from z = b" if not rack.helix.angle else "Transverse section",
        strokes=(*shown, line((left - more, 0.0), (right + more, 0.0), CENTRE)),
        dimensions=(
            Span(start=(left, -back), end=(right, -back), side="below"),
            Span(start=(left, -back), end=(left, 0.0), side="left"),
            Span(start=(right, -back), end=(right, tooth.addendum), side="right"),
        ),
    )
    strokes, hatches = cut(box(0.0, -back, b, -tooth.dedendum))
    teeth = polyline(
        [(0.0, -tooth.dedendum), (0.0, tooth.addendum), (b, tooth.addendum), (b, -tooth.dedendum)], VISIBLE
    )
    section = View(
        title="Section through a space",
        strokes=(*strokes, teeth, line((-0.05 * b, 0.0), (1.05 * b, 0.0), CENTRE)),
        hatches=hatches,
        dimensions=(Span(start=(0.0, -back), end=(b, -back), side="below"),),
    )
    return front, section, _tooth_detail(rack, chain)


def _tooth_detail(rack: Rack, chain: Contour) -> View:
    """The first tooth and half of the next, true to shape."""
    tooth, pitch = rack.tooth, rack.tooth.circular_pitch
    shown = [
        one
        for one in chain
        if abs((one.start + one.end)[0] / 2.0 + pitch / 2.0) < pitch and (one.start + one.end)[1] / 2.0 > -rack.back
    ]
    shown = [one for one in shown if min(one.start[1], one.end[1]) >= -tooth.dedendum * (1.0 + 1e-9)]
    half = tooth.thickness / 2.0
    ends = [float(p[0]) for one in shown for p in (one.start, one.end)]
    return View(
        title="Teeth in the transverse section",
        strokes=(
            *(Stroke(chain=(one,), kind=VISIBLE) for one in shown),
            line((min(ends), 0.0), (max(ends), 0.0), CENTRE),
        ),
        dimensions=(
            Span(start=(half - pitch, 0.0), end=(half, 0.0), side="below"),
            Span(start=(-half, 0.0), end=(half, 0.0), side="above"),
            Span(start=(min(ends), 0.0), end=(0.0, tooth.addendum), side="left"),
            Span(start=(max(ends), -tooth.dedendum), end=(0.0, tooth.addendum), side="right"),
        ),
        detail=True,
    )


def _few_teeth(rack: Rack, chain: Contour, left: float, right: float) -> tuple[Stroke, ...]:
    """The teeth at both ends on their true outline; between them tips as a thick line, roots as a thin one.

    chain   the outline of a shorter rack, which starts with the same tooth
    """
    tooth, back = rack.tooth, rack.back
    reach = _SHOWN * tooth.circular_pitch
    far = np.array([-(rack.teeth - _FEW) * tooth.circular_pitch, 0.0])
    begin = left - float(far[0])
    kept = []
    for one in chain:
        x, y = (one.start + one.end) / 2.0
        if x > right - reach and y > -back * (1.0 - 1e-9):
            kept.append(one)
        elif x < begin + reach and y > -back * (1.0 - 1e-9):
            kept.append(one.moved(0.0, far))
    tips = line((left + reach, tooth.addendum), (right - reach, tooth.addendum), VISIBLE)
    roots = line((left + reach, -tooth.dedendum), (right - reach, -tooth.dedendum), THIN)
    foot = line((left, -back), (right, -back), VISIBLE)
    return (*(Stroke(chain=(one,), kind=VISIBLE) for one in kept), tips, roots, foot)
