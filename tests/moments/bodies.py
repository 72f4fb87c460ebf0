"""Bodies to measure, and their exact moments by another route: rational arithmetic, tetrahedra from the origin."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from gearwright.moments.faces import corner_lists


def prism(corners, height, hole=None):
    """A prism of polygon faces over corners (n, 2) counter-clockwise; the walls are quads, the ends n-gons.

    With a hole (n, 2), also counter-clockwise, the ends are quads between the two loops.
    """
    n = len(corners)
    loops = [corners] if hole is None else [corners, hole]
    vertices = np.concatenate([np.column_stack([p, np.full(n, z)]) for p in loops for z in (0.0, height)])
    following = [(i + 1) % n for i in range(n)]
    faces = [[i, j, n + j, n + i] for i, j in enumerate(following)]
    if hole is None:
        return vertices, [list(range(n))[::-1], list(range(n, 2 * n)), *faces]
    faces += [[2 * n + j, 2 * n + i, 3 * n + i, 3 * n + j] for i, j in enumerate(following)]
    faces += [[n + i, n + j, 3 * n + j, 3 * n + i] for i, j in enumerate(following)]
    faces += [[j, i, 2 * n + i, 2 * n + j] for i, j in enumerate(following)]
    return vertices, faces


def gear_like(n=24, hole=False):
    angle = np.arange(n) * 2 * np.pi / n
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    radius = np.where(np.arange(n) % 2, 1.0, 0.8)[:, None]
    return prism(circle * radius, 0.5, 0.3 * circle if hole else None)


def cube(side=1.0):
    return prism(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]) * side, side)


def star_shaped(rings=9, around=14, seed=1):
    """A triangulated ball whose radius varies at random."""
    random = np.random.default_rng(seed)
    theta, phi = np.linspace(0, np.pi, rings + 2)[1:-1], np.arange(around) * 2 * np.pi / around
    grid = np.stack(
        [
            np.outer(np.sin(theta), np.cos(phi)),
            np.outer(np.sin(theta), np.sin(phi)),
            np.outer(np.cos(theta), phi * 0 + 1),
        ],
        axis=-1,
    ).reshape(-1, 3)
    vertices = np.concatenate([grid, [[0, 0, 1.0], [0, 0, -1.0]]])
    vertices *= random.uniform(0.4, 1.0, (len(vertices), 1))
    top, bottom = len(grid), len(grid) + 1
    faces = []
    for j in range(around):
        k = (j + 1) % around
        faces += [[top, j, k], [bottom, (rings - 1) * around + k, (rings - 1) * around + j]]
        for i in range(0, (rings - 1) * around, around):
            faces += [[i + j, i + around + j, i + around + k], [i + j, i + around + k, i + k]]
    return vertices, faces


def joined(first, second):
    (v1, f1), (v2, f2) = first, second
    return np.concatenate([v1, v2]), [*f1, *([i + len(v1) for i in face] for face in f2)]


def reversed_faces(body):
    return body[0], [face[::-1] for face in body[1]]


def moved(body, offset, scale=1.0):
    return body[0] * scale + offset, body[1]


def nested_cubes():
    """Vertices, indices and offsets of a cube with a void, and the numbers of their shells."""
    vertices, faces = joined(cube(2.0), moved(reversed_faces(cube()), 0.5))
    return vertices, *corner_lists(faces), np.repeat([0, 1], 6)


def exact_moments(vertices, faces):
    """Volume, centroid and central second moment as fractions."""
    points = [[Fraction(float(x)) for x in vertex] for vertex in vertices]
    volume, first = Fraction(0), [Fraction(0)] * 3
    second = [[Fraction(0)] * 3 for _ in range(3)]
    for face in faces:
        for k in range(1, len(face) - 1):
            a, b, c = points[face[0]], points[face[k]], points[face[k + 1]]
            det = (
                a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
            )
            volume += det / 6
            for i in range(3):
                first[i] += det * (a[i] + b[i] + c[i]) / 24
                for j in range(3):
                    # ∫ λ_p λ_q over the tetrahedron: 2 V 3!/5! on the diagonal, half of it off it
                    pairs = sum(p[i] * q[j] * (2 if p is q else 1) for p in (a, b, c) for q in (a, b, c))
                    second[i][j] += det * pairs / 120
    centroid = [value / volume for value in first]
    central = [[second[i][j] - first[i] * centroid[j] for j in range(3)] for i in range(3)]
    return volume, centroid, central


def relative_errors(body, volume, centroid, central):
    """Errors of V, of the centroid (by the largest coordinate) and of the central tensor (by its largest entry)."""
    exact_volume, exact_centroid, exact_central = exact_moments(*body)
    size = max(float(np.abs(body[0]).max()), 1e-300)
    largest = max(abs(x) for row in exact_central for x in row)
    return (
        abs(float((Fraction(float(volume)) - exact_volume) / exact_volume)),
        max(abs(float(Fraction(float(x)) - y)) for x, y in zip(centroid, exact_centroid, strict=True)) / size,
        max(
            abs(float((Fraction(float(central[i][j])) - exact_central[i][j]) / largest))
            for i in range(3)
            for j in range(3)
        ),
    )
