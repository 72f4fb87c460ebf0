"""Whether a section that varies along a motion is a section everywhere on the way."""

from __future__ import annotations

from ..errors import Problem
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.members import first_unsound, looks
from ..sections.plane import Section
from ..sections.section import LoopedSection


def varying_problems(section: LoopedSection, motion: Motion, ends: Ends) -> list[Problem]:
    """What keeps a section that varies from being swept so; empty where nothing does.

    Parallel motions carry it through planes that never meet, so that the body is sound where every member is and the
    volume element, which is the same all over a plane, is positive. Other motions would have to be tried against every
    member's own reach, and are refused. Members are looked at on both ends, where what varies turns back, and between.
    """
    constants = ends.constants
    if constants is None or not motion.parallel or not isinstance(section, Section):
        return [
            Problem(
                "the section varies along the motion",
                f"only straight and helical extrusions and other parallel sweeps between constant heights take such a"
                f" section, not {type(motion).__name__}; sweep one of its members, section.at(v)",
            )
        ]
    found = first_unsound(section, looks(section, *constants))
    if found is None:
        return []
    where, problems = found
    return [Problem(f"at {motion.station(where)}, {problem.subject}", problem.message) for problem in problems]
