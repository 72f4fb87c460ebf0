"""Moments of a swept solid straight from the moments of its section."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array
from .matrix import moment_matrix


def straight_sweep(section: Array, length: float) -> Array:
    """Moment matrix (4, 4), about the middle of the length, of a plane section extruded along z.

    section   (4, 4)  m[a, b] = ∫ x^a y^b dA

    Source: Al-Daccak 1989, eq. (5.15); here (S1) with the origin at mid-length, where nothing cancels.
    """
    m = section
    first = length * np.array([m[1, 0], m[0, 1], 0.0])
    second = np.zeros((3, 3))
    second[:2, :2] = length * np.array([[m[2, 0], m[1, 1]], [m[1, 1], m[0, 2]]])
    second[2, 2] = m[0, 0] * length**3 / 12.0
    return moment_matrix(length * m[0, 0], first, second)


def parallel_sweep(section: Array, linear: Array, shifts: Array, weights: Array) -> Array:
    """Moment matrix (4, 4) of a plane section swept through planes of constant z: a quadrature of (S1).

    section   (3, 3)     moment matrix of the section about a point of its own
    linear    (n, 2, 2)  the section's linear map at each node
    shifts    (n, 3)     where that point of the section is at each node, from the origin of the moments
    weights   (n,)       weights of the nodes, times det A

    M = ∫ det A T M₂ Tᵀ dξ with T = [1 0; shift (A; 0)]. Source: Al-Daccak 1989, eqs. (5.3)–(5.13).
    """
    transforms = np.zeros((len(weights), 4, 3))
    transforms[:, 0, 0] = 1.0
    transforms[:, 1:, 0] = shifts
    transforms[:, 1:3, 1:] = linear
    return np.einsum("n,nij,jk,nlk->il", weights, transforms, section, transforms)


def revolution_sweep(section: Array, start: float, stop: float) -> Array:
    """Moment matrix (4, 4) of a section of the half-plane (ρ, z), ρ ≥ 0, revolved about z from azimuth start to stop.

    section   (4, 4)  m[a, b] = ∫ ρ^a z^b dA; orders to 3 enter, since the volume element is ρ dρ dz dφ

    Source: Pappus, and Al-Daccak 1989, ch. 5, in cylindrical coordinates.
    """
    m = section
    angle = stop - start
    turn1 = _turn_integral(1, start, stop)
    turn2 = _turn_integral(2, start, stop)
    first = np.array([m[2, 0] * turn1.real, m[2, 0] * turn1.imag, m[1, 1] * angle])
    mean, double = m[3, 0] * angle / 2.0, m[3, 0] * turn2 / 2.0
    xz, yz = m[2, 1] * turn1.real, m[2, 1] * turn1.imag
    second = np.array(
        [
            [mean + double.real, double.imag, xz],
            [double.imag, mean - double.real, yz],
            [xz, yz, m[1, 2] * angle],
        ]
    )
    return moment_matrix(m[1, 0] * angle, first, second)


def _turn_integral(j: int, start: float, stop: float) -> complex:
    """∫ e^{ijφ} dφ between two azimuths; exactly nought over a whole turn."""
    if abs(abs(stop - start) - 2.0 * np.pi) < 4.0 * np.finfo(float).eps * np.pi:
        return 0j
    half, middle = (stop - start) / 2.0, (stop + start) / 2.0
    return complex(2.0 * np.sin(j * half) / j * np.exp(1j * j * middle))


def radial_sweep(section: Array, radial_integral: Callable[[int, int], complex]) -> Array:
    """Moment matrix (4, 4) about the apex of a region of the unit sphere swept radially and turned about z.

    section           (4, 4)  [Ω Nᵀ; N Q] of the region
    radial_integral   (p, j) → ∫ r^p e^{ijw(r)} dr over the sweep, w(r) the rotation about z

    V = ∫ r² dr Ω,  q = ∫ r³ R_z(w) dr N,  S = ∫ r⁴ R_z(w) Q R_z(w)ᵀ dr  (S2), with the components
    transverse to z in complex form, which a turn by w multiplies by e^{iw} and e^{2iw}.
    """
    solid_angle, first, second = section[0, 0], section[0, 1:], section[1:, 1:]
    across = radial_integral(3, 1) * complex(first[0], first[1])
    mixed = radial_integral(4, 1) * complex(second[0, 2], second[1, 2])
    double = radial_integral(4, 2) * complex(second[0, 0] - second[1, 1], 2.0 * second[0, 1]) / 2.0
    fourth = radial_integral(4, 0).real
    mean = fourth * (second[0, 0] + second[1, 1]) / 2.0
    swept_first = np.array([across.real, across.imag, radial_integral(3, 0).real * first[2]])
    swept_second = np.array(
        [
            [mean + double.real, double.imag, mixed.real],
            [double.imag, mean - double.real, mixed.imag],
            [mixed.real, mixed.imag, fourth * second[2, 2]],
        ]
    )
    return moment_matrix(radial_integral(2, 0).real * solid_angle, swept_first, swept_second)
