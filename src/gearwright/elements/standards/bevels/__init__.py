"""Sizing systems of bevel gears, and the sizes that follow from them."""
