"""Moments: pure functions on arrays, from polygons, boundaries, polyhedra and sweeps."""
