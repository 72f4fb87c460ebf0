"""Properties of smooth bodies mapped, against polyhedra mapped."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.files.contents import SmoothProperties
from gearwright.solids.polyhedron import Polyhedron

CORNER = Polyhedron([(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def of(polyhedron):
    found = polyhedron.properties()
    inertia = found.central_inertia
    second_moment = np.trace(inertia) / 2 * np.eye(3) - inertia
    return SmoothProperties(volume=found.volume, centroid=found.centroid, second_moment=second_moment)


@pytest.mark.parametrize("seed", range(6))
def test_any_affine_map(seed):
    """Half of them mirror."""
    matrix = np.eye(4)
    matrix[:3] = np.random.default_rng(seed).normal(size=(3, 4))
    matrix[0] *= (-1) ** seed
    found, expected = of(CORNER).mapped(matrix[:3, :3], matrix[:3, 3]), of(CORNER.transformed(matrix))
    assert found.volume == pytest.approx(expected.volume, rel=1e-12)
    np.testing.assert_allclose(found.centroid, expected.centroid, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found.second_moment, expected.second_moment, rtol=1e-11, atol=1e-12)
