"""Things named by where they are, so that listing them loads none."""

from __future__ import annotations

from importlib import import_module
from typing import Any

Source = str
"""Where a thing is loaded from: "package.module:name"."""


def load(source: Source) -> Any:
    """What a source names, imported now."""
    module, name = source.split(":")
    return getattr(import_module(module), name)
