"""`gearwright serve`: the designer page on this machine."""

from __future__ import annotations

import sys
import threading
from functools import partial
from importlib.util import find_spec
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter as Option

from ..errors import MachineError, Problem, ProblemsError
from ..server.hosts import is_name, origin_of
from .exits import DONE

if TYPE_CHECKING:
    from ..server.serving import Bound

PORT = 8321
_LIBRARIES = ("starlette", "uvicorn", "websockets")


def serve(
    *,
    port: Annotated[
        int | None,
        Option(
            help="Port to listen at; 0 takes any free one.", metavar="PORT", show_default=f"{PORT}, or the next free"
        ),
    ] = None,
    host: Annotated[
        str,
        Option(help="Name or address to listen at. Others than this machine's own need a token.", metavar="HOST"),
    ] = "127.0.0.1",
    origin: Annotated[
        str | None,
        Option(
            help="Address of a proxy that passes requests on, such as https://gear.example. A token is needed then.",
            metavar="ADDRESS",
            show_default=False,
        ),
    ] = None,
    open_: Annotated[
        bool, Option(name="--open", help="Open the page in a browser.", negative=(), show_default=False)
    ] = False,
) -> int:
    """Serve the designer page: a design in a form, its solid, properties, plots and files as it changes."""
    _require_sound(port, host, origin)
    _require_libraries()
    from ..server.page import NOT_BUILT, built
    from ..server.serving import bound
    from ..server.serving import serve as serve_at

    at = bound(host, PORT if port is None else port, or_next=port is None, origin=origin_of(origin or ""))
    if at.moved:
        print(f"Port {PORT} is taken; {at.names.port} it is.", file=sys.stderr)
    if not built():
        print(f"note: {NOT_BUILT}; what programs use is served.", file=sys.stderr)
    if at.token is not None:
        print("Others can reach it: whoever has this address, with its token, can use it.", file=sys.stderr)
    try:
        serve_at(at, partial(_ready, at, open_))
    finally:
        at.listener.close()
    print("Gearwright's designer page has ended.", file=sys.stderr)
    return DONE


def _ready(at: Bound, open_: bool) -> None:
    """Says where the page is, and opens it where that is asked for."""
    print(f"Gearwright's designer page: {at.address} – Ctrl-C ends it.", flush=True)
    for address in at.addresses_elsewhere:
        print(f"From other machines: {address}", flush=True)
    if open_:
        import webbrowser

        threading.Thread(target=webbrowser.open, args=(at.address,), daemon=True).start()


def _require_sound(port: int | None, host: str, origin: str | None) -> None:
    problems = []
    if port is not None and not 0 <= port <= 65535:
        problems.append(Problem(f"--port {port}", "a port is a whole number from 0 to 65535"))
    if not is_name(host):
        problems.append(Problem(f"--host {host}", "a name or an address is needed, such as 127.0.0.1 or 0.0.0.0"))
    if origin is not None and origin_of(origin) is None:
        words = "scheme and name are needed, and a port where it is not the usual one, such as https://gear.example"
        problems.append(Problem(f"--origin {origin}", words))
    if problems:
        raise ProblemsError("The server cannot start", problems)


def _require_libraries() -> None:
    missing = [name for name in _LIBRARIES if find_spec(name) is None]
    if missing:
        told = f"{', '.join(missing)} {'is' if len(missing) == 1 else 'are'} not installed"
        raise MachineError(f"{told}; the page's server comes with: pip install 'gearwright[web]'")
