"""The page of a view: the scene as JSON and the viewer's script in one HTML document that loads nothing."""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import cache
from html import escape
from pathlib import Path

import numpy as np

from ..arrays import Array
from ..colours import STEEL
from ..files.assembly import Assembly, Faceted, Part, placed_vertices
from ..pictures.camera import View
from .surface import surface
from .turning import Turning

SCRIPT = Path(__file__).parents[1] / "web_assets" / "viewer.js"
"""Built from web/ by `make web`; wheels hold it."""

_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; \
style-src 'unsafe-inline'; img-src data: blob:">
<link rel="icon" href="data:,">
<title>{title}</title>
</head>
<body>
{body}
</body>
</html>
"""

_TURNING = """<script type="application/json" id="gearwright-scene">{scene}</script>
<script>{script}</script>"""


def built() -> bool:
    """Whether the viewer's script is there."""
    return SCRIPT.is_file()


def page(title: str, body: str) -> str:
    """A whole HTML document that may load nothing, around a body."""
    return _PAGE.format(title=escape(title), body=body)


def turning_page(title: str, assembly: Assembly[Faceted], turnings: Sequence[Turning], view: View) -> str:
    """A whole HTML document in which the parts of an assembly turn."""
    scene = scene_of(title, assembly, turnings, view)
    text = json.dumps(scene, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return page(title, _TURNING.format(scene=text, script=_script(SCRIPT.stat().st_mtime_ns)))


@cache
def _script(_: int) -> str:
    """The viewer's script, read once a build, so that no text in it ends the element that it stands in."""
    return SCRIPT.read_text(encoding="utf-8").replace("</script", "<\\/script").replace("<!--", "<\\!--")


def scene_of(title: str, assembly: Assembly[Faceted], turnings: Sequence[Turning], view: View) -> dict[str, object]:
    """The scene as web/src/viewer/data.ts describes it."""
    turns = [one.most(np.ptp(part.shape.vertices, axis=0)) for part, one in zip(assembly.parts, turnings, strict=True)]
    return {
        "title": title,
        "unit": assembly.length_unit or "units",
        "direction": view.direction,
        "up": view.up,
        "turns": min(turns) if any(one.spin or any(one.slide) for one in turnings) else None,
        "bodies": [_body(part, one) for part, one in zip(assembly.parts, turnings, strict=True)],
    }


def _body(part: Part[Faceted], turning: Turning) -> dict[str, object]:
    triangles = part.shape.simple_triangles()
    placed: Array = placed_vertices(part)[np.unique(triangles)]
    return {
        "name": part.name,
        "colour": part.colour or STEEL,
        **surface(part.shape.vertices, triangles).encoded(),
        "least": placed.min(axis=0).tolist(),
        "most": placed.max(axis=0).tolist(),
        "place": part.placement.reshape(-1).tolist(),
        "spin": turning.spin,
        "slide": turning.slide,
    }
