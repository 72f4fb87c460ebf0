"""Racks: straight flanks, fillets round in the normal section, volumes by elementary sums."""

import numpy as np
import pytest
import shapely

from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.line import Line
from gearwright.elements.cylindrical.rack import Rack
from gearwright.solids.solid import flux_moments

from ...laws.contact import unmapped
from .profiles import angle_between, curves_of, unit_tangent

RACKS = {
    "straight": {"teeth": 5, "module": 4.0},
    "C, with backlash": {"teeth": 3, "module": 3.0, "basic_rack": "iso-53-c", "backlash": 0.3, "pressure_angle": 25.0},
    "helical": {"teeth": 4, "module": 2.0, "helix_angle": 30.0},
    "helical, left, own fillet": {
        "teeth": 6,
        "transverse_module": 2.0,
        "helix_angle": 20.0,
        "hand": "left",
        "fillet_radius": 0.5,
        "rack_height": 9.0,
    },
    "full radius": {"teeth": 3, "module": 5.0, "basic_rack": "agma-full-radius"},
}
every_rack = pytest.mark.parametrize("name", RACKS)
WIDTH = 11.0


def _rack(name, **more):
    return Rack(face_width=WIDTH, **{**RACKS[name], **more})


def _by_hand(gear):
    """(normal module, normal angle, helix, normal thickness) as asked for."""
    helix = np.radians(gear.helix_angle)
    module = gear.module or gear.transverse_module * np.cos(helix)
    thickness = np.pi * module / 2.0 - gear.backlash / 2.0 * np.cos(helix)
    return module, np.radians(gear.pressure_angle), helix, thickness


@every_rack
def test_the_section_is_trapeziums_with_rounded_roots_on_a_back(name):
    """The normal section as a polygon with 2000 chords a fillet, stretched along the pitch line by 1/cos β."""
    gear = _rack(name)
    module, alpha, helix, thickness = _by_hand(gear)
    depth = {"agma-full-radius": 1.35}.get(gear.basic_rack, 1.25) * module
    rho = gear.sizes()["fillet_radius"].value
    pitch, back = np.pi * module, gear.sizes()["rack_height"].value
    wall = pitch / 2.0 - thickness / 2.0 - (depth - rho) * np.tan(alpha) - rho / np.cos(alpha)
    assert wall > -1e-12
    angle = np.linspace(np.pi / 2.0, alpha, 2000)
    fillet = np.stack([rho - depth - rho * np.sin(angle), -pitch / 2.0 + wall + rho * np.cos(angle)], axis=-1)
    half = np.array([[-depth, -pitch / 2.0], *fillet, [module, -thickness / 2.0 + module * np.tan(alpha)]])
    tooth = np.concatenate([half, half[::-1] * [1.0, -1.0]])
    body = [[-back, (gear.teeth - 0.5) * pitch], [-back, -pitch / 2.0]]
    points = np.concatenate([*(tooth + np.array([0.0, k * pitch]) for k in range(gear.teeth)), body])
    area = shapely.Polygon(points).area / np.cos(helix)
    assert gear.profile.properties().area == pytest.approx(area, rel=1e-7)
    assert gear.sizes()["length"].value == pytest.approx(gear.teeth * pitch / np.cos(helix), rel=1e-14)


@every_rack
def test_fillets_are_round_in_the_normal_section_and_tangent(name):
    gear = _rack(name)
    rho, helix = gear.sizes()["fillet_radius"].value, np.radians(gear.helix_angle)
    curves = gear.profile.loops[0].curves
    fillets = [curve for curve in curves if isinstance(unmapped(curve), EllipticArc)]
    assert len(fillets) == 2 * gear.teeth
    for arc in fillets[:2]:
        points = arc.point(arc.parameter(np.linspace(0.0, 1.0, 9))) * [1.0, np.cos(helix)]
        a, b, c = points[0], points[4], points[8]
        middle = np.linalg.solve(2.0 * np.stack([b - a, c - a]), [b @ b - a @ a, c @ c - a @ a])
        np.testing.assert_allclose(np.linalg.norm(points - middle, axis=1), rho, rtol=1e-10)
        place = next(k for k, curve in enumerate(curves) if curve is arc)
        if place:
            bend = angle_between(unit_tangent(curves[place - 1], 1.0), unit_tangent(arc, 0.0))
            assert abs(bend) < 1e-7
        bend = angle_between(unit_tangent(arc, 1.0), unit_tangent(curves[place + 1], 0.0))
        assert abs(bend) < 1e-7


@every_rack
def test_flanks_lean_by_the_transverse_pressure_angle(name):
    gear = _rack(name)
    _, alpha, helix, thickness = _by_hand(gear)
    leaning = np.arctan(np.tan(alpha) / np.cos(helix))
    assert np.radians(gear.sizes()["transverse_pressure_angle"].value) == pytest.approx(leaning, rel=1e-14)
    flanks = [c for c in curves_of(gear, Line) if c.start[0] * c.end[0] < 0.0 and c.start[1] != c.end[1]]
    assert len(flanks) == 2 * gear.teeth
    for k, flank in enumerate(flanks):
        along = flank.end - flank.start
        assert abs(along[1] / along[0]) == pytest.approx(np.tan(leaning), rel=1e-12)
        share = -flank.start[0] / along[0]
        middle = (k // 2) * np.pi * _by_hand(gear)[0] / np.cos(helix)
        assert abs(flank.start[1] + share * along[1] - middle) == pytest.approx(
            thickness / 2.0 / np.cos(helix), rel=1e-12
        )


@pytest.mark.parametrize("name", ["helical", "helical, left, own fillet"])
def test_a_helical_rack_is_the_straight_one_sheared(name):
    """Along +y with z if right-hand: the volume stays, sections at all heights are the same."""
    gear = _rack(name)
    area = gear.profile.properties().area
    found = gear.properties()
    assert found.volume == pytest.approx(area * WIDTH, rel=1e-13)
    shift = (1.0 if gear.hand == "right" else -1.0) * WIDTH * np.tan(np.radians(gear.helix_angle))
    flat = gear.profile.properties().centroid
    np.testing.assert_allclose(found.centroid, [flat[0], flat[1] + shift / 2.0, WIDTH / 2.0], rtol=1e-12)
    flux = flux_moments(gear.boundary)
    assert flux.volume == pytest.approx(found.volume, rel=1e-12)
    for patch in gear.boundary.patches:
        near, far = (patch.point(np.array(0.3), np.array(v)) for v in (0.0, 1.0))
        np.testing.assert_allclose(far - near, [0.0, shift, WIDTH], atol=1e-12)


def test_normal_sections_of_helical_racks_are_those_of_straight_ones():
    """The same tooth, cut at right angles: y cos β at the same heights."""
    straight, helical = _rack("straight"), _rack("straight", helix_angle=35.0)
    fractions = np.linspace(0.0, 1.0, 7)
    for one, other in zip(straight.profile.loops[0].curves, helical.profile.loops[0].curves, strict=True):
        points, stretched = (curve.point(curve.parameter(fractions)) for curve in (one, other))
        np.testing.assert_allclose(stretched * [1.0, np.cos(np.radians(35.0))], points, atol=1e-12)


def test_racks_are_what_generates_gears():
    """Thickness and tip thickness on the curves, as the sizes say."""
    gear = _rack("helical")
    tips = [c for c in curves_of(gear, Line) if np.allclose([c.start[0], c.end[0]], 2.0)]
    assert len(tips) == gear.teeth
    widths = [abs(c.end[1] - c.start[1]) for c in tips]
    np.testing.assert_allclose(widths, gear.sizes()["tip_thickness"].value, rtol=1e-12)


def test_half_widths_are_those_of_the_outline():
    """What interference is judged by is the true tooth, fillets included."""
    gear = _rack("helical, left, own fillet")
    pitch = gear.sizes()["circular_pitch"].value
    flanks = [c for c in gear.profile.loops[0].curves[:-3] if c.start[0] != c.end[0]]
    for curve in flanks:
        points = curve.point(curve.parameter(np.linspace(0.01, 0.99, 9)))
        off = np.abs(points[:, 1] - pitch * np.round(points[:, 1] / pitch))
        np.testing.assert_allclose(gear.tooth.half_at(points[:, 0]), off, atol=1e-12)


def test_a_rack_in_inches():
    inches = Rack(teeth=3, diametral_pitch=8.0, length_unit="in", face_width=0.5, helix_angle=10.0)
    millimetres = Rack(teeth=3, module=25.4 / 8.0, face_width=12.7, helix_angle=10.0)
    assert inches.properties().volume * 25.4**3 == pytest.approx(millimetres.properties().volume, rel=1e-13)
