"""Polyhedra of a pair keep out of each other through a cycle, and a pair that does not is found out."""

import sys

import numpy as np
import pytest

import gearwright as gw
from gearwright.contact.mesh import mesh_of
from gearwright.contact.overlap import _body, flank_area, overlap_through_cycle
from gearwright.elements.bevel.bevel_pair import BevelPair

from .surfaces import flank_patches
from .test_transmission import BASIC, SPIRAL


@pytest.mark.parametrize("more", [{}, SPIRAL, {"shaft_angle": 60.0}], ids=["straight", "spiral", "Σ 60°"])
def test_conjugate_teeth_share_no_more_than_chords_and_ever_less(more):
    pair = BevelPair(**BASIC, **more)
    coarse, fine = (overlap_through_cycle(pair, tolerance=t, turns=3) for t in (0.04, 0.004))
    for found in (coarse, fine):
        assert found.keeps_apart
        assert found.volumes.max() <= 0.02 * found.bound
        assert found.volumes.shape == (3,)
    assert fine.volumes.max() <= max(coarse.volumes.max() / 10.0, 1e-3 * fine.bound)
    np.testing.assert_allclose(coarse.turns, [0.0, 7.5, 15.0])


SPIRALS = {
    "circular, Gleason": {"trace": "circular", "cutter_radius": 57.15, "standard": "gleason-spiral"},
    "circular, ISO 23509, uniform": {
        "trace": "circular",
        "cutter_radius": 57.15,
        "standard": "iso-23509",
        "taper": "uniform",
    },
    "logarithmic, ISO 23509": {"trace": "logarithmic", "standard": "iso-23509"},
}


@pytest.mark.parametrize("name", SPIRALS)
def test_13_and_44_spiral_teeth_are_whole_and_keep_apart(name):
    """Every vertex above the root cone belongs to one of 13 or 44 equal teeth; bodies are closed and of one piece."""
    pair = BevelPair(teeth=(13, 44), module=3.0, face_width=20.0, spiral_angle=35.0, **SPIRALS[name])
    found = overlap_through_cycle(pair, tolerance=0.03, turns=3)
    assert found.volumes.max() <= 0.02 * found.bound
    for gear, count in ((pair.pinion, 13), (pair.gear, 44)):
        body = _body(gear.polyhedron(0.03), np.eye(4))
        assert body.status().name == "NoError"
        assert len(body.decompose()) == 1
        tip = body.to_mesh64().vert_properties[:, :3]
        polar = np.arctan2(np.hypot(tip[:, 0], tip[:, 1]), tip[:, 2])
        tooth = gear.bevel_teeth.outer
        outer = tip[(polar > tooth.face_angle - 1e-3) & (np.linalg.norm(tip, axis=1) > gear.cone_distance)]
        azimuth = np.sort(np.arctan2(outer[:, 1], outer[:, 0]))
        gaps = np.diff(azimuth, append=azimuth[0] + 2.0 * np.pi)
        assert np.sum(gaps > 0.3 * 2.0 * np.pi / count) == count


class Overlapping(BevelPair):
    """Placed with the gear turned too far by an angle, degrees, about its axis."""

    def placements(self, turn=0.0):
        pinion, gear = super().placements(turn)
        c, s = np.cos(np.radians(0.3)), np.sin(np.radians(0.3))
        return pinion, gear @ np.array([[c, -s, 0.0, 0.0], [s, c, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0, 0, 0, 1.0]])


def test_members_that_run_into_each_other_are_found_out():
    found = overlap_through_cycle(Overlapping(**BASIC), tolerance=0.01, turns=2)
    assert not found.keeps_apart
    assert found.volumes.min() > 2.0 * found.bound


def test_backlash_shares_nothing():
    found = overlap_through_cycle(BevelPair(**BASIC, backlash=0.3), turns=1)
    assert found.volumes.tolist() == [0.0]
    assert found.tolerance == pytest.approx(1e-4 * 51.22499389946279)


@pytest.mark.parametrize("more", [{}, SPIRAL], ids=["straight", "spiral"])
def test_the_area_is_that_of_the_solids_flanks(more):
    pair = BevelPair(**BASIC, **more)
    x, w = np.polynomial.legendre.leggauss(16)
    u, v = (a.ravel() for a in np.meshgrid((x + 1.0) / 2.0, (x + 1.0) / 2.0))
    weights = np.outer(w, w).ravel() / 4.0
    whole = sum(float(np.linalg.norm(p.area_vector(u, v), axis=1) @ weights) for p in flank_patches(pair.pinion))
    assert flank_area(mesh_of(pair).pinion) == pytest.approx(whole, rel=2e-4)


def test_what_cannot_be_measured_is_refused():
    with pytest.raises(gw.GeometryError, match=r"tolerance = 0: .*\n.*turns = 0: at least 1"):
        overlap_through_cycle(BevelPair(**BASIC), tolerance=0.0, turns=0)


def test_without_the_extra_it_says_which_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    with pytest.raises(gw.MachineError, match=r"pip install 'gearwright\[mesh\]'"):
        overlap_through_cycle(BevelPair(**BASIC), tolerance=0.1, turns=1)
