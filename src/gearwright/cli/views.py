"""How properties are looked at: about which other point, and along which axes their tensors are given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, Problem
from ..placement import require_rotation
from ..rotations import quaternion_of, rotation_of
from ..solids.properties import MassProperties

FILE_AXES, PRINCIPAL_AXES = "file", "principal"

_UNIT = 1e-3
"""How far the length of a typed quaternion may be from 1: digits left out, no mistaken number."""

_RIGID = 1e-9
"""How far typed rows may be from orthonormal."""

_TENSORS = ("second_moment", "inertia", "central_inertia", "products", "central_products", "central_radii_of_gyration")


@dataclass(frozen=True, kw_only=True, eq=False)
class View:
    """A point about which inertia is also given, and the axes of all tensors.

    about  (3,) in the file's lengths and frame, or None
    axes   "file", "principal" (each body's own) or axes as columns (3, 3) in the file's frame
    """

    about: Array | None = None
    axes: str | Array = FILE_AXES

    @property
    def name(self) -> str:
        """What kind of axes these are: "file", "principal" or "given"."""
        return self.axes if isinstance(self.axes, str) else "given"

    @property
    def words(self) -> str:
        """The axes in words."""
        return {"file": "the file's axes", "principal": "principal axes"}.get(self.name, "the axes given")

    def axes_of(self, body: MassProperties) -> Array:
        """Axes of a body's tensors as columns (3, 3) in the file's frame."""
        if isinstance(self.axes, str):
            return body.principal_axes if self.axes == PRINCIPAL_AXES else np.eye(3)
        return self.axes

    def turned(self, body: MassProperties) -> MassProperties:
        """The body in a frame along the axes at the same origin: its tensors are what is shown."""
        axes = self.axes_of(body)
        return body if np.array_equal(axes, np.eye(3)) else body.moved(axes.T)

    def inertia_about(self, body: MassProperties) -> Array:
        """Inertia tensor about the point, along the axes; about the origin where no point is asked for."""
        axes = self.axes_of(body)
        point = np.zeros(3) if self.about is None else self.about
        return np.asarray(axes.T @ body.about(point) @ axes)

    def to_dict(self, body: MassProperties) -> dict[str, Any]:
        """A body's properties by name with tensors along the axes, which are named, and inertia about the point."""
        axes = self.axes_of(body)
        values = body.to_dict()
        turned = self.turned(body).to_dict()
        values |= {name: turned[name] for name in _TENSORS}
        values["axes"] = {"name": self.name, "quaternion": quaternion_of(axes), "rotation": axes}
        if self.about is not None:
            values["about"] = {"point": self.about, "inertia": self.inertia_about(body)}
        return values


def axes_in(text: str) -> str | Array:
    """Axes as they are typed: "file", "principal", w,x,y,z of a quaternion, or nine numbers, row by row.

    Raises GeometryError where they are none of these.
    """
    if text in (FILE_AXES, PRINCIPAL_AXES):
        return text
    try:
        numbers = np.array([float(word) for word in text.split(",")])
    except ValueError:
        numbers = np.empty(0)
    if numbers.size == 9 and np.all(np.isfinite(numbers)):
        return require_rotation(numbers.reshape(3, 3), _RIGID)
    if numbers.size == 4 and abs(float(np.linalg.norm(numbers)) - 1.0) < _UNIT:
        return rotation_of(numbers)
    raise GeometryError(
        "These are no axes",
        [
            Problem(
                text,
                "give file, principal, a unit quaternion w,x,y,z or nine numbers of a rotation, row by row, with commas"
                " between them; its columns are the axes. A first number that is negative needs --axes=…",
            )
        ],
    )
