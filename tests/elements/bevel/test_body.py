"""Bodies of bevel gears are as large as the sizes told: held to closed forms, to Pappus, and to their boundaries."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.moments.matrix import shifted
from gearwright.solids.solid import flux_moments

from ...laws.topology import components, edges_pair_up, fans_at_vertices, genus

PLAIN = BevelGear(teeth=24, module=3.0, mate_teeth=36, face_width=16.0)
HUB = {"bore": 14.0, "hub_diameter": 32.0}
KEY = {"keyway_width": 5.0, "keyway_depth": 2.3}
WEB = {"rim_diameter": 40.5, "web_thickness": 7.0}
HOLES = {"web_holes": 5, "web_hole_diameter": 3.0}

BODIES = {
    "plain": PLAIN,
    "bored": replace(PLAIN, bore=18.0),
    "mounting distance": replace(PLAIN, bore=18.0, mounting_distance=68.0),
    "hub, keyway, mounting distance": replace(PLAIN, **HUB, **KEY, mounting_distance=72.0),
    "web with holes": replace(PLAIN, **HUB, **WEB, **HOLES, mounting_distance=72.0),
    "flat, with a hub and a web": replace(
        PLAIN, ends="flat", bore=12.0, hub_diameter=26.0, hub_length=30.0, rim_diameter=34.0, web_thickness=6.0
    ),
    "spherical, bored": replace(PLAIN, ends="spherical", bore=20.0),
    "crown": BevelGear(teeth=30, module=3.0, pitch_angle=90.0, face_width=12.0, bore=15.0),
    "crown with a hub": BevelGear(
        teeth=30, module=3.0, pitch_angle=90.0, face_width=12.0, bore=15.0, hub_diameter=40.0, mounting_distance=20.0
    ),
    "δ = 3°": BevelGear(teeth=20, module=4.0, pitch_angle=3.0, face_width=30.0, bore=25.0),
    "δ = 85°": BevelGear(teeth=40, module=2.0, pitch_angle=85.0, face_width=9.0, bore=20.0, taper="uniform"),
    "spiral, crowned, keyed": replace(
        PLAIN, trace="circular", spiral_angle=35.0, cutter_radius=50.0, crowning=0.02, bore=20.0, keyway="din-6885"
    ),
}
every_body = pytest.mark.parametrize("name", BODIES)


def about_apex(body):
    return shifted(body.matrix, body.origin)


def apart(one, other):
    """Greatest difference of entries of two moment matrices about the apex, of the body's own size."""
    size = np.sqrt(np.trace(one[1:, 1:]) / one[0, 0])
    unit = np.array([1.0, size, size, size])
    return float(np.abs((one - other) / (one[0, 0] * np.outer(unit, unit))).max())


def volume(gear):
    return gear.solid.moments.volume


@cache
def mesh(name, tolerance):
    return BODIES[name].polyhedron(tolerance)


@every_body
def test_moments_are_the_flux_through_the_boundary(name):
    gear = BODIES[name]
    exact, flux = gear.solid.moments, flux_moments(gear.boundary)
    assert apart(about_apex(exact), about_apex(flux)) < 1e-13
    assert exact.error_bound < 2e-11  # apexes far from a narrow face cost digits


@every_body
def test_polyhedra_are_watertight_and_have_a_tunnel_for_each_hole(name):
    gear, found = BODIES[name], mesh(name, 0.02)
    triangles = np.asarray(found.faces)
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    assert components(triangles) == 1
    assert genus(triangles) == (gear.bore is not None) + (gear.web_holes or 0)


@pytest.mark.parametrize("name", [name for name in BODIES if name not in ("plain", "bored", "spiral, crowned, keyed")])
def test_polyhedra_converge_to_the_moments_with_the_tolerance(name):
    """A tolerance goes with the square of a step: order 2 in the step."""
    exact = BODIES[name].properties()
    found = [mesh(name, tolerance).properties() for tolerance in (0.02, 0.002)]
    errors = [one.volume / exact.volume - 1.0 for one in found]
    assert 0.7 < np.log10(errors[0] / errors[1]) < 1.3
    inertia = [np.abs(one.central_second - exact.central_second).max() for one in found]
    assert 0.7 < np.log10(inertia[0] / inertia[1]) < 1.3
    assert abs(errors[1]) < 1e-3


def test_a_crown_gear_s_cylinders_lean_by_rounding():
    """Their lines' ends are told to 16 digits, and so are their directions."""
    gear = BevelGear(teeth=33, module=4.15586484473923, pitch_angle=90.0, face_width=5.485741595055783)
    radii = [
        point[0] for point in (gear.body.front_edge, gear.tooth_ends.point(gear.body.ring_angle, gear.inner_distance))
    ]
    assert radii[0] != radii[1]
    assert apart(about_apex(gear.solid.moments), about_apex(flux_moments(gear.boundary))) < 1e-13


def _half_section(gear):
    """The body below the roots of a plain conical gear: corners in (ρ, z), by plane geometry in the axial plane."""
    angle, outer, inner = gear.pitch_cone_angle, gear.cone_distance, gear.inner_distance
    along, normal = np.array([np.sin(angle), np.cos(angle)]), np.array([np.cos(angle), -np.sin(angle)])
    below = gear.proportions.dedendum / outer  # tan θ_f: the roots go through the apex
    further = np.tan(np.arctan(below) + np.arctan(gear.proportions.depth / outer))
    corner = [s * (along - f * normal) for s, f in ((inner, below), (outer, below), (outer, further), (inner, further))]
    radius = 0.0 if gear.bore is None else gear.bore / 2.0
    back, front = corner[2][1], corner[3][1]
    return np.array([*corner[:3], (radius, back), (radius, front), corner[3]])


def _revolved(corners):
    """Volume, and first moment in z, of a polygon (n, 2) in (ρ, z) turned around, counter-clockwise: by Pappus."""
    following = np.roll(corners, -1, axis=0)
    (r, z), (s, w) = corners.T, following.T
    cross = r * w - s * z
    volume = 2.0 * np.pi * np.sum(cross * (r + s)) / 6.0
    first = 2.0 * np.pi * np.sum(cross * (2.0 * r * z + r * w + s * z + 2.0 * s * w)) / 24.0
    return volume, first


def _teeth(gear):
    """The same of the teeth, by their thickness over the polar angle: ∫ 2πf dΩ, f the part that is tooth."""
    tooth, angle = gear.tooth, gear.pitch_cone_angle

    def integral(power):
        total = 0.0
        x, w = np.polynomial.legendre.leggauss(60)
        for a, b in pairwise([tooth.root_angle, tooth.form_angle, tooth.face_angle]):
            polar = a + (b - a) / 4.0 * (1.0 + x) ** 2  # fillets leave their root as a square root does
            part = 2.0 * gear.teeth * tooth.profile_half(polar) * np.sin(polar) * np.cos(polar) ** (power - 3)
            reach = (gear.cone_distance**power - gear.inner_distance**power) / power
            total += (b - a) / 2.0 * np.sum(w * (1.0 + x) * part * reach / np.cos(polar - angle) ** power)
        return float(total)

    return integral(3), integral(4)


@pytest.mark.parametrize("bore", [None, 18.0])
@pytest.mark.parametrize(
    "cone", [{"mate_teeth": 36}, {"mate_teeth": 12}, {"mate_teeth": 30, "shaft_angle": 70.0}], ids=str
)
def test_a_gear_is_its_teeth_and_a_polygon_turned_around(cone, bore):
    gear = BevelGear(teeth=24, module=3.0, face_width=16.0, bore=bore, **cone)
    body, teeth = _revolved(_half_section(gear)), _teeth(gear)
    matrix = about_apex(gear.solid.moments)
    assert matrix[0, 0] == pytest.approx(body[0] + teeth[0], rel=1e-10)
    assert matrix[0, 3] == pytest.approx(body[1] + teeth[1], rel=1e-10)


def _frustum(gear, low, high):
    """Volume within the back cone from one z to another, outside the bore."""
    angle = gear.pitch_cone_angle
    radii = [(gear.cone_distance - z * np.cos(angle)) / np.sin(angle) for z in (low, high)]
    a, b = radii
    return np.pi * (high - low) * ((a * a + a * b + b * b) / 3.0 - (gear.bore or 0.0) ** 2 / 4.0)


@pytest.mark.parametrize("bore", [None, 18.0])
def test_moving_the_mounting_face_adds_a_frustum_of_the_back_cone(bore):
    faces = (60.0, 63.0, 70.0)
    found = [volume(replace(PLAIN, bore=bore, mounting_distance=z)) for z in faces]
    for k in (0, 1):
        added = _frustum(replace(PLAIN, bore=bore), faces[k], faces[k + 1])
        assert found[k + 1] - found[k] == pytest.approx(added, rel=1e-9)


def test_the_mounting_distance_that_is_told_changes_nothing_when_it_is_given():
    told = PLAIN.sizes()["mounting_distance"].value
    assert volume(replace(PLAIN, mounting_distance=told)) == pytest.approx(volume(PLAIN), rel=1e-12)


@pytest.mark.parametrize("ends", ["conical", "flat"])
@pytest.mark.parametrize("wide", [False, True], ids=["narrow", "wider than the front face"])
def test_a_longer_hub_adds_a_cylinder(ends, wide):
    gear = replace(PLAIN, ends=ends, bore=14.0, hub_diameter=32.0)
    if wide:
        gear = replace(gear, mate_teeth=18, hub_diameter=50.0 if ends == "conical" else 40.0)
        assert gear.body.hub_is_wide
    back = gear.sizes()["mounting_distance"].value
    found = [replace(gear, mounting_distance=back + more) for more in (0.0, 2.0, 11.0)]
    area = np.pi * (gear.hub_diameter**2 - gear.bore**2) / 4.0
    for one, more in zip(found, (0.0, 2.0, 11.0), strict=True):
        assert volume(one) - volume(found[0]) == pytest.approx(area * more, rel=1e-9, abs=1e-8)
    spin = [about_apex(one.solid.moments)[[1, 2], [1, 2]].sum() for one in found]
    ring = np.pi * (gear.hub_diameter**4 - gear.bore**4) / 32.0
    assert spin[2] - spin[0] == pytest.approx(ring * 11.0, rel=1e-9)
    alone = volume(replace(gear, hub_diameter=None))
    assert volume(found[0]) == pytest.approx(alone, rel=1e-12)


def test_a_hub_s_length_counts_from_its_own_end():
    by_length = replace(PLAIN, **HUB, hub_length=31.0)
    by_distance = replace(PLAIN, **HUB, mounting_distance=by_length.sizes()["mounting_distance"].value)
    assert volume(by_length) == pytest.approx(volume(by_distance), rel=1e-13)
    front = mesh_of(by_length).vertices[:, 2]
    inside = np.hypot(*mesh_of(by_length).vertices[:, :2].T) < 8.0
    assert np.ptp(front[inside]) == pytest.approx(31.0, abs=1e-9)


@cache
def mesh_of(gear):
    return gear.polyhedron(0.05)


@pytest.mark.parametrize("hub", [{}, {"hub_diameter": 32.0, "mounting_distance": 72.0}], ids=["", "hub"])
def test_a_keyway_takes_away_a_prism(hub):
    gear = replace(PLAIN, bore=14.0, **hub)
    keyed = replace(gear, **KEY)
    depth, half = 7.0 + KEY["keyway_depth"], KEY["keyway_width"] / 2.0
    area = quad(lambda y: depth - np.sqrt(49.0 - y * y), -half, half, epsabs=0.0, epsrel=1e-13)[0]
    first = quad(lambda y: (depth**2 - 49.0 + y * y) / 2.0, -half, half, epsabs=0.0, epsrel=1e-13)[0]
    levels = mesh_of(gear).vertices
    height = np.ptp(levels[np.hypot(levels[:, 0], levels[:, 1]) < 7.01][:, 2])
    plain, cut = (about_apex(one.solid.moments) for one in (gear, keyed))
    assert plain[0, 0] - cut[0, 0] == pytest.approx(area * height, rel=1e-9)
    assert plain[0, 1] - cut[0, 1] == pytest.approx(first * height, rel=1e-9)
    assert cut[0, 2] == pytest.approx(0.0, abs=1e-9 * plain[0, 0])


def test_a_web_leaves_its_thickness_between_hub_and_rim():
    hub = replace(PLAIN, **HUB, mounting_distance=72.0)
    levels = mesh_of(replace(PLAIN, bore=14.0)).vertices
    height = np.ptp(levels[np.hypot(levels[:, 0], levels[:, 1]) < 7.01][:, 2])
    ring = np.pi * (WEB["rim_diameter"] ** 2 - HUB["hub_diameter"] ** 2) / 4.0
    webs = [about_apex(replace(hub, **more).solid.moments) for more in ({}, WEB, {**WEB, "web_thickness": 3.0})]
    assert webs[0][0, 0] - webs[1][0, 0] == pytest.approx(ring * (height - 7.0), rel=1e-9)
    assert webs[1][0, 0] - webs[2][0, 0] == pytest.approx(ring * 4.0, rel=1e-9)
    middle = (webs[1] - webs[2])[0, 3] / (ring * 4.0)
    low = levels[np.hypot(levels[:, 0], levels[:, 1]) < 7.01][:, 2].min()
    assert middle == pytest.approx(low + height / 2.0, rel=1e-9)


def test_holes_take_cylinders_out_of_the_web():
    web = replace(PLAIN, **HUB, **WEB, mounting_distance=72.0)
    for circle, count in ((None, 5), (35.5, 3)):
        holes = replace(web, web_holes=count, web_hole_diameter=3.0, web_hole_circle=circle)
        lost = about_apex(web.solid.moments) - about_apex(holes.solid.moments)
        assert lost[0, 0] == pytest.approx(count * np.pi * 2.25 * 7.0, rel=1e-9)
        middle = (36.25 if circle is None else circle) / 2.0  # between the hub's 32 and the rim's 40.5
        about_axis = (lost[1, 1] + lost[2, 2]) / lost[0, 0]
        assert about_axis == pytest.approx(middle**2 + 1.125, rel=1e-8)


@pytest.mark.parametrize("ends", ["spherical", "flat"])
def test_a_bore_takes_away_what_is_between_the_ends(ends):
    gear = replace(PLAIN, ends=ends)
    inner, outer = gear.inner_distance, gear.cone_distance
    if ends == "flat":
        lost = np.pi * 81.0 * (outer - inner) * np.cos(gear.pitch_cone_angle)
    else:
        lost = 2.0 * np.pi / 3.0 * (outer**3 - (outer**2 - 81.0) ** 1.5 - inner**3 + (inner**2 - 81.0) ** 1.5)
    assert volume(gear) - volume(replace(gear, bore=18.0)) == pytest.approx(lost, rel=1e-10)


def test_inches_and_millimetres_are_the_same_gear():
    gear = BODIES["web with holes"]
    lengths = ("face_width", "bore", "hub_diameter", "rim_diameter", "web_thickness", "web_hole_diameter")
    values = {name: getattr(gear, name) / 25.4 for name in (*lengths, "mounting_distance")}
    inch = replace(gear, **values, module=None, diametral_pitch=25.4 / 3.0, length_unit="in")
    scale = np.diag([1.0, 25.4, 25.4, 25.4])
    assert apart(scale @ about_apex(inch.solid.moments) @ scale * 25.4**3, about_apex(gear.solid.moments)) < 1e-14
    keyed = replace(PLAIN, bore=20.0, keyway="din-6885")
    own = replace(PLAIN, face_width=16.0 / 25.4, bore=20.0 / 25.4, keyway="din-6885", module=3.0, length_unit="in")
    assert volume(own) * 25.4**3 == pytest.approx(volume(keyed), rel=1e-13)


@every_body
def test_sizes_told_are_those_of_the_surface(name):
    gear, points = BODIES[name], mesh(name, 0.02).vertices
    sizes = {key: size.value for key, size in gear.sizes().items()}
    radius, height = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    chord = 1e-12 if gear.pitch_cone_angle < 1.5 else 2e-5  # the widest circle of a crown gear runs across its teeth
    assert 2.0 * radius.max() == pytest.approx(sizes["outside_diameter"], rel=chord)
    if gear.ends == "spherical":
        assert "mounting_distance" not in sizes
        return
    tips = []
    for end in (gear.cone_distance, gear.inner_distance):
        lean = gear.pitch_cone_angle if gear.ends == "conical" else 0.0
        there = np.cos(lean - gear.pitch_cone_angle) * end
        on_it = np.abs(radius * np.sin(lean) + height * np.cos(lean) - there) < 1e-9 * there
        tips.append(max(zip(np.arctan2(radius, height)[on_it], radius[on_it], height[on_it], strict=True)))
    assert sizes["crown_to_apex"] == pytest.approx(tips[0][2], abs=1e-9)
    assert sizes["axial_face_width"] == pytest.approx(tips[0][2] - tips[1][2], abs=1e-9)
    assert sizes["inner_tip_diameter"] == pytest.approx(2.0 * tips[1][1], rel=1e-12)
    if gear.hub_diameter is not None or gear.mounting_distance is not None:
        assert sizes["mounting_distance"] == pytest.approx(height.max(), rel=1e-12)
    assert sizes["crown_to_back"] == pytest.approx(sizes["mounting_distance"] - tips[0][2], abs=1e-9)
    assert np.any(np.abs(height - sizes["mounting_distance"]) < 1e-9)


@pytest.mark.parametrize(("ends", "angle"), [("conical", None), ("flat", 0.0)])
def test_ends_lie_on_the_surfaces_they_are_named_after(ends, angle):
    """Every point of the teeth's end is as far along the pitch line, or along the axis, as the end is."""
    gear = replace(PLAIN, ends=ends, bore=18.0)
    points = gear.polyhedron(0.1).vertices
    radius, height = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    lean = gear.pitch_cone_angle if angle is None else angle
    level = radius * np.sin(lean) + height * np.cos(lean)
    last = gear.cone_distance * (1.0 if ends == "conical" else np.cos(gear.pitch_cone_angle))
    assert level.max() == pytest.approx(last, rel=1e-13)
    tips = np.arctan2(radius, height) > gear.bevel_teeth.outer.root_angle + 1e-9
    assert level[tips].min() == pytest.approx(last * gear.inner_distance / gear.cone_distance, rel=1e-13)
