"""Bore, keyway, hub and web of a gear: exact, watertight, the same as by booleans, or refused with the limit."""

from dataclasses import fields
from types import SimpleNamespace

import manifold3d
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gearwright.elements import declarations
from gearwright.elements.blanks.blank import Blank
from gearwright.elements.blanks.limits import blank_problems
from gearwright.elements.standards.din_6885 import parallel_key
from gearwright.motions.ends import between
from gearwright.motions.straight import Straight
from gearwright.parameters import Parameter
from gearwright.solids.composite import Composite
from gearwright.solids.solid import flux_moments
from gearwright.solids.swept import Swept

from ..laws.manifolds import manifold
from ..laws.topology import components, edges_pair_up, fans_at_vertices, genus
from .rings import AREA, FACE, MOTIONS, ROOT, TEETH, TIP, ring, section

FULL = {
    "bore": 30.0,
    "keyway": "din-6885",
    "hub_diameter": 50.0,
    "hub_length": 60.0,
    "hub_offset": 8.0,
    "rim_diameter": 96.0,
    "web_thickness": 12.0,
    "web_holes": 6,
    "web_hole_diameter": 14.0,
}


def without(*names, **changes):
    return {name: value for name, value in {**FULL, **changes}.items() if name not in names}


HUB, WEB = ("hub_diameter", "hub_length", "hub_offset"), ("rim_diameter", "web_thickness")
HOLES = ("web_holes", "web_hole_diameter")
BODIES = {
    "all of it": FULL,
    "no bore": without("bore", "keyway"),
    "round bore": without("keyway"),
    "own keyway": without("keyway", keyway_width=6.0, keyway_depth=5.0),
    "no holes": without(*HOLES),
    "web and round bore": without("keyway", *HOLES),
    "no hub": without(*HUB),
    "no hub, no holes": without(*HUB, *HOLES),
    "holes in a full web": without("bore", "keyway", *HUB),
    "hub on one side": without("hub_offset", *WEB, *HOLES),
    "hub on both sides": without(*WEB, *HOLES),
    "hub without bore": without("bore", "keyway", *WEB, *HOLES),
    "hub as long as the teeth": without("hub_length", "hub_offset"),
    "hub inside the rim": without(hub_length=20.0, hub_offset=-9.0),
    "holes in a disc": without(*HUB, web_thickness=FACE),
    "hub and holes in a disc": without(web_thickness=FACE),
    "keyway alone": without(*HUB, *WEB, *HOLES),
    "one hole": without(web_holes=1, web_hole_circle=75.0),
}


def elementary_volume(blank):
    """By sectors, cylinders and a slot, none of them as the package builds it."""
    core = 0.0 if blank.bore is None else blank.bore / 2.0
    web = FACE if blank.web_thickness is None else blank.web_thickness
    hub = None if blank.hub_diameter is None else blank.hub_diameter / 2.0
    length = web if hub is None else blank.hub_length or FACE
    volume = AREA * FACE
    if blank.rim_diameter is not None:
        volume -= np.pi * (blank.rim_diameter / 2.0) ** 2 * (FACE - web)
    if hub is not None:
        volume += np.pi * hub**2 * (length - web)
    volume -= np.pi * core**2 * length
    if blank.web_holes:
        volume -= blank.web_holes * np.pi * blank.web_hole_diameter**2 / 4.0 * web
    if blank.keyway == "din-6885":
        key = parallel_key(blank.bore)
        width, depth = key.width, key.hub_depth
    else:
        width, depth = blank.keyway_width or 0.0, blank.keyway_depth or 0.0
    inside = width / 2.0 * np.sqrt(core**2 - width**2 / 4.0) + core**2 * np.arcsin(width / 2.0 / core) if width else 0.0
    return volume - (width * (core + depth) - inside) * length


def built(name, kind="spur"):
    blank = Blank(**BODIES[name])
    assert blank_problems(blank, 2.0 * ROOT, FACE) == []
    return blank.solid(ring(kind), ROOT, FACE)


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("name", BODIES)
def test_moments_are_those_of_elementary_bodies_and_of_the_flux(name, kind):
    solid = built(name, kind)
    exact, flux = solid.moments, flux_moments(solid.boundary)
    assert exact.method == "exact"
    assert exact.volume == pytest.approx(elementary_volume(Blank(**BODIES[name])), rel=1e-13)
    assert exact.volume == pytest.approx(flux.volume, rel=1e-12)
    np.testing.assert_allclose(exact.centroid, flux.centroid, atol=1e-12 * TIP)
    norm = np.linalg.norm(flux.central_second)
    np.testing.assert_allclose(exact.central_second, flux.central_second, atol=1e-12 * norm)
    assert exact.error_bound < 1e-12


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("name", BODIES)
def test_polyhedra_are_watertight_and_converge(name, kind):
    """Chords of bores and of hubs err in opposite senses, so that the volume's errors have a bound, but no order."""
    solid, blank = built(name, kind), Blank(**BODIES[name])
    area = solid.properties().area
    for tolerance in (0.16, 0.01):
        body = solid.polyhedron(tolerance)
        triangles = np.asarray(body.faces)
        assert edges_pair_up(triangles)
        assert set(fans_at_vertices(triangles)) == {1}
        assert components(triangles) == 1
        assert genus(triangles) == (blank.bore is not None) + (blank.web_holes or 0)
        assert abs(body.properties().volume - solid.moments.volume) < tolerance * area / 2.0
    low, high = body.vertices[:, 2].min(), body.vertices[:, 2].max()
    start, end = (0.0, FACE) if blank.hub_diameter is None else blank.hub_levels(FACE)
    assert (low, high) == (min(start, 0.0), max(end, FACE))


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("name", ["all of it", "no hub", "hub on one side", "keyway alone"])
def test_they_do_not_pass_through_themselves(name, kind):
    assert built(name, kind).polyhedron(0.1).self_intersections().count == 0


@pytest.mark.parametrize("kind", MOTIONS)
def test_the_teeth_stay_a_pattern_without_further_edges(kind):
    """Whatever is inside: the flanks' patches, their edges and triangles are those of the ring alone."""

    def teeth(solid):
        boundary = solid.boundary
        flanks = [patch for patch in boundary.patches if patch.pattern.order == TEETH and patch.name != "loop 2.1"]
        edges = {use.edge for patch in flanks for use in patch.sides}
        body = solid.polyhedron(0.05)
        corners = np.hypot(*np.moveaxis(body.vertices[np.asarray(body.faces)][..., :2], -1, 0))
        level = np.ptp(body.vertices[np.asarray(body.faces)][..., 2], axis=1) == 0.0
        beyond = np.all(corners > ROOT - 0.06, axis=1) & ~level
        return len(flanks), len(edges), int(beyond.sum())

    alone = teeth(ring(kind)(20.0))
    assert alone[0] == (8 if kind == "herringbone" else 4)
    for name in ("all of it", "keyway alone", "hub on one side"):
        assert teeth(built(name, kind)) == alone


def test_end_faces_on_one_plane_are_one():
    solid = built("hub on one side")
    assert len(solid.pieces) == 3
    down = [cap for cap in solid.boundary.caps if cap.surface.origin[2] == 0.0]
    assert [[loop.pattern.order for loop in cap.loops] for cap in down] == [[TEETH, 1]]
    levels = sorted(cap.surface.origin[2] for cap in built("all of it").boundary.caps)
    assert levels == [-8.0, 0.0, 14.0, 26.0, FACE, 52.0]


def test_rim_and_hub_of_one_height_stay_two_faces():
    """On one plane, but with the web between them."""
    caps = built("hub as long as the teeth").boundary.caps
    assert [len([c for c in caps if c.surface.origin[2] == z]) for z in (0.0, FACE)] == [2, 2]


def test_as_few_pieces_as_will_do():
    pieces = {name: len(built(name).pieces) for name in BODIES}
    assert pieces["all of it"] == 5  # ring, step, web, step, hub
    assert pieces["no hub, no holes"] == 3  # ring, step, keyed web
    assert pieces["web and round bore"] == pieces["hub without bore"] == 2
    assert pieces["holes in a disc"] == 3  # ring, holes, keyway
    assert pieces["keyway alone"] == 2


def test_with_nothing_but_a_bore_it_is_the_ring_itself():
    holes = []
    made = ring()(None)

    def only(hole):
        holes.append(hole)
        return made

    assert Blank().solid(only, ROOT, FACE) is made
    assert Blank(bore=20.0).solid(only, ROOT, FACE) is made
    assert Blank(bore=20.0, keyway="none").solid(only, ROOT, FACE) is made
    assert Blank(hub_diameter=60.0).solid(only, ROOT, FACE) is made  # no longer than the teeth
    assert Blank(bore=20.0, rim_diameter=90.0, web_thickness=FACE).solid(only, ROOT, FACE) is made
    assert holes == [None, 10.0, 10.0, None, 10.0]


def test_keyway_and_first_hole_lie_below_the_first_tooth():
    """What is missing on +x moves the centroid to −x, by first moments of slot and hole."""
    plain, slot = (built(name).moments for name in ("round bore", "own keyway"))
    moved = slot.volume * slot.centroid - plain.volume * plain.centroid
    assert moved[1] == pytest.approx(0.0, abs=1e-9)
    # a slot from |y| < 3, x < 20 less the disc of radius 15: ∫ x dA = ∫ (400 − (225 − y²))/2 dy
    assert moved[0] == pytest.approx(-60.0 * ((400.0 - 225.0) * 3.0 + 9.0), rel=1e-11)
    one = built("one hole").moments
    rest = built("no holes").moments
    moved = one.volume * one.centroid - rest.volume * rest.centroid
    np.testing.assert_allclose(moved, -np.pi * 49.0 * 12.0 * np.array([37.5, 0.0, 20.0]), rtol=1e-10, atol=1e-8)


def test_holes_are_midway_unless_a_circle_is_given():
    assert Blank(**FULL).hole_circle.circle == pytest.approx((25.0 + 48.0) / 2.0)
    assert Blank(**BODIES["one hole"]).hole_circle.circle == 37.5
    corner = np.hypot(15.0 + 3.3, 4.0)  # of the keyway 8 × 3.3 that a bore of 30 has
    assert Blank(**BODIES["no hub"]).hole_circle.circle == pytest.approx((corner + 48.0) / 2.0)


def test_sizes_that_follow_from_others():
    found = Blank(bore=40.0 / 25.4, keyway="din-6885", length_unit="in").sizes()
    assert {name: size.value * 25.4 for name, size in found.items()} == pytest.approx(
        {"keyway_width": 12.0, "keyway_depth": 3.3}
    )
    assert Blank(**FULL).sizes()["web_hole_circle"].value == pytest.approx(73.0)
    assert Blank(bore=40.0).sizes() == {}


def test_every_field_is_declared_and_taken_from_an_element():
    names = [field.name for field in fields(Blank)]
    assert all(isinstance(getattr(declarations, name.upper()), Parameter) for name in names)
    element = SimpleNamespace(**{name: getattr(Blank(**FULL), name) for name in names}, teeth=24)
    assert Blank.of(element) == Blank(**FULL)


@pytest.mark.parametrize("name", ["all of it", "keyway alone"])
def test_inches_are_millimetres_of_another_size(name):
    lengths = {k: v / 25.4 if isinstance(v, float) else v for k, v in BODIES[name].items()}
    blank = Blank(**lengths, length_unit="in")
    assert blank_problems(blank, 2.0 * ROOT / 25.4, FACE / 25.4) == []

    def small(hole):
        return Swept(section=section(hole, 1.0 / 25.4), motion=Straight(), ends=between(0.0, FACE / 25.4))

    inches, millimetres = blank.solid(small, ROOT / 25.4, FACE / 25.4).moments, built(name).moments
    assert inches.volume * 25.4**3 == pytest.approx(millimetres.volume, rel=1e-13)
    np.testing.assert_allclose(inches.centroid * 25.4, millimetres.centroid, atol=1e-11)


def test_levels_that_differ_by_rounding_are_one():
    offset = 0.1 + 0.2 - 0.3
    blank = Blank(bore=30.0, keyway="din-6885", hub_diameter=60.0, hub_length=FACE + offset, hub_offset=offset)
    assert offset != 0.0
    assert len(blank.zones(ROOT, FACE)) == 1


def test_it_can_be_put_elsewhere():
    solid = built("all of it", "herringbone")
    turned = solid.moved([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], (5.0, -7.0, 90.0))
    body = turned.polyhedron(0.1)
    assert edges_pair_up(np.asarray(body.faces))
    assert flux_moments(turned.boundary).volume == pytest.approx(solid.moments.volume, rel=1e-12)


class TestBooleans:
    """The same bodies cut out of the toothed disc by another's booleans on polyhedra."""

    SEGMENTS = 512

    def cylinder(self, radius, low, high, x=0.0, y=0.0):
        return manifold3d.Manifold.cylinder(high - low, radius, radius, self.SEGMENTS).translate((x, y, low))

    def cut_out(self, disc):
        """BODIES["all of it"], number by number."""
        for low, high in ((-1.0, 14.0), (26.0, 41.0)):
            disc -= self.cylinder(48.0, low, high)
        disc += self.cylinder(25.0, -8.0, 52.0)
        disc -= self.cylinder(15.0, -9.0, 53.0)
        disc -= manifold3d.Manifold.cube((18.3, 8.0, 62.0)).translate((0.0, -4.0, -9.0))
        for angle in np.pi / 3.0 * np.arange(6):
            disc -= self.cylinder(7.0, 13.0, 27.0, 36.5 * np.cos(angle), 36.5 * np.sin(angle))
        return disc

    @pytest.mark.parametrize("kind", MOTIONS)
    def test_the_whole_is_what_booleans_leave(self, kind):
        tolerance = 0.02
        solid = built("all of it", kind)
        ours = manifold(solid.polyhedron(tolerance))
        theirs = self.cut_out(manifold(ring(kind)(None).polyhedron(tolerance)))
        apart = (ours - theirs).volume() + (theirs - ours).volume()
        assert apart < 0.25 * tolerance * solid.properties().area
        assert theirs.volume() == pytest.approx(solid.moments.volume, rel=5e-4)
        assert theirs.genus() == ours.genus() == 7

    def test_another_body_would_be_told_apart(self):
        solid = Blank(**{**FULL, "hub_offset": 8.5}).solid(ring(), ROOT, FACE)
        ours, theirs = manifold(solid.polyhedron(0.02)), self.cut_out(manifold(ring()(None).polyhedron(0.02)))
        assert (ours - theirs).volume() + (theirs - ours).volume() > 0.5 * 0.02 * solid.properties().area


KEYED_CORNER = 2.0 * np.hypot(15.0 + 3.3, 4.0)
REFUSED = [
    # changes to FULL (None: left out), the parameter named, words of the message
    ({"bore": None}, "keyway", ("a keyway needs a bore",)),
    ({"bore": None, "keyway": None, "keyway_width": 6.0, "keyway_depth": 2.0}, "keyway_width", ("needs a bore",)),
    ({"keyway_width": 6.0}, "keyway_width", ('keyway "din-6885"', "the standard's size")),
    ({"keyway": "none", "keyway_depth": 6.0}, "keyway_depth", ('keyway "none"', "left out")),
    ({"keyway": None, "keyway_depth": 6.0}, "keyway_depth", ("goes with keyway_width",)),
    ({"keyway": None, "keyway_width": 6.0}, "keyway_width", ("goes with keyway_depth",)),
    ({"bore": 6.0}, "keyway", ("over 6 and up to 500 mm", "give keyway_width and keyway_depth instead")),
    ({"hub_diameter": None}, "hub_length", ("give hub_diameter",)),
    ({"hub_diameter": None}, "hub_offset", ("give hub_diameter",)),
    ({"web_thickness": None}, "rim_diameter", ("give its web_thickness",)),
    ({"rim_diameter": None}, "web_thickness", ("rim_diameter",)),
    ({"rim_diameter": None, "web_thickness": None}, "web_holes", ("need a web", "rim_diameter and web_thickness")),
    ({"rim_diameter": None, "web_thickness": None}, "web_hole_diameter", ("need a web",)),
    ({"web_holes": None}, "web_hole_diameter", ("goes with web_holes",)),
    ({"web_hole_diameter": None}, "web_holes", ("goes with web_hole_diameter",)),
    (
        {"web_holes": None, "web_hole_diameter": None, "web_hole_circle": 70.0},
        "web_hole_circle",
        ("goes with web_holes and web_hole_diameter",),
    ),
    ({"bore": 120.0, "keyway": None}, "bore", ("cuts into the tooth roots", "root diameter, 110 mm")),
    ({"hub_diameter": 36.0}, "hub_diameter", ("no wall around the keyway", "37.47 mm")),
    ({"hub_diameter": 30.0, "keyway": None}, "hub_diameter", ("no wall around the bore", "30 mm")),
    ({"hub_diameter": 111.0}, "hub_diameter", ("reaches the tooth roots", "110 mm")),
    ({"rim_diameter": 111.0}, "rim_diameter", ("reaches the tooth roots", "110 mm")),
    ({"rim_diameter": 49.0}, "rim_diameter", ("leaves no web", "hub_diameter", "50 mm")),
    ({"web_thickness": 41.0}, "web_thickness", ("at most the face width, 40 mm",)),
    ({"hub_offset": -15.0}, "hub_offset", ("begin inside the web", "at least -14 mm")),
    ({"hub_length": 33.0}, "hub_length", ("end inside the web", "at least 34 mm")),
    ({"web_hole_circle": 97.0}, "web_hole_circle", ("outside the web", "more than 50 mm (hub)", "96 mm (rim)")),
    ({"web_hole_circle": 49.0}, "web_hole_circle", ("more than 50 mm (hub)",)),
    ({"web_hole_diameter": 24.0}, "web_hole_diameter", ("run into the rim", "less than 23 mm", "6 on a circle of 73")),
    ({"web_hole_circle": 60.0}, "web_hole_diameter", ("run into the hub", "less than 10 mm")),
    ({"bore": 1e-8, "keyway": None}, "bore", ("rounding", "at least 1.1", "e-07 mm", "right unit")),
    ({"web_hole_diameter": 1e-8}, "web_hole_diameter", ("rounding", "at least 7.30", "e-08 mm")),
    ({"web_holes": 20}, "web_hole_diameter", ("run into the next hole", "less than 11.41 mm")),
]


@pytest.mark.parametrize(("changes", "name", "words"), REFUSED, ids=lambda value: str(value)[:60])
def test_refusals_name_the_parameter_the_limit_and_the_way_out(changes, name, words):
    given = {k: v for k, v in {**FULL, **changes}.items() if v is not None}
    found = blank_problems(Blank(**given), 2.0 * ROOT, FACE)
    messages = [message for parameter, message in found if parameter == name]
    assert any(all(word in message for word in words) for message in messages), found


def test_a_keyway_in_the_roots_is_refused():
    alone = {"bore": 106.0, "keyway": "din-6885"}  # 28 × 6.4: corners on 2 √(59.4² + 14²) = 122.1
    [(name, message)] = blank_problems(Blank(**alone), 2.0 * ROOT, FACE)
    assert name == "keyway"
    assert "122.1 mm" in message
    assert "root diameter, 110 mm" in message
    own = {"bore": 30.0, "keyway_width": 10.0, "keyway_depth": 40.0}
    assert [name for name, _ in blank_problems(Blank(**own), 2.0 * ROOT, FACE)] == ["keyway_depth"]


def test_all_problems_are_named_together():
    names = [
        name
        for name, _ in blank_problems(
            Blank(bore=120.0, hub_length=20.0, rim_diameter=130.0, web_thickness=50.0, keyway_width=3.0, web_holes=3),
            2.0 * ROOT,
            FACE,
        )
    ]
    assert names == ["keyway_width", "hub_length", "web_holes", "bore", "rim_diameter", "web_thickness"]


LIMITS = [
    # the others, what is at its limit, the limit, the way to go from there (1 up, −1 down), whether the limit will do
    ({}, "bore", 110.0, -1, False),
    ({"bore": 30.0, "keyway_depth": 4.0}, "keyway_width", 30.0, -1, False),
    ({"bore": 30.0, "keyway_width": 10.0}, "keyway_depth", float(np.sqrt(55.0**2 - 25.0)) - 15.0, -1, False),
    ({"bore": 30.0}, "hub_diameter", 30.0, 1, False),
    ({"bore": 30.0, "keyway": "din-6885"}, "hub_diameter", KEYED_CORNER, 1, False),
    ({"bore": 30.0}, "hub_diameter", 110.0, -1, False),
    ({"bore": 30.0, "web_thickness": 9.0}, "rim_diameter", 110.0, -1, False),
    ({"bore": 30.0, "web_thickness": 9.0}, "rim_diameter", 30.0, 1, False),
    ({"hub_diameter": 40.0, "web_thickness": 9.0}, "rim_diameter", 40.0, 1, False),
    ({"rim_diameter": 96.0}, "web_thickness", 40.0, -1, True),
    ({"hub_diameter": 50.0, "hub_length": 60.0}, "hub_offset", 0.0, 1, True),
    ({"hub_diameter": 50.0, "hub_length": 60.0}, "hub_offset", 20.0, -1, True),
    ({"hub_diameter": 50.0, "hub_offset": 5.0}, "hub_length", 45.0, 1, True),
    (without("hub_offset"), "hub_offset", -14.0, 1, True),
    (without("hub_length"), "hub_length", 34.0, 1, True),
    (FULL, "web_hole_diameter", 23.0, -1, False),
    (without(web_hole_circle=60.0), "web_hole_diameter", 10.0, -1, False),
    (without(web_holes=20), "web_hole_diameter", 73.0 * float(np.sin(np.pi / 20.0)), -1, False),
    (without(web_hole_diameter=1.0), "web_hole_circle", 95.0, -1, False),
    (without(web_hole_diameter=1.0), "web_hole_circle", 51.0, 1, False),
]


@pytest.mark.parametrize(("others", "name", "limit", "way", "included"), LIMITS)
def test_limits_are_where_they_are_said_to_be(others, name, limit, way, included):
    def problems(value):
        return blank_problems(Blank(**{**others, name: value}), 2.0 * ROOT, FACE)

    inside, beyond = limit + way * 1e-6, limit - way * 1e-6
    assert problems(inside) == []
    assert problems(beyond) != []
    if not name.startswith("keyway"):  # there the limit is itself rounded
        assert (problems(limit) == []) == included
    solid = Blank(**{**others, name: inside}).solid(ring(), ROOT, FACE)
    assert solid.moments.volume > 0.0
    if included:
        solid = Blank(**{**others, name: limit}).solid(ring(), ROOT, FACE)
        assert solid.moments.volume == pytest.approx(flux_moments(solid.boundary).volume, rel=1e-12)


@pytest.mark.parametrize(("bore", "found"), [(6.0, False), (6.001, True), (500.0, True), (500.001, False)])
def test_the_range_of_the_standard(bore, found):
    assert (blank_problems(Blank(bore=bore, keyway="din-6885"), 2000.0, FACE) == []) == found


def lengths(low, high):
    return st.none() | st.floats(low, high)


@st.composite
def blanks(draw):
    """Of any sizes that a root diameter of 110 mm and a face width of 40 mm may suggest, possible or not."""
    values = {"bore": draw(lengths(2.0, 70.0))}
    how = draw(st.sampled_from([None, None, "none", "din-6885", "own"]))
    if how == "own":
        values |= {"keyway_width": draw(st.floats(0.5, 30.0)), "keyway_depth": draw(st.floats(0.2, 15.0))}
    else:
        values["keyway"] = how
    if draw(st.booleans()):
        values |= {"hub_diameter": draw(st.floats(10.0, 100.0)), "hub_length": draw(lengths(5.0, 90.0))}
        values["hub_offset"] = draw(st.sampled_from([0.0, 0.0, 10.0, -5.0]) | st.floats(-20.0, 30.0))
    if draw(st.booleans()):
        values |= {"rim_diameter": draw(st.floats(40.0, 109.0)), "web_thickness": draw(st.floats(2.0, 40.0))}
        if draw(st.booleans()):
            values |= {"web_holes": draw(st.integers(1, 12)), "web_hole_diameter": draw(st.floats(1.0, 30.0))}
            values["web_hole_circle"] = draw(lengths(30.0, 100.0))
    return values


run = settings(max_examples=120, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


@run
@given(blanks(), st.sampled_from(list(MOTIONS)))
def test_any_blank_is_refused_or_watertight(values, kind):
    blank = Blank(**values)
    problems = blank_problems(blank, 2.0 * ROOT, FACE)
    if problems:
        assert all(hasattr(blank, name) and message for name, message in problems)
        return
    solid = blank.solid(ring(kind), ROOT, FACE)
    assert solid.moments.volume == pytest.approx(elementary_volume(blank), rel=1e-12)
    body = solid.polyhedron()
    triangles = np.asarray(body.faces)
    assert edges_pair_up(triangles)
    assert set(fans_at_vertices(triangles)) == {1}
    assert isinstance(solid, Composite | Swept)
    assert body.properties().volume == pytest.approx(solid.moments.volume, rel=2e-3)
