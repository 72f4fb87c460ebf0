"""The flank of a tooth that may look different from end to end, as contact needs to know it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.polynomial import Chebyshev, chebyshev

from ..arrays import Array, ArrayLike
from ..elements.bevel.teeth import BevelTeeth
from ..elements.bevel.tooth import BevelTooth

_DEGREE = 16  # along the face and up the relief: both are far from anything singular


class Flank(Protocol):
    """The flank of a tooth centred on azimuth 0, the same on both sides. Angles in radians.

    A level is the surface of parameter v on which the teeth could end (see `Radial`); arrays broadcast.

    varies   whether it looks different from level to level
    cusp     polar angle at which the form begins, fillets and form circle apart
    """

    @property
    def varies(self) -> bool: ...
    @property
    def cusp(self) -> float: ...
    def form_angle(self, level: ArrayLike) -> Array:
        """Polar angle (...) from which it can touch on levels (...)."""
        ...

    def face_angle(self, level: ArrayLike) -> Array:
        """Polar angle (...) of the tip on levels (...)."""
        ...

    def half_angle(self, polar: ArrayLike, level: ArrayLike) -> Array:
        """Half the tooth's angular thickness about its axis (...) at polar angles (...) on levels (...)."""
        ...

    def form_half(self, polar: ArrayLike) -> Array:
        """The same without relief and crowning: of the form alone."""
        ...


@dataclass(frozen=True, kw_only=True)
class BevelFlank:
    """That of a bevel gear's teeth: what changes along the face is taken at a few levels and interpolated between.

    Angles, thickness and relief are analytic between the ends; 17 levels give them to rounding, but for the form angle
    where undercut begins between the ends.
    """

    teeth: BevelTeeth

    @property
    def varies(self) -> bool:
        return self.teeth.varies

    @property
    def cusp(self) -> float:
        return self.teeth.mean.flank.least_polar

    def form_angle(self, level: ArrayLike) -> Array:
        return np.maximum(self._along(self._form_angles, level), self.cusp)

    def face_angle(self, level: ArrayLike) -> Array:
        return self._along(self._face_angles, level)

    def half_angle(self, polar: ArrayLike, level: ArrayLike) -> Array:
        thickness = self._along(self._thicknesses, level)
        return thickness / 2.0 - self.teeth.mean.flank.azimuth_at(polar) - self._relieved(polar, level)

    def form_half(self, polar: ArrayLike) -> Array:
        return self.teeth.thickness / 2.0 - self.teeth.mean.flank.azimuth_at(polar)

    @cached_property
    def _ends(self) -> tuple[float, float]:
        return self.teeth.level("inner"), self.teeth.level("outer")

    @cached_property
    def _stations(self) -> list[BevelTooth]:
        """Teeth at Chebyshev points between the ends, or one where all are alike."""
        if not self.varies:
            return [self.teeth.mean]
        inner, outer = self._ends
        middle, half = (inner + outer) / 2.0, (outer - inner) / 2.0
        return [self.teeth.tooth(float(middle + half * x)) for x in chebyshev.chebpts1(_DEGREE + 1)]

    @cached_property
    def _form_angles(self) -> Chebyshev:
        return self._fit([tooth.form_angle for tooth in self._stations])

    @cached_property
    def _face_angles(self) -> Chebyshev:
        return self._fit([tooth.face_angle for tooth in self._stations])

    @cached_property
    def _thicknesses(self) -> Chebyshev:
        return self._fit([tooth.thickness for tooth in self._stations])

    @cached_property
    def _begins(self) -> Chebyshev:
        return self._fit([tooth.face_angle if tooth.relief is None else tooth.relief.begin for tooth in self._stations])

    def _fit(self, values: list[float]) -> Chebyshev:
        return Chebyshev(_coefficients(np.array(values)), domain=self._ends)

    def _along(self, fit: Chebyshev, level: ArrayLike) -> Array:
        return np.asarray(fit(np.clip(level, *self._ends)))

    @cached_property
    def _reliefs(self) -> Array:
        """Coefficients (a, b) over the height in the relief, from −1 to 1, and over the level, of what it takes off."""
        share = (chebyshev.chebpts1(_DEGREE + 1) + 1.0) / 2.0
        columns = []
        for tooth in self._stations:
            begin = tooth.face_angle if tooth.relief is None else tooth.relief.begin
            polar = begin + share * (tooth.face_angle - begin)
            columns.append(tooth.thickness / 2.0 - tooth.flank.azimuth_at(polar) - tooth.half_angle(polar))
        return _coefficients(_coefficients(np.stack(columns, axis=-1)).T).T

    def _relieved(self, polar: ArrayLike, level: ArrayLike) -> Array | float:
        """What relief takes off (...)."""
        if not self.teeth.relief:
            return 0.0
        begin, face = self._along(self._begins, level), self.face_angle(level)
        share = (np.asarray(polar, float) - begin) / (face - begin)
        inner, outer = self._ends
        along = (2.0 * np.clip(level, inner, outer) - inner - outer) / (outer - inner)
        share, along = np.broadcast_arrays(np.clip(2.0 * share - 1.0, -1.0, 1.0), along)
        return np.where(share > -1.0, chebyshev.chebval2d(share, along, self._reliefs), 0.0)


def _coefficients(values: Array) -> Array:
    """Of the Chebyshev polynomials (n, ...) that are worth values (n, ...) at the n Chebyshev points."""
    count = len(values)
    points = chebyshev.chebpts1(count)
    basis = chebyshev.chebvander(points, count - 1)
    weights = np.full(count, 2.0 / count)
    weights[0] = 1.0 / count
    return np.asarray((weights * basis).T @ values)
