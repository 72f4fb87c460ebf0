"""Tip relief, chamfers and crowning, measured on the surface against the plain gear's flanks."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from gearwright.curves.involute import Involute
from gearwright.curves.line import Line
from gearwright.curves.relieved_involute import RelievedInvolute
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.solids.solid import flux_moments

from .profiles import curves_of, polar, turned

RELIEF, HEIGHT, WIDTH = 0.04, 1.4, 14.0
KINDS = {
    "spur": (SpurGear, {"teeth": 24}),
    "helical": (HelicalGear, {"teeth": 15, "helix_angle": 25.0, "hand": "left"}),
    "herringbone": (HerringboneGear, {"teeth": 18, "helix_angle": 20.0}),
    "internal": (InternalGear, {"teeth": 42}),
    "internal helical": (InternalGear, {"teeth": 38, "helix_angle": 15.0}),
}
every_kind = pytest.mark.parametrize("kind", KINDS)


def _gear(kind, **more):
    element, values = KINDS[kind]
    return element(module=2.5, face_width=WIDTH, **values, **more)


def _off(point, plain):
    """(distance of a point from a plain involute, roll there), positive where the point is inside the tooth."""
    found = minimize_scalar(
        lambda roll: float(np.linalg.norm(plain.point(np.float64(roll)) - point)),
        bounds=(0.01, 1.2),
        method="bounded",
        options={"xatol": 1e-13},
    )
    roll = float(found.x)
    along = plain.derivative(np.float64(roll))
    across = np.array([-along[1], along[0]]) / np.linalg.norm(along)
    return float(across @ (point - plain.point(np.float64(roll)))), roll


@pytest.mark.parametrize(("form", "power"), [("linear", 1), ("parabolic", 2)])
@every_kind
def test_relief_grows_along_the_normal_to_its_amount(kind, form, power):
    """From 0 where it begins to C at the end of the flank, with the given power of the roll angle."""
    gear = _gear(kind, tip_relief=RELIEF, tip_relief_height=HEIGHT, tip_relief_form=form)
    plain = curves_of(_gear(kind), Involute)[0]
    (curve, *_) = curves_of(gear, RelievedInvolute)
    points = curve.point(curve.parameter(np.linspace(0.0, 1.0, 9)))
    outward = -1.0 if gear.is_internal else 1.0
    if outward < 0.0:
        points = points[::-1]
    tip = gear.toothing.tip_radius
    assert polar(points[[0, -1]])[0] == pytest.approx([tip - outward * HEIGHT, tip], rel=1e-12)
    depth, roll = np.transpose([_off(point, plain) for point in points])
    depth *= np.sign(depth[-1])
    share = (roll - roll[0]) / (roll[-1] - roll[0])
    np.testing.assert_allclose(depth, RELIEF * share**power, atol=1e-7 * RELIEF)
    thinner = gear.sizes()["tip_thickness"].value < _gear(kind).sizes()["tip_thickness"].value
    assert thinner
    assert gear.properties().volume < _gear(kind).properties().volume


@every_kind
def test_what_is_below_the_relief_stays(kind):
    gear = _gear(kind, tip_relief=RELIEF, tip_relief_height=HEIGHT)
    involute, plain = curves_of(gear, Involute)[0], curves_of(_gear(kind), Involute)[0]
    for fraction in (0.0, 0.4, 1.0):
        assert abs(_off(involute.point(involute.parameter(fraction)), plain)[0]) < 1e-9


@every_kind
def test_a_chamfer_is_as_high_as_wide(kind):
    """Its height along the radius is what is asked for; it leans by 45° against the radius halfway between its ends."""
    gear = _gear(kind, tip_chamfer=0.3)
    plain = curves_of(_gear(kind), Involute)[0]
    chamfers = [curve for curve in curves_of(gear, Line) if abs(abs(np.diff(polar(_ends(curve))[0])[0]) - 0.3) < 1e-9]
    assert len(chamfers) == 2
    inner, outer = _ends(chamfers[0])[:: -1 if gear.is_internal else 1]
    assert polar(outer)[0] == pytest.approx(gear.toothing.tip_radius, rel=1e-13)
    assert abs(_off(inner, plain)[0]) < 1e-9
    assert 2.0 * polar(inner)[0] == pytest.approx(gear.sizes()["usable_tip_diameter"].value, rel=1e-13)
    along = turned(outer - inner, -float(polar(_ends(chamfers[0]))[1].mean()))
    assert np.degrees(np.arctan2(abs(along[1]), abs(along[0]))) == pytest.approx(45.0, abs=1e-9)
    pitch = 2.0 * np.pi / gear.teeth
    half = float(polar(outer)[1])
    half = abs(half - pitch * round(half / pitch))
    thickness = 2.0 * half * gear.toothing.tip_radius
    assert gear.sizes()["tip_thickness"].value == pytest.approx(thickness, rel=1e-12)
    assert thickness < _gear(kind).sizes()["tip_thickness"].value
    assert gear.properties().volume < _gear(kind).properties().volume


def _ends(curve):
    return np.stack([curve.start, curve.end])


@every_kind
def test_crowning_is_its_amount_at_the_ends_and_nought_in_the_middle(kind):
    gear, plain = _gear(kind, crowning=0.03), curves_of(_gear(kind), Involute)
    flanks = [patch for patch in gear.boundary.patches if isinstance(_innermost(patch.curve), Involute)]
    assert len(flanks) >= 2
    found = []
    for patch in flanks:
        for v in (0.0, 0.25, 0.5, 0.75, 1.0):
            points = patch.point(np.linspace(0.2, 0.8, 4), np.full(4, v))
            z = float(points[0, 2])
            way = min(z, WIDTH - z) if kind == "herringbone" else z
            flat = turned(points[:, :2], -gear.helix.sense * way * np.tan(gear.helix.angle) / gear.pitch_radius)
            found += [(z / WIDTH, min(abs(_off(point, one)[0]) for one in plain)) for point in flat]
    share, depth = np.transpose(found)
    np.testing.assert_allclose(depth, 0.03 * (2.0 * share - 1.0) ** 2, atol=1e-9)
    assert {0.0, 0.5, 1.0} <= set(np.round(share, 12))


def _innermost(curve):
    while hasattr(curve, "curve"):
        curve = curve.curve
    return curve


@every_kind
def test_crowned_teeth_are_thinner_at_the_ends(kind):
    """Both flanks go into the tooth: the volume falls by C_β/3 times the area of all flanks, nearly."""
    amount = 0.01
    lost = _gear(kind).properties().volume - _gear(kind, crowning=amount).properties().volume
    gear = _gear(kind)
    depth = gear.sizes()["tooth_depth"].value
    area = 2.0 * gear.teeth * depth * WIDTH
    assert 0.9 < lost / (amount / 3.0 * area) < 1.6


@pytest.mark.parametrize(
    "more",
    [
        {"crowning": 0.03},
        {"crowning": 0.03, "tip_relief": 0.03, "tip_chamfer": 0.2},
        {"tip_relief": 0.03, "tip_relief_form": "parabolic"},
    ],
    ids=", ".join,
)
@every_kind
def test_moments_are_the_flux_through_the_boundary(kind, more):
    gear = _gear(kind, **more)
    exact, flux = gear.solid.moments, flux_moments(gear.boundary)
    assert flux.volume == pytest.approx(exact.volume, rel=1e-11)
    np.testing.assert_allclose(flux.centroid, exact.centroid, atol=1e-11 * gear.pitch_radius)
    scale = np.linalg.norm(exact.central_second)
    np.testing.assert_allclose(flux.central_second, exact.central_second, atol=1e-11 * scale)
    assert gear.polyhedron(0.02).properties().volume == pytest.approx(exact.volume, rel=0.02)
