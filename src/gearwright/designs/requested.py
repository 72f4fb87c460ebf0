"""What a request asks to be built: the design, its element, and the density."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import Problem, ProblemsError
from ..materials import DENSITY, material
from .built import Built, built_from
from .design import Design, design_of
from .kinds import article


@dataclass(frozen=True, kw_only=True)
class Requested:
    """A design that can be built. kilograms   density in kg/m³, None where none is given"""

    design: Design
    element: Any
    kilograms: float | None

    def built(self) -> Built:
        """What it is made of."""
        return built_from(self.design.kind, self.element, self.kilograms)


def requested(request: Mapping[str, Any], more: list[Problem] | None = None) -> Requested:
    """What "design" with "density" (kg/m³) or "material" (a name) asks for.

    more   what is wrong with the request besides

    Raises ProblemsError with all that is wrong.
    """
    design = design_of(request["design"])
    element, problems = design.element()
    kilograms, others = density_given(request)
    found = [*problems, *others, *(more or [])]
    if found or element is None:
        kind = design.kind
        raise ProblemsError(f"{article(kind.name).capitalize()} {kind.name} cannot be built so", found)
    return Requested(design=design, element=element, kilograms=kilograms)


def density_given(request: Mapping[str, Any]) -> tuple[float | None, list[Problem]]:
    """The density in kg/m³, None where none is given, and what is wrong with it."""
    density, name = request.get("density"), request.get("material")
    if density is not None and name is not None:
        return None, [Problem(f"material = {name!r}", "give either a material or a density, not both")]
    if name is not None:
        try:
            return material(name).density, []
        except ProblemsError as error:
            return None, list(error.problems)
    if density is not None and (problem := DENSITY.problem(density)):
        return None, [Problem(f"density = {density!r} kg/m³", problem)]
    return density, []
