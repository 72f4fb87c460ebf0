"""Lines of contact: both flanks are there, as many as the contact ratio says, as long as they must be."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from gearwright.contact.approach import Approach
from gearwright.contact.lines import contact_lines, contact_ratios, lines_at
from gearwright.contact.mesh import mesh_of
from gearwright.contact.path import ContactPath
from gearwright.curves.traces.trace import Trace
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.errors import GeometryError

from .octoid import with_octoids
from .test_transmission import BASIC, PAIRS, SPIRAL, every_pair, every_side

TURNS = np.linspace(0.0, 22.5, 7)


@dataclass(frozen=True, kw_only=True)
class Arched(Trace):
    """Like a zerol gear's: turning back in the middle of the face."""

    middle: float
    rate: float

    @property
    def reach(self):
        return 0.0, np.inf

    def crown_angle(self, distance):
        raise NotImplementedError

    def spiral_angle(self, distance):
        raise NotImplementedError

    def turn(self, distance):
        return self.rate * (np.asarray(distance, float) - self.middle) ** 2

    def slope(self, distance):
        return 2.0 * self.rate * (np.asarray(distance, float) - self.middle)


def arched(pair):
    """The mesh of a pair with such a trace."""
    mesh = mesh_of(pair)
    rate = 4e-3
    pinion = replace(mesh.pinion, trace=Arched(middle=pair.pinion.mean_distance, rate=rate))
    gear_rate = -rate * mesh.pinion.teeth / mesh.gear.teeth
    gear = replace(mesh.gear, trace=Arched(middle=pair.pinion.mean_distance, rate=gear_rate))
    return replace(mesh, pinion=pinion, gear=gear)


def both_flanks_are_there(mesh, side):
    approach, path = Approach(mesh=mesh, side=side), ContactPath(mesh=mesh, side=side)
    for turn in np.radians(TURNS):
        lines = lines_at(path, turn)
        assert lines
        for line in lines:
            at = np.full(line.distance.shape, turn + mesh.pitch * line.tooth)
            level = mesh.pinion.level(line.polar, line.distance)
            np.testing.assert_allclose(approach.lead(at, level, line.polar), 0.0, atol=1e-11)
            assert np.all(approach.room(at, level, line.polar) > -1e-9)
            assert np.all(mesh.pinion.room(line.polar, line.distance) > -1e-9)


@every_side
@every_pair
def test_both_flanks_are_on_the_lines(name, side):
    """The lines are found from the pinion and the law of gearing; the gear's flank comes to them by itself."""
    both_flanks_are_there(mesh_of(BevelPair(**PAIRS[name])), side)
    both_flanks_are_there(with_octoids(BevelPair(**PAIRS[name])), side)


@every_side
@pytest.mark.parametrize("hand", ["left", "right"])
def test_so_are_those_of_spirals(side, hand):
    pair = BevelPair(**BASIC, **SPIRAL, hand=hand)
    both_flanks_are_there(mesh_of(pair), side)
    both_flanks_are_there(with_octoids(pair), side)


@every_side
def test_so_are_those_of_arches(side):
    both_flanks_are_there(arched(BevelPair(**BASIC)), side)


@every_side
@every_pair
def test_involutes_touch_on_the_great_circle_tangent_to_both_base_cones(name, side):
    pair = BevelPair(**PAIRS[name])
    path = ContactPath(mesh=mesh_of(pair), side=side)
    points = path.point(np.linspace(*path.heights, 40))
    normal = np.linalg.svd(points)[2][2]
    # nearest to the cusp, slopes of the fitted flank are quotients of roundings
    assert np.abs(points @ normal).max() < 1e-9
    axes = [placement[:3, 2] for placement in pair.placements()]
    tangent = [np.sin(gear.tooth.base_cone_angle) for gear in (pair.pinion, pair.gear)]
    assert np.abs([axis @ normal for axis in axes]) == pytest.approx(tangent, abs=1e-10)


@every_side
@every_pair
def test_the_contact_ratio_is_that_of_the_closed_form(name, side):
    pair = BevelPair(**PAIRS[name])
    found = contact_ratios(pair, side)
    assert found.transverse == pytest.approx(pair.sizes()["contact_ratio"].value, abs=1e-11)
    assert found.overlap == 0.0
    assert found.total == found.transverse


EVERY_TRACE = pytest.mark.parametrize(
    "more", [{}, SPIRAL, {**SPIRAL, "hand": "left"}], ids=["straight", "right", "left"]
)


@EVERY_TRACE
def test_there_are_as_many_lines_on_average_as_the_total_contact_ratio(more):
    pair = BevelPair(**BASIC, **more)
    turns = (np.arange(200) + 0.5) / 200.0 * 360.0 / 16
    found = contact_ratios(pair)
    assert np.mean([len(contact_lines(pair, turn, samples=2)) for turn in turns]) == pytest.approx(
        found.total, abs=0.01
    )


@EVERY_TRACE
@pytest.mark.parametrize("form", ["involute", "octoid"])
def test_contact_ratios_are_those_that_the_pair_says_in_closed_form(more, form):
    """In all exactly so where ends are spheres; conical ones take or give a little at the tips."""
    pair = BevelPair(**BASIC, **more, tooth_form=form, ends="spherical")
    said, found = pair.sizes(), contact_ratios(pair)
    assert found.transverse == pytest.approx(said["contact_ratio"].value, abs=1e-11)
    assert found.overlap == pytest.approx(said["overlap_ratio"].value, abs=1e-13)
    assert found.total == pytest.approx(said["total_contact_ratio"].value, abs=1e-11)
    assert (found.overlap > 0.5) == bool(more)
    on_cones = contact_ratios(replace(pair, ends="conical"))
    assert (on_cones.transverse, on_cones.overlap) == (found.transverse, found.overlap)
    assert on_cones.total == pytest.approx(found.total, abs=0.01)
    assert (on_cones.total == pytest.approx(found.total, abs=1e-9)) == (not more)


@pytest.mark.parametrize(
    "given", [{"taper": "uniform", "teeth": (24, 30)}, {"standard": "gleason-straight"}], ids=["uniform", "gleason"]
)
def test_tips_that_do_not_point_at_the_apex_touch_longer_at_one_end(given):
    pair = BevelPair(**{**BASIC, **given})
    path, ratios = ContactPath(mesh=mesh_of(pair)), contact_ratios(pair)
    inner, outer = (float(np.ptp(path.turn(np.concatenate(path.active(r))))) for r in path.mesh.pinion.pitch_ends)
    transverse = ratios.transverse * path.mesh.pitch
    assert min(inner, outer) < transverse < max(inner, outer)
    assert max(inner, outer) <= ratios.total * path.mesh.pitch * (1.0 + 1e-3)
    assert ratios.transverse == pytest.approx(pair.sizes()["contact_ratio"].value, abs=1e-10)
    for side in ("drive", "coast"):
        both_flanks_are_there(path.mesh, side)


def test_a_line_from_end_to_end_leans_by_the_base_spiral_angle():
    """tan β_b = cos a tan β on the plane of action of a logarithmic spiral, at every cone distance."""
    lengths = {}
    for name, more in {"straight": {}, "spiral": SPIRAL}.items():
        pair = BevelPair(**BASIC, **more, ends="spherical")
        lines = [line for turn in TURNS for line in contact_lines(pair, turn, samples=513)]
        lengths[name] = max(line.length for line in lines if np.ptp(line.distance) > 10.0 - 1e-9)
    assert lengths["straight"] == pytest.approx(10.0, rel=1e-12)
    lean = np.arctan(np.cos(np.radians(20.0)) * np.tan(np.radians(35.0)))
    assert lengths["spiral"] == pytest.approx(10.0 / np.cos(lean), rel=1e-6)


@pytest.mark.parametrize(
    "given", [{}, {"ends": "flat"}, {"taper": "uniform", "teeth": (24, 30)}], ids=["conical", "flat", "uniform"]
)
def test_lines_of_a_spiral_end_at_the_ends_or_the_tips(given):
    pair = BevelPair(**{**BASIC, **SPIRAL, **given})
    path = ContactPath(mesh=mesh_of(pair))
    for turn in TURNS:
        for line in contact_lines(pair, turn):
            for r, polar in zip(line.distance[[0, -1]], line.polar[[0, -1]], strict=True):
                other = path.gear_polar(polar)
                rooms = path.mesh.pinion.room(polar, r), path.mesh.gear.room(other, r)
                assert min(rooms) == pytest.approx(0.0, abs=1e-9)
            middle = len(line.polar) // 2
            assert path.mesh.gear.room(path.gear_polar(line.polar[middle]), line.distance[middle]) > 1e-6


def test_an_arched_tooth_touches_alike_on_both_arms():
    path = ContactPath(mesh=arched(BevelPair(**BASIC, ends="spherical")))
    (line,) = [line for line in lines_at(path, 0.0) if line.tooth == 0]
    assert np.ptp(line.distance) == pytest.approx(10.0, rel=1e-12)
    np.testing.assert_allclose(line.polar, line.polar[::-1], rtol=1e-12)
    cut = [line for turn in TURNS for line in lines_at(path, np.radians(turn)) if np.ptp(line.distance) < 9.0]
    assert any(line.distance[-1] < path.mesh.pinion.trace.middle for line in cut)
    assert any(line.distance[0] > path.mesh.pinion.trace.middle for line in cut)


@pytest.mark.parametrize(
    "given", [{"turn": float("nan")}, {"turn": float("inf")}, {"turn": 0.0, "samples": 1}], ids=str
)
def test_what_is_no_turn_or_no_line_is_refused(given):
    with pytest.raises(GeometryError, match="finite turn in degrees and at least 2 points"):
        contact_lines(BevelPair(**BASIC), **given)
