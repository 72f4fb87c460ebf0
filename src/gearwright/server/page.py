"""The page's own files, and what stands in for them where they were not built."""

from __future__ import annotations

import hashlib
from pathlib import Path

from starlette.requests import Request
from starlette.responses import Response

FOLDER = Path(__file__).parents[1] / "web_assets" / "page"
"""Built from web/ by `make web`; wheels hold it."""

NOT_BUILT = "the page is not built here: run `make web` in a checkout (Node 20.19 or newer), or install a wheel"
_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".woff2": "font/woff2",
    ".json": "application/json",
    ".txt": "text/plain; charset=utf-8",
}
_STAND_IN = f"""<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><title>Gearwright</title></head>
<body>
<h1>Gearwright</h1>
<p>The server runs, but {NOT_BUILT.replace("`make web`", "<code>make web</code>")}.</p>
<p>What programs use is there: <a href="/api/openapi.json">/api/openapi.json</a> describes it.</p>
</body>
</html>
"""


def built(folder: Path = FOLDER) -> bool:
    """Whether the page is there."""
    return (folder / "index.html").is_file()


def page_files(folder: Path = FOLDER) -> dict[str, Path]:
    """The files that are served, by their paths; nothing else of the disk ever is."""
    if not built(folder):
        return {}
    found = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.suffix in _TYPES)
    named = {"/" + path.relative_to(folder).as_posix(): path for path in found}
    return {"/": folder / "index.html", **named}


def page_reply(request: Request, files: dict[str, Path]) -> Response | None:
    """A file of the page, None where there is none of this path."""
    path = request.url.path
    if path == "/" and not files:
        return Response(_STAND_IN, media_type="text/html", headers={"cache-control": "no-cache"})
    if path not in files:
        return None
    data = files[path].read_bytes()
    tag = f'"{hashlib.sha256(data).hexdigest()[:32]}"'
    headers = {"etag": tag, "cache-control": "no-cache"}
    if tag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    return Response(data, headers={**headers, "content-type": _TYPES[files[path].suffix]})
