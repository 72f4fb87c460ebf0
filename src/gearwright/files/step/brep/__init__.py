"""Boundaries as Open CASCADE's solids: faces on elementary surfaces or splines that share their edges and vertices."""
