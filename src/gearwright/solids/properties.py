"""Mass properties of a body: one volume, one centroid, one central tensor; everything else follows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem
from ..html_tables import numbers
from ..moments.body import BodyMoments, Method
from ..moments.matrix import inertia_tensor, moment_matrix
from ..placement import require_rotation
from ..rotations import quaternion_of
from .combining import combined_error, require_within
from .extent import Extent
from .principal import principal_axes
from .sound_values import fixed_array, require_finite, sound_density

_METHODS: tuple[Method, ...] = ("exact", "quadrature", "polyhedron")
"""From the best to the coarsest; a sum is as good as its coarsest part."""

_RIGID = 1e-9
"""How far R Rᵀ may be from 1 for R to count as a rotation."""

_ROUNDED = 4e-15
"""Up to which that is rounding; what is beyond stretches the body."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MassProperties:
    """Volume, centroid and inertia of a body, in the length unit it was built in.

    volume          V
    centroid        (3,) centre of mass
    central_second  (3, 3) ∫ r rᵀ dV about the centroid, geometric (not times the density)
    density         mass per cubed length unit; of bodies joined together, the mean density
    find_extent     gives area and bounding box when they are first asked for: on a smooth boundary they cost
                    more than all the rest
    method          how they were found: "exact", "quadrature" or "polyhedron"
    error_bound     bound on the relative error of V and, norm-wise, of the central second moment
    evaluations     how often a quadrature along a motion evaluated it; 0 where none was needed
    warnings        what is wrong with the boundary and was allowed, and what the values mean then

    Everything derived is mass-weighted, except the radii of gyration. Tensors named `central_` are
    about the centroid, the others about the origin; axes are always those of the frame. In `inertia`
    and `central_inertia` the off-diagonals are minus the products; `products` are +∫xy, +∫yz, +∫zx.

    Raises ParameterError if the density is not positive or a value not finite.
    """

    volume: float
    centroid: Array
    central_second: Array
    density: float = 1.0
    find_extent: Callable[[], Extent] = field(default=Extent, repr=False)
    method: Method = "exact"
    error_bound: float = 0.0
    evaluations: int = 0
    warnings: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        second = fixed_array(self.central_second, (3, 3))
        values = {
            "volume": float(self.volume),
            "centroid": fixed_array(self.centroid, (3,)),
            "central_second": fixed_array((second + second.T) / 2.0, (3, 3)),
            "density": sound_density(self.density),
        }
        require_finite(values)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @classmethod
    def from_moments(
        cls,
        moments: BodyMoments,
        *,
        density: float = 1.0,
        find_extent: Callable[[], Extent] = Extent,
        warnings: tuple[str, ...] = (),
    ) -> MassProperties:
        """From moments about a point near the centroid."""
        return cls(
            volume=moments.volume,
            centroid=moments.centroid,
            central_second=moments.central_second,
            density=density,
            find_extent=find_extent,
            method=moments.method,
            error_bound=moments.error_bound,
            evaluations=moments.evaluations,
            warnings=warnings,
        )

    @cached_property
    def extent(self) -> Extent:
        """Area and bounding box, found once."""
        return self.find_extent()

    @property
    def area(self) -> float | None:
        """Surface area, None where unknown."""
        return self.extent.area

    @property
    def bounding_box(self) -> Array | None:
        """Lowest and highest coordinates (2, 3), None where unknown."""
        return self.extent.bounding_box

    @property
    def mass(self) -> float:
        """Density × volume."""
        return self.density * self.volume

    @property
    def first_moment(self) -> Array:
        """∫ r dm about the origin (3,)."""
        return self.mass * self.centroid

    @property
    def second_moment(self) -> Array:
        """∫ r rᵀ dm about the origin (3, 3)."""
        return self.density * self.central_second + self.mass * np.outer(self.centroid, self.centroid)

    @property
    def inertia(self) -> Array:
        """Inertia tensor about the origin (3, 3); off-diagonals are minus the products."""
        return inertia_tensor(self.second_moment)

    @property
    def central_inertia(self) -> Array:
        """Inertia tensor about the centroid (3, 3); off-diagonals are minus the products."""
        return self.density * inertia_tensor(self.central_second)

    @property
    def products(self) -> Array:
        """Products of inertia +∫xy dm, +∫yz dm, +∫zx dm about the origin (3,)."""
        return self.second_moment[[0, 1, 2], [1, 2, 0]]

    @property
    def central_products(self) -> Array:
        """Products of inertia +∫xy dm, +∫yz dm, +∫zx dm about the centroid (3,)."""
        return self.density * self.central_second[[0, 1, 2], [1, 2, 0]]

    @property
    def principal_moments(self) -> Array:
        """Principal moments of inertia about the centroid (3,), ascending."""
        axes = self.principal_axes
        return np.asarray(np.einsum("ik,ij,jk->k", axes, self.central_inertia, axes))

    @property
    def principal_axes(self) -> Array:
        """Axes of the principal moments, in their order, as columns (3, 3): right-handed, signs settled."""
        return principal_axes(self.central_inertia)

    @property
    def principal_quaternion(self) -> Array:
        """Unit quaternion (w, x, y, z), w ≥ 0, that turns the frame's axes into the principal ones.

        Its matrix is `principal_axes`: it takes components along the principal axes to components in the frame.
        """
        return quaternion_of(self.principal_axes)

    @property
    def radii_of_gyration(self) -> Array:
        """√(principal moment / mass), about the principal axes through the centroid (3,)."""
        return np.sqrt(np.maximum(self.principal_moments, 0.0) / self.mass)

    @property
    def central_radii_of_gyration(self) -> Array:
        """√(Ixx / mass), √(Iyy / mass), √(Izz / mass), about the frame's axes through the centroid (3,)."""
        return np.sqrt(np.maximum(np.diag(self.central_inertia), 0.0) / self.mass)

    @property
    def moments(self) -> Array:
        """Moment matrix [m qᵀ; q S] about the origin (4, 4)."""
        return moment_matrix(self.mass, self.first_moment, self.second_moment)

    def about(self, point: ArrayLike) -> Array:
        """Inertia tensor about a point (3,), axes parallel to the frame; off-diagonals minus the products."""
        arm = self.centroid - fixed_array(point, (3,))
        return self.central_inertia + self.mass * inertia_tensor(np.outer(arm, arm))

    def moved(self, rotation: ArrayLike, translation: ArrayLike = (0.0, 0.0, 0.0)) -> MassProperties:
        """Properties of the body moved by r → R r + t, R (3, 3) a rotation, t (3,).

        The bounding box is kept where R only exchanges axes, else dropped: it does not follow from the box.
        Raises GeometryError if R is not a rotation (for mirroring and scaling, transform the body itself).
        """
        matrix, shift = require_rotation(rotation, _RIGID), fixed_array(translation, (3,))
        strain = float(np.abs(matrix @ matrix.T - np.eye(3)).max())
        strain = strain if strain > _ROUNDED else 0.0
        return replace(
            self,
            centroid=matrix @ self.centroid + shift,
            central_second=matrix @ self.central_second @ matrix.T,
            error_bound=self.error_bound + 6.0 * strain,
            find_extent=partial(_moved_extent, self, matrix, shift),
        )

    def __add__(self, other: MassProperties) -> MassProperties:
        """Properties of two bodies that do not overlap, as one; of unlike densities the mean is given."""
        if not isinstance(other, MassProperties):
            return NotImplemented
        return self._combined(other, 1.0, partial(_joint_extent, self, other))

    def __radd__(self, other: object) -> MassProperties:
        """So that `sum` takes several: 0 + a is a."""
        return self if isinstance(other, int) and other == 0 else NotImplemented

    def __sub__(self, other: MassProperties) -> MassProperties:
        """Properties of this body without a body that is part of it (give that one this body's density).

        Raises GeometryError if nothing would remain, or the part's box is not within this body's.
        """
        if not isinstance(other, MassProperties):
            return NotImplemented
        if not (other.volume < self.volume and other.mass < self.mass):
            raise GeometryError(
                "The body taken away is no part of the other",
                [
                    Problem(
                        f"volume {other.volume:.6g} of {self.volume:.6g}, mass {other.mass:.6g} of {self.mass:.6g}",
                        "the part must be smaller than the whole; check the order, the units and the densities",
                    )
                ],
            )
        require_within(self.bounding_box, other.bounding_box)
        return self._combined(other, -1.0, partial(_remaining_extent, self, other))

    def _combined(self, other: MassProperties, sign: float, find_extent: Callable[[], Extent]) -> MassProperties:
        volume = self.volume + sign * other.volume
        mass = self.mass + sign * other.mass
        like = self.density == other.density
        density = self.density if like else mass / volume
        weights = np.array([1.0, sign]) if like else np.array([self.density, sign * other.density]) / density
        arm = other.centroid - self.centroid
        second = weights[0] * self.central_second + weights[1] * other.central_second
        second = second + (weights[0] * self.volume) * (sign * other.mass / mass) * np.outer(arm, arm)
        return MassProperties(
            volume=volume,
            centroid=self.centroid + (sign * other.mass / mass) * arm,
            central_second=second,
            density=density,
            find_extent=find_extent,
            method=max(self.method, other.method, key=_METHODS.index),
            error_bound=combined_error(self, other, sign, volume, second),
            evaluations=self.evaluations + other.evaluations,
            warnings=tuple(dict.fromkeys(self.warnings + other.warnings)),
        )

    def validity(self) -> tuple[Problem, ...]:
        """Why no body can have these properties; empty where one can.

        Volume positive; central second moment positive definite, which is the same as: no principal
        moment of inertia exceeds the sum of the other two.
        """
        problems = []
        if not self.volume > 0.0:
            problems.append(
                Problem(f"volume = {self.volume:.6g}", "must be positive; faces turned inward give a negative one")
            )
        spread = np.linalg.eigvalsh(self.central_second)
        if not spread[0] > -(self.error_bound + 1e-15) * abs(spread[2]) or not spread[2] > 0.0:
            first, second, third = self.principal_moments
            problems.append(
                Problem(
                    f"principal moments {first:.6g}, {second:.6g}, {third:.6g}",
                    "each must be positive and at most the sum of the other two; usual causes are an open boundary"
                    " and inertia taken about another point than the centroid",
                )
            )
        return tuple(problems)

    def to_dict(self) -> dict[str, Any]:
        """Everything by name as plain numbers and lists, for JSON; products named xy, yz, zx."""
        names = (
            "volume mass density centroid first_moment second_moment inertia central_inertia products central_products"
            " principal_moments principal_axes principal_quaternion radii_of_gyration central_radii_of_gyration moments"
            " area bounding_box method error_bound evaluations warnings"
        )
        values: dict[str, Any] = {name: getattr(self, name) for name in names.split()}
        for name in ("products", "central_products"):
            values[name] = dict(zip(("xy", "yz", "zx"), values[name].tolist(), strict=True))
        values["warnings"] = list(self.warnings)
        return {name: v.tolist() if isinstance(v, np.ndarray) else v for name, v in values.items()}

    def __repr__(self) -> str:
        middle = numbers(self.centroid)
        mass = "" if self.density == 1.0 else f", mass {self.mass:.7g}"
        return f"<MassProperties: volume {self.volume:.7g}{mass}, centroid ({middle}), {self.method}>"

    def _repr_html_(self) -> str:
        from .summaries import properties_summary

        return properties_summary(self)


def _moved_extent(body: MassProperties, rotation: Array, shift: Array) -> Extent:
    return body.extent.moved(rotation, shift)


def _joint_extent(one: MassProperties, other: MassProperties) -> Extent:
    return one.extent.joined(other.extent)


def _remaining_extent(whole: MassProperties, part: MassProperties) -> Extent:
    return whole.extent.without(part.extent)
