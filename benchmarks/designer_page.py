"""The designer page: what one change costs the server, how much it sends, and fifty people at once.

Replies are the shape of a design, from its parameters to the message that a browser draws, each time another module so
that nothing is remembered; CPU of the process, medians. Bytes a vertex are those of the second message, when the page
knows the topology, by all vertices that it then draws. Beside them what other pages send: a watertight mesh of the same
solids as glTF by trimesh, from meshes that exist already.

Fifty clients, each with a connection of its own to one server on the loopback, change a design every second or so for a
minute, as fifty people who pull at sliders: time to the shape and to the whole answer, and what failed. The clients run
in this process, on the same processors.

What limits us: half of a reply is the element's own checks and its boundary, in a thousand small numpy calls; it hardly
grows with the number of teeth or triangles, since one tooth stands for all.

    python benchmarks/designer_page.py [SECONDS]
"""

from __future__ import annotations

import asyncio
import json
import random
import re
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from timing import median_seconds

GOAL, BYTES = 0.040, 12.0
RUNS, CLIENTS = 9, 50
DESIGNS: dict[str, dict[str, Any]] = {
    "spur pair 17/40": {"element": "spur", "teeth": [17, 40], "module": 2.0, "face_width": 16},
    "helical gear z 24": {"element": "helical", "teeth": 24, "module": 2.0, "face_width": 60, "helix_angle": 35},
    "herringbone gear z 60": {
        "element": "herringbone",
        "teeth": 60,
        "module": 2.0,
        "face_width": 60,
        "helix_angle": 30,
    },
    "herringbone pair 30/60": {
        "element": "herringbone",
        "teeth": [30, 60],
        "module": 2.0,
        "face_width": 40,
        "helix_angle": 30,
    },
    "spiral bevel gear z 60": {
        "element": "bevel",
        "teeth": 60,
        "mate_teeth": 90,
        "module": 4.0,
        "face_width": 60,
        "trace": "logarithmic",
        "spiral_angle": 35,
    },
    "spiral bevel pair 16/24": {
        "element": "bevel",
        "teeth": [16, 24],
        "module": 4.0,
        "face_width": 20,
        "trace": "logarithmic",
        "spiral_angle": 35,
    },
    "cam": {
        "element": "cam",
        "programme": "dwell 36, rise 72, dwell 144, return 108",
        "follower": "translating-roller",
        "lift": 12.0,
        "base_radius": 25.0,
        "roller_radius": 8.0,
        "thickness": 12.0,
    },
}
cpu = partial(median_seconds, clock=time.process_time)


class Changing:
    """A design whose module, or thickness, grows by a little each time."""

    def __init__(self, design: dict[str, Any]):
        self._design, self._name = design, "module" if "module" in design else "thickness"
        self._times = 0

    def __call__(self) -> dict[str, Any]:
        self._times += 1
        return {**self._design, self._name: self._design[self._name] * (1.0 + 1e-5 * self._times)}


def shape(design: dict[str, Any], known: list[str] | None = None) -> bytes:
    """The first answer to a design."""
    from gearwright.designs.live import answers

    found = next(answers({"design": design, "have": known or []}))
    assert isinstance(found, bytes)
    return found


def header(message: bytes) -> dict[str, Any]:
    """What stands before the arrays."""
    return json.loads(message[4 : 4 + int.from_bytes(message[:4], "little")])


def as_glb(design: dict[str, Any]) -> tuple[float, float, int]:
    """Seconds for a glTF file of the polyhedra by trimesh, its bytes, and how many vertices it has."""
    import trimesh

    from gearwright.designs.design import design_of

    element, _ = design_of(design).element()
    parts = [element.pinion, element.gear] if isinstance(design.get("teeth"), list) else [element]
    meshes = [(p.vertices, p.simple_triangles()) for p in (part.polyhedron() for part in parts)]

    def export() -> bytes:
        scene = trimesh.Scene([trimesh.Trimesh(*mesh, process=False) for mesh in meshes])
        return scene.export(file_type="glb", include_normals=True)

    return cpu(export, 3), len(export()), sum(len(vertices) for vertices, _ in meshes)


def replies() -> None:
    """Prints a row a design."""
    print(f"shape of a design; the goal is {1e3 * GOAL:.0f} ms of CPU and {BYTES:.0f} bytes a vertex after the first")
    print(f"{'':24}{'ms':>7}{'triangles':>11}{'first kB':>10}{'next kB':>9}{'B/vertex':>10}   glTF: ms  B/vertex")
    for name, design in DESIGNS.items():
        changing = Changing(design)
        first = shape(design)
        shells = [shell for body in header(first)["bodies"] for shell in body["shells"]]
        then = shape(design, [shell["key"] for shell in shells])
        drawn = sum(shell["order"] * shell["vertices"] for shell in shells)
        seconds = cpu(lambda changing=changing: shape(changing()), RUNS)
        theirs, size, vertices = as_glb(design)
        print(
            f"{name:24}{1e3 * seconds:7.1f}{header(first)['triangles']:11d}{len(first) / 1e3:10.1f}"
            f"{len(then) / 1e3:9.1f}{len(then) / drawn:10.2f}{1e3 * theirs:11.1f}{size / vertices:10.1f}"
        )


@dataclass
class Told:
    """Seconds to shapes and to whole answers, asks that were overtaken, and what failed."""

    shapes: list[float] = field(default_factory=list)
    wholes: list[float] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)


async def person(address: str, design: dict[str, Any], seconds: float, told: Told, seed: int) -> None:
    """Changes a design every second or so, and waits for the answer before the next."""
    from websockets.asyncio.client import connect

    rng, changing = random.Random(seed), Changing(design)
    live = address.replace("http", "ws") + "api/live"
    async with connect(live, origin=address.rstrip("/"), max_size=None, proxy=None, compression=None) as socket:
        await asyncio.sleep(rng.random())
        ends, number, known = time.monotonic() + seconds, 0, []
        while time.monotonic() < ends:
            number += 1
            asked = time.monotonic()
            request = {"ask": "design", "id": number, "design": changing(), "material": "steel", "have": known}
            await socket.send(json.dumps(request))
            while True:
                answer = await asyncio.wait_for(socket.recv(), 120)
                if isinstance(answer, bytes):
                    told.shapes.append(time.monotonic() - asked)
                    known = [shell["key"] for body in header(answer)["bodies"] for shell in body["shells"]]
                    continue
                said = json.loads(answer)
                if said["answer"] == "done":
                    told.wholes.append(time.monotonic() - asked)
                    break
                if said["answer"] in ("failed", "refused"):
                    told.failures.append(answer)
                    break
            await asyncio.sleep(0.5 + rng.random())


async def people(address: str, seconds: float) -> Told:
    """Fifty of them at once."""
    told = Told()
    designs = list(DESIGNS.values())
    crowd = [person(address, designs[i % len(designs)], seconds, told, i) for i in range(CLIENTS)]
    for problem in await asyncio.gather(*crowd, return_exceptions=True):
        if problem is not None:
            told.failures.append(repr(problem))
    return told


def crowd(seconds: float) -> None:
    """Prints how fifty people fare with one server."""
    words = [sys.executable, "-m", "gearwright", "serve", "--port", "0"]
    server = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)  # noqa: S603  ours
    try:
        assert server.stdout is not None
        found = re.search(r"http:\S+/", server.stdout.readline())
        assert found is not None
        asyncio.run(people(found[0], 3.0))  # compiled code is loaded
        told = asyncio.run(people(found[0], seconds))
    finally:
        server.terminate()
        server.wait(20)
    print(f"\n{CLIENTS} clients for {seconds:.0f} s: {len(told.wholes)} answers, {len(told.failures)} failures")
    for name, times in (("shape", told.shapes), ("whole answer", told.wholes)):
        marks = statistics.quantiles(times, n=20)
        print(f"  {name:14} median {statistics.median(times):.2f} s, p95 {marks[18]:.2f} s, longest {max(times):.2f} s")
    for failure in told.failures[:5]:
        print("  ", failure[:200])


if __name__ == "__main__":
    replies()
    crowd(float(sys.argv[1]) if sys.argv[1:] else 60.0)
