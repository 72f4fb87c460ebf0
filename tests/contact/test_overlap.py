"""Polyhedra of a pair keep out of each other through a cycle, and a pair that does not is found out."""

import sys

import numpy as np
import pytest

import gearwright as gw
from gearwright.contact.mesh import mesh_of
from gearwright.contact.overlap import flank_area, overlap_through_cycle
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
    assert fine.volumes.max() <= coarse.volumes.max() / 10.0
    np.testing.assert_allclose(coarse.turns, [0.0, 7.5, 15.0])


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
