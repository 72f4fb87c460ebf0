"""Sizing systems and inspection sizes of standards."""
