"""Boundaries: edges, patches and caps, their triangulation and the flux through them; no notion of a gear."""
