"""Every kind of part, as a polyhedron, is its design to within the chords, and none when it is a little larger."""

import numpy as np
import pytest

import gearwright as gw

from ..examples import PARTS, built, polyhedron, size

TOLERANCE = 1e-3
"""Of the part's size: coarse, so that the polyhedra are small."""
SOME = [part for part in {part.element: part for part in PARTS}.values() if "pair" not in part.element]


@pytest.mark.parametrize("part", SOME, ids=str)
def test_a_polyhedron_is_its_design_to_within_its_chords_and_stretched_is_not(part):
    within = TOLERANCE * size(part)
    agreement = gw.compare(polyhedron(part, TOLERANCE), built(part), within=within)
    assert agreement.passed, str(agreement)
    (found,) = (one.comparison for one in agreement.parts)
    assert found.deviation.rms < within / 2.0
    assert found.area == pytest.approx(polyhedron(part, TOLERANCE).properties().area, rel=2e-2)
    stretched = polyhedron(part, TOLERANCE).transformed(np.diag([1.0, 1.0, 1.05, 1.0]))
    assert not gw.compare(stretched, built(part), within=within).passed
