"""Sections: closed loops of curves in the plane or on the unit sphere, the outer loop first."""
