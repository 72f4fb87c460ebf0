"""Errors of polyhedra have the orders that theory gives, and what has no order says so."""

import json
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.extent import rough_diagonal
from gearwright.boundary.sampling import fixed_sampling
from gearwright.boundary.tessellation import tessellate
from gearwright.solids.convergence import QUANTITIES, ErrorRow

from ..examples import PARTS, built

TAPERED = gw.extrude(
    gw.Section.spline([(12.0, 0.0), (3.0, 6.0), (-5.0, 2.0), (1.0, -8.0)]), 10.0, twist=60.0, scale=(0.8, 0.8)
)
"""Twisted and tapered, off its axis and of no symmetry, so that nothing vanishes by itself."""


@cache
def layers_of_tapered(diagonals="alternating", layers=(8, 16, 32, 64)):
    return gw.layer_refinement(TAPERED, layers, segments=4, diagonals=diagonals)


@dataclass(frozen=True)
class Claiming:
    """A solid whose exact values are other ones."""

    solid: object
    volume: float = 1.0
    shift: float = 0.0

    @property
    def boundary(self):
        return self.solid.boundary

    def polyhedron(self, tolerance=None):
        return self.solid.polyhedron(tolerance)

    def properties(self, density=1.0):
        found = self.solid.properties(density)
        return gw.MassProperties(
            volume=found.volume * self.volume,
            centroid=found.centroid + np.array([self.shift, 0.0, 0.0]),
            central_second=found.central_second,
        )


def close_to(order, tolerance):
    return {name: pytest.approx(order, abs=tolerance) for name in QUANTITIES}


def test_order_one_in_the_tolerance():
    found = gw.approximation_error(TAPERED)
    assert found.orders == close_to(1.0, 0.05)
    assert not found.remarks
    assert found.diagonals == "alternating"
    assert [row.step for row in found.rows] == sorted((row.step for row in found.rows), reverse=True)
    assert all(row.volume < 0.0 for row in found.rows)


def test_order_two_in_the_section_alone():
    assert gw.section_refinement(TAPERED, (8, 16, 32)).orders == close_to(2.0, 0.02)


def test_order_two_in_the_layers_alone_and_one_with_a_fixed_diagonal():
    assert layers_of_tapered().orders == close_to(2.0, 0.02)
    assert layers_of_tapered("fixed", (128, 256)).orders == close_to(1.0, 0.03)


def test_a_fixed_diagonal_errs_to_the_side_that_the_hand_of_the_twist_decides():
    section = gw.Section.rectangle(3.0, 1.0)
    left, right = (
        gw.layer_refinement(gw.extrude(section, 2.0, twist=twist), (32, 64), diagonals="fixed").rows[-1].volume
        for twist in (-90.0, 90.0)
    )
    assert left * right < 0.0
    # what alternating diagonals leave is the mean of both
    even = gw.layer_refinement(gw.extrude(section, 2.0, twist=90.0), (32, 64)).rows[-1].volume
    assert even == pytest.approx((left + right) / 2.0, abs=0.02 * abs(left))
    assert abs(even) < 0.1 * abs(left)


def test_errors_of_section_and_layers_make_up_that_of_the_polyhedron():
    boundary, exact = TAPERED.boundary, TAPERED.properties()
    whole = gw.Polyhedron(*tessellate(boundary, fixed_sampling(boundary, 4, 16, 1.0))).properties()
    section = gw.section_refinement(TAPERED, (4, 8)).rows[0].volume
    layers = layers_of_tapered().rows[1].volume
    assert whole.volume / exact.volume == pytest.approx((1.0 + section) * (1.0 + layers), rel=1e-12)


def test_what_the_errors_are_relative_to():
    """Against values taken from the polyhedron itself."""
    tolerances = (0.2, 0.05)
    found = gw.approximation_error(TAPERED, tolerances)
    exact = TAPERED.properties()
    for row, tolerance in zip(found.rows, tolerances, strict=True):
        polyhedron = TAPERED.polyhedron(tolerance)
        properties = polyhedron.properties()
        assert row.step == tolerance
        assert row.triangles == len(polyhedron.faces)
        assert (1.0 + row.volume) * exact.volume == pytest.approx(properties.volume, rel=1e-14)
        offset = np.linalg.norm(properties.centroid - exact.centroid)
        assert row.centroid == pytest.approx(offset / rough_diagonal(TAPERED.boundary), rel=1e-9)
        change = np.linalg.norm(properties.central_inertia - exact.central_inertia)
        assert row.inertia == pytest.approx(change / np.linalg.norm(exact.central_inertia), rel=1e-9)


@pytest.mark.parametrize("study", [gw.approximation_error, gw.section_refinement, gw.layer_refinement])
def test_a_box_is_exact_and_has_no_order(study):
    found = study(gw.extrude(gw.Section.rectangle(2.0, 3.0, (5.0, 1.0)), 4.0))
    for row in found.rows:
        assert max(abs(row.volume), row.centroid, row.inertia) < 1e-14
    assert found.orders == dict.fromkeys(QUANTITIES)
    assert [remark.split(": ")[1] for remark in found.remarks] == 3 * ["exact to rounding, so that it has no order"]
    assert "rounding" in str(found)


def test_sizes_and_places_make_no_difference():
    """A metre or a micrometre, at the origin or a thousand lengths away."""
    section = gw.Section.spline([(2.0, 0.0), (0.5, 1.0), (-1.0, 0.2), (0.0, -1.5)])
    near = gw.section_refinement(gw.extrude(section, 2.0))
    for scale, away in ((1e-6, 0.0), (1e6, 0.0), (1.0, 1e3)):
        points = away + scale * np.array([(2.0, 0.0), (0.5, 1.0), (-1.0, 0.2), (0.0, -1.5)])
        found = gw.section_refinement(gw.extrude(gw.Section.spline(points), 2.0 * scale))
        assert [row.volume for row in found.rows] == pytest.approx([row.volume for row in near.rows], rel=1e-5)


@pytest.mark.parametrize(
    ("claim", "quantity"), [({"volume": 1.05}, "volume"), ({"shift": 0.5}, "centroid")], ids=["volume", "centroid"]
)
def test_a_wrong_exact_value_is_detected(claim, quantity):
    found = gw.approximation_error(Claiming(TAPERED, **claim))
    assert found.orders[quantity] == pytest.approx(0.0, abs=0.1)
    assert any(remark.startswith(f"{quantity}: the error does not fall") for remark in found.remarks)


def study_of(*volumes, rounding=1e-14):
    rows = tuple(
        ErrorRow(step=10.0 * 2.0**n, triangles=None, volume=volume, centroid=0.0, inertia=abs(volume))
        for n, volume in enumerate(volumes)
    )
    return gw.ApproximationError(refined="layers", against="the truth", rows=rows, rounding=rounding)


@pytest.mark.parametrize(
    ("volumes", "order", "remark"),
    [
        ((4e-2, 1e-2, 2.5e-3), 2.0, None),
        ((-8e-3, -4e-3, -2e-3), 1.0, None),
        ((4e-2, 1.7e-2, 2.5e-3), 2.0, None),
        ((4e-2, 2e-2, 2.5e-3), None, "does not follow a power"),
        ((4e-8, 1e-8, 1e-15, 2e-15), 2.0, None),
        ((1e-3, -1e-4, -1e-5), None, "changes its sign"),
        ((1e-3, 1e-9, 1e-6), None, "does not follow a power"),
        ((1e-15, 1e-9, 1e-10), None, "no more than rounding at some steps"),
        ((1e-3, 1e-3, 1e-3), 0.0, "does not fall"),
        ((1e-3, 2e-3, 4e-3), -1.0, "does not fall"),
    ],
)
def test_orders_and_why_there_are_none(volumes, order, remark):
    found = study_of(*volumes)
    assert found.orders["volume"] == (None if order is None else pytest.approx(order, abs=1e-9))
    said = [one for one in found.remarks if one.startswith("volume")]
    assert (remark in said[0]) if remark else not said


def test_the_table_and_the_dictionary_say_the_same():
    found = layers_of_tapered()
    table = str(found)
    assert table.splitlines()[0].startswith("Errors against the solid with its section curves cut into 4 chords")
    document = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert document["orders"] == found.orders
    assert document["diagonals"] == "alternating"
    for row in document["rows"]:
        line = next(line for line in table.splitlines() if line.split()[0] == f"{row['step']:g}")
        assert line.split()[1:3] == [str(row["triangles"]), f"{row['volume']:+.2e}"]
    assert table.splitlines()[-1].split() == ["order", "2.00", "2.00", "2.00"]


def test_a_plot_tells_studies_apart_by_their_diagonals_or_by_names(tmp_path):
    studies = [layers_of_tapered(), layers_of_tapered("fixed", (128, 256))]
    for file, names in (("plain", ()), ("same", ("alternating", "fixed")), ("other", ("pinion", "gear"))):
        gw.plot_convergence(studies, tmp_path / f"{file}.svg", names=names)
    plain, same, other = ((tmp_path / f"{file}.svg").read_bytes() for file in ("plain", "same", "other"))
    assert plain == same != other
    with pytest.raises(ValueError, match="1 names for 2 studies"):
        gw.plot_convergence(studies, tmp_path / "one.svg", names=["pinion"])
    studies[0].plot(tmp_path / "alone.svg")
    assert (tmp_path / "alone.svg").read_bytes() != plain


@pytest.mark.parametrize("part", PARTS[:: len(PARTS) // 6], ids=str)
def test_every_element_can_be_studied(part):
    volumes = [abs(row.volume) for row in gw.section_refinement(built(part), (8, 16)).rows]
    assert volumes[1] < max(0.5 * volumes[0], 1e-13)  # straight sides leave nothing but rounding
    assert gw.layer_refinement(built(part), (4, 8), segments=2).orders["volume"] in (None, pytest.approx(2.0, abs=0.1))


@pytest.mark.parametrize(
    "solid",
    [
        gw.revolve(gw.Section.polygon([(0, 0), (2, 0), (0, 3)])),
        gw.revolve(gw.Section.polygon([(0, 0), (2, 0), (0, 3)]), 100.0),
        gw.revolve(gw.Section.circle(1.0, (3.0, 0.0))),
        gw.sweep_along(gw.Section.circle(1.0), gw.helix(5.0, 4.0, 2.0)),
    ],
    ids=["cone", "wedge of a cone", "ring", "spring"],
)
def test_turns_and_paths_have_order_two_in_their_layers(solid):
    found = gw.layer_refinement(solid)
    assert found.orders["volume"] == pytest.approx(2.0, abs=0.05)
    steps = [row.step for row in found.rows]
    assert steps[0] >= 4
    assert steps[1:] == [2 * step for step in steps[:-1]]


def refused(call):
    with pytest.raises(gw.GeometryError) as raised:
        call()
    return "\n".join(map(str, raised.value.problems))


def test_unusable_steps_are_named_together():
    text = refused(lambda: gw.approximation_error(TAPERED, (0.1, -1.0, float("nan"), "x")))
    for subject in ("tolerances[1] = -1.0", "tolerances[2] = nan", "tolerances[3] = 'x'"):
        assert subject in text
    text = refused(lambda: gw.layer_refinement(TAPERED, (4, 0.5), segments=0, diagonals="both"))
    for subject in ("layers[1] = 0.5", "segments = 0", "diagonals = 'both': choose one of alternating, fixed"):
        assert subject in text


@pytest.mark.parametrize("steps", [(0.1,), (), (0.1, 0.1), (0.1, 0.1, 0.2), 0.1, "0.1"])
def test_an_order_needs_two_different_steps(steps):
    assert "tolerances = " in refused(lambda: gw.approximation_error(TAPERED, steps))


def test_what_would_be_too_fine_or_too_coarse_is_refused():
    assert "more than 20000000 triangles" in refused(lambda: gw.approximation_error(TAPERED, (0.1, 1e-9)))
    text = refused(lambda: gw.section_refinement(TAPERED, (4, 10**7)))
    assert "segments = 10000000: more than 20000000 triangles; at most" in text
    most = int(text.split("at most ")[1].split()[0])
    assert f"segments = {most + 1}" in refused(lambda: gw.section_refinement(TAPERED, (4, most + 1)))
    assert 2 * 4 * most <= 20_000_000 < 2 * 4 * (most + 1)  # two triangles a segment of four curves
    assert "layers = 10000000" in refused(lambda: gw.layer_refinement(TAPERED, (4, 10**7)))
    cylinder = gw.extrude(gw.Section.circle(1.0), 2.0)
    least = 20_000_000 // 12 + 1  # two triangles for each sixth of the circle
    assert "at most 1666666 are" in refused(lambda: gw.section_refinement(cylinder, (4, least)))
    most_of_a_turn = gw.revolve(gw.Section.circle(1.0, (3.0, 0.0)), 350.0)
    text = refused(lambda: gw.layer_refinement(most_of_a_turn, (1, 2)))
    assert "layers = 1: so few that the polyhedron is no solid" in text
    assert "turned inward); take more" in text


def test_what_has_no_exact_properties_is_refused():
    box = gw.extrude(gw.Section.rectangle(1.0, 1.0), 1.0).polyhedron()
    assert "a Polyhedron: a solid" in refused(lambda: gw.approximation_error(box))
    pair = gw.BevelPair(teeth=(16, 20), module=4.0, face_width=15.0)
    assert ".pinion or .gear" in refused(lambda: gw.section_refinement(pair))
