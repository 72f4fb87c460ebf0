"""Every part's STEP file, as Open CASCADE reads it: one valid closed solid, its properties and faces the exact ones."""

from functools import cache

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.ShapeAnalysis import ShapeAnalysis_ShapeTolerance

from gearwright.boundary.nearness import Skin
from gearwright.parameters import MILLIMETRES
from gearwright.solids.saving import SMOOTH_TOLERANCE

from ..examples import built, every_part, size
from ..files import occt

KERNEL = 1e-7
"""Relative: what Open CASCADE's plain Gauss rule resolves of splines of degree 7."""

FACES = 24  # of splines, of which points are measured


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("step")


@cache
def written(part, folder):
    path = folder / f"{part}.step".replace("/", "-")
    built(part).save(path)
    return path


@cache
def read(part, folder):
    return occt.read(written(part, folder))


def tolerance_of(part):
    return built(part).smooth_tolerance or SMOOTH_TOLERANCE * size(part)


@every_part
def test_it_is_one_valid_closed_solid(part, folder):
    shape = read(part, folder)
    (solid,) = occt.solids(shape)
    assert occt.is_valid(shape)
    for edge, count in occt.edge_uses(solid):
        assert count == (1 if BRep_Tool.Degenerated_s(edge) else 2)


@every_part
def test_edges_are_no_farther_from_faces_than_was_asked(part, folder):
    # what joins faces is a tolerance of theirs; Open CASCADE's own for points is 1e-7 of whatever unit
    unit = MILLIMETRES[built(part).length_unit]
    worst = ShapeAnalysis_ShapeTolerance().Tolerance(read(part, folder), 1)
    assert worst <= max(1.0001e-7 * unit, 2.0 * tolerance_of(part) * unit)


@every_part
def test_volume_centroid_and_inertia_are_the_exact_ones(part, folder):
    unit = MILLIMETRES[built(part).length_unit]
    exact = built(part).properties()
    volume, centroid, inertia = occt.properties(read(part, folder))
    assert volume == pytest.approx(exact.volume * unit**3, rel=KERNEL)
    assert np.allclose(centroid, exact.centroid * unit, rtol=0.0, atol=KERNEL * size(part) * unit)
    largest = np.abs(exact.central_inertia).max() * unit**5
    assert np.allclose(inertia, exact.central_inertia * unit**5, rtol=0.0, atol=KERNEL * largest)


@every_part
def test_splines_are_within_the_tolerance_of_the_exact_faces(part, folder):
    unit = MILLIMETRES[built(part).length_unit]
    points = occt.free_points(read(part, folder), FACES, np.random.default_rng(7)) / unit
    if len(points):
        off = Skin.of(built(part).boundary).signed_distance(points, 1e-4 * size(part))
        assert np.abs(off).max() <= tolerance_of(part)
