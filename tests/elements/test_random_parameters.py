"""Any parameters are either refused as such, or give a watertight part of positive volume; nothing else happens.

pytest turns every warning into an error, so numpy's about overflow and invalid values fail these tests too.
"""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.cams.cam import Cam
from gearwright.elements.cams.kinds import KINDS
from gearwright.elements.cams.laws import FIXED_LAWS
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.elements.cylindrical.rack import Rack
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.elements.standards.iso_53 import BASIC_RACKS
from gearwright.elements.sweep import Sweep
from gearwright.errors import ParameterError

from ..examples import EXAMPLES, SHARP
from ..laws.topology import edges_pair_up, fans_at_vertices

run = settings(max_examples=40, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))

teeth = st.integers(3, 60)
angle = st.one_of(st.floats(14.0, 30.0), st.floats(0.5, 50.0))
share = st.floats(0.05, 1.6)
"""A length in modules."""


def maybe(strategy):
    return st.none() | strategy


@st.composite
def common(draw):
    module = draw(st.floats(0.2, 30.0))
    values = {"module": module} if draw(st.booleans()) else {"diametral_pitch": 25.4 / module}
    values["length_unit"] = draw(st.sampled_from(["mm", "in"]))
    values["pressure_angle"] = draw(angle)
    own = module / (25.4 if values["length_unit"] == "in" else 1.0)
    values["backlash"] = draw(st.sampled_from([0.0, 0.02, 0.3])) * own
    return values, own


@st.composite
def blank(draw, module, z):
    values = {}
    for name, strategy in (("addendum", share), ("dedendum", share), ("circular_thickness", st.floats(0.8, 2.2))):
        value = draw(maybe(strategy))
        if value is not None:
            values[name] = value * module
    bore = draw(maybe(st.floats(0.02, 1.0)))
    return values if bore is None else {**values, "bore": bore * z * module}


@st.composite
def trace(draw):
    kind = draw(st.sampled_from(["straight", "straight", "skew", "logarithmic", "circular", "involute", "epicycloid"]))
    if kind == "straight":
        return {}
    values = {
        "trace": kind,
        "spiral_angle": draw(st.floats(0.0, 50.0)),
        "hand": draw(st.sampled_from(["right", "left"])),
    }
    if kind in ("circular", "epicycloid"):
        values["cutter_radius"] = draw(st.floats(2.0, 100.0))
    if kind == "epicycloid":
        values["blade_groups"] = draw(st.integers(1, 17))
    return values


@st.composite
def spur_gears(draw):
    values, module = draw(common())
    z = draw(teeth)
    return SpurGear, {**values, **draw(blank(module, z)), "teeth": z, "face_width": draw(st.floats(0.3, 30.0)) * module}


@st.composite
def flanks(draw, module, *, ring=False):
    """Profile shift, fillets, relief, chamfer and crowning, in lengths of the module."""
    values = {"profile_shift": draw(st.sampled_from([0.0, 0.2, 0.4, -0.2]) | st.floats(-1.0, 1.0))}
    values["basic_rack"] = draw(st.sampled_from(list(BASIC_RACKS)))
    values["pressure_angle"] = draw(st.sampled_from([20.0, 25.0]) | st.floats(14.5, 30.0))
    values["root"] = draw(st.sampled_from(["fillet", "fillet", "radial"]))
    radius = "fillet_radius" if ring else "rack_tip_radius"
    for name, strategy in (
        ("tip_relief", st.floats(0.001, 0.05)),
        ("tip_chamfer", st.floats(0.01, 0.2)),
        ("crowning", st.floats(0.001, 0.05)),
        (radius, st.floats(0.01, 0.5)),
    ):
        if draw(st.integers(0, 3)) == 3 and (name != radius or values["root"] == "fillet"):
            values[name] = draw(strategy) * module
    values["tip_relief_form"] = draw(st.sampled_from(["linear", "parabolic"]))
    return values


@st.composite
def helices(draw):
    angle = draw(st.floats(0.0, 45.0) | st.floats(0.0, 80.0))
    return {"helix_angle": angle, "hand": draw(st.sampled_from(["right", "left"]))}


@st.composite
def bodies(draw, diameter, width):
    """A body inside the teeth, most often one that fits."""
    if draw(st.booleans()):
        return {}
    values = {"bore": diameter * draw(st.floats(0.1, 0.3))}
    if draw(st.booleans()):
        values |= {"keyway_width": values["bore"] * 0.25, "keyway_depth": values["bore"] * 0.12}
    if draw(st.booleans()):
        hub = {"hub_diameter": diameter * draw(st.floats(0.4, 0.6)), "hub_length": width * draw(st.floats(1.1, 3.0))}
        values |= hub
    return values


@st.composite
def external_gears(draw):
    kind = draw(st.sampled_from([SpurGear, HelicalGear, HerringboneGear]))
    values, module = draw(common())
    z = draw(st.integers(12, 60) | teeth)
    width = draw(st.floats(0.5, 6.0)) * module
    values |= {**draw(flanks(module)), **({} if kind is SpurGear else draw(helices()))}
    values |= draw(bodies(z * module, width))
    span = draw(st.sampled_from([None, None, None, 2, 3]))
    return kind, {**values, "teeth": z, "face_width": width, "span_teeth": span}


@st.composite
def internal_gears(draw):
    values, module = draw(common())
    values |= {**draw(flanks(module, ring=True)), **draw(helices())}
    values["addendum_coefficient"] = draw(st.sampled_from([0.6, 0.8, 1.0]))
    width = draw(st.floats(0.5, 6.0)) * module
    return InternalGear, {**values, "teeth": draw(st.integers(36, 80) | st.integers(20, 70)), "face_width": width}


@st.composite
def racks(draw):
    values, module = draw(common())
    values |= {**draw(helices()), "basic_rack": draw(st.sampled_from(list(BASIC_RACKS)))}
    for name, strategy in (("addendum", share), ("dedendum", share), ("fillet_radius", st.floats(0.01, 0.6))):
        value = draw(maybe(strategy))
        if value is not None:
            values[name] = value * module
    return Rack, {**values, "teeth": draw(st.integers(3, 8)), "face_width": draw(st.floats(0.5, 6.0)) * module}


@st.composite
def bevel_gears(draw):
    values, module = draw(common())
    z, pitch_angle = draw(teeth), draw(st.one_of(st.floats(3.0, 90.0), st.just(90.0)))
    cone_distance = z * module / 2.0 / np.sin(np.radians(pitch_angle))
    width = float(draw(st.floats(0.02, 1.05)) * cone_distance)
    return BevelGear, {
        **values,
        **draw(blank(module, z)),
        **draw(trace()),
        "teeth": z,
        "pitch_angle": pitch_angle,
        "face_width": width,
    }


@st.composite
def bevel_pairs(draw):
    values, module = draw(common())
    numbers = draw(st.tuples(st.integers(10, 50), st.integers(10, 50)))
    depth = draw(st.floats(0.8, 2.2))
    values |= {
        "working_depth": depth * module,
        "whole_depth": draw(st.floats(0.98, 1.3)) * depth * module,
        "gear_addendum": draw(st.floats(0.3, 0.7)) * depth * module,
    }
    return BevelPair, {
        **values,
        **draw(trace()),
        "teeth": numbers,
        "shaft_angle": draw(st.floats(30.0, 130.0)),
        "face_width": draw(st.floats(0.1, 6.0)) * module,
    }


@st.composite
def programmes(draw):
    """A turn of dwells and moves that comes back; now and then one that does not."""
    kinds = draw(
        st.sampled_from(["rise return", "dwell rise dwell return", "rise dwell return dwell", "rise return dwell"])
    )
    shares = np.array([draw(st.floats(0.3, 1.0)) for _ in kinds.split()])
    angles = np.round(360.0 * shares / shares.sum(), 3)
    angles[-1] = draw(st.sampled_from([1.0, 1.0, 1.0, 1.01])) * (360.0 - angles[:-1].sum())
    return ", ".join(f"{kind} {angle:.3f}" for kind, angle in zip(kinds.split(), angles, strict=True))


@st.composite
def cams(draw):
    size = draw(st.sampled_from([1e-3, 0.1, 1.0, 40.0, 1e4]))
    follower = draw(st.sampled_from(list(KINDS)))
    values = {"programme": draw(programmes()), "follower": follower, "thickness": draw(st.floats(0.1, 3.0)) * size}
    values["law"] = draw(st.sampled_from([*FIXED_LAWS, None]))
    if follower.startswith("oscillating"):
        values |= {"swing": draw(st.floats(2.0, 60.0)), "pivot_distance": size}
        values["sense"] = draw(st.sampled_from(["opposite", "same", None]))
    else:
        values["lift"] = draw(st.floats(0.05, 0.8)) * size
    ranges = {
        "oscillating-flat-face": {"face_offset": (-0.3, 4.0), "initial_angle": (-20.0, 70.0)},
        "translating-flat-face": {"base_radius": (0.3, 3.0)},
        "translating-roller": {"base_radius": (0.3, 3.0), "roller_radius": (0.05, 1.0), "offset": (-0.6, 0.6)},
        "oscillating-roller": {"arm_length": (0.3, 1.1), "roller_radius": (0.03, 0.4), "initial_angle": (15.0, 90.0)},
    }[follower]
    for name, (low, high) in ranges.items():
        values[name] = draw(st.floats(low, high)) * (1.0 if name == "initial_angle" else size)
    bore = draw(maybe(st.floats(0.02, 1.0)))
    return Cam, values if bore is None else {**values, "bore": bore * size}


def _built_or_refused(element, values):
    try:
        found = element(**values)
    except ParameterError:
        return
    assert all(np.isfinite(size.value) for size in found.sizes().values())
    for part in (found.pinion, found.gear) if element is BevelPair else (found,):
        exact = part.properties()
        body = part.polyhedron()
        triangles = np.asarray(body.faces)
        assert edges_pair_up(triangles)
        assert set(fans_at_vertices(triangles)) == {1}
        approximate = body.properties()
        assert exact.volume > 0.0
        assert exact.error_bound < 1e-9
        assert approximate.volume == pytest.approx(exact.volume, rel=0.01)


@run
@given(spur_gears())
def test_spur_gears(case):
    _built_or_refused(*case)


@run
@given(bevel_gears())
def test_bevel_gears(case):
    _built_or_refused(*case)


@settings(run, max_examples=60)
@given(external_gears())
def test_external_gears(case):
    _built_or_refused(*case)


@settings(run, max_examples=30)
@given(internal_gears())
def test_internal_gears(case):
    _built_or_refused(*case)


@settings(run, max_examples=30)
@given(racks())
def test_racks(case):
    _built_or_refused(*case)


@settings(run, max_examples=25)
@given(bevel_pairs())
def test_bevel_pairs(case):
    _built_or_refused(*case)


@settings(run, max_examples=120)
@given(cams())
def test_cams(case):
    _built_or_refused(*case)


anything = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 10**6),
    st.floats(),
    st.text(max_size=3),
    st.lists(st.floats(), max_size=3),
    st.tuples(st.integers(0, 30), st.integers(0, 30)),
    st.lists(st.lists(st.floats(-9.0, 9.0), min_size=2, max_size=3), max_size=4),
    st.dictionaries(
        st.sampled_from(["circle", "rectangle", "polygon", "centre", "helix", "f1", "h2"]),
        st.floats() | st.lists(st.floats(-3.0, 3.0) | st.lists(st.floats(-9.0, 9.0), max_size=3), max_size=4),
        max_size=2,
    ),
)


@pytest.mark.parametrize(
    ("element", "base"),
    [
        (SpurGear, {"teeth": 16, "module": 8.0, "face_width": 50.0}),
        (HelicalGear, {"teeth": 20, "module": 4.0, "face_width": 15.0, "helix_angle": 20.0}),
        (InternalGear, {"teeth": 40, "module": 4.0, "face_width": 15.0}),
        (Rack, {"teeth": 5, "module": 4.0, "face_width": 15.0}),
        (BevelGear, {"teeth": 20, "pitch_angle": 45.0, "module": 4.0, "face_width": 15.0}),
        (BevelPair, {"teeth": (16, 20), "module": 4.0, "face_width": 15.0}),
        (Sweep, {"section": {"rectangle": (3.0, 2.0), "centre": (4.0, 1.0)}, "length": 5.0}),
        (Cam, {**EXAMPLES["cam"]["translating roller, offset"]}),
        (Cam, {**EXAMPLES["cam"]["oscillating flat face"]}),
        (Sweep, {"section": {"circle": 1.0}, "path": ((0.0, 0.0, 0.0), (0.0, 5.0, 10.0), (9.0, 9.0, 30.0))}),
    ],
    ids=lambda value: value.__name__ if isinstance(value, type) else "",
)
def test_anything_in_any_place_is_refused_or_taken(element, base):
    names = list(element.__dataclass_fields__)

    @settings(run, max_examples=250)
    @given(st.dictionaries(st.sampled_from(names), anything, min_size=1, max_size=3))
    def check(changes):
        try:
            element(**{**base, **changes})
        except ParameterError:
            return

    check()


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 1e3, 1e9])
@pytest.mark.parametrize("element", [SpurGear, BevelGear], ids=lambda element: element.__name__)
def test_size_does_not_matter(element, scale):
    more = {} if element is SpurGear else {"pitch_angle": 50.0}
    one, other = (
        element(teeth=20, module=4.0 * s, face_width=15.0 * s, bore=20.0 * s, **more).properties() for s in (1.0, scale)
    )
    assert other.volume == pytest.approx(one.volume * scale**3, rel=1e-12)


@pytest.mark.parametrize("excess", [1e-3, 1e-6, 1e-9, 1e-12, 0.0, -1e-12, -1e-9, -1e-6, -1e-3])
def test_root_at_the_base_circle(excess):
    """Where the radial piece of the flank is next to nothing the polyhedron stays a sensible one."""
    dedendum = 64.0 - 64.0 * float(np.cos(np.radians(20.0))) + excess
    gear = SpurGear(teeth=16, module=8.0, face_width=50.0, dedendum=dedendum, root="radial")
    assert gear.properties().volume == pytest.approx(669403.09, abs=10.0)
    body = gear.polyhedron()
    assert len(body.faces) < 30_000
    assert body.properties().volume == pytest.approx(gear.properties().volume, rel=1e-3)


@pytest.mark.parametrize("bore", [0.1, 3.0, 4.4, 4.9])
@pytest.mark.parametrize("teeth", [3, 4, 5])
def test_few_teeth_around_a_bore(teeth, bore):
    """A sector is then a third of the whole, and its chord comes near the axis."""
    gear = SpurGear(teeth=teeth, module=4.0, face_width=8.0, addendum=1.0, dedendum=3.4, bore=bore)
    assert gear.polyhedron().properties().volume == pytest.approx(gear.properties().volume, rel=2e-3)


@pytest.mark.parametrize(
    ("element", "values"),
    [
        (SpurGear, {"teeth": 3, "module": 4.483, "face_width": 7.75, "dedendum": 1.0144, "bore": 2.25656}),
        (SpurGear, {"teeth": 5, "module": 1.81243, "face_width": 3.137, "addendum": 2.1152, "bore": 1.2319}),
        (BevelGear, {"teeth": 3, "module": 0.908, "mate_teeth": 8, "face_width": 1.16, "bore": 0.0521}),
        (BevelGear, {"teeth": 4, "module": 8.12, "mate_teeth": 100, "face_width": 4.08, "bore": 2.573}),
        (
            BevelGear,
            {"teeth": 12, "module": 2.0, "pitch_angle": 5.0, "face_width": 13.66, "addendum": 0.87, "bore": 6.288},
        ),
        (BevelGear, {"teeth": 38, "diametral_pitch": 4.383, "mate_teeth": 50, "face_width": 63.5, "bore": 58.92}),
        (
            BevelGear,
            {
                **SHARP,
                "teeth": 3,
                "module": 1.0,
                "pitch_angle": 3.0,
                "face_width": 28.62,
                "trace": "logarithmic",
                "spiral_angle": 1.0,
            },
        ),
        (
            BevelGear,
            {
                **SHARP,
                "teeth": 4,
                "diametral_pitch": 2.113226323374023,
                "pressure_angle": 18.109035818894796,
                "pitch_angle": 70.0,
                "face_width": 0.25581846224337484,
                "trace": "logarithmic",
                "spiral_angle": 2.7295732329441114,
            },
        ),
        (
            BevelGear,
            {
                **SHARP,
                "teeth": 24,
                "mate_teeth": 38,
                "shaft_angle": 116.27378367019209,
                "module": 2.384024737064433,
                "face_width": 4.629085887024703,
                "addendum": 4.523965193548972 / 2,
                "dedendum": 6.134071786200287 - 4.523965193548972 / 2,
            },
        ),
        (
            BevelGear,
            {
                **SHARP,
                "teeth": 16,
                "mate_teeth": 54,
                "diametral_pitch": 8.863254062643028,
                "backlash": 0.16927823861772875,
                "face_width": 28.24523264612272,
            },
        ),
    ],
    ids=lambda value: value.__name__ if isinstance(value, type) else "",
)
def test_parts_that_once_failed(element, values):
    """Thin sectors beside a bore, chords of a ring or a border just below the sphere, an apex all but reached."""
    part = element(**values)
    body = part.polyhedron()
    assert edges_pair_up(np.asarray(body.faces))
    assert body.properties().volume == pytest.approx(part.properties().volume, rel=0.01)
