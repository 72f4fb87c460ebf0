"""How the errors of an element's polyhedra fall with the chord tolerance, as a chart."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..pictures.chart import Axis, Chart, Line, Style
from ..solids.approximation import approximation_error
from ..solids.convergence import QUANTITIES, ApproximationError
from .pair import Pair

_MEASURES = """volume: relative; centroid: over the bounding diagonal; inertia: about the centroid, norm of the \
difference over the norm"""


def convergence(element: Any) -> Chart:
    """Relative errors of volume, centroid and inertia over the tolerance, log over log; of each member of a pair."""
    parts = element.members if isinstance(element, Pair) else {"": element}
    studies = {name: approximation_error(part) for name, part in parts.items()}
    styles: tuple[Style, ...] = ("solid", "dashed")
    return Chart(
        title=f"Errors of polyhedra, {element.description}",
        x=Axis(label="chord tolerance", unit=element.length_unit),
        y=Axis(label="relative error"),
        log="both",
        lines=[
            line
            for style, (name, study) in zip(styles, studies.items(), strict=False)
            for line in _lines(name, study, style)
        ],
        notes=[
            _MEASURES,
            *(_said(name, remark) for name, study in studies.items() for remark in study.remarks),
        ],
    )


def _lines(name: str, study: ApproximationError, style: Style) -> list[Line]:
    orders = study.orders
    found = []
    for quantity in QUANTITIES:
        steps, errors = study.measured(quantity)
        order = orders[quantity]
        label = _said(name, quantity) + ("" if order is None else f", order {order:.2f}")
        if len(steps):
            found.append(Line(name=label, x=steps, y=np.abs(errors), style=style))
    return found


def _said(name: str, what: str) -> str:
    return f"{name}: {what}" if name else what
