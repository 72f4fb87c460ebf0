"""Surfaces on which end faces lie: their charts, and the flux through a region bounded by loops."""
