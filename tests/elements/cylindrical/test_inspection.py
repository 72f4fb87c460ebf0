"""Spans, measurements over pins and balls, and chords, against the surfaces of the flanks themselves."""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.optimize import brentq, minimize, root

from gearwright.curves.curve import Curve
from gearwright.curves.involute import Involute
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.errors import ParameterError

from .profiles import curves_of, polar, turned


@dataclass(frozen=True)
class Helicoid:
    """A flank of the gear's tooth number k that goes on beyond root, tip and ends, screwed along the lead."""

    curve: Curve
    per_height: float
    turn: float

    def point(self, u: float, z: float) -> np.ndarray:
        flat = turned(self.curve.point(np.float64(u)), self.turn + self.per_height * z)
        return np.array([*flat, z])

    def normal(self, u: float, z: float) -> np.ndarray:
        along = turned(self.curve.derivative(np.float64(u)), self.turn + self.per_height * z)
        x, y, _ = self.point(u, z)
        found = np.cross([*along, 0.0], [-self.per_height * y, self.per_height * x, 1.0])
        return found / np.linalg.norm(found)

    def distance(self, centre: np.ndarray) -> tuple[float, float]:
        """From a point to the nearest one of the flank, and the radius of that."""
        a, b = self.curve.interval
        found = min(
            (
                minimize(
                    lambda at: float(np.sum((self.point(at[0], at[1] * 10.0) - centre) ** 2)),
                    [a + share * (b - a), 0.0],
                    method="Nelder-Mead",
                    options={"xatol": 1e-11, "fatol": 1e-22, "maxiter": 2000, "maxfev": 2000},
                )
                for share in (0.2, 0.8)
            ),
            key=lambda one: one.fun,
        )
        foot = self.point(found.x[0], found.x[1] * 10.0)
        return float(np.sqrt(found.fun)), float(np.hypot(foot[0], foot[1]))


def _flank(gear, which, tooth=0):
    """The clockwise (0) or the counter-clockwise (1) flank of a tooth; of an internal gear, of a space."""
    per_height = gear.helix.sense * np.tan(gear.helix.angle) / gear.pitch_radius
    return Helicoid(curves_of(gear, Involute)[which], float(per_height), 2.0 * np.pi * tooth / gear.teeth)


def _span(gear, teeth, first_roll=None):
    """(width, roll, cosine of both normals) of parallel planes that touch the outer flanks of so many teeth.

    The normal from the one flank's point at a roll angle to where it meets the other; both at the same roll, found
    with the rest, if none is given.
    """
    first, last = _flank(gear, 0), _flank(gear, 1, teeth - 1)
    guess = 2.0 * gear.pitch_radius * np.sin(np.pi * (teeth - 0.5) / gear.teeth)
    sign = np.sign(first.normal(0.4, 0.0) @ (last.point(0.4, 0.0) - first.point(0.4, 0.0)))

    def off(unknown):
        roll, z, width = unknown
        own = roll if first_roll is None else first_roll
        return last.point(roll, z * guess) - first.point(own, 0.0) - sign * width * guess * first.normal(own, 0.0)

    found = root(off, [0.4, sign * np.sin(first.normal(0.4, 0.0)[2]), 1.0], tol=1e-14)
    assert np.abs(found.fun).max() < 1e-10
    roll, z, width = found.x
    own = roll if first_roll is None else first_roll
    return width * guess, float(roll), abs(float(first.normal(own, 0.0) @ last.normal(roll, z * guess)))


GEARS = {
    "spur": SpurGear(teeth=24, module=3.0, face_width=20.0, profile_shift=0.4),
    "spur, odd, backlash": SpurGear(teeth=17, module=2.0, face_width=9.0, pressure_angle=25.0, backlash=0.2),
    "helical": HelicalGear(teeth=20, module=2.0, face_width=30.0, helix_angle=20.0),
    "helical, odd, left": HelicalGear(
        teeth=31, module=1.5, face_width=30.0, helix_angle=35.0, hand="left", profile_shift=0.3
    ),
    "helical, steep": HelicalGear(teeth=13, module=4.0, face_width=60.0, helix_angle=45.0, backlash=0.1),
}
RINGS = {
    "even": InternalGear(teeth=40, module=2.0, face_width=10.0),
    "odd, shifted": InternalGear(teeth=51, module=1.5, face_width=10.0, profile_shift=0.4, backlash=0.1),
    "helical, odd": InternalGear(teeth=37, module=2.0, face_width=10.0, helix_angle=25.0),
    "helical, even, left": InternalGear(
        teeth=60, module=1.0, face_width=10.0, helix_angle=12.0, hand="left", profile_shift=-0.2
    ),
}
every_gear = pytest.mark.parametrize("name", GEARS)


@every_gear
def test_the_span_is_the_distance_of_parallel_planes_on_the_flanks(name):
    """Whether they are held symmetrically or not."""
    sizes = GEARS[name].sizes()
    _, middle, _ = _span(GEARS[name], int(sizes["span_teeth"].value))
    for roll in (None, 0.8 * middle, 1.1 * middle):
        width, _, parallel = _span(GEARS[name], int(sizes["span_teeth"].value), roll)
        assert width == pytest.approx(sizes["span"].value, rel=1e-11)
        assert parallel == pytest.approx(1.0, abs=1e-12)


def test_spans_of_helical_teeth_lean_and_need_a_face_for_that():
    """Their planes touch W sin β_b apart along the axis; sin β_b = sin β cos α_n."""
    given = {"teeth": 24, "module": 2.0, "helix_angle": 20.0}
    span = HelicalGear(**given, face_width=20.0, span_teeth=4).sizes()["span"].value
    least = span * np.sin(np.radians(20.0)) * np.cos(np.radians(20.0))
    assert HelicalGear(**given, face_width=1.001 * least, span_teeth=4).sizes()["span"].value == span
    for element, width in ((HelicalGear, 0.999 * least), (HerringboneGear, 1.999 * least)):
        with pytest.raises(ParameterError, match=r"needs a face of more than 6\.9"):
            element(**given, face_width=width, span_teeth=4)
    assert "span" not in HelicalGear(**given, face_width=2.0).sizes()


@every_gear
def test_spans_are_possible_where_both_contacts_are_on_the_flanks(name):
    """Measured symmetrically; the next smaller and the next larger numbers touch beyond form or tip circle."""
    gear = GEARS[name]
    possible = [k for k in range(1, gear.teeth) if _spanned(gear, k)]
    assert possible == list(range(possible[0], possible[-1] + 1))
    form, tip = gear.sizes()["form_diameter"].value / 2.0, gear.sizes()["usable_tip_diameter"].value / 2.0
    for k in (max(1, possible[0] - 1), *possible, possible[-1] + 1):
        _, roll, _ = _span(gear, k)
        radius = float(polar(_flank(gear, 0).curve.point(np.float64(roll)))[0])
        assert (roll > 0.0 and form <= radius <= tip) == (k in possible), (k, radius)


def _spanned(gear, k):
    try:
        return type(gear)(**{**_given(gear), "span_teeth": k}).sizes()["span_teeth"].value == k
    except ValueError:
        return False


def _given(gear):
    return {name: getattr(gear, name) for name in gear.__dataclass_fields__}


@pytest.mark.parametrize("gear", [*GEARS.values(), *RINGS.values()], ids=[*GEARS, *(f"ring, {name}" for name in RINGS)])
def test_pins_and_balls_touch_both_flanks(gear):
    """A ball centred on the middle of a space moves along it until it touches the flanks as surfaces in space."""
    sizes, ring = gear.sizes(), gear.is_internal
    diameter, measured = sizes["pin_diameter"].value, sizes["over_pins"].value
    flank = _flank(gear, 0 if ring else 1)
    middle = np.pi / gear.teeth
    direction = np.array([np.cos(middle), np.sin(middle), 0.0])

    def excess(radius):
        return flank.distance(radius * direction)[0] - diameter / 2.0

    guess = (measured - (-diameter if ring else diameter)) / 2.0
    near = 0.05 * gear.normal_module
    centre = brentq(excess, guess - near, guess + 2.0 * near, xtol=1e-10)
    opposite = gear.teeth // 2
    across = np.array([np.cos(2.0 * np.pi * opposite / gear.teeth), np.sin(2.0 * np.pi * opposite / gear.teeth)])
    apart = np.linalg.norm(centre * (across - [1.0, 0.0]))
    assert measured == pytest.approx(apart + (-diameter if ring else diameter), rel=1e-9)
    touching = flank.distance(centre * direction)[1]
    assert sizes["pin_contact_diameter"].value == pytest.approx(2.0 * touching, rel=1e-6)


def test_published_span_and_measurement_over_pins():
    """KHK technical reference: spur gears z 24, m 3, x 0.4 over four teeth; z 20, m 3, x 0.3 over pins of 5.5."""
    span = SpurGear(teeth=24, module=3.0, face_width=20.0, profile_shift=0.4, span_teeth=4).sizes()
    assert span["span"].value == pytest.approx(32.8266, abs=0.6e-4)
    pins = SpurGear(teeth=20, module=3.0, face_width=20.0, profile_shift=0.3, pin_diameter=5.5).sizes()
    assert pins["pin_pressure_angle"].value == pytest.approx(28.362475, abs=0.6e-6)
    assert pins["over_pins"].value == pytest.approx(69.572872, abs=0.6e-6)


@pytest.mark.parametrize("gear", [GEARS["spur"], GEARS["spur, odd, backlash"], RINGS["even"], RINGS["odd, shifted"]])
def test_chords_of_straight_teeth_on_the_pitch_circle(gear):
    """Between the points of both flanks of a tooth on the pitch circle; and the tip's height above their chord."""
    curves = curves_of(gear, Involute)
    one = curves[0]
    u = brentq(lambda at: float(polar(one.point(np.float64(at)))[0]) - gear.pitch_radius, *one.interval, xtol=1e-14)
    pitch = 2.0 * np.pi / gear.teeth
    azimuth = float(polar(one.point(np.float64(u)))[1])
    azimuth = abs(azimuth - pitch * round(azimuth / pitch))
    chord = 2.0 * gear.pitch_radius * np.sin(azimuth)
    height = abs(gear.toothing.tip_radius - gear.pitch_radius * np.cos(azimuth))
    assert gear.sizes()["chordal_thickness"].value == pytest.approx(chord, rel=1e-12)
    assert gear.sizes()["chordal_height"].value == pytest.approx(height, rel=1e-12)


@pytest.mark.parametrize("name", ["helical", "helical, odd, left", "helical, steep"])
def test_chords_of_helical_teeth(name):
    """Between points of both flanks along the normal helix of the pitch cylinder, which is nearly a circle there.

    The circle of its curvature d/cos² β stands for it in ISO 21771: for these teeth right to 1e-3.
    """
    gear = GEARS[name]
    half = gear.toothing.thickness / 2.0 * np.cos(gear.helix.angle) ** 2 / gear.pitch_radius
    rise = gear.toothing.thickness / 2.0 * np.cos(gear.helix.angle) * np.sin(gear.helix.angle)
    chord = 2.0 * np.hypot(gear.pitch_radius * np.sin(half), rise)
    sizes = gear.sizes()
    assert sizes["chordal_thickness"].value == pytest.approx(chord, rel=1e-3)
    height = gear.toothing.tip_radius - gear.pitch_radius * np.cos(half)
    assert sizes["chordal_height"].value == pytest.approx(height, rel=1e-3)
