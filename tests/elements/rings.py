"""Toothed rings with the plainest teeth, to put a gear's body into: radial flanks between arcs."""

import numpy as np

from gearwright.curves.arc import Arc
from gearwright.curves.line import Line
from gearwright.motions.ends import between
from gearwright.motions.extrusion import Extrusion
from gearwright.motions.herringbone import Herringbone
from gearwright.motions.straight import Straight
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section
from gearwright.solids.swept import Swept

TEETH, ROOT, TIP, FACE = 24, 55.0, 64.0, 40.0
STEP = 2.0 * np.pi / TEETH
MOTIONS = {
    "spur": Straight(),
    "helical": Extrusion(length=FACE, twist=0.3),
    "herringbone": Herringbone(length=FACE, twist=0.25),
}
AREA = TEETH * (0.4 * STEP * TIP**2 + 0.6 * STEP * ROOT**2) / 2.0
"""Of the full section: sectors alone."""


def _at(radius, angle):
    return (float(radius * np.cos(angle)), float(radius * np.sin(angle)))


def section(hole=None, scale=1.0):
    """The toothed section, its first tooth centred on +x, with a round hole."""
    low, high, root, tip = -0.2 * STEP, 0.2 * STEP, scale * ROOT, scale * TIP
    curves = (
        Line(first=_at(root, low), last=_at(tip, low)),
        Arc(radius=tip, interval=(low, high)),
        Line(first=_at(tip, high), last=_at(root, high)),
        Arc(radius=root, interval=(high, low + STEP)),
    )
    holes = () if hole is None else (Loop(curves=(Arc(radius=hole, interval=(0.0, -STEP)),), copies=TEETH),)
    return Section(loops=(Loop(curves=curves, copies=TEETH), *holes))


def ring(kind="spur"):
    """The toothed ring by the radius of its hole."""
    return lambda hole: Swept(section=section(hole), motion=MOTIONS[kind], ends=between(0.0, FACE))
