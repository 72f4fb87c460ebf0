"""The command line: text and options in, tables, JSON and files out."""

from .app import main

__all__ = ["main"]
