"""`gearwright properties FILE…`: volumetric properties of bodies in files."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import fields
from functools import partial
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from ..designs.kinds import option_name
from ..errors import GearwrightError, Problem, ProblemsError
from ..moments.summation import processors
from ..parameters import did_you_mean
from .batch import in_order
from .exits import DONE, MACHINES_FAULT, report
from .file_names import named_files
from .measuring import STANDARD_INPUT, Answer, Failure, Measured, Question, answer
from .outputs import progress
from .property_formats import heading, result
from .property_options import DEFAULT, FLATTENED, Wanted, asked
from .summing import Sum

_WORTH_A_PROCESS = 3.0
"""Seconds of work; starting a process takes about one."""

_SECONDS_A_FILE, _SECONDS_A_BYTE = 3e-3, 1 / 40e6
"""What measuring a file takes, roughly."""

FILES = Option(
    metavar="FILE",
    required=True,
    allow_leading_hyphen=True,
    json_list=False,  # a name may begin with a bracket
    help="Files of bodies, folders of them, @LIST for the files that a text file names, - for what is piped in.",
)


def properties(
    *files: Annotated[Path, FILES],
    wanted: FLATTENED = DEFAULT,
) -> int:
    """Mass, volume, centroid and inertia of closed polyhedra and of thin shells.

    A file that cannot be used is named on stderr; the others are still done.
    """
    question, view = asked(wanted)
    tasks = named_files(_without_unknown_options(files))
    said = partial(_said, shown=partial(result, written=wanted.written, view=view, question=question))
    worst, total = DONE, Sum()
    sys.stdout.write(heading(wanted.written))
    with closing(_answers(tasks, question, wanted.jobs)) as answers:
        for found in _with_progress(answers, len(tasks)):
            worst = max(worst, said(found))
            if wanted.sum and isinstance(found, Measured):
                total.take(found)
    together = total.total()
    if together is not None:
        worst = max(worst, said(together))
        if worst != DONE:
            print("note: files that could not be used are not in the sum", file=sys.stderr)
    return worst


def _said(found: Answer, shown: Callable[[Measured], str]) -> int:
    """Writes a result, with its remarks, or says why there is none; gives the exit code."""
    if isinstance(found, Failure):
        print(found.message, file=sys.stderr)
        return found.code
    for remark in found.remarks:
        print(f"note: {found.file}: {remark}", file=sys.stderr)
    try:
        sys.stdout.write(shown(found))
    except GearwrightError as error:
        return report(error, "gearwright properties", subject=found.file or "the sum")
    sys.stdout.flush()
    return DONE


def _answers(tasks: Sequence[Path | Failure], question: Question, jobs: int | None) -> Generator[Answer]:
    """What each file answers, in their order."""
    work = partial(_answer, question=question)
    files = [task for task in tasks if isinstance(task, Path)]
    return in_order(tasks, work, 1 if STANDARD_INPUT in files else jobs or _processes(files), _lost)


def _answer(task: Path | Failure, question: Question) -> Answer:
    return task if isinstance(task, Failure) else answer(task, question)


def _lost(task: Path | Failure, code: int) -> Answer:
    if isinstance(task, Failure):
        return task
    how = f"by signal {-code}" if code < 0 else f"with code {code}"
    message = (
        f"{task}: the process that measured it was ended {how}; the usual cause is too little memory: measure it alone,"
        " or take fewer --jobs"
    )
    return Failure(code=MACHINES_FAULT, message=message)


def _processes(files: Sequence[Path]) -> int:
    """How many processes are worth their start."""
    work = len(files) * _SECONDS_A_FILE + sum(_size(file) for file in files) * _SECONDS_A_BYTE
    return max(1, min(processors(), len(files), int(work / _WORTH_A_PROCESS)))


def _size(file: Path) -> int:
    try:
        return file.stat().st_size
    except (OSError, ValueError):
        return 0


def _with_progress(answers: Iterator[Answer], count: int) -> Iterator[Answer]:
    """The answers, saying on a terminal how many of the files are done while it waits for the next."""
    for number in range(count):
        with progress(f"measuring, {number} of {count} files are done" if count > 1 else "measuring"):
            found = next(answers)
        yield found


def _without_unknown_options(files: Sequence[Path]) -> Sequence[Path]:
    """The names, of which only - may begin with a hyphen: others are options that there are not."""
    known = sorted(option_name(one.name) for one in fields(Wanted))
    problems = [
        Problem(str(file), f"there is no such option{did_you_mean(str(file), known)}; a file of this name is ./{file}")
        for file in files
        if str(file).startswith("-") and file != STANDARD_INPUT
    ]
    if problems:
        raise ProblemsError("These options are not known (`gearwright properties --help` lists them)", problems)
    return files
