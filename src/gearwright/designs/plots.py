"""Charts of designs: which there are of a kind of element, and the one that is asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from .. import catalog
from ..errors import Problem, ProblemsError
from ..parameters import did_you_mean
from .design import Design, design_of
from .kinds import article


def plots_of(kind: catalog.Element) -> list[dict[str, str]]:
    """[{"name": …, "title": …}] of the charts that there are of a kind of element; loads none of them."""
    return [{"name": plot.name, "title": plot.title} for plot in kind.plots]


def plot(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Yields the chart {"title", "x", "y", "equal", "lines", "log", "notes"} that {"design", "plot"} asks for.

    Raises ProblemsError where the design cannot be built or has no such chart, and what the chart raises.
    """
    from .requested import requested

    found = _chosen(design_of(request["design"]), request.get("plot"))
    yield catalog.load(found.source)(requested(request).element).to_dict()


def _chosen(design: Design, name: object) -> catalog.Plot:
    for one in design.kind.plots:
        if one.name == name:
            return one
    known = [one.name for one in design.kind.plots]
    problem = Problem(f"plot = {name!r}", f"one of {', '.join(known)} is needed{did_you_mean(name, known)}")
    raise ProblemsError(f"There is no such chart of {article(design.kind.name)} {design.kind.name}", [problem])
