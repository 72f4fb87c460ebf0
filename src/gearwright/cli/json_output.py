"""Documents as JSON on stdout."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from typing import Any

from ..designs.document import plain


def json_line(document: Mapping[str, Any], indent: int | None = None) -> str:
    """JSON text; arrays as lists, what is not finite as null, Greek letters escaped where stdout has none."""
    has_greek = (sys.stdout.encoding or "").lower().replace("-", "") == "utf8"
    return json.dumps(plain(document), indent=indent, ensure_ascii=not has_greek, allow_nan=False)
