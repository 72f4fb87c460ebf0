"""Accessors of a glTF file: arrays of numbers in its buffers."""

from __future__ import annotations

from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from ..text.places import shown
from .buffers import Buffers, chosen
from .document import Value

MOST_ELEMENTS = 100_000_000
"""Elements of all accessors read: many may lie over the same bytes, or over none."""

_COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_INDICES = (5121, 5123, 5125)
_POSITIONS = (5120, 5121, 5122, 5123, 5126)

Numbers = NDArray[Any]


@final
class Accessors:
    """Arrays by the numbers of their accessors."""

    def __init__(self, found: Value, buffers: Buffers):
        self._listed = found.items("accessors")
        self._buffers = buffers
        self._elements = 0
        self._kept: dict[tuple[int, bool], Numbers] = {}

    def positions(self, asking: Value) -> tuple[Numbers, float]:
        """Points (n, 3), single precision or double where they are whole numbers in the file, and their rounding.

        KHR_mesh_quantization: whole numbers, and normalised ones c / (2ᵇ − 1), of b bits, or max(c / (2ᵇ⁻¹ − 1), −1).
        Raises FileError where the accessor is no such array in its buffer, or a point is not finite.
        """
        accessor = chosen(self._listed, asking, "POSITION", "accessors")
        raw = self._array(asking.whole("POSITION"), accessor, "VEC3", _POSITIONS)
        if raw.dtype.kind == "f":
            bad = np.flatnonzero(~np.isfinite(raw).all(axis=1))
            if len(bad):
                raise accessor.error(f"point {bad[0]} is not finite: {raw[bad[0]].tolist()}; export the scene again")
            largest = np.abs(raw).max(initial=np.float32(0))
            return raw, float(np.spacing(largest)) / 2.0
        if not accessor.flag("normalized"):
            return raw.astype(np.float64), 0.5
        most = float(np.iinfo(raw.dtype).max)
        return np.maximum(raw / most, -1.0), 0.5 / most

    def indices(self, asking: Value) -> Numbers:
        """Whole numbers (n,). Raises FileError where the accessor is no such array in its buffer."""
        accessor = chosen(self._listed, asking, "indices", "accessors")
        return self._array(asking.whole("indices"), accessor, "SCALAR", _INDICES).reshape(-1).astype(np.int64)

    def _array(self, number: int, accessor: Value, shape: str, allowed: tuple[int, ...]) -> Numbers:
        key = (number, shape == "SCALAR")
        if key not in self._kept:
            self._kept[key] = self._read(accessor, shape, allowed)
        return self._kept[key]

    def _read(self, accessor: Value, shape: str, allowed: tuple[int, ...]) -> Numbers:
        given = accessor.text("type")
        if given != shape:
            raise accessor.error(f'is of type "{shown(given, 20)}"; {shape} is needed here')
        dtype = _dtype(accessor, allowed)
        count = accessor.whole("count", least=1)
        self._elements += count
        if self._elements > MOST_ELEMENTS:
            raise accessor.error(
                f"accessors of more than {MOST_ELEMENTS} elements, the most that are read; split the file"
            )
        if "bufferView" in accessor:
            result = self._strided(accessor, "bufferView", dtype, _WIDTHS[shape], count)
        else:
            result = np.zeros((count, _WIDTHS[shape]), dtype=dtype)
        if "sparse" in accessor:
            result = self._replaced(accessor.member("sparse"), result)
        return result

    def _strided(self, asking: Value, key: str, dtype: np.dtype[Any], width: int, count: int) -> Numbers:
        """Elements (count, width) that start at the member `byteOffset` of a view."""
        data, stride = self._buffers.view(asking, key)
        start, size = asking.whole("byteOffset", 0), dtype.itemsize * width
        stride = stride or size
        if stride < size or start + stride * (count - 1) + size > len(data):
            raise asking.error(
                f"{count} elements of {size} bytes, {stride} apart from byte {start}, do not fit into the"
                f" {len(data)} bytes of their view; the file is damaged"
            )
        return np.ndarray((count, width), dtype, data, start, (stride, dtype.itemsize))

    def _replaced(self, sparse: Value, result: Numbers) -> Numbers:
        """An array with some elements replaced."""
        count = sparse.whole("count", least=1, most=len(result))
        where, values = sparse.member("indices"), sparse.member("values")
        places = self._strided(where, "bufferView", _dtype(where, _INDICES), 1, count).reshape(-1).astype(np.int64)
        if places.max() >= len(result):
            raise where.error(f"element {places.max()} is replaced, and there are {len(result)}, numbered from 0")
        result = result.copy()
        result[places] = self._strided(values, "bufferView", result.dtype, result.shape[1], count)
        return result


def _dtype(asking: Value, allowed: tuple[int, ...]) -> np.dtype[Any]:
    kind = asking.whole("componentType")
    if kind not in allowed:
        raise asking.error(f"componentType is {kind}; one of {', '.join(map(str, allowed))} is needed here")
    return np.dtype(_COMPONENTS[kind])
