"""Whatever a bevel gear or pair accepts builds a closed solid whose moments are the flux through its boundary."""

import numpy as np
from hypothesis import HealthCheck, given, settings

from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.errors import ParameterError
from gearwright.moments.matrix import shifted
from gearwright.solids.solid import flux_moments

from .random_bevels import gears, pairs

run = settings(max_examples=45, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


def _about_apex(body):
    return shifted(body.matrix, body.origin)


def _holds(part):
    exact, flux = part.solid.moments, flux_moments(part.boundary)
    one, other = _about_apex(exact), _about_apex(flux)
    size = np.sqrt(np.trace(one[1:, 1:]) / one[0, 0])
    unit = np.array([1.0, size, size, size])
    assert np.abs((one - other) / (one[0, 0] * np.outer(unit, unit))).max() < 1e-10
    assert exact.volume > 0.0
    assert exact.error_bound < 1e-9
    assert all(np.isfinite(size.value) for size in part.sizes().values())


def _built_or_refused(element, values):
    try:
        found = element(**values)
    except ParameterError:
        return
    for part in (found.pinion, found.gear) if element is BevelPair else (found,):
        _holds(part)


@run
@given(gears())
def test_gears(case):
    _built_or_refused(*case)


@settings(run, max_examples=15)
@given(pairs())
def test_pairs(case):
    _built_or_refused(*case)
