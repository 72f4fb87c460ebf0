"""Sound polyhedra of many kinds, for tests that break them."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from ..moments.bodies import cube, gear_like, joined, moved, reversed_faces, star_shaped


@st.composite
def sound_bodies(draw):
    """Vertices and faces: up to three bodies side by side, some with a void and a body in it; turned and moved."""
    result = None
    for place in range(draw(st.integers(1, 3))):
        body = draw(st.sampled_from([cube(2.0), gear_like(12), gear_like(8, hole=True), star_shaped(4, 7)]))
        if len(body[1]) == 6 and draw(st.booleans()):
            body = joined(body, moved(reversed_faces(cube()), 0.5))
            if draw(st.booleans()):
                body = joined(body, moved(star_shaped(3, 5), 1.0, 0.4))
        body = moved(body, [4.0 * place, 0, 0])
        result = body if result is None else joined(result, body)
    vertices, faces = result
    turn, _ = np.linalg.qr(np.random.default_rng(draw(st.integers(0, 99))).normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    scale, shift = draw(st.sampled_from([1e-3, 1.0, 1e4])), draw(st.sampled_from([0.0, 10.0, -1e3]))
    return (vertices @ turn.T + shift) * scale, [list(map(int, face)) for face in faces]


def shell_of(faces, chosen):
    """Numbers of the faces that hang together with a face, over vertices."""
    inside, grown = {chosen}, True
    while grown:
        vertices = {v for f in inside for v in faces[f]}
        more = {f for f, face in enumerate(faces) if vertices & set(face)}
        grown, inside = more != inside, more
    return sorted(inside)
