import numpy as np
import pytest

from gearwright.pictures.renderer import CREASE_LINE, SILHOUETTE, collect, ink, rasterise


def drawn(points, triangles, size=100):
    depth = np.full((size, size), -np.inf, np.float32)
    owner = np.full((size, size), -1, np.int32)
    rasterise(np.asarray(points, float), np.asarray(triangles, dtype=np.int64), depth, owner, 0, size)
    return depth, owner


TWO = np.array([[10, 10, 0], [90, 10, 0], [50, 90, 0], [10, 50, 5], [90, 50, 5], [50, -20, 5]], float)


@pytest.mark.parametrize("order", [[[0, 1, 2], [3, 4, 5]], [[3, 4, 5], [0, 1, 2]]])
def test_the_nearer_triangle_hides_the_farther_one_whichever_comes_first(order):
    depth, owner = drawn(TWO, order)
    nearer = order.index([3, 4, 5])
    assert owner[30, 50] == nearer
    assert depth[30, 50] == 5.0
    assert owner[70, 50] == 1 - nearer
    assert owner[95, 5] == -1


def test_of_two_crossing_triangles_each_hides_the_other_on_its_side():
    points = np.array([[0, 0, -10], [100, 0, 10], [100, 100, 10], [0, 100, -10], [0, 0, 0], [100, 0, 0], [100, 100, 0]])
    _, owner = drawn(points, [[0, 1, 2], [4, 5, 6]])
    assert owner[10, 40] == 1
    assert owner[10, 60] == 0


def test_a_triangle_covers_as_many_pixels_as_its_area():
    rng = np.random.default_rng(7)
    areas, counts = [], []
    for corners in rng.uniform(0.0, 400.0, (40, 3, 2)):
        _, owner = drawn(np.column_stack([corners, np.zeros(3)]), [[0, 1, 2]], size=400)
        (ax, ay), (bx, by) = corners[1] - corners[0], corners[2] - corners[0]
        areas.append(abs(ax * by - ay * bx) / 2.0)
        counts.append(int((owner == 0).sum()))
    assert np.max(np.abs(np.subtract(areas, counts))) < 60.0  # a pixel here and there along 1000 pixels of border
    assert abs(sum(areas) - sum(counts)) < 100.0


def test_triangles_that_share_edges_leave_no_gap_and_no_overlap():
    rng = np.random.default_rng(3)
    turn = np.sort(rng.uniform(0.0, 2.0 * np.pi, 300))
    points = np.column_stack([50.0 + 49.0 * np.cos(turn), 50.0 + 49.0 * np.sin(turn), np.zeros(300)])
    points = np.vstack([points, [50.123, 50.456, 0.0]])
    fan = np.column_stack([np.arange(300), np.roll(np.arange(300), -1), np.full(300, 300)])
    covered = sum((drawn(points, [triangle])[1] >= 0).astype(int) for triangle in fan)
    assert covered[20:80, 20:80].min() == 1
    assert covered.max() == 1


def test_edges_through_pixel_centres_belong_to_one_side_only():
    x, y = np.meshgrid([10.5, 40.5, 70.5], [10.5, 40.5, 70.5])
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(9)])
    squares = [(0, 1, 3, 4), (1, 2, 4, 5), (3, 4, 6, 7), (4, 5, 7, 8)]
    triangles = [t for a, b, c, d in squares for t in ((a, b, d), (a, d, c))]
    covered = sum((drawn(points, [triangle])[1] >= 0).astype(int) for triangle in triangles)
    assert covered.max() == 1
    assert covered.sum() == 60 * 60


def test_depth_is_that_of_the_plane():
    points = np.array([[0, 0, 0], [100, 0, 30], [0, 100, -20]], float)
    depth, owner = drawn(points, [[0, 1, 2]])
    rows, columns = np.nonzero(owner == 0)
    assert depth[rows, columns] == pytest.approx(0.3 * (columns + 0.5) - 0.2 * (rows + 0.5), abs=1e-4)


@pytest.mark.parametrize(
    "corners",
    [
        [[5, 5, 0]] * 3,
        [[0, 0, 0], [50, 50, 0], [100, 100, 0]],
        [[np.nan, 0, 0], [50, 50, 0], [0, 100, 0]],
        [[np.inf, 0, 0], [50, 50, 0], [0, 100, 0]],
        [[-300, -300, 0], [-200, -300, 0], [-200, -200, 0]],
    ],
)
def test_degenerate_and_distant_triangles_draw_nothing(corners):
    assert (drawn(corners, [[0, 1, 2]])[1] == -1).all()


def test_a_triangle_larger_than_the_picture_fills_it():
    corners = [[-1e6, -1e6, 0], [1e6, -1e6, 0], [0, 1e7, 0]]
    assert (drawn(corners, [[0, 1, 2]])[1] == 0).all()


def roof(rise):
    """Two squares that meet along the column x = 50, the ridge higher by so much."""
    points = np.array([[x, y, rise if x == 50 else 0] for x in (0, 50, 100) for y in (0, 100)], float)
    triangles = np.array([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])
    slope = rise / 50.0
    normals = np.array([[-slope, 0, 1], [-slope, 0, 1], [slope, 0, 1], [slope, 0, 1]])
    normals = np.repeat(normals[:, None] / np.sqrt(1.0 + slope**2), 3, axis=1)
    return points, triangles, normals, np.zeros(4, np.int64)


@pytest.mark.parametrize(("rise", "kind"), [(0.0, 0), (2.0, 0), (25.0, CREASE_LINE)])
def test_a_line_is_drawn_where_faces_meet_at_an_angle(rise, kind):
    points, triangles, normals, members = roof(rise)
    depth, owner = drawn(points, triangles)
    marks = ink(points, triangles, normals, members, depth, owner, 0, 100)
    assert (marks[20:80, 49:51] == kind).all()
    assert (marks[20:80, 10:45] == 0).all()


def test_a_line_is_drawn_where_a_surface_hides_another_or_ends():
    points = np.array([[0, 0, 0], [0, 90, 0], [90, 0, 0], [0, 0, 30], [0, 45, 30], [45, 0, 30]], float)
    triangles = np.array([[0, 1, 2], [3, 4, 5]])
    normals = np.broadcast_to([0.0, 0.0, 1.0], (2, 3, 3)).copy()
    depth, owner = drawn(points, triangles)
    marks = ink(points, triangles, normals, np.zeros(2, np.int64), depth, owner, 0, 100)
    assert marks[5, 40] == SILHOUETTE
    assert marks[5, 85] == SILHOUETTE
    assert marks[5, 60] == 0
    upper, lower = (
        ink(points, triangles, normals, np.zeros(2, np.int64), depth, owner, *rows) for rows in ((0, 37), (37, 100))
    )
    assert np.array_equal(np.vstack([upper, lower]), marks)  # bands meet without a seam


def test_samples_share_out_each_pixel():
    points, triangles, normals, members = roof(25.0)
    depth, owner = drawn(points, triangles, 102)
    values, places = collect(points, triangles, normals, members, depth, owner, 3, 0, 34)
    shares = np.zeros((34, 34))
    np.add.at(shares, (places[:, 0], places[:, 1]), values[:, 6])
    assert shares == pytest.approx((owner >= 0).reshape(34, 3, 34, 3).mean(axis=(1, 3)))
    ridge = places[(places[:, 1] == 16) & (places[:, 0] == 10)]
    assert len(ridge) == 2  # both faces in one pixel
    assert np.linalg.norm(values[:, 3:6], axis=-1) == pytest.approx(1.0)
