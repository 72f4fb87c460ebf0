"""Tooth traces of bevel gears, each in a file of its own."""
