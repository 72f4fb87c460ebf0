"""Gears on parallel axes: external, internal and racks, and pairs of them."""
