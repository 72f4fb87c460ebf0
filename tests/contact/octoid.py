"""The octoid, conjugate to a crown gear with plane flanks: written from its generation, for comparison."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from gearwright.contact.mesh import mesh_of

_OFF_CUSP = 0.002  # radians: the octoid's own cusp lies a little above the lowest point of its path


@dataclass(frozen=True, kw_only=True)
class Octoid:
    """Flank of a tooth of a pitch cone, of an angular thickness there, by a pressure angle."""

    pitch_angle: float
    pressure_angle: float
    thickness: float
    form: float
    face: float
    varies = False

    @property
    def cusp(self):
        return self.least_polar

    def form_angle(self, level):
        return np.full(np.shape(level), self.form)

    def face_angle(self, level):
        return np.full(np.shape(level), self.face)

    def half_angle(self, polar, level):  # noqa: ARG002 - the same on every level
        return self.form_half(polar)

    def form_half(self, polar):
        """Half thickness where the path of contact, carried back by the roll −u/sin γ, has a polar angle."""
        polar = np.asarray(polar, float)
        low, high = np.full(polar.shape, self._lowest), np.full(polar.shape, 0.8)
        for _ in range(60):
            u = (low + high) / 2.0
            over = self._polar(u) > polar
            low, high = np.where(over, low, u), np.where(over, u, high)
        x, y, z = self._path(u)
        s, c = np.sin(self.pitch_angle), np.cos(self.pitch_angle)
        azimuth = np.arctan2(y, s * x - c * z) - u / s
        return self.thickness / 2.0 + azimuth

    @cached_property
    def _lowest(self):
        """Roll at which the path of contact comes nearest to the axis: the flank begins after it."""
        u = np.linspace(-1.2, 0.0, 12001)
        return u[np.argmin(self._polar(u))]

    @property
    def least_polar(self):
        return float(self._polar(self._lowest))

    def _path(self, u):
        c, s = np.cos(self.pressure_angle), np.sin(self.pressure_angle)
        scale = np.sqrt(1.0 - c**2 * np.sin(u) ** 2)
        return scale, c**2 * np.sin(u) * np.cos(u) / scale, -c * s * np.sin(u) / scale

    def _polar(self, u):
        x, _, z = self._path(u)
        return np.arccos(np.cos(self.pitch_angle) * x + np.sin(self.pitch_angle) * z)


def with_octoids(pair, members=("pinion", "gear")):
    """The mesh of a pair in which the flanks of some members are octoids of the same thickness and depth."""
    mesh = mesh_of(pair)
    changed = {}
    for name in members:
        gear, member = getattr(pair, name), getattr(mesh, name)
        flank = Octoid(
            pitch_angle=gear.pitch_cone_angle,
            pressure_angle=np.radians(gear.pressure_angle),
            thickness=gear.tooth.thickness,
            form=float(member.flank.form_angle(member.outer)),
            face=float(member.flank.face_angle(member.outer)),
        )
        flank = replace(flank, form=max(flank.form, flank.least_polar + _OFF_CUSP))
        changed[name] = replace(member, flank=flank)
    return replace(mesh, **changed)
