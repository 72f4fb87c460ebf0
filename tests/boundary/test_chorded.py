"""The body with a section of chords and no layers is the sweep of the inscribed polygon."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.chorded import chorded_moments, sagitta
from gearwright.boundary.sampling import fixed_sampling
from gearwright.boundary.tessellation import tessellate, tessellate_caps
from gearwright.curves.arc import Arc

from ..laws.topology import volume

GEAR = gw.SpurGear(teeth=7, module=3.0, face_width=20.0, bore=5.0)
BORED_BEVEL = gw.BevelGear(
    teeth=12, mate_teeth=20, module=3.0, face_width=12.0, bore=8.0, trace="logarithmic", spiral_angle=30.0
)


def inscribed(section, chords):
    """The polygon section with so many chords a curve, six times as many on a curve closed in itself."""
    outlines = []
    for loop in section.loops:
        curves = loop.with_copies(1).curves
        n = chords * (6 if len(curves) == 1 else 1)
        outlines.append(np.concatenate([c.point(c.parameter(np.arange(n) / n)) for c in curves]))
    return gw.Section.polygon(outlines[0], holes=outlines[1:])


def moments(solid, chords):
    boundary = solid.boundary
    found = fixed_sampling(boundary, chords, 1, 0.1)
    return chorded_moments(boundary, found, solid.properties().centroid)


@pytest.mark.parametrize(
    "form",
    [
        {"twist": 50.0},
        {"twist": -35.0, "scale": (0.7, 1.2)},
        {"scale": (0.5, 0.5), "skew": (13.0, -4.0)},
    ],
    ids=["twisted", "left-handed and squeezed", "tapered and skew"],
)
@pytest.mark.parametrize("chords", [1, 3])
def test_it_is_the_exact_sweep_of_the_inscribed_polygon(form, chords):
    section = GEAR.solid.section
    found = moments(gw.extrude(section, 20.0, **form), chords)
    exact = gw.extrude(inscribed(section, chords), 20.0, **form).properties()
    assert found.volume == pytest.approx(exact.volume, rel=1e-13)
    assert found.centroid == pytest.approx(exact.centroid, abs=1e-12)
    assert found.central_second == pytest.approx(exact.central_second, rel=1e-12, abs=1e-12 * exact.volume)


def test_a_ring_without_caps_has_its_section_in_chords_too():
    ring = gw.revolve(gw.Section.circle(1.0, (3.0, 0.0)))
    hexagon = np.pi / 3.0 * np.arange(6)
    around = gw.Section.polygon(np.stack([3.0 + np.cos(hexagon), np.sin(hexagon)], axis=1))
    assert moments(ring, 1).volume == pytest.approx(gw.revolve(around).properties().volume, rel=1e-13)


@pytest.mark.parametrize("part", [BORED_BEVEL, gw.revolve(gw.Section.circle(1.0, (3.0, 0.0)), 100.0)], ids=type)
def test_polyhedra_of_ever_more_layers_tend_to_it(part):
    """Without any formula: Richardson's value for infinitely many layers, with the same caps."""
    boundary = part.boundary
    found = [fixed_sampling(boundary, 4, layers, 0.1) for layers in (32, 64)]
    coarse, fine = (volume(*tessellate(boundary, one)) for one in found)
    limit = chorded_moments(boundary, found[0], part.properties().centroid).volume
    assert limit == pytest.approx(fine + (fine - coarse) / 3.0, rel=2e-8)
    assert abs(coarse / limit - 1.0) > 1e-6


def test_the_point_they_are_taken_about_makes_no_difference():
    boundary = BORED_BEVEL.boundary
    found = fixed_sampling(boundary, 3, 1, 0.1)
    near, far = (chorded_moments(boundary, found, np.array(point)) for point in ([0.0, 0.0, 15.0], [4.0, -3.0, 2.0]))
    assert far.volume == pytest.approx(near.volume, rel=1e-13)
    assert far.centroid == pytest.approx(near.centroid, abs=1e-12)


def test_chords_that_enclose_nothing_are_refused():
    lens = gw.Section.outline([Arc(radius=1.0, interval=(k * np.pi, (k + 1) * np.pi)) for k in (0, 1)])
    with pytest.raises(gw.GeometryError, match="1 chords a section curve: take more"):
        moments(gw.extrude(lens, 1.0), 1)


def test_caps_alone_are_those_of_the_whole():
    found = fixed_sampling(BORED_BEVEL.boundary, 4, 3, 0.2)
    points, triangles = tessellate(BORED_BEVEL.boundary, found)
    cap_points, caps = tessellate_caps(BORED_BEVEL.boundary, found)
    whole = {tuple(np.round(corners, 9).ravel()) for corners in points[triangles]}
    assert len(caps) > 100
    assert whole.issuperset(tuple(np.round(corners, 9).ravel()) for corners in cap_points[caps])


def test_the_sagitta_of_a_circle():
    cylinder = gw.extrude(gw.Section.circle(2.0), 1.0).boundary
    assert sagitta(cylinder, fixed_sampling(cylinder, 2, 1, 1.0)) == pytest.approx(2.0 * (1.0 - np.cos(np.pi / 12.0)))
