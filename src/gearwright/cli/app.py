"""The commands. Those that compute load when they are called, so that `--help` answers at once."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Sequence
from io import StringIO, TextIOWrapper

import cyclopts

from .. import __version__, catalog
from ..designs.kinds import commands, option_name, teeth_given
from ..library_threads import one_thread
from .exits import DONE, report

EPILOGUE = """Lengths are millimetres unless --length-unit says otherwise, angles degrees.
Results go to stdout, progress and warnings to stderr.
Exit codes: 0 done, 1 a check failed, 2 unusable input, 3 the machine's fault."""


def build() -> cyclopts.App:
    """The application with every command registered by where it is loaded from."""
    app = cyclopts.App(
        name="gearwright",
        version=__version__,
        help="Geometric modelling of gears, cams and swept solids, with exact volumetric properties.",
        help_epilogue=EPILOGUE,
        help_format="plaintext",
        exit_on_error=False,
        print_error=False,
        suppress_keyboard_interrupt=False,
        result_action="return_value",
    )
    for name in commands():
        app.command(f"{__package__}.elements:{name}", name=name, help=_help(name))
    app.command(f"{__package__}.build:build", name="build", help="Build the element that a TOML file describes.")
    app.command(f"{__package__}.schema:schema", name="schema", help="Print the JSON Schema of those TOML files.")
    app.command(
        f"{__package__}.properties:properties", name="properties", help="Mass, centroid and inertia of bodies in files."
    )
    app.command(f"{__package__}.materials:materials", name="materials", help="List materials and their densities.")
    app.command(
        f"{__package__}.check:check",
        name="check",
        help="Check files of bodies: closed, outward, not crossing.",
    )
    app.command(
        f"{__package__}.convert:convert",
        name="convert",
        help="Convert bodies, drawings and designs into files of other formats.",
    )
    app.command(f"{__package__}.serve:serve", name="serve", help="Serve the designer page on this machine.")
    app.command(
        f"{__package__}.demo:demo", name="demo", help="Build a bevel pair; compare exact with polyhedral values."
    )
    return app


def _help(command: str) -> str:
    """What an element's command builds; of several kinds, what chooses between them."""
    kinds = [element for element in catalog.ELEMENTS if element.command == command]
    summaries = f"Build {' or '.join(kind.summary for kind in kinds)}: sizes, properties, files."
    if len(kinds) == 1:
        return summaries
    return "\n\n".join([summaries, *(f"{teeth_given(kind, option_name)}: {kind.summary}." for kind in kinds)])


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line on the arguments (those of the process, if None) and gives the exit code."""
    one_thread()
    words = list(sys.argv[1:] if arguments is None else arguments)
    _open_missing_streams()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="replace")  # a code page without ² or δ must not stop an answer
    try:
        code = build()(words)
        sys.stdout.flush()
    except SystemExit:
        return DONE  # a help page whose reader left
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001  an edge: everything becomes a message and a code
        return report(error, shlex.join(["gearwright", *words]))
    return code if isinstance(code, int) else DONE


def _open_missing_streams() -> None:
    """Gives a process that was started without stdout or stderr one that takes everything."""
    if sys.stdout is None:
        sys.stdout = StringIO()
    if sys.stderr is None:
        sys.stderr = StringIO()
