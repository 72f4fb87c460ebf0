"""A spur gear's outline of some 400 corners, 50 mm long, twisted by 20°: volume and inertia beside meshing peers.

manifold3d extrudes with a twist in so many layers, trimesh sweeps the polygon along a straight path with angles; both
then take the properties of the mesh. They are given as many layers as the error asks for. Gearwright's closed form has
no layers; its polyhedra are made of the same corners.
"""

from __future__ import annotations

import math

import manifold3d
import numpy as np
import shapely
import trimesh
from timing import median_seconds

import gearwright as gw
from gearwright.boundary.sampling import fixed_sampling
from gearwright.boundary.tessellation import tessellate

LENGTH, TWIST = 50.0, 20.0
ERRORS = (1e-4, 1e-5, 1e-6)
MOST_LAYERS = 1 << 13


def corners() -> np.ndarray:
    """Corners (384, 2) on the outline of the 16-tooth gear, module 8."""
    loop = gw.SpurGear(teeth=16, module=8.0, face_width=LENGTH).solid.section.loops[0].with_copies(1)
    fractions = np.arange(4) / 4.0
    return np.concatenate([curve.point(curve.parameter(fractions)) for curve in loop.curves])


def manifold_properties(points: np.ndarray, layers: int) -> np.ndarray:
    """Volume alone: manifold3d has no inertia."""
    section = manifold3d.CrossSection([points])
    body = manifold3d.Manifold.extrude(section, LENGTH, n_divisions=layers - 1, twist_degrees=TWIST)
    return np.array([body.volume()])


def trimesh_properties(points: np.ndarray, layers: int) -> np.ndarray:
    """Volume and inertia about the axis."""
    heights = np.linspace(0.0, LENGTH, layers + 1)
    path = np.stack([np.zeros_like(heights), np.zeros_like(heights), heights], axis=-1)
    angles = np.linspace(0.0, math.radians(TWIST), layers + 1)
    body = trimesh.creation.sweep_polygon(shapely.Polygon(points), path, angles=angles)
    return np.array([body.volume, body.moment_inertia[2, 2]])


def polyhedron_properties(section: gw.Section, layers: int) -> np.ndarray:
    """Volume and inertia about the axis of our polyhedron with the same corners."""
    boundary = gw.extrude(section, LENGTH, twist=TWIST).boundary
    cut = fixed_sampling(boundary, across=1, layers=layers, tolerance=1.0)
    found = gw.Polyhedron(*tessellate(boundary, cut)).properties()
    return np.array([found.volume, found.inertia[2, 2]])


def exact_properties(section: gw.Section) -> gw.MassProperties:
    """The closed form, from the built section."""
    return gw.extrude(section, LENGTH, twist=TWIST).properties()


def layers_for(properties: object, exact: np.ndarray, error: float) -> int | None:
    """Fewest layers, by doubling, whose relative errors stay below; None where none do."""
    layers = 1
    while layers <= MOST_LAYERS:
        found = properties(layers)
        if np.max(np.abs(found / exact[: len(found)] - 1.0)) < error:
            return layers
        layers *= 2
    return None


def main() -> None:
    """Prints medians and ratios."""
    points = corners()
    section = gw.Section.polygon(points)
    body = exact_properties(section)
    exact = np.array([body.volume, body.inertia[2, 2]])
    solids = iter([gw.extrude(section, LENGTH, twist=TWIST) for _ in range(201)])
    alone = median_seconds(lambda: next(solids).properties(), 200)
    ours = median_seconds(lambda: exact_properties(section), 200)
    building = median_seconds(lambda: exact_properties(gw.Section.polygon(points)), 20)
    print(f"{len(points)} corners, {LENGTH:g} mm, {TWIST:g}°; closed form, error bound {body.error_bound:.0e}:")
    print(
        f"  properties() {alone * 1e6:.0f} µs; with extrude() {ours * 1e6:.0f} µs; from corners {building * 1e3:.1f} ms"
    )
    print(f"{'error below':<14}{'by':<14}{'layers':>8}{'median':>14}{'to the closed form':>22}")
    peers = {
        "manifold3d": lambda layers: manifold_properties(points, layers),
        "trimesh": lambda layers: trimesh_properties(points, layers),
        "polyhedron": lambda layers: polyhedron_properties(section, layers),
    }
    for error in ERRORS:
        for name, properties in peers.items():
            layers = layers_for(properties, exact, error)
            if layers is None:
                print(f"{error:<14g}{name:<14}{'more than ' + str(MOST_LAYERS):>8}")
                continue
            seconds = median_seconds(lambda p=properties, n=layers: p(n), 5)
            print(f"{error:<14g}{name:<14}{layers:>8}{seconds * 1e3:>11.1f} ms{seconds / ours:>20.0f} ×")


if __name__ == "__main__":
    main()
