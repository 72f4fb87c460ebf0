"""What a file holds: bodies bounded by polygon faces, and the unit of their lengths."""

from __future__ import annotations

from dataclasses import dataclass

from ..arrays import Array, Indices

Data = bytes | memoryview
"""The bytes of a file. Every reader is a function parse(data, name) → Contents; `name` is the path, for messages."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """One body of a file, with the faces as they stand there: no polygon is cut, no gap is closed.

    name              as the file has it; "" where it has none
    vertices          (n, 3) in the file's lengths, placed where the file places the body
    indices, offsets  faces as in `moments.faces`: at least 3 corners each, all numbers in range
    rounding          largest error by which the file rounds a coordinate; 0 where it keeps double precision
    """

    name: str
    vertices: Array
    indices: Indices
    offsets: Indices
    rounding: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Contents:
    """The bodies of a file, at least one.

    length_unit   a key of LENGTH_UNITS; None where the file states none
    remarks       what was read in some way a reader should know of, in words: things left out, as lines and points
    """

    bodies: tuple[Body, ...]
    length_unit: str | None = None
    remarks: tuple[str, ...] = ()
