"""Any pair on parallel axes is refused as such, or its members' sections run together without cutting each other."""

import numpy as np
import pytest
from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

from gearwright.elements.cylindrical.gear_pair import GearPair
from gearwright.errors import ParameterError

from .running import shared

KINDS = ("spur", "helical", "herringbone", "internal", "rack")
MOST = 1e-4  # of m_n²: what chords share where flanks touch


def maybe(strategy):
    return st.none() | strategy


def each(strategy):
    return st.tuples(strategy, strategy)


@st.composite
def pairs(draw, kind):
    module = draw(st.sampled_from([0.5, 2.0, 8.0]))
    first = draw(st.integers(5, 40))
    second = first + draw(st.integers(3, 60)) if kind == "internal" else draw(st.integers(5, 60))
    if kind == "rack":
        second = draw(st.integers(5, 9))
    values = {"kind": kind, "teeth": (first, second), "module": module, "face_width": 3.0 * module}
    if kind != "spur":
        values["helix_angle"] = draw(st.sampled_from([10.0, 25.0] if kind in KINDS[1:3] else [0.0, 15.0]))
        values["hand"] = draw(st.sampled_from(["right", "left"]))
    small = st.floats(-0.6, 0.8)
    values["profile_shift"] = draw(maybe(small if kind == "rack" else each(small)))
    values["pressure_angle"] = draw(st.sampled_from([14.5, 20.0, 20.0, 25.0]))
    values["root"] = draw(st.sampled_from(["fillet", "fillet", "radial"]))
    values["backlash"] = draw(st.sampled_from([0.0, 0.05])) * module
    values["addendum_coefficient"] = draw(maybe(each(st.floats(0.6, 1.2))))
    values["tip_shortening"] = draw(st.sampled_from(["full", "none"]))
    if draw(st.booleans()):
        sense = {"internal": -1.0}.get(kind, 1.0)
        reference = (first + sense * second) / 2.0 if kind != "rack" else first / 2.0
        helix = np.cos(np.radians(values.get("helix_angle", 0.0)))
        values["centre_distance"] = abs(reference) * module / helix + draw(st.floats(-0.3, 0.6)) * module
    return values


def _built(values):
    try:
        return GearPair(**values), None
    except ParameterError as error:
        return None, error


@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=40, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_built_pairs_run_without_cutting(kind, data):
    values = data.draw(pairs(kind))
    pair, error = _built(values)
    if error is not None:
        assert error.element == "GearPair"
        assert all(problem.message and "nan" not in problem.message for problem in error.problems)
        event("refused")
        return
    event("built")
    assert all(np.isfinite(size.value) for size in pair.sizes().values())
    assert min(pair.mesh.clearances) > 0.0
    assert pair.mesh.contact_ratio > 0.0
    for turn in (0.0, data.draw(st.floats(0.0, 1.0))):
        assert shared(pair, turn) < MOST * pair.pinion.normal_module**2, (values, turn)
