"""`gearwright schema`: what a design file may hold, as JSON Schema."""

from __future__ import annotations

import json
import sys
from typing import Annotated

from cyclopts import Parameter as Option

from ..designs.kinds import commands
from ..designs.schema import design_schema
from ..errors import Problem, ProblemsError
from ..parameters import did_you_mean
from .exits import DONE

ONE = Option(metavar="ELEMENT", help="One element's name; all of them if not given.")


def schema(
    element: Annotated[str | None, ONE] = None,
    /,
) -> int:
    """Print the JSON Schema of design files, which `gearwright build` reads.

    It says which keys there are, their types, limits, units and defaults; what goes together only building finds out.
    """
    known = commands()
    if element is not None and element not in known:
        hint = did_you_mean(element, known)
        problem = Problem(f"ELEMENT = {element!r}", f"choose one of {', '.join(known)}{hint}")
        raise ProblemsError("There is no such element", [problem])
    document = design_schema(known if element is None else [element])
    sys.stdout.write(json.dumps(document, indent=2, ensure_ascii=True) + "\n")
    return DONE
