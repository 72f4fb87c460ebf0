"""Several measured files as one."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from ..errors import Problem, ProblemsError
from ..solids.extent import Extent
from .measuring import Measured


class Sum:
    """Adds up files that are measured one after another, keeping none of them."""

    def __init__(self) -> None:
        self._total: Measured | None = None
        self._problems: list[Problem] = []

    def take(self, found: Measured) -> None:
        """Adds a file, whose bodies must not overlap the others'."""
        if self._total is None:
            self._total = replace(found, file=None, bodies={}, remarks=())
        elif found.units != self._total.units:
            units, first = found.units, self._total.units
            said = f"{units.length} and {units.mass}, not {first.length} and {first.mass} like the first file"
            self._problems.append(Problem(str(found.file), f"it is in {said}"))
        else:
            parts = self._total.together, found.together
            # found now, so that no chain of all the files is kept; the files lie apart, so that areas add
            extent = parts[0].extent.joined(parts[1].extent)._replace(area=_added(parts[0].area, parts[1].area))
            together = replace(parts[0] + parts[1], find_extent=partial(Extent, *extent))
            self._total = replace(self._total, together=together)

    def total(self) -> Measured | None:
        """All files together, None where there was none. Raises ProblemsError where their units differ."""
        if self._problems:
            raise ProblemsError("These files have no sum", self._problems[:10])
        return self._total


def _added(one: float | None, other: float | None) -> float | None:
    return None if one is None or other is None else one + other
