"""Polyhedra of any number of triangles."""

from __future__ import annotations

import numpy as np


def torus(around, across, large=2.0, small=1.0):
    """Vertices (n, 3) and triangles (2n, 3) of a torus about z."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    ring = large + small * np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), small * np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    return vertices, np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
