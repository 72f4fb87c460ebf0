"""Ways to give the same gear, proportions of basic racks, bodies, and sizes measured on the boundary."""

import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.trochoid import Trochoid
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.elements.cylindrical.rack import Rack
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.elements.standards.din_6885 import parallel_key
from gearwright.solids.solid import flux_moments

from ...laws.contact import unmapped
from .profiles import curves_of, polar

BASE = {"teeth": 23, "module": 3.0, "face_width": 8.0}
KINDS = {
    "spur": (SpurGear, {}),
    "helical": (HelicalGear, {"helix_angle": 18.0}),
    "herringbone": (HerringboneGear, {"helix_angle": 24.0}),
    "internal": (InternalGear, {"teeth": 43, "helix_angle": 10.0}),
    "rack": (Rack, {"teeth": 4, "helix_angle": 12.0}),
}
every_kind = pytest.mark.parametrize("kind", KINDS)
every_gear = pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "rack"])


def _gear(kind, *without, **more):
    element, own = KINDS[kind]
    values = {**BASE, **own, **more}
    return element(**{name: value for name, value in values.items() if name not in without})


def _same(one, other, scale=1.0):
    first, second = one.properties(), other.properties()
    assert second.volume * scale**3 == pytest.approx(first.volume, rel=1e-12)
    assert second.inertia[2, 2] * scale**5 == pytest.approx(first.inertia[2, 2], rel=1e-12)


@every_kind
def test_inches_and_diametral_pitch(kind):
    """A diametral pitch is per inch, in the normal section; a module is in mm in either length unit."""
    more = {"tip_relief": 0.02, "profile_shift": 0.2} if kind != "rack" else {"fillet_radius": 0.5}
    millimetres = _gear(kind, **more)
    inches = {name: value / 25.4 for name, value in more.items() if name != "profile_shift"}
    inches |= {"face_width": 8.0 / 25.4, "length_unit": "in"}
    _same(millimetres, _gear(kind, **{**more, **inches}), 25.4)
    _same(millimetres, _gear(kind, "module", **{**more, **inches}, diametral_pitch=25.4 / 3.0), 25.4)
    _same(millimetres, _gear(kind, "module", **more, diametral_pitch=25.4 / 3.0))


@pytest.mark.parametrize("kind", ["helical", "herringbone", "internal", "rack"])
def test_the_transverse_module_is_larger_by_the_cosine(kind):
    helix = np.radians(KINDS[kind][1]["helix_angle"])
    gear = _gear(kind, "module", transverse_module=float(3.0 / np.cos(helix)))
    _same(_gear(kind), gear)
    assert gear.sizes()["module"].value == pytest.approx(3.0, rel=1e-14)
    if kind != "rack":
        assert gear.sizes()["transverse_module"].value * gear.teeth == pytest.approx(
            gear.sizes()["pitch_diameter"].value, rel=1e-14
        )


@every_gear
@pytest.mark.parametrize("shift", [0.0, 0.3, -0.2])
def test_a_tip_can_be_given_in_three_ways(kind, shift):
    """The coefficient is the basic rack's, to which the shift is added; addendum and diameter are the gear's own."""
    by_coefficient = _gear(kind, profile_shift=shift, addendum_coefficient=0.9)
    by_length = _gear(kind, profile_shift=shift, addendum=(0.9 + shift) * 3.0)
    outwards = -1.0 if kind == "internal" else 1.0
    diameter = by_coefficient.sizes()["pitch_diameter"].value + outwards * 2.0 * (0.9 + shift) * 3.0
    by_diameter = _gear(kind, profile_shift=shift, tip_diameter=diameter)
    for other in (by_length, by_diameter):
        _same(by_coefficient, other)
        assert other.sizes()["outside_diameter"].value == pytest.approx(diameter, rel=1e-14)
    default = _gear(kind, profile_shift=shift)
    assert default.sizes()["addendum"].value == pytest.approx((1.0 + shift) * 3.0, rel=1e-14)


@every_gear
def test_a_root_can_be_given_in_two_ways(kind):
    by_coefficient = _gear(kind, profile_shift=0.2, dedendum_coefficient=1.4)
    _same(by_coefficient, _gear(kind, profile_shift=0.2, dedendum=1.2 * 3.0))
    outwards = -1.0 if kind == "internal" else 1.0
    pitch = by_coefficient.sizes()["pitch_diameter"].value
    assert by_coefficient.sizes()["root_diameter"].value == pytest.approx(pitch - outwards * 7.2, rel=1e-14)


def test_so_can_a_rack():
    one = _gear("rack", addendum_coefficient=0.8, dedendum_coefficient=1.3)
    _same(one, _gear("rack", addendum=2.4, dedendum=3.9))
    x = np.concatenate([np.stack([c.start, c.end])[:, 0] for c in one.profile.loops[0].curves])
    assert [x.max(), np.sort(np.unique(np.round(x, 9)))[1]] == pytest.approx([2.4, -3.9])


@pytest.mark.parametrize("kind", ["spur", "helical", "herringbone"])
def test_a_rack_tip_radius_can_be_given_in_two_ways(kind):
    _same(_gear(kind, rack_tip_radius=0.6), _gear(kind, rack_tip_coefficient=0.2))
    assert _gear(kind).properties().volume > _gear(kind, rack_tip_radius=0.1).properties().volume


PROPORTIONS = {
    "iso-53-a": (1.0, 1.25, 0.38),
    "iso-53-b": (1.0, 1.25, 0.30),
    "iso-53-c": (1.0, 1.25, 0.25),
    "iso-53-d": (1.0, 1.40, 0.39),
    "agma-full-radius": (1.0, 1.35, None),
}


@pytest.mark.parametrize("rack", PROPORTIONS)
def test_proportions_of_basic_racks(rack):
    """ISO 53:1998, table 1; the full-radius rack is round all over, so no land is left at the root."""
    addendum, dedendum, radius = PROPORTIONS[rack]
    gear = SpurGear(teeth=40, module=2.0, face_width=5.0, basic_rack=rack)
    assert gear.sizes()["outside_diameter"].value == pytest.approx(80.0 + 4.0 * addendum, rel=1e-15)
    assert gear.sizes()["root_diameter"].value == pytest.approx(80.0 - 4.0 * dedendum, rel=1e-15)
    lands = [c for c in curves_of(gear, Arc) if np.hypot(*c.start) < 39.0]
    if radius is None:
        assert not lands
        radius = (np.pi / 4.0 - 1.35 * np.tan(np.radians(20.0))) / (
            1.0 / np.cos(np.radians(20.0)) - np.tan(np.radians(20.0))
        )
    else:
        assert len(lands) == 1
    fillet = unmapped(curves_of(gear, Trochoid)[0])
    assert fillet.half_axes == pytest.approx((2.0 * radius, 2.0 * radius), rel=1e-12)


@every_gear
def test_sizes_are_found_on_the_section(kind):
    gear = _gear(kind, profile_shift=0.2, tip_chamfer=0.15)
    sizes = {name: size.value for name, size in gear.sizes().items()}
    loop = gear.profile.loops[1 if kind == "internal" else 0]
    fractions = np.linspace(0.0, 1.0, 5)
    radii = np.concatenate([polar(curve.point(curve.parameter(fractions)))[0] for curve in loop.curves])
    low, high = sorted((sizes["outside_diameter"], sizes["root_diameter"]))
    assert 2.0 * radii.min() == pytest.approx(low, rel=1e-13)
    assert 2.0 * radii.max() == pytest.approx(high, rel=1e-13)
    assert sizes["tooth_depth"] == pytest.approx((high - low) / 2.0, rel=1e-12)
    assert sizes["base_pitch"] == pytest.approx(np.pi * sizes["base_diameter"] / gear.teeth, rel=1e-13)
    assert sizes["circular_pitch"] == pytest.approx(np.pi * sizes["pitch_diameter"] / gear.teeth, rel=1e-13)
    assert sizes["normal_thickness"] == pytest.approx(sizes["circular_thickness"] * np.cos(gear.helix.angle), rel=1e-13)


BODIES = {
    "keyway": {"bore": 20.0, "keyway": "din-6885"},
    "hub": {"bore": 16.0, "hub_diameter": 30.0, "hub_length": 14.0, "hub_offset": 2.0},
    "web with holes, hub and keyway": {
        "bore": 14.0,
        "keyway": "din-6885",
        "hub_diameter": 24.0,
        "hub_length": 10.0,
        "rim_diameter": 50.0,
        "web_thickness": 3.0,
        "web_holes": 5,
        "web_hole_diameter": 8.0,
    },
}


@pytest.mark.parametrize("crowning", [0.0, 0.03])
@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("kind", ["spur", "helical", "herringbone"])
def test_bodies_of_gears(kind, body, crowning):
    """Exact moments are the flux through one closed boundary, and what is taken off is what was asked for."""
    more = BODIES[body]
    gear, full = _gear(kind, **more, crowning=crowning), _gear(kind, crowning=crowning)
    exact, flux = gear.solid.moments, flux_moments(gear.boundary)
    assert flux.volume == pytest.approx(exact.volume, rel=1e-11)
    scale = np.linalg.norm(exact.central_second)
    np.testing.assert_allclose(flux.central_second, exact.central_second, atol=1e-11 * scale)
    assert exact.volume - full.properties().volume == pytest.approx(_added(more), rel=1e-9)


def _added(body):
    """Volume of hub less bore, keyway and hollows, by elementary sums."""
    r, width = body["bore"] / 2.0, BASE["face_width"]
    hub, length = body.get("hub_diameter", 2.0 * r) / 2.0, body.get("hub_length", width)
    web = body.get("web_thickness", width)
    added = np.pi * (hub**2 * (length - web) - r**2 * length)
    if "rim_diameter" in body:
        added -= np.pi * (body["rim_diameter"] / 2.0) ** 2 * (width - web)
        added -= body["web_holes"] * np.pi * (body["web_hole_diameter"] / 2.0) ** 2 * web
    if "keyway" in body:
        key = parallel_key(body["bore"])
        half = key.width / 2.0
        mouth = np.arcsin(half / r)
        inside = r**2 * mouth - half * np.sqrt(r**2 - half**2)
        slot = key.width * (r + key.hub_depth - np.sqrt(r**2 - half**2)) - inside
        added -= slot * length
    return added
