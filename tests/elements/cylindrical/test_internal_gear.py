"""Internal gears: involute flanks of spaces, circular fillets, and the signs of profile shift, on the boundary."""

from itertools import pairwise

import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.involute import Involute
from gearwright.elements.cylindrical.internal_gear import InternalGear

from ...laws.contact import unmapped
from .profiles import angle_between, curves_of, polar, unit_tangent

RINGS = {
    "standard": {"teeth": 36, "module": 2.0},
    "shifted towards the axis": {"teeth": 91, "module": 1.5, "profile_shift": 0.5, "backlash": 0.1},
    "shifted away": {"teeth": 60, "module": 1.0, "profile_shift": -0.4, "fillet_radius": 0.2},
    "helical": {"teeth": 40, "module": 2.0, "helix_angle": 25.0, "hand": "left"},
    "25°, no fillets": {"teeth": 33, "module": 3.0, "pressure_angle": 25.0, "root": "radial"},
}
every_ring = pytest.mark.parametrize("name", RINGS)
FRACTIONS = np.linspace(0.0, 1.0, 7)


def _ring(name, **more):
    return InternalGear(face_width=6.0, **{**RINGS[name], **more})


def _ends(curve):
    return np.stack([curve.start, curve.end])


def _first_tooth_half(gear, radius):
    """Half the angle of the tooth on +x at a radius, read off the flanks' curves."""
    pitch = 2.0 * np.pi / gear.teeth
    half = []
    for curve in curves_of(gear, Involute):
        r, azimuth = polar(curve.point(curve.parameter(np.linspace(0.0, 1.0, 4001))))
        azimuth = azimuth - pitch * np.round(azimuth.mean() / pitch)
        order = np.argsort(r)
        half.append(abs(np.interp(radius, r[order], azimuth[order])))
    assert half[0] == pytest.approx(half[1], rel=1e-9)
    return half[0]


@every_ring
def test_normals_of_flanks_touch_the_base_circle(name):
    gear = _ring(name)
    helix = np.radians(RINGS[name].get("helix_angle", 0.0))
    transverse = np.arctan(np.tan(np.radians(gear.pressure_angle)) / np.cos(helix))
    base = gear.teeth * RINGS[name]["module"] / 2.0 / np.cos(helix) * np.cos(transverse)
    for curve in curves_of(gear, Involute):
        for fraction in FRACTIONS:
            point = curve.point(curve.parameter(fraction))
            assert abs(unit_tangent(curve, fraction) @ point) == pytest.approx(base, rel=1e-12)


@every_ring
def test_teeth_are_concave_and_taper_towards_the_axis(name):
    """Inside the material, each flank's tangent leaves the tooth: an external tooth's would stay in it."""
    gear = _ring(name)
    sizes = gear.sizes()
    tip, form = sizes["usable_tip_diameter"].value / 2.0, sizes["form_diameter"].value / 2.0
    radii = np.linspace(tip * 1.0001, form * 0.9999, 9)
    half = np.array([_first_tooth_half(gear, r) for r in radii])
    assert np.all(np.diff(half * radii) > 0.0)
    assert np.all(np.diff(half, 2) > 0.0)
    assert sizes["outside_diameter"].value < sizes["pitch_diameter"].value < sizes["root_diameter"].value


@every_ring
def test_a_positive_shift_makes_teeth_thicker(name):
    """s_t = m_n (π/2 + 2x tan α_n)/cos β on the pitch circle, less half the backlash, as ISO 21771 has it."""
    gear, values = _ring(name), RINGS[name]
    helix = np.radians(values.get("helix_angle", 0.0))
    nominal = np.pi / 2.0 + 2.0 * values.get("profile_shift", 0.0) * np.tan(np.radians(gear.pressure_angle))
    pitch_radius = gear.teeth * values["module"] / 2.0 / np.cos(helix)
    thickness = 2.0 * _first_tooth_half(gear, pitch_radius) * pitch_radius
    wanted = values["module"] * nominal / np.cos(helix) - values.get("backlash", 0.0) / 2.0
    assert thickness == pytest.approx(wanted, rel=1e-6)
    assert gear.sizes()["circular_thickness"].value == pytest.approx(wanted, rel=1e-14)


@every_ring
def test_a_positive_shift_moves_tips_and_roots_towards_the_axis(name):
    gear, values = _ring(name), RINGS[name]
    m, x = values["module"], values.get("profile_shift", 0.0)
    pitch = gear.sizes()["pitch_diameter"].value
    loop = gear.profile.loops[1]
    radii = np.concatenate([polar(curve.point(curve.parameter(FRACTIONS)))[0] for curve in loop.curves])
    assert 2.0 * radii.min() == pytest.approx(pitch - 2.0 * m * (1.0 + x), rel=1e-13)
    assert 2.0 * radii.max() == pytest.approx(pitch + 2.0 * m * (1.25 - x), rel=1e-13)
    outside = gear.profile.loops[0].curves[0].start
    assert 2.0 * np.hypot(*outside) == pytest.approx(gear.sizes()["outer_diameter"].value, rel=1e-14)


@every_ring
def test_fillets_are_arcs_tangent_to_flank_and_root(name):
    gear = _ring(name)
    curves = gear.profile.loops[1].curves
    fillets = [c for c in curves if isinstance(unmapped(c), Arc) and abs(np.diff(polar(_ends(c))[0])[0]) > 1e-6]
    radius = gear.sizes()["fillet_radius"].value
    if gear.root == "radial":
        assert not fillets
        assert radius == 0.0
        return
    assert len(fillets) == 2
    joints = [pair for pair in pairwise(curves) if any(one in (id(pair[0]), id(pair[1])) for one in map(id, fillets))]
    assert len(joints) == 4
    for before, after in joints:
        np.testing.assert_allclose(before.end, after.start, atol=1e-12 * gear.pitch_radius)
        assert abs(angle_between(unit_tangent(before, 1.0), unit_tangent(after, 0.0))) < 1e-8
    for arc in fillets:
        a, b, c = (arc.point(arc.parameter(f)) for f in (0.0, 0.4, 1.0))
        sides = [np.linalg.norm(p - q) for p, q in ((a, b), (b, c), (c, a))]
        area = abs(np.linalg.det(np.stack([b - a, c - a]))) / 2.0
        assert np.prod(sides) / (4.0 * area) == pytest.approx(radius, rel=1e-9)
    join = min(polar(arc.start)[0] for arc in fillets), min(polar(arc.end)[0] for arc in fillets)
    assert 2.0 * min(join) == pytest.approx(gear.sizes()["form_diameter"].value, rel=1e-13)


@every_ring
def test_half_angles_are_those_of_the_outline(name):
    """What interference is judged by is the true tooth, fillets included."""
    gear = _ring(name)
    pitch = 2.0 * np.pi / gear.teeth
    kinds = [*curves_of(gear, Involute), *curves_of(gear, Arc)]
    flanks = [c for c in kinds if np.ptp(polar(_ends(c))[0]) > 1e-6]
    for curve in flanks:
        radius, azimuth = polar(curve.point(curve.parameter(np.linspace(0.02, 0.98, 9))))
        off = np.abs(azimuth - pitch * np.round(azimuth / pitch))
        np.testing.assert_allclose(gear.tooth.half_angle(radius), off, atol=1e-9)


@every_ring
def test_sizes_at_the_tip(name):
    gear = _ring(name, tip_chamfer=0.1)
    tip = gear.sizes()["outside_diameter"].value / 2.0
    arcs = [c for c in curves_of(gear, Arc) if np.allclose(polar(_ends(c))[0], tip, rtol=1e-12)]
    assert len(arcs) == 1
    azimuth = polar(_ends(arcs[0]))[1]
    assert tip * np.ptp(azimuth) == pytest.approx(gear.sizes()["tip_thickness"].value, rel=1e-10)
    assert gear.sizes()["usable_tip_diameter"].value == pytest.approx(2.0 * tip + 0.2, rel=1e-13)


def test_the_largest_fillet_rounds_the_whole_root():
    """Just inside the limit the two fillets of a space leave next to no land."""
    limit = _ring("standard").tooth.largest_fillet_radius
    gear = _ring("standard", fillet_radius=limit * (1.0 - 1e-9))
    assert gear.tooth.root_half * gear.toothing.root_radius < 1e-6
    assert gear.properties().volume > 0.0
