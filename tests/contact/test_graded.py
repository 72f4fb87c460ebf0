"""Graded series resolve what begins like a root, at their foot or a hair below it."""

import numpy as np
import pytest

from gearwright.contact.graded import Graded

FOOT, HEAD = 0.62, 0.75


@pytest.mark.parametrize("below", [0.0, 1e-9, 1e-7, 1e-5, 6e-5, 1e-3, 0.1])
def test_a_power_of_three_halves_with_its_branch_at_or_below_the_foot(below):
    """Slopes are checked from a thousandth of the root of the height upwards, where they are promised."""
    start = FOOT - below
    found = Graded.of(lambda u: 0.1 - (u - start) ** 1.5, FOOT, HEAD)
    u = FOOT + (HEAD - FOOT) * np.linspace(2e-3, 1.0, 2001) ** 2
    np.testing.assert_allclose(found.value(u), 0.1 - (u - start) ** 1.5, atol=1e-14)
    np.testing.assert_allclose(found.slope(u), -1.5 * np.sqrt(u - start), atol=1e-9)


def test_it_is_asked_for_nothing_outside():
    asked = []
    Graded.of(lambda u: asked.append(u) or u, FOOT, HEAD)
    assert FOOT <= np.min(asked) <= np.max(asked) <= HEAD


def test_places_keep_their_shape():
    found = Graded.of(np.cos, FOOT, HEAD)
    for u in (0.7, np.full((2, 3), 0.7), np.array([])):
        np.testing.assert_allclose(found.value(u), np.cos(u), atol=1e-15)
        np.testing.assert_allclose(found.slope(u), -np.sin(u), atol=1e-12)
