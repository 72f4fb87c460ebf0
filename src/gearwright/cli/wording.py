"""What elements say, in the words of the command line: options for parameters."""

from __future__ import annotations

import re
from collections.abc import Iterable

from .. import catalog
from ..designs.kinds import option_name
from ..errors import Problem
from ..parameters import declarations


def in_options(problems: Iterable[Problem], kinds: Iterable[catalog.Element]) -> list[Problem]:
    """Problems that name options where the elements name parameters: "--face-width = 90 mm"."""
    names = {d.name for kind in kinds for d in declarations(catalog.load(kind.source))}
    return [Problem(_subject(problem.subject, names), text_in_options(problem.message, names)) for problem in problems]


def text_in_options(text: str, names: Iterable[str]) -> str:
    """A text with options for those names that are no words of prose: they hold an underscore."""
    known = "|".join(re.escape(name) for name in names if "_" in name)
    return re.sub(rf"\b({known})\b", lambda found: option_name(found[1]), text) if known else text


def _subject(subject: str, names: Iterable[str]) -> str:
    known = "|".join(map(re.escape, names))
    return re.sub(rf"^((?:pinion |gear )?)({known})\b", lambda found: found[1] + option_name(found[2]), subject)
