"""What helical teeth add to the parameters of straight ones."""

from __future__ import annotations

import numpy as np

from ...parameters import MILLIMETRES, Problems
from .. import refusals
from ..element import module_in

HELIX_NUMBERS = ("transverse_module", "helix_angle", "hand")
"""Names of those parameters."""


def require_one_module(
    problems: Problems, module: float | None, diametral_pitch: float | None, transverse_module: float | None
) -> None:
    """Adds a problem unless exactly one of the three is given."""
    if sum(given is not None for given in (module, diametral_pitch, transverse_module)) != 1:
        problems.add("module", refusals.ONE_MODULE)


def normal_module(
    length_unit: str,
    module: float | None,
    diametral_pitch: float | None,
    transverse_module: float | None,
    helix: float,
) -> float:
    """m_n in the length unit: m_n = m_t cos β, for a helix angle β in radians."""
    if transverse_module is None:
        return module_in(length_unit, module, diametral_pitch)
    return float(transverse_module / MILLIMETRES[length_unit] * np.cos(helix))
