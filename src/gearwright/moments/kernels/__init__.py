"""Compiled loops over the faces of polyhedra."""
