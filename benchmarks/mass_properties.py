"""Full moments of triangle meshes beside other libraries, and beside reading the same bytes once.

For 20 thousand to 10 million triangles of a torus: volume, centroid, inertia, closure residual and area by
`gw.mass_properties`, on one thread and on all; what libigl, trimesh, VTK, pymeshlab and manifold3d take for what they
have of it, those that are installed (`pip install -e '.[bench]'`). Then a call for 12 triangles, and a binary STL file
from the disk, streamed beside loaded by trimesh, each in a process of its own, with its peak memory.

All take their turn in every round, so that a busy machine is unjust to none; medians are printed.
"""

from __future__ import annotations

import gc
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numba import njit

import gearwright as gw
from gearwright.files.stl import writer as stl
from gearwright.moments.summation import processors

SHAPES = {20_000: (100, 100), 200_000: (400, 250), 2_000_000: (1000, 1000), 10_000_000: (2500, 2000)}
TURN = 0.05
"""Seconds of one's turn: long enough that a sleeping processor is awake, caches are filled and clocks are up."""

SLOW = 200_000
"""Triangles above which a peer that takes more than a microsecond for each is not asked again."""


def torus(around: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (n, 3) and triangles (2n, 3), int32."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    ring = 2.0 + np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    return vertices, np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3).astype(np.int32)


@njit(nogil=True, fastmath=True)
def _read(numbers: np.ndarray) -> int:
    total = np.uint64(0)
    for k in range(len(numbers)):
        total ^= numbers[k]
    return total


def contenders(vertices: np.ndarray, triangles: np.ndarray) -> dict[str, Callable[[], object]]:
    """What is timed, by name; objects that a library needs are made before."""
    words = [np.ascontiguousarray(array).reshape(-1).view(np.uint64) for array in (vertices, triangles)]
    found: dict[str, Callable[[], object]] = {
        "reading the bytes once, 1 thread": lambda: [_read(array) for array in words],
        "gearwright, 1 thread": lambda: gw.mass_properties(vertices, triangles, threads=1),
        f"gearwright, {processors()} threads": lambda: gw.mass_properties(vertices, triangles),
    }
    if find_spec("igl"):
        import igl

        found["libigl moments"] = lambda: igl.moments(vertices, triangles)
    if len(triangles) > 2_000_000:
        return found
    found |= _with_objects(vertices, triangles)
    return found


def _with_objects(vertices: np.ndarray, triangles: np.ndarray) -> dict[str, Callable[[], object]]:
    found: dict[str, Callable[[], object]] = {}
    if find_spec("trimesh"):
        import trimesh

        found["trimesh mass_properties"] = lambda: trimesh.triangles.mass_properties(vertices[triangles])
    if find_spec("manifold3d"):
        import manifold3d

        body = manifold3d.Manifold(manifold3d.Mesh64(vertices, triangles.astype(np.uint64)))
        found["manifold3d volume alone"] = lambda: body.translate((0, 0, 0)).volume()
    if find_spec("vtk"):
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        from vtkmodules.vtkFiltersCore import vtkMassProperties

        points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetData(numpy_to_vtk(vertices, deep=True))
        cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.reshape(-1).astype(np.int64), deep=True))
        mesh.SetPoints(points)
        mesh.SetPolys(cells)

        def volume() -> float:
            measure = vtkMassProperties()
            measure.SetInputData(mesh)
            return measure.GetVolume()

        found["VTK volume and area alone"] = volume
    if find_spec("pymeshlab") and len(triangles) <= SLOW:
        import pymeshlab

        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, triangles))
        found["pymeshlab get_geometric_measures"] = meshes.get_geometric_measures
    return found


def medians(actions: dict[str, Callable[[], object]], rounds: int) -> dict[str, float]:
    """Median seconds of each over rounds in which all have their turn: a rest, a warming up, then TURN seconds."""
    times: dict[str, list[float]] = {name: [] for name in actions}
    for _ in range(rounds):
        for name, action in actions.items():
            time.sleep(0.02)  # threads of the one before may still wait for work, and take a core for that
            action()
            end = time.perf_counter() + TURN
            while time.perf_counter() < end:
                start = time.perf_counter()
                action()
                times[name].append(time.perf_counter() - start)
    return {name: statistics.median(those) for name, those in times.items()}


def compare_in_memory() -> None:
    """Prints millions of triangles a second, and ratios to one thread of ours."""
    for count, shape in SHAPES.items():
        actions = contenders(*torus(*shape))
        found = medians(actions, 7 if count <= SLOW else 4)
        own = found["gearwright, 1 thread"]
        print(f"\n{count} triangles                        ms      Mtri/s    × ours on 1 thread")
        for name, seconds in sorted(found.items(), key=lambda item: item[1]):
            print(f"  {name:34} {1e3 * seconds:9.3f} {count / seconds / 1e6:9.1f} {seconds / own:9.2f}")
        del actions
        gc.collect()


def compare_calls() -> None:
    """Prints what one call for 12 triangles costs."""
    corners = np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = np.array([[q[0], q[k], q[k + 1]] for q in quads for k in (1, 2)])
    actions: dict[str, Callable[[], object]] = {"gearwright": lambda: gw.mass_properties(corners, triangles)}
    if find_spec("igl"):
        import igl

        actions["libigl"] = lambda: igl.moments(corners, triangles)
    if find_spec("trimesh"):
        import trimesh

        actions["trimesh"] = lambda: trimesh.triangles.mass_properties(corners[triangles])
    print("\n12 triangles: microseconds a call")
    for name, action in actions.items():
        seconds = medians({name: lambda action=action: [action() for _ in range(200)]}, 15)[name] / 200
        print(f"  {name:34} {1e6 * seconds:9.2f}")


_OURS = "import gearwright as gw; m = gw.stream_properties(path); volume = m.volume"
_TRIMESH = "import trimesh; m = trimesh.load(path).mass_properties; volume = m.volume"
_TIMED = """
import sys, time
path = sys.argv[1]
{imports}
start = time.perf_counter()
{work}
seconds = time.perf_counter() - start
peak = [line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")]
print(seconds, int(peak[0]) / 1024, volume)
"""


def _timed(work: str, path: Path) -> tuple[float, float, float]:
    """Seconds after imports, peak MiB and volume, in a process of its own; the second of two runs."""
    imports, _, rest = work.partition("; ")
    code = _TIMED.format(imports=imports, work=rest)
    for _ in range(2):
        done = subprocess.run(  # noqa: S603  our own interpreter and code
            [sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=True
        )
    seconds, memory, volume = map(float, done.stdout.split())
    return seconds, memory, volume


def compare_files() -> None:
    """Prints seconds and peak memory for a binary STL file from the disk."""
    with tempfile.TemporaryDirectory() as folder:
        for count in (2_000_000, 10_000_000):
            path = Path(folder) / f"{count}.stl"
            stl.write(path, *torus(*SHAPES[count]))
            print(f"\nbinary STL, {count} triangles, {path.stat().st_size / 1e6:.0f} MB      s     peak MiB   volume")
            peers = {"gearwright, streamed": _OURS}
            if find_spec("trimesh") and count <= 2_000_000:
                peers["trimesh load + mass_properties"] = _TRIMESH
            for name, work in peers.items():
                seconds, memory, volume = _timed(work, path)
                print(f"  {name:34} {seconds:9.3f} {memory:9.0f}   {volume:.9f}")


if __name__ == "__main__":
    compare_in_memory()
    compare_calls()
    compare_files()
