"""OBJ files: vertices and faces of any number of corners, in objects or groups."""

from __future__ import annotations

import re

import numpy as np

from ...arrays import Indices
from ...errors import FileError
from ...moments.faces import Corners
from ..contents import Body, Contents, Data
from ..noted_unit import noted_unit
from ..parts import apart
from ..rounding import Written
from ..text.decimals import NO_NUMBER, NOT_FINITE, none_late, none_seen, read_late
from ..text.places import MARK, misfit, with_line_feeds
from .statements import FEW_CORNERS, LEFT_OUT, NO_STATEMENT, NO_VERTEX, count, fill

_CONTINUED = re.compile(rb"\\[ \t]*\r?\n")
_COMMENT_OR_CONTINUED = re.compile(rb"#[^\n]*|\\[ \t]*\r?\n")
_EXPECTED = {
    NO_NUMBER: "a number",
    NOT_FINITE: "a finite number (this one is not finite)",
    FEW_CORNERS: "one of at least 3",
    NO_STATEMENT: "a statement of OBJ files, as v or f, or a comment that begins with #,",
}


def parse(data: Data, name: str) -> Contents:
    """The bodies of an OBJ file: its objects (o), where it has none its groups (g); a name that comes again goes on.

    Polygons stay whole. Vertices keep their order in every body, those without faces are left out, those of several
    bodies go with each. Negative numbers count back from the last vertex so far. What follows x, y, z (a weight,
    colours), texture, normals and materials are ignored; points, lines, curves and surfaces are left out with a remark.
    Rounding is as `Written.rounding` finds it.
    Raises FileError with the line and what stands there if the text is not that of an OBJ file.
    """
    lines = with_line_feeds(bytes(data))
    if not lines.strip():
        raise FileError(f"{name}: the file is empty; an OBJ file was expected; write it again")
    text = _joined(b" " * len(MARK) + lines[len(MARK) :] if lines.startswith(MARK) else lines)
    characters = np.frombuffer(text, np.uint8)
    vertices, faces, words, marks = count(characters)
    points, indices = np.empty(3 * vertices), np.empty(words, np.int64)
    offsets, names = np.zeros(faces + 1, np.int64), np.empty((marks, 4), np.int64)
    left_out, seen = np.zeros(len(LEFT_OUT), np.int64), none_seen()
    problem, place, late = fill(characters, points, indices, offsets, names, none_late(), seen, left_out)
    if problem:
        raise _refusal(name, lines, place, problem, vertices)
    beyond = read_late(text, points, late)
    if beyond is not None:
        raise _refusal(name, lines, beyond, NOT_FINITE, vertices)
    if not faces:
        raise FileError(f"{name}: an OBJ file without faces (lines that begin with f); export the body as polygons")
    owners, body_names = _owners(text, names, faces)
    written, table = Written.of(seen), points.reshape(-1, 3)
    bodies = tuple(
        Body(name=title, vertices=own, indices=f.indices, offsets=f.offsets, rounding=written.rounding(own))
        for title, (own, f) in zip(
            body_names, apart(table, Corners(indices, offsets), owners, len(body_names)), strict=True
        )
    )
    return Contents(bodies=bodies, length_unit=noted_unit(lines), remarks=_remarks(left_out))


def _joined(text: bytes) -> bytes:
    """The text with lines that end with a backslash joined to the next; every character keeps its place."""
    if not _CONTINUED.search(text):
        return text
    return _COMMENT_OR_CONTINUED.sub(lambda m: m[0] if m[0].startswith(b"#") else b" " * len(m[0]), text)


def _refusal(path: str, text: bytes, place: int, problem: int, vertices: int) -> FileError:
    wanted = (
        f"the number of a vertex, 1 to {vertices} or negative to count back from here,"
        if problem == NO_VERTEX and vertices
        else "no face before there are vertices"
        if problem == NO_VERTEX
        else _EXPECTED[problem]
    )
    found = "a face of fewer than 3 corners" if problem == FEW_CORNERS else ""
    return misfit(path, "OBJ", text, place, wanted, found=found)


def _owners(text: bytes, names: Indices, faces: int) -> tuple[Indices, list[str]]:
    """The body of every face (f,), and the names of the bodies."""
    chosen = names[names[:, 0] == 1] if np.any(names[:, 0] == 1) else names
    starts = np.concatenate([[0], chosen[:, 1], [faces]])
    spans = np.flatnonzero(np.diff(starts))  # the others have no faces
    numbers: dict[str, int] = {}
    owner = []
    for k in spans.tolist():
        title = "" if k == 0 else " ".join(text[chosen[k - 1, 2] : chosen[k - 1, 3]].decode("utf-8", "replace").split())
        owner.append(numbers.setdefault(title, len(numbers)))
    return np.repeat(np.array(owner, np.int64), np.diff(starts)[spans]), list(numbers)


def _remarks(left_out: Indices) -> tuple[str, ...]:
    if not left_out.any():
        return ()
    listed = ", ".join(f"{LEFT_OUT[k]} ({left_out[k]})" for k in np.flatnonzero(left_out))
    return (f"left out, as they are no faces of bodies: statements {listed}",)
