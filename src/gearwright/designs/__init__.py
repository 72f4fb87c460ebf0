"""Designs: elements of the catalog as named values, and what is built from them. Every edge uses it."""
