"""Module and helix of a gear, as its parameters give them."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ...parameters import MILLIMETRES, Problems
from .. import refusals
from ..element import module_in


@dataclass(frozen=True, kw_only=True)
class Helix:
    """Parameters of an element by their names; those that straight teeth do not have are left at their defaults."""

    length_unit: str
    module: float | None
    diametral_pitch: float | None
    transverse_module: float | None = None
    helix_angle: float | None = 0.0
    hand: str = "right"

    @classmethod
    def of(cls, element: object) -> Helix:
        """The module and helix of an element that declares parameters of these names."""
        return cls(
            **{field.name: getattr(element, field.name) for field in fields(cls) if hasattr(element, field.name)}
        )

    @property
    def angle(self) -> float:
        """β, radians."""
        return float(np.radians(self.helix_angle or 0.0))

    @property
    def sense(self) -> int:
        """+1 for a right-hand helix, −1 for a left-hand one."""
        return 1 if self.hand == "right" else -1

    @property
    def normal_module(self) -> float:
        """m_n in the length unit: m_n = m_t cos β."""
        if self.transverse_module is None:
            return module_in(self.length_unit, self.module, self.diametral_pitch)
        return float(self.transverse_module / MILLIMETRES[self.length_unit] * np.cos(self.angle))


HELIX_NUMBERS = tuple(field.name for field in fields(Helix))
"""Names of those parameters."""


def require_one_module(problems: Problems, element: object) -> None:
    """Adds a problem unless the module of an element is given in exactly one way."""
    helix = Helix.of(element)
    given = sum(one is not None for one in (helix.module, helix.diametral_pitch, helix.transverse_module))
    if given != 1:
        problems.add("module", refusals.ONE_MODULE if hasattr(element, "transverse_module") else refusals.ONE_PITCH)
