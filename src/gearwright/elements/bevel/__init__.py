"""Bevel gears and pairs on intersecting axes."""
