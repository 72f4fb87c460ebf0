"""Bevel pairs from nothing to STEP files, beside py-gearworks and build123d; STL files beside trimesh and numpy-stl.

A 16/20 pair, module 12.7 mm, 38.1 mm wide, straight and spiral by 35°: both members built and written to one STEP
file, after everything is imported. Both files are read again: whether Open CASCADE finds their solids valid; how far
ours are from the exact volumes (the peer's pair has other ends and no exact volume). STL is a spiral gear in about
100,000 triangles, written only.

All times are CPU seconds, medians. What limits us: a tenth is the pair itself, about two thirds are splines and
their edges and faces, the rest is Open CASCADE's writing. What limits the peer: splines fitted and sewn.

    python benchmarks/cad_exchange.py [PYTHON]

PYTHON is an interpreter that has py-gearworks, where this one has not.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from bevel_pair import ALIKE, peer_parts
from timing import median_seconds, of_peer

GOALS = {"16/20 straight": 0.5, "16/20 spiral 35°": 1.5, "STL": 0.03}
STL_TOLERANCE = 0.021  # mm: 100,000 triangles
RUNS, PEER_RUNS = 5, 3
cpu = partial(median_seconds, clock=time.process_time)


def write_pair(sizes: dict[str, Any], path: Path) -> None:
    """Both members to one file, from nothing."""
    from gearwright import BevelPair

    BevelPair(**sizes).save(path)


def write_peer_pair(sizes: dict[str, Any], path: Path) -> None:
    """The same by py-gearworks, which has no pairs but gears."""
    import build123d

    build123d.export_step(build123d.Compound(children=peer_parts(sizes)), path)


def peer() -> dict[str, Any]:
    """Seconds, kilobytes and valid solids of each pair."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "pair.step"
        for name, sizes in ALIKE.items():
            seconds = cpu(lambda sizes=sizes: write_peer_pair(sizes, path), PEER_RUNS)
            found[name] = (seconds, path.stat().st_size / 1e3, [valid for valid, _ in solids_in(path)])
    return found


def solids_in(path: Path) -> Iterator[tuple[bool, float]]:
    """Of each solid of a STEP file, whether Open CASCADE finds it valid, and its volume."""
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_SOLID
    from OCP.TopExp import TopExp_Explorer

    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    solids = TopExp_Explorer(reader.OneShape(), TopAbs_SOLID)
    while solids.More():
        properties = GProp_GProps()
        BRepGProp.VolumePropertiesGK_s(solids.Current(), properties, 1e-9, False, True, False, False)
        yield BRepCheck_Analyzer(solids.Current()).IsValid(), properties.Mass()
        solids.Next()


def step_files(folder: Path, theirs: dict[str, Any]) -> None:
    """Prints times, sizes and what is in the files."""
    from gearwright import BevelPair

    path = folder / "pair.step"
    print(f"{'STEP, both members':<22}{'Gearwright':>12}{'goal':>9}{'py-gearworks':>15}{'ratio':>8}")
    for name, sizes in ALIKE.items():
        ours = cpu(lambda sizes=sizes: write_pair(sizes, path), RUNS)
        slow, kilobytes, sound = theirs[name]
        print(f"{name:<22}{ours:>10.2f} s{GOALS[name]:>7.1f} s{slow:>13.2f} s{slow / ours:>7.1f}×")
        pair = BevelPair(**sizes)
        errors = []
        for (valid, volume), member in zip(solids_in(path), (pair.pinion, pair.gear), strict=True):
            assert valid
            errors.append(abs(volume / member.properties().volume - 1.0))
        own = path.stat().st_size / 1e3
        print(
            f"    {own:.0f} kB, valid, volumes within {max(errors):.0e}; the peer's {kilobytes:.0f} kB, valid: {sound}"
        )


def stl_files(folder: Path) -> None:
    """Prints times of writing triangles that are there."""
    from gearwright import BevelPair

    gear = BevelPair(**ALIKE["16/20 spiral 35°"]).gear
    body, path = gear.polyhedron(STL_TOLERANCE), folder / "gear.stl"
    triangles = body.triangles()
    ways = {"Gearwright": lambda: body.save(path), **stl_peers(body.vertices, triangles, path)}
    print(f"STL of {len(triangles)} triangles, goal {GOALS['STL'] * 1e3:.0f} ms")
    ours = None
    for name, way in ways.items():
        seconds = cpu(way, 3 * RUNS)
        ours = ours or seconds
        kilobytes = path.stat().st_size / 1e3
        print(f"    {name:<18}{seconds * 1e3:>8.1f} ms{seconds / ours:>7.1f}×{kilobytes:>10.0f} kB")


def stl_peers(vertices: Any, triangles: Any, path: Path) -> dict[str, Any]:
    """What other libraries take for it, their meshes made beforehand."""
    found: dict[str, Any] = {}
    if find_spec("trimesh"):
        import trimesh

        mesh = trimesh.Trimesh(vertices, triangles, process=False)
        found["trimesh"] = lambda: mesh.export(path)
    if find_spec("stl"):
        import numpy as np
        import stl.mesh

        solid = stl.mesh.Mesh(np.zeros(len(triangles), dtype=stl.mesh.Mesh.dtype))
        solid.vectors[:] = vertices[triangles]
        found["numpy-stl"] = lambda: solid.save(str(path))
    return found


def main() -> None:
    """Prints medians and ratios."""
    found = of_peer(__file__, peer)
    with tempfile.TemporaryDirectory() as folder:
        step_files(Path(folder), found)
        stl_files(Path(folder))


if __name__ == "__main__":
    main()
