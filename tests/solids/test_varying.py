"""Sections that vary along straight and helical sweeps, held against closed forms, flux, polyhedra and twists."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.boundary.faces import alike
from gearwright.curves.arc import Arc
from gearwright.curves.frames import rotation_minimising
from gearwright.curves.helix import helix
from gearwright.curves.line import Line
from gearwright.curves.polynomial import Polynomial, parabola
from gearwright.curves.turning import TurnedArc, turned
from gearwright.errors import GeometryError
from gearwright.moments.matrix import shifted
from gearwright.motions.along import Along
from gearwright.motions.ends import between
from gearwright.motions.extrusion import Extrusion
from gearwright.motions.motion import Motion
from gearwright.motions.revolution import Revolution
from gearwright.motions.straight import Straight
from gearwright.motions.transform import transform_of
from gearwright.motions.transforming import Transforming
from gearwright.sections.loop import Loop
from gearwright.sections.members import looks, member_moments
from gearwright.sections.plane import Section
from gearwright.solids.approximation import layer_refinement, section_refinement
from gearwright.solids.solid import flux_moments
from gearwright.solids.swept import Swept

from ..laws.facets import distance_from_patch, distance_to_patch, facets
from ..laws.topology import components, edges_pair_up, genus
from .crowned import FACE_WIDTH, CrownedGear

CROWNED = CrownedGear(parabola(0.004, 0.0, FACE_WIDTH))
RELIEVED = CrownedGear(Polynomial(coefficients=(0.001, 2e-4, 0.0, 0.0, 6e-8), centre=7.0), teeth=17)
HIGH = CrownedGear(parabola(0.003, 0.0, FACE_WIDTH), teeth=61)  # its roots lie outside the base circle
TWISTS = (0.0, 0.3, -2.0)
FLUX = 4e-14
"""Products of matrices are summed in an order of the processor's own: on the worst of seven, 1.6e-14 was left."""
every_gear = pytest.mark.parametrize("gear", [CROWNED, RELIEVED, HIGH], ids=["crowned", "relieved", "high"])
every_twist = pytest.mark.parametrize("twist", TWISTS)


def same_moments(one, other, tolerance):
    assert one.volume == pytest.approx(other.volume, rel=tolerance)
    size = np.cbrt(other.volume)
    np.testing.assert_allclose(one.centroid, other.centroid, rtol=0.0, atol=tolerance * size)
    norm = np.linalg.norm(other.central_second)
    np.testing.assert_allclose(one.central_second, other.central_second, rtol=0.0, atol=tolerance * norm)


@every_twist
@every_gear
def test_moments_by_quadrature_of_members_are_those_of_the_flux(gear, twist):
    solid = gear.solid(twist)
    same_moments(solid.moments, flux_moments(solid.boundary), 1e-14)
    assert solid.moments.method == "exact"
    assert 0 < solid.moments.evaluations <= 32
    assert solid.moments.error_bound < 1e-13


@every_twist
@every_gear
def test_moments_are_those_in_closed_form(gear, twist):
    """Flanks that turn by δ into a tooth take N δ (r_a² − r_f²) of the area, and N δ (r_a⁴ − r_f⁴)/2 of ∫ r² dA.

    Turns about z change none of V, ∫ z dV, ∫ z² dV and ∫ r² dV, and a gear's ∫ x² and ∫ y² are equal.
    """
    (root, tip), n = gear.radii, gear.teeth
    plain = replace(gear, thinning=Polynomial(coefficients=(0.0,))).section.moments
    delta = np.polynomial.Polynomial(gear.thinning.coefficients)(np.polynomial.Polynomial([-gear.thinning.centre, 1.0]))
    z = np.polynomial.Polynomial([0.0, 1.0])
    area = plain[0, 0] - n * (tip**2 - root**2) * delta
    polar = plain[2, 0] + plain[0, 2] - n * (tip**4 - root**4) / 2.0 * delta
    volume, level, levels, turned = ((p.integ()(FACE_WIDTH)) for p in (area, z * area, z * z * area, polar))

    body = gear.solid(twist).moments
    matrix = shifted(body.matrix, body.origin)
    assert body.volume == pytest.approx(volume, rel=2e-15)
    assert matrix[0, 3] == pytest.approx(level, rel=4e-15)
    assert matrix[3, 3] == pytest.approx(levels, rel=4e-15)
    np.testing.assert_allclose([matrix[1, 1], matrix[2, 2]], turned / 2.0, rtol=4e-15)
    np.testing.assert_allclose(matrix[[0, 0, 1, 1, 2], [1, 2, 2, 3, 3]], 0.0, atol=1e-15 * volume * tip**2)


def test_spur_and_helical_have_one_inertia_about_the_axis():
    straight, *helical = (CROWNED.solid(twist).properties() for twist in TWISTS)
    for one in helical:
        assert one.inertia[2, 2] == pytest.approx(straight.inertia[2, 2], rel=4e-15)
        assert one.volume == pytest.approx(straight.volume, rel=4e-15)


@every_twist
def test_polyhedra_converge_to_the_exact_moments(twist):
    solid = CROWNED.solid(twist)
    exact = solid.moments
    errors = []
    for tolerance in (2e-2, 5e-3, 1.25e-3):
        found = solid.polyhedron(tolerance)
        assert found.validity().valid
        triangles = np.asarray(found.faces)
        assert edges_pair_up(triangles)
        assert components(triangles) == 1
        assert genus(triangles) == 1
        errors.append(abs(found.properties().volume / exact.volume - 1.0))
    # of the tolerance; segments, which are rounded up, are its square root
    assert np.log(errors[0] / errors[-1]) / np.log(16.0) == pytest.approx(1.0, abs=0.1)
    assert errors[-1] < 1e-4


@every_twist
def test_polyhedra_are_of_order_two_in_the_section_and_in_the_layers(twist):
    solid = CROWNED.solid(twist)
    for study in (section_refinement(solid, (4, 8, 16)), layer_refinement(solid, (8, 16, 32))):
        assert study.orders["volume"] == pytest.approx(2.0, abs=0.05)
        assert study.orders["inertia"] == pytest.approx(2.0, abs=0.05)
        assert abs(study.rows[-1].volume) < 1e-3


@pytest.mark.parametrize("twist", [0.0, 0.3])
def test_chords_keep_the_tolerance_on_crowned_flanks(twist):
    gear, tolerance = CrownedGear(parabola(0.02, 0.0, FACE_WIDTH)), 1e-3
    found = facets(gear.solid(twist).boundary, tolerance)
    random = np.random.default_rng(5)
    layers = {one.layers for one in found.patches if one.patch.curve.varies}
    worst = 0.0
    for one in found.patches:
        worst = max(worst, distance_to_patch(one.subset(random, 600), 6).max())
        assert distance_from_patch(one, random, 300).max() <= tolerance
    assert tolerance / 3.0 < worst <= tolerance
    assert min(layers) > 5


def test_without_thinning_nothing_changes():
    none = CrownedGear(Polynomial(coefficients=(0.0, 0.0, 0.0), centre=4.0))
    assert none.section.varies
    plain = none.section.at(3.0)
    assert not plain.varies
    for twist in (0.0, 0.3):
        constant = Swept(section=plain, motion=none.solid(twist).motion, ends=between(0.0, FACE_WIDTH))
        assert constant.moments.evaluations == 0
        same_moments(none.solid(twist).moments, constant.moments, 1e-15)
        one, other = none.solid(twist).polyhedron(0.02), constant.polyhedron(0.02)
        np.testing.assert_allclose(one.vertices, other.vertices, atol=1e-13)
        np.testing.assert_array_equal(np.asarray(one.faces), np.asarray(other.faces))


def lopsided(turning=None):
    """A region without any symmetry, the axis outside of it, and the same with every curve turning alike."""
    arc = Arc(radius=1.6, centre=(2.6, 0.9), interval=(-0.8, 1.9))
    corner = (1.1, -0.4)
    outer = (Line(first=corner, last=tuple(arc.start)), arc, Line(first=tuple(arc.end), last=corner))
    hole = (Arc(radius=0.5, centre=(2.9, 1.1), interval=(2.0 * np.pi, 0.0)),)
    loops = [tuple(curve if turning is None else turned(curve, turning) for curve in chain) for chain in (outer, hole)]
    return Section(loops=tuple(Loop(curves=curves) for curves in loops))


class TestAllCurvesTurningAlike:
    """A section that turns as a whole by an angle linear in the height is one that a twisted motion turns."""

    length, rate = 2.5, 0.9
    evenly = Polynomial(coefficients=(0.0, rate))

    def pair(self):
        turning = Swept(section=lopsided(self.evenly), motion=Straight(), ends=between(0.0, self.length))
        motion = Extrusion(length=self.length, twist=self.rate * self.length)
        return turning, Swept(section=lopsided(), motion=motion, ends=between(0.0, self.length))

    def test_moments(self):
        turning, twisted = self.pair()
        assert twisted.moments.evaluations == 0
        same_moments(turning.moments, twisted.moments, 4e-15)
        same_moments(flux_moments(turning.boundary), twisted.moments, FLUX)

    def test_points_and_partials(self):
        turning, twisted = self.pair()
        u, v = np.meshgrid(np.linspace(0.0, 1.0, 5), np.linspace(0.0, 1.0, 7))
        for one, other in zip(turning.boundary.patches, twisted.boundary.patches, strict=True):
            np.testing.assert_allclose(one.point(u, v), other.point(u, v), atol=1e-14)
            for a, b in zip(one.partials(u, v), other.partials(u, v), strict=True):
                np.testing.assert_allclose(a, b, atol=1e-13)

    def test_edges(self):
        turning, twisted = self.pair()
        f = np.linspace(0.0, 1.0, 9)
        for one, other in zip(turning.boundary.edges, twisted.boundary.edges, strict=True):
            u = one.curve.parameter(f)
            assert one.name == other.name
            np.testing.assert_allclose(one.curve.point(u), other.curve.point(u), atol=1e-14)
            np.testing.assert_allclose(one.curve.derivative(u), other.curve.derivative(u), atol=1e-13)
            np.testing.assert_allclose(one.start.position, other.start.position, atol=1e-14)

    def test_polyhedra(self):
        turning, twisted = (solid.polyhedron(1e-3) for solid in self.pair())
        np.testing.assert_allclose(turning.vertices, twisted.vertices, atol=1e-13)
        # ties in the triangulation of end faces are decided by rounding
        assert len(turning.faces) == len(twisted.faces)
        assert turning.properties().volume == pytest.approx(twisted.properties().volume, rel=1e-14)

    def test_extents(self):
        turning, twisted = (solid.properties() for solid in self.pair())
        np.testing.assert_allclose(turning.bounding_box, twisted.bounding_box, atol=1e-12)
        assert turning.area == pytest.approx(twisted.area, rel=1e-13)

    def test_a_twist_back_makes_it_straight(self):
        back = Extrusion(length=self.length, twist=-self.rate * self.length)
        upright = Swept(section=lopsided(self.evenly), motion=back, ends=between(0.0, self.length))
        constant = Swept(section=lopsided(), motion=Straight(), ends=between(0.0, self.length))
        same_moments(upright.moments, constant.moments, 4e-15)
        same_moments(flux_moments(upright.boundary), constant.moments, FLUX)

    def test_scaled_and_skewed(self):
        growing = {"length": self.length, "scale": (1.4, 1.4), "skew": (0.7, -0.3)}
        turning = Swept(section=lopsided(self.evenly), motion=Extrusion(**growing), ends=between(0.0, self.length))
        twisted = Swept(
            section=lopsided(),
            motion=Extrusion(**growing, twist=self.rate * self.length),
            ends=between(0.0, self.length),
        )
        same_moments(turning.moments, twisted.moments, 4e-15)
        same_moments(flux_moments(turning.boundary), twisted.moments, 1e-14)


def test_any_smooth_transform_takes_a_section_that_varies():
    def shearing(z):
        return [[1.0 - 0.02 * z, 0.2 * np.sin(z / 8.0)], [0.001 * z**2, 1.0 + 0.01 * z]]

    motion = Transforming(transform=transform_of(shearing, FACE_WIDTH, 1e-14))
    solid = Swept(section=CROWNED.section, motion=motion, ends=between(0.0, FACE_WIDTH))
    same_moments(solid.moments, flux_moments(solid.boundary), 1e-13)


def test_a_moved_body_and_a_sum_keep_what_the_section_does():
    gear = CrownedGear(parabola(0.004, 0.0, FACE_WIDTH), teeth=13, bore=8.0).solid(0.3)
    rotation = [[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]]
    moved = gear.moved(rotation, (1.0, 2.0, 3.0))
    same_moments(moved.moments, flux_moments(moved.boundary), 1e-13)
    collar = Swept(
        section=Section(
            loops=tuple(
                Loop(curves=(Arc(radius=r, interval=(0.0, s * 2.0 * np.pi)),)) for r, s in ((12.0, 1), (8.0, -1))
            )
        ),
        motion=Straight(),
        ends=between(FACE_WIDTH, FACE_WIDTH + 8.0),
    )
    both = gear + collar
    assert both.moments.volume == pytest.approx(gear.moments.volume + 80.0 * np.pi * 8.0, rel=1e-14)
    same_moments(both.moments, flux_moments(both.boundary), 1e-13)
    assert both.polyhedron(0.02).validity().valid


def test_patches_of_families_are_not_evaluated_together_with_others():
    for run in alike(CROWNED.solid().boundary.patches):
        assert len(run) == 1 or not any(patch.curve.varies for patch in run)


class TestMembers:
    def test_moments_of_many_members_are_those_of_each(self):
        for section in (CROWNED.section, lopsided(Polynomial(coefficients=(0.3, -0.4, 0.2)))):
            heights = np.linspace(0.0, FACE_WIDTH, 37)
            found, error = member_moments(section, heights)
            assert error < 1e-13
            powers = np.add.outer(np.arange(4), np.arange(4))
            unit = section.size ** (2.0 + powers)
            for v, moments in zip(heights, found, strict=True):
                each = section.at(float(v)).local_moments.about(section.middle)
                # rounding grows with what the member's third moments take from the distance of its middle
                np.testing.assert_allclose(moments / unit, each / unit, rtol=1e-15, atol=1e-14)

    def test_they_are_looked_at_on_both_ends_and_where_they_turn_back(self):
        found = looks(RELIEVED.section, 2.0, 9.0)
        assert (found[0], found[-1]) == (2.0, 9.0)
        assert len(found) == 9  # the polynomial's own turn lies below
        section = CrownedGear(parabola(0.002, 1.0, 4.0)).section
        assert 2.5 in looks(section, 0.0, 11.0)

    def test_the_reference_is_what_takes_no_height(self):
        assert CROWNED.section.moments[0, 0] == pytest.approx(CROWNED.section.at(10.0).moments[0, 0], rel=1e-15)
        assert CROWNED.section.at(0.0).moments[0, 0] < CROWNED.section.moments[0, 0]


class TestRefusals:
    def test_a_gap_that_opens_on_the_way_is_refused_with_the_height(self):
        section = CROWNED.section
        outline = section.loops[0]
        constant_tip = TurnedArc(
            radius=CROWNED.radii[1],
            azimuths=outline.curves[2].azimuths,
            turnings=2 * (Polynomial(coefficients=(0.0,)),),
        )
        curves = (*outline.curves[:2], constant_tip, *outline.curves[3:])
        gaping = Section(loops=(replace(outline, curves=curves), section.loops[1]))
        with pytest.raises(GeometryError, match=r"at height 0, gap of 0\.156 after curve 2 of 6") as caught:
            Swept(section=gaping, motion=Straight(), ends=between(0.0, FACE_WIDTH))
        assert len(caught.value.problems) == 2

    def test_teeth_that_grow_pointed_on_the_way_are_refused_with_the_height(self):
        with pytest.raises(GeometryError, match=r"at height 20, loop 1 at .* the outline crosses itself"):
            CrownedGear(Polynomial(coefficients=(0.0, 0.0014))).solid()

    def test_teeth_that_are_pointed_at_one_height_alone_are_refused_there(self):
        """At 11.3 the flanks turn by 0.028, more than the 0.0275 of half a tip; at the heights around by less."""
        with pytest.raises(GeometryError, match=r"at height 11\.3, loop 1"):
            CrownedGear(Polynomial(coefficients=(0.028, 0.0, -0.0006), centre=11.3)).solid()
        blunt = CrownedGear(Polynomial(coefficients=(0.027, 0.0, -0.0006), centre=11.3))
        assert blunt.solid().moments.volume > 0.0

    @pytest.mark.parametrize(
        ("motion", "ends"),
        [
            (Revolution(), between(-1.0, 0.0)),
            (Along(frame=rotation_minimising(helix(90.0, 40.0, 0.8))), between(0.0, 1.0)),
        ],
        ids=["revolution", "along"],
    )
    def test_other_motions_are_refused(self, motion: Motion, ends):
        with pytest.raises(GeometryError, match="the section varies along the motion: only straight and helical"):
            Swept(section=lopsided(Polynomial(coefficients=(0.0, 0.1))), motion=motion, ends=ends)
