"""What keeps the faces of a polyhedron from bounding a solid: found, named, and placed."""
