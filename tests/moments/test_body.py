"""Bodies about their centroids, and how far their errors grow on the way there."""

import numpy as np
import pytest

from gearwright.moments.body import BodyMoments, about_centroid


def box(centre, sides):
    """Moment matrix about the origin of a box by Gauss points, exact for second moments."""
    x = np.array([-1.0, 1.0]) / np.sqrt(3.0)
    grid = np.stack(np.meshgrid(x, x, x), axis=-1).reshape(-1, 3) * np.array(sides) / 2.0 + np.array(centre)
    h = np.column_stack([np.ones(8), grid])
    return h.T @ h * np.prod(sides) / 8.0


def test_a_body_is_centred_on_itself():
    body = about_centroid(box((3.0, -1.0, 2.0), (1.0, 2.0, 4.0)), "exact", 1e-16)
    np.testing.assert_allclose(body.origin, [3.0, -1.0, 2.0], rtol=1e-15)
    np.testing.assert_allclose(body.centroid, [3.0, -1.0, 2.0], rtol=1e-15)
    np.testing.assert_allclose(body.matrix[0, 1:], 0.0, atol=1e-14)
    np.testing.assert_allclose(body.central_second, 8.0 / 12.0 * np.diag([1.0, 4.0, 16.0]), atol=1e-13)
    assert body.volume == pytest.approx(8.0)
    assert body.method == "exact"


def test_the_matrix_may_be_about_another_point():
    body = about_centroid(box((0.5, 0.0, 0.25), (1.0, 2.0, 4.0)), "quadrature", 1e-16, np.array([10.0, 20.0, 30.0]))
    np.testing.assert_allclose(body.centroid, [10.5, 20.0, 30.25], rtol=1e-15)
    np.testing.assert_allclose(body.central_second, 8.0 / 12.0 * np.diag([1.0, 4.0, 16.0]), atol=1e-14)


def test_a_residue_of_the_origin_is_taken_off():
    body = BodyMoments(
        origin=np.array([1.0, 1.0, 1.0]),
        matrix=box((0.1, 0.2, 0.3), (1.0, 2.0, 4.0)),
        method="exact",
        error_bound=1e-16,
    )
    np.testing.assert_allclose(body.centroid, [1.1, 1.2, 1.3], rtol=1e-15)
    np.testing.assert_allclose(body.central_second, 8.0 / 12.0 * np.diag([1.0, 4.0, 16.0]), atol=1e-14)


def error_and_bound(distance, signs, error):
    """Relative error of the central second moment and its bound, where the matrix is off by `error` an entry."""
    central = box((0.0, 0.0, 0.0), (1.0, 2.0, 4.0))[1:, 1:]
    disturbed = box((distance, 0.0, 0.0), (1.0, 2.0, 4.0)) * (1.0 + error * np.array(signs))
    body = about_centroid(disturbed, "exact", error)
    return np.linalg.norm(body.central_second - central) / np.linalg.norm(central), body.error_bound


@pytest.mark.parametrize("distance", [0.0, 1.0, 1e2, 1e3])
@pytest.mark.parametrize("error", [1e-14, 1e-10])
def test_the_error_bound_grows_as_much_as_the_shift_cancels(distance, error):
    actual, bound = error_and_bound(distance, np.diag([0, 1, -1, 1]), error)
    assert actual <= 1.001 * bound + 1e-15 * (1.0 + distance**2)
    assert max(error, 0.05 * distance**2 * error) <= bound <= 4.0 * error * (1.0 + distance**2)


@pytest.mark.parametrize("distance", [1e1, 1e2, 1e3])
def test_the_error_bound_counts_the_errors_of_volume_and_first_moment(distance):
    signs = np.diag([1, 1, 1, 1])
    signs[0, 1] = signs[1, 0] = -1
    actual, bound = error_and_bound(distance, signs, 1e-10)
    assert actual <= 1.001 * bound
