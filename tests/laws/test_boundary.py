"""Laws of boundaries: faces meet edge on edge, close, and hold what their section says they hold."""

from collections import Counter

import numpy as np

from gearwright.curves.curve import turn
from gearwright.solids.solid import flux_moments

from ..examples import built, every_part, size

FRACTIONS = np.linspace(0.0, 1.0, 9)


@every_part
def test_every_edge_is_used_twice_in_opposite_senses(part):
    boundary = built(part).boundary
    uses = Counter()
    for patch in boundary.patches:
        uses.update((use.edge, use.reverse) for use in patch.sides)
    for cap in boundary.caps:
        uses.update((use.edge, use.reverse != loop.reverse) for loop in cap.loops for use in loop.uses)
    assert set(uses.values()) == {1}
    assert all((edge, not reverse) in uses for edge, reverse in uses if not edge.degenerate)


@every_part
def test_a_patch_runs_along_the_edges_it_names(part):
    t, zero, one = FRACTIONS, np.zeros(9), np.ones(9)
    for patch in built(part).boundary.patches:
        around = ((t, zero), (one, t), (1.0 - t, one), (zero, 1.0 - t))
        for use, (u, v) in zip(patch.sides, around, strict=True):
            along = t[::-1] if use.reverse else t
            points = use.edge.curve.point(use.edge.curve.parameter(along))
            angle = 2.0 * np.pi * use.turn / use.edge.pattern.order
            np.testing.assert_allclose(points @ turn(angle, 3).T, patch.point(u, v), atol=1e-13 * size(part), rtol=0.0)


@every_part
def test_edges_run_from_their_start_to_their_end_vertex(part):
    for edge in built(part).boundary.edges:
        start, end = edge.curve.point(np.array(edge.curve.interval))
        beyond = turn(2.0 * np.pi * edge.end_turn / edge.pattern.order, 3) @ edge.end.position
        np.testing.assert_allclose([start, end], [edge.start.position, beyond], atol=1e-13 * size(part), rtol=0.0)


@every_part
def test_loops_of_caps_are_closed_and_lie_on_their_surface(part):
    for cap in built(part).boundary.caps:
        for loop in cap.loops:
            curves = [use.edge.curve for use in loop.uses]
            starts = np.array([curve.start for curve in curves])
            ends = np.array([curve.end for curve in curves])
            sense = loop.uses[-1].edge.end_turn
            onward = turn(2.0 * np.pi * sense / loop.pattern.order, 3) @ starts[0]
            following = np.concatenate([starts[1:], [onward]])
            np.testing.assert_allclose(ends, following, atol=1e-12 * size(part), rtol=0.0)
            for curve in curves:
                assert cap.surface.deviation(curve.point(curve.parameter(FRACTIONS))).max() < 1e-13 * size(part)


@every_part
def test_partials_of_patches_are_derivatives(part):
    random = np.random.default_rng(2)
    u, v = random.uniform(0.05, 0.95, (2, 20))
    h = 1e-5
    for patch in built(part).boundary.patches:
        du, dv = patch.partials(u, v)
        across = (patch.point(u + h, v) - patch.point(u - h, v)) / (2.0 * h)
        along = (patch.point(u, v + h) - patch.point(u, v - h)) / (2.0 * h)
        np.testing.assert_allclose(du, across, atol=1e-7 * size(part), rtol=0.0)
        np.testing.assert_allclose(dv, along, atol=1e-7 * size(part), rtol=0.0)


@every_part
def test_flux_through_the_boundary_is_the_exact_moments(part):
    exact, flux = built(part).solid.moments, flux_moments(built(part).boundary)
    scale = np.linalg.norm(exact.central_second)
    assert exact.method == "exact"
    assert flux.method == "quadrature"
    assert abs(flux.volume / exact.volume - 1.0) < 1e-12
    np.testing.assert_allclose(flux.centroid, exact.centroid, atol=1e-12 * size(part), rtol=0.0)
    assert np.abs(flux.central_second - exact.central_second).max() < 1e-12 * max(scale, _cancelled(part, exact))


def _cancelled(part, exact):
    """Where the origin is far away, the flux about it is a difference of larger numbers."""
    return exact.volume * float(exact.centroid @ exact.centroid) / 10.0
