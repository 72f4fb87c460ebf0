"""Whether the polyhedra of a bevel pair keep out of each other through a tooth cycle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from ..errors import GeometryError, MachineError, Problem
from ..solids.polyhedron import Polyhedron
from .mesh import Member, mesh_of

_FINE = 1e-4  # of the cone distance: the chord tolerance where none is given
_GRID = 97  # points along and up a flank whose area is measured


@dataclass(frozen=True, kw_only=True)
class CycleOverlap:
    """What two polyhedra share at turns of one pitch.

    turns       (n,) of the pinion, degrees
    volumes     (n,) shared, length cubed
    tolerance   chord tolerance of the polyhedra, length
    flank_area  of both flanks of a tooth of the pinion, length squared
    """

    turns: Array
    volumes: Array
    tolerance: float
    flank_area: float

    @property
    def bound(self) -> float:
        """Volume that chords alone can make them share: tolerance × flank area."""
        return self.tolerance * self.flank_area

    @property
    def keeps_apart(self) -> bool:
        """Whether no overlap exceeds the bound."""
        return bool(self.volumes.max() <= self.bound)


def overlap_through_cycle(pair: BevelPair, *, tolerance: float | None = None, turns: int = 4) -> CycleOverlap:
    """The volume that both members share when placed at so many turns of one pitch, by polyhedra to a tolerance.

    Without backlash conjugate flanks touch, and chords of concave ones protrude: what is shared then falls with the
    tolerance, and stays below tolerance × flank area. Booleans are those of manifold3d, none of ours.
    Raises GeometryError for no turns or a tolerance that is none, MachineError without the extra `mesh`.
    """
    chord = _FINE * pair.pinion.cone_distance if tolerance is None else tolerance
    _require(chord, turns)
    angles = np.arange(turns) / turns * 360.0 / pair.pinion.teeth
    bodies = [member.polyhedron(chord) for member in (pair.pinion, pair.gear)]
    volumes = [
        (_body(bodies[0], pinion) ^ _body(bodies[1], gear)).volume()
        for pinion, gear in (pair.placements(float(angle)) for angle in angles)
    ]
    return CycleOverlap(
        turns=angles, volumes=np.array(volumes), tolerance=chord, flank_area=flank_area(mesh_of(pair).pinion)
    )


def flank_area(member: Member) -> float:
    """Of both flanks of a tooth, from form to tip, by small quadrangles: good to 1e-4 of it."""
    level = np.broadcast_to(np.linspace(member.inner, member.outer, _GRID)[:, None], (_GRID, _GRID))
    form, face = member.flank.form_angle(level), member.flank.face_angle(level)
    polar = form + (face - form) * np.linspace(0.0, 1.0, _GRID)
    polar[:, -1] = face[:, -1]
    points = member.flank_points(level, polar, 1.0)
    diagonals = points[1:, 1:] - points[:-1, :-1], points[1:, :-1] - points[:-1, 1:]
    return float(np.linalg.norm(np.cross(*diagonals), axis=-1).sum())  # half a flank's quadrangles, twice


def _body(polyhedron: Polyhedron, placement: Array) -> Any:
    try:
        import manifold3d
    except ImportError:
        raise MachineError(
            "volumes shared by polyhedra need manifold3d; install it with pip install 'gearwright[mesh]'"
        ) from None
    points = np.asarray(polyhedron.vertices) @ placement[:3, :3].T + placement[:3, 3]
    return manifold3d.Manifold(manifold3d.Mesh64(points, np.asarray(polyhedron.faces).astype(np.uint64)))


def _require(tolerance: float, turns: int) -> None:
    problems = []
    if not (np.isfinite(tolerance) and tolerance > 0.0):
        problems.append(Problem(f"tolerance = {tolerance:g}", "a chord distance greater than 0, in the pair's unit"))
    if turns < 1:
        problems.append(Problem(f"turns = {turns}", "at least 1"))
    if problems:
        raise GeometryError("The overlap cannot be measured", problems)
