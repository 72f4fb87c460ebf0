"""Pairs running: transmission error, lines of contact, overlap through a cycle."""
