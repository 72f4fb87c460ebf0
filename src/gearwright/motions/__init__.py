"""Motions: how a section moves to make a solid, and between which ends."""
