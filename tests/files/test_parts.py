"""Bodies of a file hold the faces that are theirs, each with the vertices it uses and no others."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.files.parts import apart, used_alone
from gearwright.moments.faces import Corners, corner_lists


def by_hand(points, faces):
    """The vertices that faces use, in their order, and the faces by these numbers."""
    used = sorted({k for face in faces for k in face})
    return [points[k] for k in used], [[used.index(k) for k in face] for face in faces]


def lists(faces: Corners):
    return [faces.indices[a:b].tolist() for a, b in zip(faces.offsets[:-1], faces.offsets[1:], strict=True)]


polygons = st.lists(st.lists(st.integers(0, 8), min_size=3, max_size=5), min_size=1, max_size=8)


@settings(max_examples=150, deadline=None)
@given(polygons, st.integers(1, 4), st.randoms(use_true_random=False))
def test_apart_and_used_alone(faces, count, chance):
    points = [[k, k * k, -k] for k in range(9)]
    table = np.array(points, float)
    own, corners = used_alone(table, Corners(*corner_lists(faces)))
    assert (own.tolist(), lists(corners)) == by_hand(points, faces)
    count = min(count, len(faces))
    owners = [*range(count), *(chance.randrange(count) for _ in faces[count:])]
    chance.shuffle(owners)
    bodies = apart(table, Corners(*corner_lists(faces)), np.array(owners), count)
    assert len(bodies) == count
    for k, (own, corners) in enumerate(bodies):
        mine = [face for face, owner in zip(faces, owners, strict=True) if owner == k]
        assert (own.tolist(), lists(corners)) == by_hand(points, mine)
