"""Teeth are what a rack with rounded tips leaves when it rolls around the gear: checked with the rack itself."""

import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.involute import Involute
from gearwright.curves.trochoid import Trochoid
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.spur_gear import SpurGear

from .generating_rack import GeneratingRack
from .profiles import angle_between, curves_of, polar, turned, unit_tangent

PLAIN = {
    "spur": (SpurGear, {"teeth": 24, "module": 3.0}, 0.38 * 3.0),
    "positive shift, small radius": (
        SpurGear,
        {"teeth": 19, "module": 2.0, "profile_shift": 0.5, "rack_tip_radius": 0.2, "backlash": 0.1},
        0.2,
    ),
    "negative shift": (SpurGear, {"teeth": 40, "module": 1.0, "profile_shift": -0.4, "pressure_angle": 25.0}, 0.3),
    "full radius": (SpurGear, {"teeth": 27, "module": 2.0, "basic_rack": "agma-full-radius"}, None),
    "helical": (HelicalGear, {"teeth": 21, "module": 2.5, "helix_angle": 25.0}, 0.38 * 2.5),
    "helical, steep": (
        HelicalGear,
        {"teeth": 12, "module": 2.0, "helix_angle": 45.0, "basic_rack": "iso-53-d", "profile_shift": 0.2},
        0.78,
    ),
    "helical, full radius": (
        HelicalGear,
        {"teeth": 30, "module": 1.5, "helix_angle": 15.0, "basic_rack": "agma-full-radius", "hand": "left"},
        None,
    ),
}
UNDERCUT = {
    "eight teeth": (SpurGear, {"teeth": 8, "module": 4.0}, 0.38 * 4.0),
    "six teeth, shifted": (SpurGear, {"teeth": 6, "module": 2.0, "profile_shift": 0.2}, 0.38 * 2.0),
    "sixteen, hardly": (SpurGear, {"teeth": 16, "module": 5.0}, 0.38 * 5.0),
    "helical, nine teeth": (HelicalGear, {"teeth": 9, "module": 2.0, "helix_angle": 20.0}, 0.38 * 2.0),
    "three teeth": (SpurGear, {"teeth": 3, "module": 8.0}, 0.38 * 8.0),
    "five teeth, shifted": (SpurGear, {"teeth": 5, "module": 2.0, "profile_shift": 0.4, "addendum": 1.4}, 0.38 * 2.0),
    "four teeth, steep": (HelicalGear, {"teeth": 4, "module": 2.0, "helix_angle": 30.0}, 0.38 * 2.0),
    "sharp rack": (SpurGear, {"teeth": 11, "module": 3.0, "rack_tip_radius": 0.05}, 0.05),
}
ALL = {**PLAIN, **UNDERCUT}


def _full_radius(gear):
    """In the normal section the arc of a full radius is centred on the tooth and tangent to land and sides."""
    m, alpha, depth = gear.normal_module, np.radians(gear.pressure_angle), 1.35 * gear.normal_module
    slope, secant = np.tan(alpha), 1.0 / np.cos(alpha)
    return (np.pi * m / 4.0 - depth * slope) / (secant - slope)


def _case(name):
    element, values, radius = ALL[name]
    gear = element(face_width=5.0, **values)
    if radius == 0.3:
        gear = element(face_width=5.0, **values, rack_tip_radius=0.3)
    return gear, GeneratingRack.of(gear, _full_radius(gear) if radius is None else radius)


def _generated(gear):
    """Points of all that is generated, the first space turned onto +x."""
    fractions = np.linspace(0.0, 1.0, 9)
    rising = [*curves_of(gear, Trochoid)[:1], *curves_of(gear, Involute)[:1]]
    land = [curve for curve in curves_of(gear, Arc) if np.hypot(*curve.start) < gear.pitch_radius]
    points = [curve.point(curve.parameter(fractions)) for curve in (*rising, *land)]
    return [turned(one, np.pi / gear.teeth * (-1.0 if polar(one)[1].mean() > 0.0 else 1.0)) for one in points]


@pytest.mark.parametrize("name", ALL)
def test_the_rack_touches_every_point_and_cuts_none(name):
    """Root land, fillet and involute are its envelope: the least distance over its rolling is nought."""
    gear, rack = _case(name)
    curves = _generated(gear)
    assert len(curves) == (2 if rack.corner[0] < 1e-12 else 3)
    for points in curves:
        least = [rack.least_clearance(point) for point in points]
        np.testing.assert_allclose(least, 0.0, atol=1e-10 * gear.normal_module)


def test_a_rack_of_another_radius_would_not():
    """The bound above tells: a tip radius other by a thousandth of a module is seen."""
    gear, rack = _case("helical")
    other = GeneratingRack.of(gear, rack.tip_radius - 1e-3 * gear.normal_module)
    fillet = _generated(gear)[0]
    assert max(abs(other.least_clearance(point)) for point in fillet) > 1e-5


@pytest.mark.parametrize("name", PLAIN)
def test_fillets_run_on_into_involutes_and_roots(name):
    gear, _ = _case(name)
    fillet, involute = curves_of(gear, Trochoid)[0], curves_of(gear, Involute)[0]
    np.testing.assert_allclose(fillet.end, involute.start, atol=1e-13 * gear.pitch_radius)
    assert abs(angle_between(unit_tangent(fillet, 1.0), unit_tangent(involute, 0.0))) < 1e-8
    assert abs(unit_tangent(fillet, 0.0) @ fillet.start) < 1e-8 * gear.pitch_radius
    assert polar(fillet.start)[0] == pytest.approx(gear.toothing.root_radius, rel=1e-14)


@pytest.mark.parametrize("name", UNDERCUT)
def test_undercut_trims_the_involute_where_the_fillet_crosses_it(name):
    gear, rack = _case(name)
    fillet, involute = curves_of(gear, Trochoid)[0], curves_of(gear, Involute)[0]
    assert np.linalg.norm(fillet.end - involute.start) < 1e-12
    radius = float(polar(involute.start)[0])
    assert 2.0 * radius == pytest.approx(gear.sizes()["form_diameter"].value, rel=1e-14)
    assert radius > gear.toothing.base_radius
    corner = angle_between(unit_tangent(fillet, 1.0), unit_tangent(involute, 0.0))
    assert abs(corner) > 1e-3
    a, b = involute.interval
    cut_off = turned(involute.point(a - 0.05 * (b - a)), np.pi / gear.teeth)
    assert rack.least_clearance(cut_off) < -1e-6, "the involute below would have been cut away"


@pytest.mark.parametrize("name", ["eight teeth", "helical, nine teeth", "full radius"])
def test_a_disc_cut_by_the_rack_keeps_the_same_area(name):
    """By polygons; scallops between the positions leave too much, by the second power of their distance."""
    gear, rack = _case(name)
    tip = gear.toothing.tip_radius
    left = [np.pi * tip**2 - gear.teeth * rack.cut_area(tip, n) for n in (150, 300)]
    area = gear.profile.properties().area
    excess = [one / area - 1.0 for one in left]
    assert 0.0 < excess[1] < 5e-5
    assert 3.0 < excess[0] / excess[1] < 5.0


@pytest.mark.parametrize("angle", [14.5, 20.0, 25.0])
@pytest.mark.parametrize("helix", [0.0, 30.0])
def test_undercut_begins_at_the_limits_that_are_quoted(angle, helix):
    """At x_min the involute begins on the base circle; a little less is undercut, a little more is not."""
    base = {"teeth": 10, "module": 2.0, "face_width": 5.0, "pressure_angle": angle, "helix_angle": helix}
    base |= {"rack_tip_coefficient": 0.2, "addendum": 1.2}
    limit = HelicalGear(**base).sizes()["undercut_shift"].value
    for off, undercut in ((-0.01, True), (0.01, False)):
        gear = HelicalGear(**base, profile_shift=limit + off)
        assert gear.sizes()["undercut_shift"].value == pytest.approx(limit, rel=1e-12)
        fillet, involute = curves_of(gear, Trochoid)[0], curves_of(gear, Involute)[0]
        bent = abs(angle_between(unit_tangent(fillet, 1.0), unit_tangent(involute, 0.0))) > 1e-6
        assert bent == undercut
    at_limit = HelicalGear(**base, profile_shift=limit)
    assert at_limit.sizes()["form_diameter"].value == pytest.approx(at_limit.sizes()["base_diameter"].value, rel=1e-9)


def test_the_limits_of_the_standard_rack():
    """17.097 = 2/sin² 20° and x_min = 1 − z sin² 20°/2 hold for a flank that is straight down to one module.

    That of ISO 53 A is straight to 1.25 − 0.38 (1 − sin 20°) = 0.99997 modules, its radius being rounded to 0.38:
    3.3e-5 less, which z_min shows in its fourth decimal.
    """
    straight = 1.25 - 0.38 * (1.0 - np.sin(np.radians(20.0)))
    square = np.sin(np.radians(20.0)) ** 2
    sizes = SpurGear(teeth=12, module=3.0, face_width=5.0).sizes()
    assert sizes["undercut_teeth"].value == pytest.approx(17.097, abs=1e-3)
    assert sizes["undercut_teeth"].value == pytest.approx(2.0 / square * straight, rel=1e-12)
    assert sizes["undercut_shift"].value == pytest.approx(1.0 - 6.0 * square, abs=3.3e-5)
    exact = (1.25 - 1.0) / (1.0 - np.sin(np.radians(20.0)))
    sizes = SpurGear(teeth=12, module=3.0, face_width=5.0, rack_tip_coefficient=float(exact)).sizes()
    assert sizes["undercut_teeth"].value == pytest.approx(2.0 / square, rel=1e-12)
    assert sizes["undercut_shift"].value == pytest.approx(1.0 - 6.0 * square, rel=1e-12)
