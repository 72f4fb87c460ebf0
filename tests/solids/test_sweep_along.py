"""Sweeps along paths: closed forms, flux, polyhedra's limits, frames, closed paths; what cannot be swept is refused."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import gearwright as gw
from gearwright.solids.solid import flux_moments

from ..laws.topology import components, edges_pair_up, fans_at_vertices, genus

TURN = 2.0 * np.pi
FRAMES = ("rotation-minimising", "frenet", "fixed-up")
WIRE = gw.Section.rectangle(1.0, 0.8)
BLADE = gw.Section.polygon(
    [(-0.4, -0.2), (0.9, -0.3), (0.5, 0.6), (-0.3, 0.4)], holes=[[(0.0, 0.0), (0.3, 0.0), (0.1, 0.2)]]
)


def knot(u):
    """A trefoil."""
    k = TURN * np.asarray(u)
    return np.stack(
        [(4 + 2 * np.cos(3 * k)) * np.cos(2 * k), (4 + 2 * np.cos(3 * k)) * np.sin(2 * k), 2 * np.sin(3 * k)], -1
    )


def breathing(s):
    """Comes back onto itself, with a twist of a whole turn."""
    size, angle = 1.0 + 0.3 * np.sin(TURN * s), TURN * s
    c, s = np.cos(angle), np.sin(angle)
    return [[size * c, -s, 0.1 * s], [size * s, c, 0.0], [0.0, 0.0, 1.0]]


SOLIDS = {
    "spring": lambda: gw.sweep_along(WIRE, gw.helix(5.0, 3.0, 3.0)),
    "spring, Frenet": lambda: gw.sweep_along(WIRE, gw.helix(5.0, 3.0, 3.0), frame="frenet"),
    "spring, fixed-up, left": lambda: gw.sweep_along(BLADE, gw.helix(5.0, 3.0, 2.2, "left"), frame="fixed-up"),
    "knot": lambda: gw.sweep_along(BLADE, knot),
    "knot through points": lambda: gw.sweep_along(BLADE, knot(np.linspace(0.0, 1.0, 49))),
    "knot, breathing": lambda: gw.sweep_along(BLADE, knot, transform=breathing),
    "bend": lambda: gw.sweep_along(BLADE, [(0, 0, 0), (8, 1, 3), (15, 7, 1), (18, 16, 5)]),
    "bend, transformed": lambda: gw.sweep_along(
        BLADE, [(0, 0, 0), (8, 1, 3), (15, 7, 1)], transform=lambda s: [[1 - 0.4 * s, 0.2 * s], [-0.1 * s, 1 + 0.3 * s]]
    ),
    "ring": lambda: gw.sweep_along(BLADE, gw.helix(5.0, 0.0)),
}
every_solid = pytest.mark.parametrize("name", SOLIDS)
CLOSED = {"knot", "knot through points", "knot, breathing", "ring"}


def close(found, expected, relative):
    size = np.cbrt(expected.volume)
    scale = np.linalg.norm(expected.central_second)
    assert found.volume == pytest.approx(expected.volume, rel=relative)
    np.testing.assert_allclose(found.centroid, expected.centroid, atol=relative * size)
    np.testing.assert_allclose(found.central_second, expected.central_second, atol=relative * scale)


@every_solid
def test_moments_are_those_of_the_flux_through_the_boundary(name):
    solid = SOLIDS[name]()
    close(solid.moments, flux_moments(solid.boundary), 1e-12)
    assert solid.moments.method == "exact"
    assert 0.0 < solid.moments.error_bound < 1e-12
    assert solid.moments.evaluations > 0


@every_solid
def test_moments_are_the_limit_of_polyhedra(name):
    """Errors stay below tolerance × area / volume, and fall with the tolerance."""
    solid = SOLIDS[name]()
    exact = solid.properties()
    tolerances = (4e-3, 1e-3, 2.5e-4)
    found = [solid.polyhedron(tolerance).properties() for tolerance in tolerances]
    for quantity in ("volume", "central_second"):
        truth = np.asarray(getattr(exact, quantity))
        errors = [np.linalg.norm(getattr(one, quantity) - truth) / np.linalg.norm(truth) for one in found]
        assert np.all(np.array(errors) < np.array(tolerances) * exact.area / exact.volume)
        assert errors[2] < 0.3 * errors[0]


@every_solid
def test_polyhedra_are_watertight_manifolds(name):
    polyhedron = SOLIDS[name]().polyhedron(1e-2)
    triangles = np.asarray(polyhedron.faces)
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    pieces = 2 if (name in CLOSED and "knot" in name) or name == "ring" else 1  # a closed hole is a shell of its own
    hollow = not name.startswith("spring") or "left" in name
    assert components(triangles) == (pieces if hollow else 1)
    if name not in CLOSED:
        assert genus(triangles) == (1 if hollow else 0)
    assert polyhedron.validity().valid
    assert not polyhedron.self_intersections()


def test_a_torus_by_revolution_and_along_a_circle():
    volume = 2.0 * np.pi**2 * 5.0 * 1.3**2
    around = volume * (25.0 + 0.75 * 1.69)
    for torus in (
        gw.revolve(gw.Section.circle(1.3, (5.0, 0.0))),
        gw.sweep_along(gw.Section.circle(1.3), gw.helix(5.0, 0.0)),
        gw.sweep_along(
            gw.Section.circle(1.3), lambda u: np.stack([5 * np.cos(TURN * u), 0 * u, 5 * np.sin(TURN * u)], -1)
        ),
    ):
        found = torus.properties()
        assert found.volume == pytest.approx(166.796314, abs=5e-7)
        assert found.principal_moments[2] == pytest.approx(4381.322188, abs=5e-7)
        assert found.volume == pytest.approx(volume, rel=1e-13)
        assert found.principal_moments[2] == pytest.approx(around, rel=1e-13)
        np.testing.assert_allclose(found.centroid, 0.0, atol=1e-13)


@pytest.mark.parametrize("frame", FRAMES)
def test_a_section_centred_on_the_path_sweeps_its_area_times_the_length(frame):
    """Pappus, which holds for any frame and any path."""
    path = gw.helix(5.0, 3.0, 2.5)
    solid = gw.sweep_along(gw.Section.circle(0.7), path, frame=frame)
    assert solid.properties().volume == pytest.approx(np.pi * 0.49 * path.length, rel=1e-13)


def test_off_the_path_towards_the_centre_the_section_sweeps_less():
    """In the Frenet frame x points to the centre: the length is shortened by x times the curvature."""
    path = gw.helix(5.0, 3.0, 1.0)
    rise = 3.0 / TURN
    curvature = 5.0 / (25.0 + rise**2)
    for x in (0.6, -0.6):
        volume = gw.sweep_along(gw.Section.rectangle(0.5, 0.4, (x, 0.1)), path, frame="frenet").properties().volume
        assert volume == pytest.approx(0.2 * path.length * (1.0 - curvature * x), rel=1e-12)


def test_along_a_straight_path_it_is_the_extrusion():
    along = gw.sweep_along(
        BLADE, [(0, 0, 0), (0, 0, 4)], transform=lambda s: [[1 + s, 0, 0.3 * s], [0, 1 - 0.5 * s, 0]]
    )
    extruded = gw.extrude(BLADE, 4.0, scale=(2.0, 0.5), skew=(0.3, 0.0))
    found, expected = along.properties(), extruded.properties()
    # section y is towards +x, so that section x is towards −y: a turn by 90° about z
    turned = expected.moved([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    assert found.volume == pytest.approx(expected.volume, rel=1e-13)
    np.testing.assert_allclose(found.centroid, turned.centroid, atol=1e-13)
    np.testing.assert_allclose(found.central_second, turned.central_second, atol=1e-12)


def test_a_closed_path_closes():
    for name in CLOSED:
        solid = SOLIDS[name]()
        assert solid.boundary.caps == ()
    assert len(SOLIDS["bend"]().boundary.caps) == 2


@pytest.mark.parametrize("radius", [1.9, 2.0])
def test_a_section_that_reaches_the_centre_of_curvature_is_refused(radius):
    with pytest.raises(gw.GeometryError) as caught:
        gw.sweep_along(gw.Section.circle(2.0), gw.helix(radius, 0.0))
    for words in (
        "section point [2.0, 0.0] at path parameter",
        f"radius of curvature is {radius:g} there",
        "reaches 2 towards",
        "a radius greater than 2 would do",
    ):
        assert words in str(caught.value)


def test_a_little_wider_it_is_built():
    path = gw.helix(2.1, 0.0)
    solid = gw.sweep_along(gw.Section.circle(2.0), path)
    assert solid.properties().volume == pytest.approx(4.0 * np.pi * path.length, rel=1e-12)
    assert gw.sweep_along(gw.Section.circle(2.0), gw.helix(2.0 + 1e-6, 0.0))


def test_a_bend_too_tight_is_refused_where_it_is():
    with pytest.raises(gw.GeometryError) as caught:
        gw.sweep_along(gw.Section.circle(1.1), lambda u: np.stack([10 * u, 50 * (u - 0.5) ** 2, 0 * u], -1))
    text = str(caught.value)
    assert "at path parameter 0.5, [5.0, 1.1, 0.0] in space" in text
    # the radius of the parabola y = x²/2 is (1 + x²)^(3/2), and is 1.1 at x = √(1.1^(2/3) − 1) = 0.2561
    assert "from path parameter 0.474387 to path parameter 0.525613" in text


def test_only_the_side_towards_the_centre_counts():
    """A section that reaches 3 away from the centre, and 1 towards it, goes round a radius of 1.2."""
    section = gw.Section.rectangle(4.0, 0.5, (-1.0, 0.0))
    assert gw.sweep_along(section, gw.helix(1.2, 0.0), frame="frenet")
    with pytest.raises(gw.GeometryError, match="a radius greater than 3 would do"):
        gw.sweep_along(gw.Section.rectangle(4.0, 0.5, (1.0, 0.0)), gw.helix(1.2, 0.0), frame="frenet")


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (
            lambda: gw.sweep_along(WIRE, gw.helix(5.0, 1.0), "bishop"),
            "choose one of rotation-minimising, frenet, fixed-up",
        ),
        (lambda: gw.sweep_along(WIRE, []), "at least two points"),
        (lambda: gw.sweep_along(WIRE, [(0, 0, 0), (float("nan"), 0, 0)]), "point 1"),
        (
            lambda: gw.sweep_along(WIRE, knot, transform=lambda s: [[1 + s, 0], [0, 1]]),
            "must come back to where it began",
        ),
        (
            lambda: gw.sweep_along(WIRE, [(0, 0, 0), (9, 0, 0)], transform=lambda s: [[1 - 2 * s, 0], [0, 1]]),
            "determinant",
        ),
        (lambda: gw.sweep_along(WIRE, [(0, 0, 0), (9, 0, 0)], transform=lambda s: [[1, 0, 0]]), "f1, g1, h1"),
        (
            lambda: gw.sweep_along(WIRE, [(0, 0, 0), (9, 0, 0)], transform=lambda s: [[1 + (s > 0.5), 0], [0, 1]]),
            "jumps",
        ),
    ],
)
def test_what_cannot_be_swept_is_refused(build, words):
    with pytest.raises(gw.GearwrightError, match=words):
        build()


def test_a_sweep_that_hits_itself_is_found_on_request():
    """Locally valid, but the second winding runs through the first."""
    solid = gw.sweep_along(gw.Section.circle(1.0), gw.helix(5.0, 1.0, 2.0))
    assert solid.polyhedron(0.05).self_intersections()
    assert not gw.sweep_along(gw.Section.circle(1.0), gw.helix(5.0, 2.5, 2.0)).self_intersections(0.05)


def test_chords_keep_the_tolerance_in_a_bend_that_is_short():
    """Points all over the triangles of a tube lie as far from the path as its radius."""
    bend = [(0, 0, 0), (30, 0, 0), (58, 0.3, 0), (62, 2.5, 0), (62, 5.5, 0), (58, 7.7, 0), (30, 8, 0), (0, 8, 0)]
    solid = gw.sweep_along(gw.Section.circle(1.0), bend)
    path = solid.motion.frame.path
    u = np.linspace(0.0, 1.0, 40_001)
    along = cKDTree(path.point(u))
    tolerance = 0.02
    polyhedron = solid.polyhedron(tolerance)
    corners = polyhedron.vertices[np.asarray(polyhedron.faces)]
    middles = np.concatenate([corners.mean(axis=1), *((corners + np.roll(corners, 1, axis=1)).swapaxes(0, 1) / 2.0)])
    distance, nearest = along.query(middles)
    inside = (nearest > 0) & (nearest < len(u) - 1)  # the ends are flat
    assert np.max(np.abs(distance[inside] - 1.0)) <= tolerance
    assert np.max(np.abs(distance[inside] - 1.0)) > 0.3 * tolerance


def test_the_bounding_box_of_a_spring_holds_all_its_windings():
    """They reach almost equally far, and the wire's corners turn from one to the next."""
    for solid in (
        SOLIDS["spring"](),
        gw.sweep_along(gw.Section.rectangle(1.0, 1.0, (1.0, 0.0)), gw.helix(5.0, 3.0, 12.0)),
    ):
        box = solid.properties().bounding_box
        u = np.linspace(0.0, 1.0, 60_001)
        corners = [solid.motion.place(np.broadcast_to(c.start, (len(u), 2)), u) for c in solid.section.loops[0].curves]
        cloud = np.concatenate(corners)
        np.testing.assert_allclose(box, [cloud.min(axis=0), cloud.max(axis=0)], atol=2e-6)
