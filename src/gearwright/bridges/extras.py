"""Libraries that are there only where an extra was installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from ..errors import MachineError


def required(module: str, library: str, extra: str) -> Any:
    """A module of a library that an extra brings. Raises MachineError, saying how to install it."""
    try:
        return import_module(module)
    except ImportError as error:
        raise MachineError(
            f"{library} is not installed ({error}); it comes with: pip install 'gearwright[{extra}]'"
        ) from error
