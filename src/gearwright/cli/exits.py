"""What the command line says and returns when something goes wrong: never a traceback."""

from __future__ import annotations

import difflib
import os
import sys
import traceback

from cyclopts import (
    ConsumeMultipleError,
    CycloptsError,
    MissingArgumentError,
    UnknownCommandError,
    UnusedCliTokensError,
)

from ..errors import GearwrightError, MachineError

DONE, CHECK_FAILED, UNUSABLE_INPUT, MACHINES_FAULT, INTERRUPTED = 0, 1, 2, 3, 130

_PATH_ERRORS = (FileNotFoundError, FileExistsError, IsADirectoryError, NotADirectoryError)
"""System errors that another file name mends; others (permissions, a full disk) are the machine's."""


def report(error: BaseException, command: str, subject: str = "") -> int:
    """Says on stderr what went wrong, and gives the exit code.

    command   what the user typed, for the request to report an internal error
    subject   what the error is about, such as a file, if its text may not say so
    """
    if isinstance(error, BrokenPipeError):
        return _reader_left()
    code, message = explained(error, command, subject)
    if message:
        print(message, file=sys.stderr)
    return code


def explained(error: BaseException, command: str, subject: str = "") -> tuple[int, str]:
    """Exit code and message of an error; arguments as those of `report`."""
    if os.environ.get("GEARWRIGHT_DEBUG") == "1":
        traceback.print_exception(error)
    code, message = _code_and_message(error, command)
    if subject and message and not message.startswith(subject):
        message = f"{subject}: {message}"
    return code, message


def _code_and_message(error: BaseException, command: str) -> tuple[int, str]:
    match error:
        case KeyboardInterrupt():
            return INTERRUPTED, ""
        case CycloptsError():
            return UNUSABLE_INPUT, _option_message(error)
        case MachineError():
            return MACHINES_FAULT, str(error)
        case GearwrightError():
            return UNUSABLE_INPUT, str(error)
        case OSError():
            code = UNUSABLE_INPUT if isinstance(error, _PATH_ERRORS) else MACHINES_FAULT
            where = f"{error.filename}: " if error.filename else ""
            return code, f"{where}{error.strerror or error}"
        case MemoryError():
            return MACHINES_FAULT, "Not enough memory. A coarser --tolerance makes smaller polyhedra."
        case _:
            return MACHINES_FAULT, _internal_message(error, command)


def _option_message(error: CycloptsError) -> str:
    chain = " ".join(["gearwright", *(error.command_chain or ())])
    match error:
        case UnknownCommandError():
            text = _unknown_command(error)
        case UnusedCliTokensError():
            text = f"No option takes this: {' '.join(error.unused_tokens or ())}"
        case ConsumeMultipleError(argument=argument, actual_count=0) if argument:
            text = f"{argument.name}: a value is needed."
        case ConsumeMultipleError(argument=argument) if argument:
            optional = argument.parameter.consume_multiple == (0, 1)
            accepted = "at most one value is" if optional else "one or two values are"
            text = f"{argument.name}: {accepted} accepted, not {error.actual_count}."
        case MissingArgumentError(argument=argument) if argument:
            text = f"{error.keyword or argument.parameter.metavar or argument.name}: a value is needed."
        case _:
            text = str(error).strip()
    return f"{text}\nSee `{chain} --help` for what is accepted."


def _unknown_command(error: UnknownCommandError) -> str:
    """Says which commands there are. The error's own text would load all of them to do so."""
    (word, *_) = error.unused_tokens or [""]
    known = list(error.app or ())
    names = [name for name in known if not name.startswith("-")]
    nearest = difflib.get_close_matches(word, known, n=1)
    hint = f" Did you mean {nearest[0]}?" if nearest else ""
    what = "option" if word.startswith("-") else "command"
    return f"Unknown {what}: {word}.{hint} The commands are {', '.join(names)}."


def _internal_message(error: BaseException, command: str) -> str:
    return (
        f"Gearwright failed, and the fault is its own ({type(error).__name__}: {error}).\n"
        f"Please report it with this command:\n  {command}\n"
        "GEARWRIGHT_DEBUG=1 before the command shows where it happened."
    )


def _reader_left() -> int:
    """Whoever read the output has enough (`| head`): nothing is wrong, and nothing more is written."""
    devnull = os.open(os.devnull, os.O_WRONLY)
    os.dup2(devnull, sys.stdout.fileno())
    return DONE
