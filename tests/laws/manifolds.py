"""Polyhedra as bodies of manifold3d, whose booleans are none of ours."""

import manifold3d
import numpy as np


def manifold(polyhedron, placement=None):
    """The body that a polyhedron of triangles bounds, put in place by a 4×4."""
    points = np.array(polyhedron.vertices)
    if placement is not None:
        points = points @ placement[:3, :3].T + placement[:3, 3]
    body = manifold3d.Manifold(manifold3d.Mesh64(points, np.asarray(polyhedron.faces).astype(np.uint64)))
    assert body.status() == manifold3d.Error.NoError
    return body
