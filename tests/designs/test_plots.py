"""Charts say what the elements are, measured by other routes: areas, sizes, lifts, errors."""

import json
import subprocess
import sys
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from gearwright import catalog
from gearwright.contact.running import running
from gearwright.designs.design import design_of
from gearwright.designs.plots import plot, plots_of
from gearwright.elements.bevel.charts import developed
from gearwright.errors import ProblemsError
from gearwright.solids.approximation import approximation_error

from ..examples import BY_NAME, EXAMPLES

SPUR = {"element": "spur", "teeth": 24, "module": 3, "face_width": 20, "bore": 15}
PAIRS = {
    "spur": {"element": "spur", "teeth": [16, 40], "module": 3, "face_width": 20},
    "shifted": {"element": "helical", "teeth": [12, 31], "module": 2, "face_width": 9, "helix_angle": 20,
                "profile_shift": [0.4, 0.2]},
    "internal": {"element": "internal", "teeth": [16, 44], "module": 2, "face_width": 9},
    "rack": {"element": "rack", "teeth": [28, 7], "module": 4, "face_width": 9},
}  # fmt: skip
SPIRAL = {"element": "bevel", "teeth": [16, 20], "module": 4, "face_width": 16, "trace": "circular",
          "spiral_angle": 35, "cutter_radius": 50}  # fmt: skip
PROGRAMME = "dwell 36, rise 72, dwell 144, return 108"
CAMS = {name: {"element": "cam", **EXAMPLES["cam"][name]} for name in EXAMPLES["cam"]}
every_cam = pytest.mark.parametrize("cam", CAMS.values(), ids=CAMS.keys())
every_kind = pytest.mark.parametrize("kind", catalog.ELEMENTS, ids=lambda kind: kind.name)


def chart(design, name):
    (found,) = plot({"design": design, "plot": name})
    return json.loads(json.dumps(found, allow_nan=False))


def element(design):
    return design_of(design).element()[0]


# Of the trace that is quickest to follow: what is held here is what the chart does with it.
RUNNING = {"element": "bevel", "teeth": [16, 20], "module": 4, "face_width": 16, "trace": "logarithmic",
           "spiral_angle": 35}  # fmt: skip


@cache
def runs():
    return running(element(RUNNING))


def line(found, start):
    """The one line whose name starts so: x and y, with gaps as nan."""
    (one,) = (one for one in found["lines"] if one["name"].startswith(start))
    return np.array(one["x"], float), np.array(one["y"], float)


def area(x, y):
    """Of the loops between gaps, by their corners."""
    cuts = np.flatnonzero(np.isnan(x))
    pieces = zip(np.split(x, cuts), np.split(y, cuts), strict=True)
    loops = [(a[~np.isnan(a)], b[~np.isnan(b)]) for a, b in pieces]
    assert all(a[0] == pytest.approx(a[-1], abs=1e-9) and b[0] == pytest.approx(b[-1], abs=1e-9) for a, b in loops)
    return sum(float(np.sum(a[:-1] * b[1:] - a[1:] * b[:-1])) / 2.0 for a, b in loops)


@every_kind
def test_every_chart_of_every_kind_is_made(kind):
    design = {"element": kind.command, **next(iter(EXAMPLES[kind.name].values()))}
    assert plots_of(kind)[0]["name"] == "profile"
    for one in plots_of(kind):
        if one["name"] == "convergence":
            continue
        found = chart(design, one["name"])
        assert set(found) == {"title", "x", "y", "equal", "lines", "log", "notes", "window"}
        assert found["x"]["label"]
        assert found["y"]["label"]
        assert found["equal"] == (one["name"] in ("profile", "contact-lines"))
        for each in found["lines"]:
            assert each["style"] in ("solid", "dashed", "points")
            assert len(each["x"]) == len(each["y"]) >= 1
            assert None not in (each["x"][0], each["x"][-1])


def test_charts_are_listed_without_numpy():
    code = (
        "import sys; from gearwright import catalog; from gearwright.designs.plots import plots_of\n"
        "assert all(plots_of(kind) for kind in catalog.ELEMENTS); assert 'numpy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_every_kind_shows_how_its_polyhedra_converge():
    assert all("convergence" in [one.name for one in kind.plots] for kind in catalog.ELEMENTS)


def test_the_area_of_a_profile_is_the_volume_over_the_face_width():
    gear = element(SPUR)
    x, y = line(chart(SPUR, "profile"), "profile")
    assert area(x, y) == pytest.approx(gear.properties().volume / 20.0, rel=2e-5)
    assert np.nanmax(np.hypot(x, y)) == pytest.approx(gear.sizes()["outside_diameter"].value / 2.0, rel=1e-9)


@pytest.mark.parametrize("name", ["fillets, left", "undercut, relieved, chamfered, bored"])
def test_the_area_of_a_helical_gear_is_that_of_any_of_its_sections(name):
    design = {"element": "helical", **EXAMPLES["helical gear"][name]}
    expected = element(design).properties().volume / design["face_width"]
    assert area(*line(chart(design, "profile"), "profile")) == pytest.approx(expected, rel=2e-5)


def test_circles_are_those_of_the_sizes():
    found, sizes = chart(SPUR, "profile"), element(SPUR).sizes()
    names = {"pitch": "pitch", "base": "base", "tip": "outside", "root": "root"}
    for circle, size in names.items():
        radius = np.hypot(*line(found, f"{circle} circle"))
        assert radius == pytest.approx(sizes[f"{size}_diameter"].value / 2.0, rel=1e-12)
    assert all(one["style"] == "dashed" for one in found["lines"][1:])


@pytest.mark.parametrize("design", PAIRS.values(), ids=PAIRS.keys())
def test_members_in_mesh_do_not_cross(design):
    import shapely

    found = chart(design, "profile")
    mate = "rack" if design["element"] == "rack" else "gear"
    rings = [np.stack(line(found, name), axis=-1) for name in ("pinion", mate)]
    gap = np.flatnonzero(np.isnan(rings[1][:, 0]))
    if design["element"] == "internal":
        outer, inner = rings[1][: gap[0]], rings[1][gap[0] + 1 :]
        other = shapely.Polygon(outer, [inner])
    else:
        other = shapely.Polygon(rings[1])
    pinion = shapely.Polygon(rings[0])
    assert pinion.intersection(other).area < 1e-4 * design["module"] ** 2
    assert pinion.distance(other) < 1e-3 * design["module"], "without backlash flanks touch"


@pytest.mark.parametrize("design", PAIRS.values(), ids=PAIRS.keys())
def test_the_path_of_contact_ends_where_the_tips_are(design):
    pair = element(design)
    x, y = line(chart(design, "profile"), "path of contact")
    sizes = pair.sizes()
    assert np.hypot(x[1] - x[0], y[1] - y[0]) == pytest.approx(sizes["path_of_contact"].value, rel=1e-9)
    assert np.arctan2(x[1] - x[0], y[1] - y[0]) == pytest.approx(
        np.radians(sizes["working_pressure_angle"].value), rel=1e-9
    )
    middle = np.interp(0.0, y, x)
    assert middle == pytest.approx(sizes["pinion_working_diameter"].value / 2.0, rel=1e-9), "through the pitch point"
    assert np.hypot(x[1], y[1]) == pytest.approx(pair.pinion.tooth.flank.usable_tip_radius, rel=1e-9)
    if design["element"] == "spur":
        assert np.hypot(x[0] - 84.0, y[0]) == pytest.approx(pair.gear.tip_radius, rel=1e-9)
    if design["element"] == "rack":
        assert x[0] == pytest.approx(pair.placements()[1][0, 3] - pair.gear.tooth.addendum, abs=1e-3)


@pytest.mark.parametrize("design", PAIRS.values(), ids=PAIRS.keys())
def test_flanks_touch_along_the_path_of_contact(design):
    """Where it crosses a flank of the pinion squarely, there it meets the mate's; the other flanks it crosses askew."""
    import shapely

    found = chart(design, "profile")
    ends = np.stack(line(found, "path of contact"), axis=-1)
    path, way = shapely.LineString(ends), (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    pinion = np.stack(line(found, "pinion"), axis=-1)
    mate = np.stack(line(found, "rack" if design["element"] == "rack" else "gear"), axis=-1)
    cuts = np.flatnonzero(np.isnan(mate[:, 0]))
    loops = [shapely.LineString(part[~np.isnan(part[:, 0])]) for part in np.split(mate, cuts)]
    squarely = 0
    for a, b in pairwise(pinion):
        crossing = path.intersection(shapely.LineString([a, b]))
        if crossing.is_empty or abs((b - a) @ way) > 0.02 * np.linalg.norm(b - a):
            continue
        squarely += 1
        assert min(crossing.distance(loop) for loop in loops) < 3e-3 * design["module"]
    assert 1 <= squarely <= 2


def test_a_bevel_tooth_is_as_thick_on_its_pitch_circle_as_its_sizes_say():
    """Arc of the developed pitch circle between flanks, against the outer thickness, which goes with the distance."""
    design = {"element": "bevel", **EXAMPLES["bevel gear"]["pitch angle 45°"]}
    gear = element(design)
    x, y = line(chart(design, "profile"), "teeth")
    radius = gear.mean_distance * np.tan(gear.pitch_cone_angle)
    angle, height = np.arctan2(x, radius + y), np.hypot(x, radius + y) - radius
    at = np.flatnonzero(height[:-1] * height[1:] < 0.0)
    crossing = angle[at] - height[at] * (angle[at + 1] - angle[at]) / (height[at + 1] - height[at])
    assert len(crossing) == 6, "two flanks of three teeth"
    thickness = np.sort(crossing)[1::2] - np.sort(crossing)[::2]
    expected = gear.sizes()["circular_thickness"].value * gear.mean_distance / gear.cone_distance
    assert radius * thickness == pytest.approx(expected, rel=1e-4)


def test_development_keeps_lengths_along_the_back_cone():
    """Of a point moved along the cone's slant, and of an arc about the axis; a crown gear's becomes a straight line."""
    for angle in (30.0, 89.999, 90.0):
        gear = element({"element": "bevel", "teeth": 30, "module": 3, "face_width": 8, "pitch_angle": angle})
        pitch, small = gear.pitch_cone_angle, 1e-6
        arc = developed(gear, np.full(2, pitch), np.array([0.2, 0.2 + small]))
        expected = small * gear.mean_distance * np.sin(pitch)
        assert np.linalg.norm(arc[1] - arc[0]) == pytest.approx(expected, rel=1e-6)
        slant = developed(gear, pitch + np.array([0.0, small]), np.zeros(2))
        assert slant[1] - slant[0] == pytest.approx([0.0, small * gear.mean_distance], rel=1e-6, abs=1e-15)
        if angle == 90.0:
            assert developed(gear, np.full(2, pitch), np.array([0.0, 0.3]))[:, 1] == pytest.approx(0.0, abs=1e-12)


def test_bevel_members_mesh_on_their_developed_cones():
    """By Tredgold's approximation they nearly touch and nearly do not cross."""
    import shapely

    design = {"element": "bevel", "teeth": [16, 20], "module": 5, "face_width": 20}
    found = chart(design, "profile")
    one, other = (np.stack(line(found, name), axis=-1) for name in ("pinion", "gear"))
    below = shapely.Polygon([*one, (one[-1, 0], -40.0), (one[0, 0], -40.0)])
    above = shapely.Polygon([*other, (other[-1, 0], 40.0), (other[0, 0], 40.0)])
    assert below.intersection(above).area < 0.01
    assert below.distance(above) < 0.01


def test_spiral_angles_are_those_of_the_sizes():
    found, sizes = chart(SPIRAL, "spiral-angle"), element(SPIRAL).pinion.sizes()
    x, y = line(found, "toe")
    expected = [sizes[f"{place}_spiral_angle"].value for place in ("inner", "mean", "outer")]
    assert y == pytest.approx(expected, rel=1e-12)
    assert y[1] == pytest.approx(35.0, rel=1e-12)
    along, angles = line(found, "circular trace")
    assert np.interp(x, along, angles) == pytest.approx(y, rel=1e-6)


def test_a_circular_trace_turns_as_its_cutter_does():
    """On the crown gear the trace is a circle of the cutter's radius: r² = R² + c² − 2 R c sin β … by three points."""
    x, y = line(chart(SPIRAL, "spiral-angle"), "circular trace")
    radius, beta = x, np.radians(y)
    # distance of the cutter's axis from the apex: the same seen from every point of the trace
    apart = radius**2 + 50.0**2 - 2.0 * radius * 50.0 * np.sin(beta)
    assert apart == pytest.approx(apart[0], rel=1e-9)


def test_the_range_of_the_transmission_error_is_that_of_the_running():
    found, sizes = chart(RUNNING, "transmission-error"), runs()
    x, apart = line(found, "axes")
    assert np.ptp(apart) == pytest.approx(sizes["transmission_error_at_offset_error"].value, rel=1e-9)
    _, designed = line(found, "as designed")
    assert np.ptp(designed) == pytest.approx(sizes["transmission_error"].value, abs=1e-6)
    assert (x[0], x[-1]) == (0.0, 2.0)
    assert np.all(np.diff(x) > 0.0)
    assert apart[:48] == pytest.approx(apart[48:96])
    assert apart[:48].mean() == pytest.approx(0.0, abs=1e-6)


def test_lengths_of_the_lines_of_contact_are_those_of_the_running():
    (_, y), sizes = line(chart(RUNNING, "contact-length"), "all lines"), runs()
    assert y.min() == pytest.approx(sizes["least_contact_length"].value)
    assert y.max() == pytest.approx(sizes["greatest_contact_length"].value)


def test_lines_of_contact_lie_on_the_flank():
    import shapely

    found = chart(RUNNING, "contact-lines")
    flank = shapely.Polygon(np.stack(line(found, "flank"), axis=-1)).buffer(1e-3)
    points = np.stack(line(found, "lines of contact"), axis=-1)
    assert shapely.contains_xy(flank, points[~np.isnan(points[:, 0])]).all()


@every_cam
def test_the_displacement_rises_by_the_lift(cam):
    made = element(cam)
    x, y = line(chart(cam, "cam-displacement"), "displacement")
    assert y.max() == pytest.approx(made.amount, rel=1e-12)
    assert y.min() == pytest.approx(0.0, abs=1e-9)
    assert (x[0], x[-1]) == (0.0, pytest.approx(360.0))


@every_cam
def test_velocity_is_the_slope_of_displacement_and_acceleration_that_of_velocity(cam):
    """By the cam angle in radians; positions in radians where the follower swings."""
    swings = element(cam).kind.swings
    psi, s = line(chart(cam, "cam-displacement"), "displacement")
    psi, s = np.radians(psi), np.radians(s) if swings else s
    velocity, acceleration = line(chart(cam, "cam-velocity"), "vel")[1], line(chart(cam, "cam-acceleration"), "acc")[1]
    for primitive, slope in ((s, velocity), (velocity, acceleration)):
        steps = np.diff(psi) * (slope[:-1] + slope[1:]) / 2.0
        assert np.cumsum(steps) == pytest.approx(primitive[1:] - primitive[0], abs=2e-3 * np.abs(primitive).max())
    assert np.abs(velocity).max() == pytest.approx(element(cam).sizes()["largest_velocity"].value, rel=1e-3)
    assert np.abs(acceleration).max() == pytest.approx(element(cam).sizes()["largest_acceleration"].value, rel=2e-3)


@every_cam
def test_pressure_angle_and_radius_of_curvature_reach_what_the_sizes_say(cam):
    sizes = element(cam).sizes()
    pressure = line(chart(cam, "pressure-angle"), "pressure")[1]
    assert pressure.max() == pytest.approx(sizes["largest_pressure_angle"].value, rel=1e-3, abs=1e-9)
    radius = line(chart(cam, "curvature-radius"), "radius")[1]
    assert np.nanmin(radius[radius > 0.0]) == pytest.approx(sizes["least_curvature_radius"].value, rel=1e-2)
    hollow = radius[radius < 0.0]
    assert len(hollow) == 0 or -hollow.max() == pytest.approx(sizes["hollow_curvature_radius"].value, rel=1e-2)
    assert (len(hollow) > 0) == ("hollow_curvature_radius" in sizes)


@every_cam
def test_the_disk_encloses_the_area_of_its_sizes(cam):
    made = element(cam)
    x, y = line(chart(cam, "profile"), "profile")
    bore = np.pi * (made.bore or 0.0) ** 2 / 4.0
    assert area(x, y) == pytest.approx(made.sizes()["disk_area"].value - bore, rel=1e-4)


def test_a_cam_of_least_area_stands_beside_the_best_with_a_fixed_law():
    design = {"element": "cam", "programme": PROGRAMME, "swing": 30, "pivot_distance": 20, "thickness": 40,
              "minimise": "area"}  # fmt: skip
    found = chart(design, "cam-displacement")
    assert [one["style"] for one in found["lines"]] == ["solid", "dashed"]
    assert max(found["lines"][1]["y"]) == pytest.approx(30.0)
    assert found["lines"][0]["y"] != found["lines"][1]["y"]


def test_convergence_shows_the_errors_that_the_study_finds():
    design = {"element": "helical", **EXAMPLES["helical gear"]["fillets, left"]}
    found, study = chart(design, "convergence"), approximation_error(element(design))
    assert found["log"] == "both"
    x, y = line(found, "volume")
    assert x == pytest.approx([row.step for row in study.rows])
    assert y == pytest.approx([abs(row.volume) for row in study.rows])
    assert f"order {study.orders['inertia']:.2f}" in line_name(found, "inertia")


def line_name(found, start):
    return next(one["name"] for one in found["lines"] if one["name"].startswith(start))


def test_the_section_of_a_sweep_has_its_area():
    name = "twisted, scaled and skewed, with two holes"
    design = {"element": "sweep", **EXAMPLES["sweep"][name]}
    expected = element(design).sizes()["section_area"].value
    assert area(*line(chart(design, "profile"), "section")) == pytest.approx(expected, rel=1e-9)


def test_a_chart_that_there_is_not_is_refused_with_those_there_are():
    with pytest.raises(ProblemsError, match=r"no such chart of a spur gear(?s:.*)profile, convergence"):
        chart(SPUR, "transmission-error")


def test_a_design_that_cannot_be_built_is_refused_with_its_problems():
    with pytest.raises(ProblemsError, match=r"spur gear cannot be built so(?s:.*)teeth = 1"):
        chart({**SPUR, "teeth": 1}, "profile")


def test_every_kind_of_the_catalog_has_an_example_here():
    assert set(BY_NAME) == set(EXAMPLES)
