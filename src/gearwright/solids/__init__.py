"""Solids: swept, composite and polyhedral, with their properties."""
