"""What a page draws of a part is its boundary: closed, outward, within the tolerance, sharp edges and no others."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.nearness import Skin
from gearwright.boundary.sampling import sampling
from gearwright.viewer.frame import DrawnBody, frame
from gearwright.viewer.shells import shells

from ..examples import PARTS, built, every_part, size
from ..viewer.frames import read

TOLERANCE = 1e-3  # of the diagonal


def message(part, known=()):
    boundary = built(part).boundary
    drawn = shells(boundary, sampling(boundary, TOLERANCE * size(part)))
    body = DrawnBody(name="part", called="part", colour=(0.5, 0.5, 0.5), shells=drawn, placement=np.eye(4))
    return frame({"answer": "mesh"}, [body], known)


def expanded(part):
    """Corners (t, 3, 3) of all triangles and the normals drawn at them, and the ends (e, 2, 3) of all edges."""
    return drawn_by(message(part))


def drawn_by(sent):
    _, bodies = read(sent)
    corners, normals, edges = [], [], []
    for shell in bodies["part"]:
        places, directions = shell.images(shell.positions), shell.images(shell.normals, 0.0)
        corners.append(places[:, shell.triangles].reshape(-1, 3, 3))
        normals.append(directions[:, shell.triangles].reshape(-1, 3, 3))
        edges.append(places[:, shell.edges].reshape(-1, 2, 3))
    return np.concatenate(corners), np.concatenate(normals), np.concatenate(edges)


@every_part
def test_triangles_are_closed_outward_and_of_the_volume(part):
    corners, normals, _ = expanded(part)
    exact = built(part).properties()
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2.0
    total = np.linalg.norm(areas, axis=1).sum()
    assert np.linalg.norm(areas.sum(axis=0)) < 1e-5 * total  # as whole as 2²¹ steps are
    volume = np.sum(corners.mean(axis=1) * areas) / 3.0
    assert abs(volume - exact.volume) < 1.01 * TOLERANCE * size(part) * total
    # normals are those of the surface, which a triangle's own only resembles
    agreeing = np.einsum("tij,tj->ti", normals, areas)
    share = np.linalg.norm(areas, axis=1)[:, None] * np.ones(3)
    assert share[agreeing < 0.7 * share].sum() < 0.02 * share.sum()


def test_a_bore_that_reaches_beyond_the_line_between_roots_is_open():
    gear = gw.SpurGear(teeth=8, module=4, face_width=10, bore=20.8)
    drawn = shells(gear.boundary, sampling(gear.boundary, 0.01))
    assert gear.root_radius * np.cos(np.pi / 8) < 10.4
    body = DrawnBody(name="part", called="part", colour=(0.5, 0.5, 0.5), shells=drawn, placement=np.eye(4))
    corners, _, _ = drawn_by(frame({}, [body]))
    flat = np.abs(corners[:, :, 2] - 10.0).max(axis=1) < 1e-4
    areas = np.cross(corners[flat, 1] - corners[flat, 0], corners[flat, 2] - corners[flat, 0])[:, 2] / 2.0
    assert areas.min() > 0
    assert areas.sum() == pytest.approx(gear.properties().volume / 10, rel=2e-3)
    assert np.linalg.norm(corners[flat].mean(axis=1)[:, :2], axis=1).min() > 10.3


@pytest.mark.parametrize("part", PARTS[::3], ids=str)
def test_points_lie_on_the_boundary_and_triangles_within_the_tolerance(part):
    corners, _, edges = expanded(part)
    rng = np.random.default_rng(7)
    some = corners[rng.integers(0, len(corners), 60)]
    skin, sag = Skin.of(built(part).boundary), TOLERANCE * size(part)
    points = np.concatenate([some[:, 0], edges[rng.integers(0, len(edges), 20), 0]] if len(edges) else [some[:, 0]])
    assert np.abs(skin.signed_distance(points, sag)).max() < 3e-6 * size(part)
    assert np.abs(skin.signed_distance(some.mean(axis=1), sag)).max() < 1.3 * TOLERANCE * size(part)


@pytest.mark.parametrize("part", PARTS[::7], ids=str)
def test_what_the_page_knows_is_not_sent_again(part):
    header, bodies = read(message(part))
    keys = [shell.entry["key"] for shell in bodies["part"]]
    again, same = read(message(part, keys))
    assert all(shell.triangles is None and shell.edges is None for shell in same["part"])
    for one, other in zip(bodies["part"], same["part"], strict=True):
        assert np.array_equal(one.positions, other.positions)
    vertices = sum(shell.entry["vertices"] for shell in same["part"])
    assert again["bytes"] <= 12 * vertices
    assert again["triangles"] == header["triangles"]


def test_sharp_edges_are_drawn_and_smooth_ones_are_not():
    spur = next(part for part in PARTS if part.element == "spur gear" and part.example == "fillets")
    _, _, edges = expanded(spur)
    gear = built(spur)
    lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
    along = np.abs(edges[:, 1, 2] - edges[:, 0, 2]) > 0.5 * lengths
    # the corners of the tips run along the axis, two a tooth; where flank, fillet and root join they are tangent
    assert lengths[along].sum() == pytest.approx(2 * gear.teeth * gear.face_width, rel=1e-5)
