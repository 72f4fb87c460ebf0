"""Moments of a swept solid straight from the moments of its section."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from math import factorial, sin

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


def plane_sweep(section: Array, places: Array, axes: Array, elements: Array) -> Array:
    """Moment matrices (n, 4, 4) per unit of the motion's parameter of a plane section moved in any way.

    section    (4, 4) or (n, 4, 4)  m[a, b] = ∫ x^a y^b dA about a point of its own, to order 3; many, if it varies
    places     (n, 3)     where that point is, from the origin of the moments
    axes       (n, 3, 2)  what the motion makes of the section's x and y
    elements   (n, 3)     the volume element J = j₀ + j_x x + j_y y, linear in the section point

    dM = T ∫ (j₀ + j_x x + j_y y) h hᵀ dA Tᵀ with h = (1, x, y) and T = [1 0; place axes]: section moments of order 3
    enter where the planes are not parallel. Source: Al-Daccak 1989, eqs. (5.3)–(5.13), there for parallel planes.
    """
    m = section
    transforms = np.zeros((len(places), 4, 3))
    transforms[:, 0, 0] = 1.0
    transforms[:, 1:, 0] = places
    transforms[:, 1:, 1:] = axes
    products = np.stack([_products(m, 0, 0), _products(m, 1, 0), _products(m, 0, 1)], axis=-3)
    weighted = np.einsum("...k,...kij->...ij", elements, products)
    return transforms @ weighted @ np.swapaxes(transforms, 1, 2)


def _products(m: Array, a: int, b: int) -> Array:
    """∫ x^a y^b h hᵀ dA (..., 3, 3) with h = (1, x, y)."""
    powers = ((0, 0), (1, 0), (0, 1))
    rows = [np.stack([m[..., a + i + k, b + j + n] for k, n in powers], axis=-1) for i, j in powers]
    return np.stack(rows, axis=-2)


def extrusion_sweep(
    section: Array,
    centre: complex,
    scales: Sequence[Sequence[float]],
    turn: complex,
    twist: float,
    skew: complex,
    half: float,
) -> Array:
    """Moment matrix (4, 4) of a plane section twisted, scaled and skewed evenly, about the axis at mid-height.

    section   (4, 4)  m[a, b] = ∫ x^a y^b dA about a point of its own
    centre    that point, x + iy from the axis
    scales    of x and of y: each at mid-height, and what it grows by from there to the end
    turn      e^{iφ} of the angle φ at mid-height
    twist     angle from mid-height to the end, radians
    skew      offset (x + iy) from mid-height, where there is none, to the end
    half      half the height

    With s from −1 to 1 a section point goes to turn e^{i twist s} (s_x x + i s_y y) + skew s at height half s, so that
    every entry of the matrix is a sum of polynomials in s times 1, e^{i twist s} or e^{2i twist s}: closed form.
    Source: Al-Daccak 1989, eqs. (5.17), (5.19)–(5.20), here all together.
    """
    # numbers and short lists: arrays so small would spend their time on themselves
    m, x, y = section.tolist(), centre.real, centre.imag
    along, across = scales
    area, mx, my = m[0][0], m[1][0] + m[0][0] * x, m[0][1] + m[0][0] * y
    xx = m[2][0] + x * (m[1][0] + mx)
    yy = m[0][2] + y * (m[0][1] + my)
    xy = m[1][1] + x * m[0][1] + y * mx
    element = [half * c for c in _product(along, across)]
    first = _product(element, [mx * a + 1j * my * b for a, b in zip(along, across, strict=True)])
    norms = [xx * c for c in _product(along, along)], [yy * c for c in _product(across, across)]
    mixture = [2j * xy * c for c in _product(along, across)]
    square = _product(element, [a - b + c for a, b, c in zip(*norms, mixture, strict=True)])
    once, twice = _harmonic_integrals(twist), _harmonic_integrals(2.0 * twist)
    volume, level, levels = (area * _integral(element, _STILL, power).real for power in range(3))
    turned, climbed = (turn * _integral(first, once, power) for power in range(2))
    mean = _integral(_product(element, [a + b for a, b in zip(*norms, strict=True)]), _STILL).real
    mean += 2.0 * (skew.conjugate() * climbed).real + abs(skew) ** 2 * levels
    double = turn**2 * _integral(square, twice) + 2.0 * skew * climbed + skew**2 * levels
    transverse = turned + skew * level
    mixed = half * (climbed + skew * levels)
    return np.array(
        [
            [volume, transverse.real, transverse.imag, half * level],
            [transverse.real, (mean + double.real) / 2.0, double.imag / 2.0, mixed.real],
            [transverse.imag, double.imag / 2.0, (mean - double.real) / 2.0, mixed.imag],
            [half * level, mixed.real, mixed.imag, half**2 * levels],
        ]
    )


_ORDERS = 5  # powers of s that occur: the element's 2 and 2 of coordinates
_SERIES = 3.0  # below this angle the power series, above it the recurrence keeps every digit
_TERMS = 30  # 3^30 / 30! is 1e-18
_INVERSE_POWERS = np.array(
    [[2.0 / (factorial(n) * (k + n + 1)) if (k + n) % 2 == 0 else 0.0 for n in range(_TERMS)] for k in range(_ORDERS)]
)
"""2/(n! (k + n + 1)) where k + n is even: the coefficients of (i angle)^n."""
_STILL = [2.0 / (k + 1) if k % 2 == 0 else 0.0 for k in range(_ORDERS)]
"""∫ s^k ds from −1 to 1."""


def _product(a: Sequence[complex], b: Sequence[complex]) -> list[complex]:
    """Coefficients of the product of two polynomials."""
    found: list[complex] = [0.0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            found[i + j] += x * y
    return found


def _integral(polynomial: Sequence[complex], harmonics: Sequence[complex], power: int = 0) -> complex:
    """∫ polynomial(s) s^power e^{i angle s} ds from −1 to 1, from the integrals of the powers."""
    return sum((c * h for c, h in zip(polynomial, harmonics[power:], strict=False)), start=0j)


def _harmonic_integrals(angle: float) -> list[complex]:
    """∫ s^k e^{i angle s} ds from −1 to 1, for k from 0 to 4."""
    if abs(angle) < _SERIES:
        found: list[complex] = (_INVERSE_POWERS @ (1j * angle) ** np.arange(_TERMS)).tolist()
        return found
    end = cmath.exp(1j * angle)
    found = [2.0 * sin(angle) / angle]
    for k in range(1, _ORDERS):
        found.append((end - (-1) ** k * end.conjugate() - k * found[-1]) / (1j * angle))
    return found


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
