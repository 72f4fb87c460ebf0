"""Bodies to draw."""

import numpy as np


def sphere(radius=1.0, rings=48, middle=(0.0, 0.0, 0.0)):
    polar = np.linspace(0.0, np.pi, rings + 1)[:, None]
    turn = np.linspace(0.0, 2.0 * np.pi, 2 * rings, endpoint=False)
    points = np.stack(
        [np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar) * np.ones_like(turn)], axis=-1
    )
    return radius * points.reshape(-1, 3) + np.asarray(middle), grid(rings, 2 * rings)


def grid(rows, columns):
    row, column = (index.ravel() for index in np.indices((rows, columns)))
    here, there = row * columns + column, row * columns + (column + 1) % columns
    below, across = here + columns, there + columns
    return np.concatenate([np.stack([here, below, across], -1), np.stack([here, across, there], -1)])


def cube(side=1.0, middle=(0.0, 0.0, 0.0)):
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return side * corners + np.asarray(middle), np.array([t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))])


def cone(apex, base, radius, sides=64, rings=8):
    """A cone without a base and without its very tip, from its apex towards the middle of the base."""
    axis = np.subtract(base, apex) / np.linalg.norm(np.subtract(base, apex))
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across = across / np.linalg.norm(across)
    turn = np.linspace(0.0, 2.0 * np.pi, sides, endpoint=False)[:, None]
    rim = np.asarray(base) + radius * (np.cos(turn) * across + np.sin(turn) * np.cross(axis, across))
    share = np.linspace(0.2, 1.0, rings + 1)[:, None, None]
    return (np.asarray(apex) + share * (rim - apex)).reshape(-1, 3), grid(rings, sides)


def crown():
    """Teeth that face -z, narrow end at z = 2, and a dome behind them of much more surface, towards +z."""
    radius, height, depth = np.array(
        [(1.0, 2.4, 0), (1.9, 2, 0.2), (3, 3, 0.3), (2.8, 3.6, 0), (2.2, 4.2, 0), (1.5, 4.6, 0), (0.5, 4.8, 0)]
    ).T[:, :, None]
    turn = np.linspace(0.0, 2.0 * np.pi, 160, endpoint=False)
    widths = radius + depth * np.sign(np.sin(20.0 * turn + 0.1))
    points = np.stack([widths * np.cos(turn), widths * np.sin(turn), height * np.ones_like(turn)], axis=-1)
    return points.reshape(-1, 3), grid(6, 160)
