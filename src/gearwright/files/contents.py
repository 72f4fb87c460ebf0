"""What a file holds: bodies bounded by polygon faces, and the unit of their lengths."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Indices

Data = bytes | memoryview
"""The bytes of a file. Every reader is a function parse(data, name) → Contents; `name` is the path, for messages."""


@dataclass(frozen=True, kw_only=True, eq=False)
class SmoothProperties:
    """Properties of a smooth body of which a file's reader makes a polyhedron, by quadrature over its smooth faces.

    volume
    centroid        (3,)
    second_moment   (3, 3), ∫ (r − centroid)(r − centroid)ᵀ dV
    """

    volume: float
    centroid: Array
    second_moment: Array

    def mapped(self, linear: Array, shift: Array) -> SmoothProperties:
        """Of the body mapped by r → A r + t: |det A| V, A c + t, |det A| A M Aᵀ."""
        stretch = abs(float(np.linalg.det(linear)))
        return SmoothProperties(
            volume=stretch * self.volume,
            centroid=linear @ self.centroid + shift,
            second_moment=stretch * linear @ self.second_moment @ linear.T,
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """One body of a file, with the faces as they stand there: no polygon is cut, no gap is closed.

    name              as the file has it; "" where it has none
    vertices          (n, 3) in the file's lengths, placed where the file places the body
    indices, offsets  faces as in `moments.faces`: at least 3 corners each, all numbers in range
    rounding          largest error by which the file rounds a coordinate; 0 where it keeps double precision
    smooth            of the smooth body whose faces the file has, where these are not faces as they stand
    """

    name: str
    vertices: Array
    indices: Indices
    offsets: Indices
    rounding: float = 0.0
    smooth: SmoothProperties | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Contents:
    """The bodies of a file, at least one.

    length_unit   a key of LENGTH_UNITS; None where the file states none
    remarks       what was read in some way a reader should know of, in words: things left out, as lines and points
    """

    bodies: tuple[Body, ...]
    length_unit: str | None = None
    remarks: tuple[str, ...] = ()
