"""Sweeps by any transform: against the closed forms, by tolerance, with kinks; what is no transform is refused."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.motions.ends import between
from gearwright.motions.transform import polynomial_transform
from gearwright.motions.transforming import Transforming
from gearwright.solids.solid import flux_moments
from gearwright.solids.swept import Swept

SECTION = gw.Section.polygon([(0.3, 0.0), (4.0, 0.2), (3.6, 3.0), (0.1, 2.5)], holes=[[(1, 1), (2, 1.1), (1.8, 2)]])


def turned(angle, sx=1.0, sy=1.0, hx=0.0, hy=0.0):
    c, s = np.cos(angle), np.sin(angle)
    return [[c * sx, -s * sy, hx], [s * sx, c * sy, hy], [0.0, 0.0, 1.0]]


def test_it_is_the_extrusion_where_that_has_a_closed_form():
    free = gw.sweep(SECTION, lambda z: turned(0.2 * z, 1 - 0.1 * z, 1 + 0.05 * z, 0.3 * z, -0.2 * z), 5.0)
    closed = gw.extrude(SECTION, 5.0, twist=np.degrees(1.0), scale=(0.5, 1.25), skew=(1.5, -1.0))
    found, expected = free.properties(), closed.properties()
    assert found.volume == pytest.approx(expected.volume, rel=1e-13)
    np.testing.assert_allclose(found.centroid, expected.centroid, atol=1e-13)
    np.testing.assert_allclose(found.central_second, expected.central_second, atol=1e-12)
    assert found.error_bound <= 1e-12
    assert found.evaluations >= 32
    assert closed.properties().evaluations == 0


def test_a_trumpet_of_exponential_bore():
    """A disc whose radius grows as e^(z/2): V = π r² ∫ e^z dz, by hand."""
    solid = gw.sweep(gw.Section.circle(2.0), lambda z: np.exp(z / 2.0) * np.eye(2), 3.0)
    assert solid.properties().volume == pytest.approx(4.0 * np.pi * np.expm1(3.0), rel=1e-13)
    flux = flux_moments(solid.boundary)
    np.testing.assert_allclose(solid.properties().central_second, flux.central_second, rtol=1e-11, atol=1e-9)


def test_along_a_plane_curve_the_volume_stays():
    """[5.13]: shifted, each slice is as large as before; Cavalieri."""
    solid = gw.sweep(SECTION, lambda z: [[1, 0, np.sin(3 * z)], [0, 1, z**2]], 2.0)
    assert solid.properties().volume == pytest.approx(2.0 * SECTION.properties().area, rel=1e-13)
    mean = [(1 - np.cos(6.0)) / 6.0, 4.0 / 3.0]
    np.testing.assert_allclose(solid.properties().centroid[:2], SECTION.properties().centroid + mean, rtol=1e-12)


def test_a_coarser_tolerance_needs_fewer_evaluations_and_says_so():
    def rippled(z):
        return turned(0.0, 1.0 + 0.3 * np.sin(40.0 * z), 1.0)

    fine, coarse = (gw.sweep(SECTION, rippled, 3.0, tolerance=t) for t in (1e-13, 1e-4))
    assert coarse.moments.evaluations < fine.moments.evaluations
    assert fine.moments.error_bound < 1e-12
    assert coarse.moments.error_bound > fine.moments.error_bound
    assert coarse.moments.error_bound - fine.moments.error_bound > coarse.motion.transform.series.error
    miss = abs(coarse.moments.volume / fine.moments.volume - 1.0)
    assert miss < 1e-4


def test_kinks_become_edges():
    solid = gw.sweep(gw.Section.rectangle(1.0, 1.0), lambda z: [[1.0 + abs(z - 2.0), 0.0], [0.0, 1.0]], 5.0)
    assert solid.motion.breaks(solid.ends) == pytest.approx((2.0,), abs=1e-9)
    assert solid.properties().volume == pytest.approx(5.0 + 2.0 + 4.5, rel=1e-10)
    polyhedron = solid.polyhedron(1e-3)
    assert np.min(np.abs(polyhedron.vertices[:, 2] - 2.0)) < 1e-9
    assert polyhedron.properties().volume == pytest.approx(11.5, rel=1e-9)  # ruled: exact


def test_polynomials_by_their_coefficients():
    transform = polynomial_transform({"f1": [1.0, 0.5], "g2": [1.0, 0.0, -0.1], "h1": [0.0, 0.0, 0.3]}, 2.0)
    given = Swept(section=SECTION, motion=Transforming(transform=transform), ends=between(0.0, 2.0))
    called = gw.sweep(SECTION, lambda z: [[1 + 0.5 * z, 0, 0.3 * z**2], [0, 1 - 0.1 * z**2, 0]], 2.0)
    np.testing.assert_allclose(given.moments.matrix, called.moments.matrix, rtol=1e-12, atol=1e-11)
    for xi in (0.0, 0.7, 2.0):
        np.testing.assert_allclose(transform.linear(xi), [[1 + 0.5 * xi, 0], [0, 1 - 0.1 * xi**2]], atol=1e-15)
        np.testing.assert_allclose(transform.offset_rate(xi), [0.6 * xi, 0.0], atol=1e-15)


def test_symmetry_is_seen():
    """Even growth and turns keep a gear's symmetry, so that its boundary is a pattern; anything else does not."""
    assert gw.sweep(SECTION, turned, 1.0).motion.rotation_order == 0
    assert gw.sweep(SECTION, lambda z: turned(0.0, 1.0 + z), 1.0).motion.rotation_order == 2
    assert gw.sweep(SECTION, lambda z: turned(0.0, hx=0.1), 1.0).motion.rotation_order == 1


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (
            lambda: gw.sweep(SECTION, lambda z: turned(0.0, 1 - z / 4), 5.0),
            "is -0.25 .* from height 4 to height 5",
        ),
        (lambda: gw.sweep(SECTION, lambda z: turned(0.0, -1.0), 5.0), "must stay greater than 0"),
        (lambda: gw.sweep(SECTION, lambda z: 1.0, 5.0), r"\[\[f1, g1, h1\], \[f2, g2, h2\], \[0, 0, 1\]\] is needed"),
        (lambda: gw.sweep(SECTION, lambda z: np.diag([1, 1, 2]), 5.0), "is needed"),
        (lambda: gw.sweep(SECTION, lambda z: 1 / 0, 5.0), "ZeroDivisionError"),
        (lambda: gw.sweep(SECTION, lambda z: turned(np.sqrt(z - 1.0) if z >= 1 else np.nan), 5.0), "not finite"),
        (lambda: gw.sweep(SECTION, lambda z: turned(0.0, 1.0 + (z > 2.0)), 5.0), "near 2: it jumps"),
        (lambda: gw.sweep(SECTION, "twist", 5.0), "a function of ξ is needed"),
        (lambda: gw.sweep(SECTION, lambda z: np.eye(3), -5.0), "length = -5.0"),
        (lambda: gw.sweep(SECTION, lambda z: np.eye(3), 5.0, tolerance=1e-20), "between 1e-14 and 0.001"),
        (lambda: polynomial_transform({"k": [1.0], "f1": ["a"]}, 1.0), "k = .*no such function(.|\n)*f1 = "),
        (lambda: polynomial_transform({"f1": []}, 1.0), "lowest power first"),
    ],
)
def test_what_is_no_transform_is_refused(build, words):
    with pytest.raises(gw.GearwrightError, match=words):
        build()


def test_sections_that_cross_themselves_are_not_swept():
    eight = [(0.0, 0.0), (4.0, 3.0), (4.0, 0.0), (0.0, 2.0)]
    from gearwright.curves.line import Line
    from gearwright.sections.loop import Loop

    lines = [Line(first=a, last=b) for a, b in zip(eight, [*eight[1:], eight[0]], strict=True)]
    loop = Loop(curves=tuple(lines))
    try:
        section = gw.Section(loops=(loop,))
    except gw.GeometryError:
        section = gw.Section(loops=(Loop(curves=tuple(line.reversed() for line in lines[::-1])),))
    for build in (
        lambda: gw.extrude(section, 1.0),
        lambda: gw.revolve(section),
        lambda: gw.sweep(section, lambda z: np.eye(2), 1.0),
        lambda: gw.sweep_along(section, [(0, 0, 0), (9, 0, 0)]),
    ):
        with pytest.raises(gw.GeometryError, match=r"crosses itself .* there"):
            build()


@pytest.mark.parametrize("c", [1e-300, 1e-310, 5e-322, 5e-324])
def test_an_offset_next_to_nothing_is_none(c):
    """Numbers that small hold only a few digits, which no series can follow."""
    solid = gw.sweep(gw.Section.rectangle(2, 1), lambda z: [[1, 0, c * z**2], [0, 1, np.sin(c * z)], [0, 0, 1]], 1.0)
    assert solid.properties().volume == pytest.approx(2.0, rel=1e-14)
