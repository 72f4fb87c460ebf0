"""Quaternions and turns against rotations built in other ways."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gearwright.rotations import quaternion_of, roll_pitch_yaw, rotation_of

numbers = st.floats(-1, 1).map(lambda value: round(value, 6))
quaternions = st.tuples(numbers, numbers, numbers, numbers).filter(lambda q: np.linalg.norm(q) > 1e-3)


@given(quaternions)
def test_a_quaternion_turns_as_an_independent_library_says(given):
    w, x, y, z = given
    turned = Rotation.from_quat([x, y, z, w]).as_matrix()
    np.testing.assert_allclose(rotation_of(given), turned, atol=4e-16 * 4)
    found = quaternion_of(turned)
    assert found[0] >= 0.0
    assert np.linalg.norm(found) == pytest.approx(1, abs=1e-15)
    np.testing.assert_allclose(rotation_of(found), turned, atol=4e-15)


@given(quaternions)
def test_turns_about_fixed_axes_make_the_rotation(given):
    turned = rotation_of(given)
    roll, pitch, yaw = roll_pitch_yaw(turned)
    about = [
        Rotation.from_rotvec(angle * axis).as_matrix()
        for angle, axis in zip((roll, pitch, yaw), np.eye(3), strict=True)
    ]
    # near ±90° roll and yaw are as good as the small components that they are made of, rounded as all of them are
    tolerance = 2e-14 + 2e-15 / max(abs(np.cos(pitch)), 1e-7)
    np.testing.assert_allclose(about[2] @ about[1] @ about[0], turned, atol=tolerance)


@pytest.mark.parametrize(
    ("axes", "angles"),
    [
        (np.eye(3), (0, 0, 0)),
        ([[1, 0, 0], [0, 0, -1], [0, 1, 0]], (np.pi / 2, 0, 0)),
        ([[0, -1, 0], [1, 0, 0], [0, 0, 1]], (0, 0, np.pi / 2)),
        ([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], (0, np.pi / 2, 0)),
        ([[0, -1, 0], [0, 0, 1], [-1, 0, 0]], (0, np.pi / 2, np.pi / 2)),
    ],
)
def test_quarter_turns_by_hand(axes, angles):
    np.testing.assert_allclose(roll_pitch_yaw(axes), angles, atol=1e-15)


def test_half_turns_have_a_settled_sign():
    np.testing.assert_array_equal(quaternion_of(np.diag([-1.0, -1.0, 1.0])), [0, 0, 0, 1])
    np.testing.assert_array_equal(quaternion_of(np.diag([-1.0, 1.0, -1.0])), [0, 0, 1, 0])
