"""The sums over triangles from which the moments of a body follow.

With corners a, b, c relative to an origin, n = (b − a) × (c − a), d = a · n and s = a + b + c, they have these rows:

    0      Σ d                                          1–3    Σ d s
    4–9    Σ d (aaᵀ + bbᵀ + ccᵀ + ssᵀ), xx yy zz xy yz zx
    10–12  Σ n                                          13     Σ |n|, or of a polygon |Σ n| over its fan
    14     Σ |d|′                                       15     Σ |d|′ tr(aaᵀ + bbᵀ + ccᵀ + ssᵀ)

|d|′ is the sum of the magnitudes of the six products of which d consists, so that it tells how much these cancel, as
in a sliver across the axes. The first ten rows give V, q and S; the next four closure and area; the last two how
much all terms cancel.
A sum is kept as two numbers, high and low, whose exact sum is known to about 32 digits: blocks of triangles are
added in plain arithmetic, blocks to each other without loss. So it does not matter how the blocks are grouped.
"""

from __future__ import annotations

from ...arrays import Array
from ...compiled import compiled
from .pairs import two_sum

ROWS = 16
RUN = 32
"""Terms that are added to each other in plain arithmetic, one after the other."""

LANES = 4
"""Triangles that are taken at a time, each adding to sums of its own: see `lanes`."""

BLOCK = LANES * RUN
"""Triangles of a run in each of four lanes."""


@compiled
def take(high: Array, low: Array, block: Array) -> None:
    """Adds a block's sums (16,), and sets them to nought."""
    for row in range(ROWS):
        high[row], error = two_sum(high[row], block[row])
        low[row] += error
        block[row] = 0.0


@compiled
def take_lanes(highs: Array, lows: Array, block: Array) -> None:
    """Adds a block's sums in lanes (64,), row after row, to sums in lanes, and sets them to nought."""
    for k in range(LANES * ROWS):
        total = highs[k] + block[k]
        part = total - highs[k]
        lows[k] += (highs[k] - (total - part)) + (block[k] - part)
        highs[k] = total
        block[k] = 0.0


@compiled
def join_lanes(high: Array, low: Array, highs: Array, lows: Array) -> None:
    """Adds sums in lanes (64,) to sums (16,)."""
    for k in range(LANES * ROWS):
        row = k // LANES
        high[row], error = two_sum(high[row], highs[k])
        low[row] += error + lows[k]


@compiled
def add_triangle(vertices: Array, i: int, j: int, k: int, origin: Array, block: Array) -> tuple[float, float, float]:
    """Adds the terms of one triangle, all but |n|, and gives n."""
    ax, ay, az = vertices[i, 0] - origin[0], vertices[i, 1] - origin[1], vertices[i, 2] - origin[2]
    bx, by, bz = vertices[j, 0] - origin[0], vertices[j, 1] - origin[1], vertices[j, 2] - origin[2]
    cx, cy, cz = vertices[k, 0] - origin[0], vertices[k, 1] - origin[1], vertices[k, 2] - origin[2]
    ux, uy, uz = vertices[j, 0] - vertices[i, 0], vertices[j, 1] - vertices[i, 1], vertices[j, 2] - vertices[i, 2]
    vx, vy, vz = vertices[k, 0] - vertices[i, 0], vertices[k, 1] - vertices[i, 1], vertices[k, 2] - vertices[i, 2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = (
        abs(ax) * (abs(uy * vz) + abs(uz * vy))
        + abs(ay) * (abs(uz * vx) + abs(ux * vz))
        + abs(az) * (abs(ux * vy) + abs(uy * vx))
    )
    d = ax * nx + ay * ny + az * nz
    sx, sy, sz = ax + bx + cx, ay + by + cy, az + bz + cz
    xx, yy, zz = (
        ax * ax + bx * bx + cx * cx + sx * sx,
        ay * ay + by * by + cy * cy + sy * sy,
        az * az + bz * bz + cz * cz + sz * sz,
    )
    block[0] += d
    block[1] += d * sx
    block[2] += d * sy
    block[3] += d * sz
    block[4] += d * xx
    block[5] += d * yy
    block[6] += d * zz
    block[7] += d * (ax * ay + bx * by + cx * cy + sx * sy)
    block[8] += d * (ay * az + by * bz + cy * cz + sy * sz)
    block[9] += d * (az * ax + bz * bx + cz * cx + sz * sx)
    block[10] += nx
    block[11] += ny
    block[12] += nz
    block[14] += size
    block[15] += size * (xx + yy + zz)
    return nx, ny, nz
