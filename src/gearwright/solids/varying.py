"""Whether a section that varies along a motion is a section everywhere on the way."""

from __future__ import annotations

from ..errors import Problem
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.members import first_unsound, looks
from ..sections.section import LoopedSection


def varying_problems(section: LoopedSection, motion: Motion, ends: Ends) -> list[Problem]:
    """What keeps a section that varies from being swept so; empty where nothing does.

    Layered motions carry it through surfaces that never meet (planes, spheres, cones), so that the body is sound where
    every member is, as their volume element is positive wherever a section may be. Other motions would have to be
    tried against every member's own reach, and are refused. Members are looked at on both ends, where what varies turns
    back, and between.
    """
    if not motion.layered:
        return [
            Problem(
                "the section varies along the motion",
                f"only straight and helical extrusions, other parallel sweeps and radial ones"
                f" take such a section, not {type(motion).__name__}; sweep one of its members, section.at(v)",
            )
        ]
    found = first_unsound(section, looks(section, ends.start, ends.finish))
    if found is None:
        return []
    where, problems = found
    return [Problem(f"at {motion.station(where)}, {problem.subject}", problem.message) for problem in problems]
