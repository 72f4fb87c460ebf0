"""Roots of many functions at once."""

import numpy as np
import pytest

from gearwright.curves.crossing import crossing

SHAPES = {
    "line": lambda x, root: x - root,
    "cube": lambda x, root: (x - root) ** 3 + 0.1 * (x - root),
    "root": lambda x, root: np.sqrt(x) - np.sqrt(root),
    "steep": lambda x, root: np.tanh(40.0 * (x - root)),
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("turned", [False, True])
def test_roots_are_found_to_rounding(shape, turned):
    roots = np.concatenate([[0.0, 1.0, 1e-12], np.linspace(0.01, 0.99, 57)])
    ends = np.zeros_like(roots), np.ones_like(roots)
    found = crossing(lambda x: SHAPES[shape](x, roots), *(ends[::-1] if turned else ends))
    np.testing.assert_allclose(found, roots, rtol=0.0, atol=2e-15)


@pytest.mark.parametrize("turned", [False, True])
def test_without_a_change_of_sign_it_is_the_nearer_end_whatever_the_others_need(turned):
    """Some are found at once, one takes long: those that have been found stay."""
    roots = np.array([-0.3, 1.2, 0.5, 5.0, -7.0, 0.4])
    ends = np.zeros_like(roots), np.ones_like(roots)

    def function(x):
        return np.where(np.arange(6) == 5, (x - 0.4) ** 9, x - roots)

    found = crossing(function, *(ends[::-1] if turned else ends))
    assert found[:5].tolist() == [0.0, 1.0, 0.5, 1.0, 0.0]
