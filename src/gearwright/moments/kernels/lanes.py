"""Four triangles at a time, in vector registers.

What a compiler makes of a loop over triangles is bound by gathering their corners one number at a time. Here each
corner is one load of four numbers, x y z and the one that follows in memory; four such loads are transposed in
registers to four x, four y, four z. That is worth a factor of two to three.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils

from .sums import LANES

_AHEAD = 512
"""Triangles by which the numbers of corners are asked for ahead of their use."""

_INT32, _INT64, _DOUBLE = ir.IntType(32), ir.IntType(64), ir.DoubleType()
_VECTOR = ir.VectorType(_DOUBLE, LANES)
_ANY_ORDER = ("contract", "reassoc", "nsz")
"""What plain arithmetic may be changed by: fused multiply-adds and another order of additions."""


class Lanes:
    """Four numbers in a register, with the operators of formulas.

    exactly   whether every operation is done as it is written, as error-free transformations need
    """

    def __init__(self, builder: Any, value: Any, exactly: bool):
        self.builder, self.value, self.exactly = builder, value, exactly

    def __add__(self, other: Lanes) -> Lanes:
        return self._like(self.builder.fadd(self.value, other.value, flags=self._flags))

    def __sub__(self, other: Lanes) -> Lanes:
        return self._like(self.builder.fsub(self.value, other.value, flags=self._flags))

    def __mul__(self, other: Lanes) -> Lanes:
        return self._like(self.builder.fmul(self.value, other.value, flags=self._flags))

    def __neg__(self) -> Lanes:
        return self._like(self.builder.fneg(self.value))

    def __abs__(self) -> Lanes:
        return self._called("fabs", self)

    def root(self) -> Lanes:
        return self._called("sqrt", self)

    def times_plus(self, factor: Lanes, summand: Lanes) -> Lanes:
        """The product with a factor plus a summand, rounded once."""
        return self._called("fma", self, factor, summand)

    @property
    def _flags(self) -> tuple[str, ...]:
        return () if self.exactly else _ANY_ORDER

    def _like(self, value: Any) -> Lanes:
        return Lanes(self.builder, value, self.exactly)

    def _called(self, name: str, *arguments: Lanes) -> Lanes:
        kind = ir.FunctionType(_VECTOR, [_VECTOR] * len(arguments))
        function = cgutils.get_or_insert_function(self.builder.module, kind, f"llvm.{name}.v{LANES}f64")
        return self._like(self.builder.call(function, [one.value for one in arguments]))


Vector = tuple[Lanes, Lanes, Lanes]


def adding(
    rows: int, take: Callable[[list[Lanes], Vector, Vector, Vector, Vector], Sequence[Lanes]], *, exactly: bool
) -> Callable[..., Any]:
    """What numba needs to know of a function that adds the terms of triangles `start` to `stop` to `sums` (4 rows,).

    take   gives the new sums in four lanes from the old, the corners a, b, c of four triangles and the origin

    The function takes vertices (n, 3) float64, triangles (m, 3) int32 or int64, start, stop, origin (3,), sums: all
    contiguous, stop − start a multiple of four. It reads eight bytes past every corner: no triangle may have the
    last vertex.
    """

    def typed(context: Any, vertices: Any, triangles: Any, start: Any, stop: Any, origin: Any, sums: Any) -> Any:
        return types.void(vertices, triangles, types.intp, types.intp, origin, sums), emitted

    def emitted(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        arrays = (0, 1, 4, 5)
        data = {k: context.make_array(signature.args[k])(context, builder, arguments[k]).data for k in arrays}
        points = builder.bitcast(data[0], _DOUBLE.as_pointer())
        places = [
            builder.bitcast(builder.gep(data[5], [_INT64(LANES * row)]), _VECTOR.as_pointer()) for row in range(rows)
        ]
        totals = [cgutils.alloca_once_value(builder, builder.load(place, align=8)) for place in places]
        x, y, z = (_splat(builder, builder.load(builder.gep(data[4], [_INT64(k)])), exactly) for k in range(3))
        with cgutils.for_range_slice(builder, arguments[2], arguments[3], _INT64(LANES), _INT64) as (first, _):
            _ask_for(builder, data[1], builder.mul(builder.add(first, _INT64(_AHEAD)), _INT64(3)))
            a, b, c = (_corners(builder, points, data[1], first, corner, exactly) for corner in range(3))
            so_far = [Lanes(builder, builder.load(total), exactly) for total in totals]
            for total, new in zip(totals, take(so_far, a, b, c, (x, y, z)), strict=True):
                builder.store(new.value, total)
        for place, total in zip(places, totals, strict=True):
            builder.store(builder.load(total), place, align=8)
        return context.get_dummy_value()

    typed.__module__ = take.__module__  # where the formulas stand: what was compiled depends on them
    return typed


def _ask_for(builder: Any, corners: Any, place: Any) -> None:
    """Asks for the vertex numbers that come later, so that they have left the memory when they are needed."""
    byte = ir.IntType(8).as_pointer()
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(ir.VoidType(), [byte, _INT32, _INT32, _INT32]), "llvm.prefetch.p0i8"
    )
    address = builder.bitcast(builder.gep(corners, [place]), byte)
    builder.call(function, [address, _INT32(0), _INT32(3), _INT32(1)])


def _splat(builder: Any, number: Any, exactly: bool) -> Lanes:
    alone = builder.insert_element(ir.Constant(_VECTOR, ir.Undefined), number, _INT32(0))
    return Lanes(builder, builder.shuffle_vector(alone, alone, _order(0, 0, 0, 0)), exactly)


def _order(*places: int) -> Any:
    return ir.Constant(ir.VectorType(_INT32, len(places)), list(places))


def _corners(builder: Any, points: Any, corners: Any, first: Any, corner: int, exactly: bool) -> Vector:
    """x, y, z of one corner of four triangles: four loads and a transposition."""
    rows = []
    for lane in range(LANES):
        place = builder.add(builder.mul(builder.add(first, _INT64(lane)), _INT64(3)), _INT64(corner))
        number = builder.load(builder.gep(corners, [place]))
        if number.type != _INT64:
            number = builder.sext(number, _INT64)
        point = builder.gep(points, [builder.mul(number, _INT64(3))])
        rows.append(builder.load(builder.bitcast(point, _VECTOR.as_pointer()), align=8))
    low, high = (builder.shuffle_vector(*pair, _order(0, 4, 2, 6)) for pair in (rows[:2], rows[2:]))
    x, z = (builder.shuffle_vector(low, high, _order(*places)) for places in ((0, 1, 4, 5), (2, 3, 6, 7)))
    low, high = (builder.shuffle_vector(*pair, _order(1, 5, 3, 7)) for pair in (rows[:2], rows[2:]))
    y = builder.shuffle_vector(low, high, _order(0, 1, 4, 5))
    return Lanes(builder, x, exactly), Lanes(builder, y, exactly), Lanes(builder, z, exactly)
