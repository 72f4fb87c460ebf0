"""Sizes that standards lay down."""
