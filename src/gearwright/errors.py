"""What goes wrong, said once: one base class, and problems that are reported all together."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


class GearwrightError(Exception):
    """Anything Gearwright refuses or cannot do. The message says what, why, and the way out."""


@dataclass(frozen=True)
class Problem:
    """One thing wrong with an input.

    subject   what is wrong, as the user wrote it, such as "face_width = 90 mm"
    message   what is accepted, what it means, the usual cause, the way out
    """

    subject: str
    message: str

    def __str__(self) -> str:
        return f"{self.subject}: {self.message}"


class ProblemsError(GearwrightError, ValueError):
    """An input with one or more problems, all named together."""

    def __init__(self, headline: str, problems: Iterable[Problem]):
        self.headline = headline
        self.problems = tuple(problems)
        super().__init__("\n".join([f"{headline}:", *(f"  {problem}" for problem in self.problems)]))


class ParameterError(ProblemsError):
    """Parameters from which an element cannot be built."""

    def __init__(self, element: str, problems: Iterable[Problem]):
        self.element = element
        super().__init__(f"{element} cannot be built from these parameters", problems)


class GeometryError(ProblemsError):
    """A section, boundary or polyhedron that does not bound a solid."""


class FileError(GearwrightError):
    """A file that cannot be read or written as asked: exit code 2."""


class MachineError(GearwrightError):
    """The machine's fault, not the input's (disk, permissions, a missing extra): exit code 3."""
