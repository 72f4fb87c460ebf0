"""Densities as the command line takes them: a number in kg/m³, or a material's name."""

from __future__ import annotations

from ..errors import ParameterError, Problem
from ..materials import material

DENSITY_HELP = "Density ρ in kg/m³; mass is then in kg. Without it, density is 1 per cubed length unit."
MATERIAL_HELP = "Density of a material; `gearwright materials` lists them."


def kilograms(density: float | None, name: str | None) -> float | None:
    """Density in kg/m³, given as such or by the name of a material; None where neither is given."""
    return material(name).density if name is not None else density


def material_problems(name: str | None) -> list[Problem]:
    """What is wrong with the name of a material."""
    try:
        kilograms(None, name)
    except ParameterError as error:
        return [Problem(f"--material {name}", problem.message) for problem in error.problems]
    return []
