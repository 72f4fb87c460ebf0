"""The thesis's cam and its polygons, sizes, remarks, and what has no cam."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.cams.cam import Cam
from gearwright.errors import ParameterError
from gearwright.moments.polygon import polygon_moments

from ...examples import EXAMPLES

THESIS = {
    "programme": "dwell 36, rise 72, dwell 144, return 108",
    "swing": 30,
    "pivot_distance": 20,
    "face_offset": 70,
    "initial_angle": 20,
    "thickness": 40,
}
ROLLER = EXAMPLES["cam"]["translating roller, offset"]
ARM = EXAMPLES["cam"]["oscillating roller"]
FACE = {"programme": THESIS["programme"], "follower": "translating-flat-face", "lift": 10, "thickness": 9}


@pytest.mark.parametrize(
    ("law", "curvature", "area"), [("cycloidal", 2.823, 21305.38), ("3-4-5", 25.165, 21312.95)]
)  # fmt: skip
def test_the_regression_cams(law, curvature, area):
    """Independent values, made with a polygon of 20 000 vertices."""
    cam = gw.Cam(**THESIS, law=law, vertices=20_000)
    sizes = cam.sizes()
    assert sizes["least_curvature_radius"].value == pytest.approx(curvature, abs=5e-4)
    assert sizes["polygon_area"].value == pytest.approx(area, abs=5e-3)
    assert sizes["disk_area"].value == pytest.approx(area, abs=5e-3)
    if law == "cycloidal":
        np.testing.assert_allclose(cam.properties().centroid, [-3.12307, 3.33409, 20.0], atol=5e-6)


def test_moments_of_the_disk_are_those_of_its_section_swept():
    cam = gw.Cam(**THESIS)
    moments = polygon_moments([cam.traced.points(2.0 * np.pi * np.arange(200_000) / 200_000)])
    exact = cam.properties()
    assert exact.volume == pytest.approx(40.0 * moments[0, 0], rel=1e-8)
    assert exact.products[0] == pytest.approx(40.0 * moments[1, 1], rel=1e-7)
    assert exact.inertia[2, 2] == pytest.approx(40.0 * (moments[2, 0] + moments[0, 2]), rel=1e-8)
    assert exact.error_bound < 1e-14


def test_the_polygon_of_100_vertices_stands_beside_the_true_profile():
    """It is inscribed, so it holds less; the errors of volume and inertia fall with the square of the number."""
    exact = gw.Cam(**THESIS).properties()
    lost = []
    for count in (100, 200, 400):
        cam = gw.Cam(**THESIS, vertices=count)
        polygon = cam.polygon_properties()
        assert cam.polygon().shape == (count, 2)
        assert polygon.volume == pytest.approx(40.0 * cam.sizes()["polygon_area"].value, rel=1e-13)
        lost.append([1.0 - polygon.volume / exact.volume, 1.0 - polygon.inertia[2, 2] / exact.inertia[2, 2]])
    assert 5e-4 < lost[0][0] < 1e-3
    np.testing.assert_allclose(np.array(lost[:-1]) / np.array(lost[1:]), 4.0, rtol=0.05)


def test_the_polygon_stands_beside_the_cam_bored_like_it():
    cam = gw.Cam(**THESIS, bore=30)
    ((name, polygon),) = cam.beside(density=2.0).items()
    assert name == "polygon"
    assert polygon.volume == pytest.approx(40.0 * (cam.sizes()["polygon_area"].value - np.pi * 15.0**2), rel=1e-12)
    assert polygon.mass == 2.0 * polygon.volume


def test_a_polygon_that_the_bore_cuts_is_none():
    assert gw.Cam(**THESIS, bore=140, vertices=3).beside() == {}


def test_a_bore_takes_away_a_cylinder():
    plain, bored = (gw.Cam(**THESIS, bore=bore).properties() for bore in (None, 24.0))
    assert plain.volume - bored.volume == pytest.approx(np.pi * 12.0**2 * 40.0, rel=1e-12)
    assert gw.Cam(**THESIS, bore=24.0).sizes()["disk_area"].value * 40.0 == pytest.approx(plain.volume, rel=1e-13)


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 1e3, 1e9])
@pytest.mark.parametrize("values", [THESIS, ROLLER, ARM], ids=["face", "roller", "arm"])
def test_size_does_not_matter(values, scale):
    lengths = {
        "pivot_distance", "face_offset", "thickness", "lift", "base_radius", "roller_radius", "offset", "bore",
        "arm_length",
    }  # fmt: skip
    one, other = (gw.Cam(**{name: v * s if name in lengths else v for name, v in values.items()}) for s in (1.0, scale))
    assert other.properties().volume == pytest.approx(one.properties().volume * scale**3, rel=1e-11)
    assert other.sizes()["largest_pressure_angle"].value == pytest.approx(one.sizes()["largest_pressure_angle"].value)


def test_remarks():
    said = " ".join(gw.Cam(**THESIS).remarks)
    assert "the pressure angle reaches 83°; more than 45° is seldom of use" in said
    assert "the pivot goes about inside the disk's largest radius" in said
    assert "acceleration" not in said
    assert "the acceleration of the harmonic law jumps" in " ".join(gw.Cam(**THESIS, law="harmonic").remarks)
    steady = {**FACE, "base_radius": 40, "programme": "rise 180, return 180", "law": "harmonic"}
    assert gw.Cam(**steady).remarks == []


def _refused(**values):
    with pytest.raises(gw.ParameterError) as raised:
        gw.Cam(**values)
    found = {}
    for problem in raised.value.problems:
        name = problem.subject.split(" = ")[0]
        found[name] = "; ".join([*([found[name]] if name in found else []), problem.message])
    return found


def test_parameters_of_other_followers_are_refused_with_those_they_apply_to():
    found = _refused(**{**THESIS, "lift": 3, "roller_radius": 2, "base_radius": 9})
    assert "but to translating-flat-face and translating-roller" in found["lift"]
    assert "but to translating-roller and oscillating-roller" in found["roller_radius"]
    assert "does not apply to the follower oscillating-flat-face" in found["base_radius"]


def test_what_is_needed_is_named_together():
    found = _refused(programme="rise 180, return 180", follower="oscillating-roller", thickness=3)
    assert set(found) == {"swing", "pivot_distance", "arm_length", "roller_radius", "initial_angle"}
    assert 'let minimise "area" choose it' in found["arm_length"]
    assert "minimise" not in found["roller_radius"]


@pytest.mark.parametrize(
    ("values", "name", "said"),
    [
        ({**THESIS, "programme": "rise 90"}, "programme", "its angles make 90°, 270° too few"),
        ({**THESIS, "initial_angle": 60}, "initial_angle", "greater than -90° and less than 60° is possible"),
        ({**THESIS, "face_offset": -8}, "face_offset", "it must be greater than -6.84 mm"),
        ({**ARM, "base_radius": 200}, "base_radius", "greater than 11 and at most 127.7 mm is possible"),
        ({**ARM, "swing": 160}, "base_radius", "at most 22.28 mm is possible"),
        ({**ROLLER, "offset": -40}, "offset", "less than 33 mm either way is possible"),
        ({**ROLLER, "bore": 50}, "bore", "less than the base circle's diameter, 50 mm"),
        ({**THESIS, "free_values": 6}, "free_values", 'ask for one with minimise "area"'),
        ({**THESIS, "law": "spline"}, "law", "a design file or Python gives them"),
        ({**THESIS, "spline_values": (0.5,)}, "spline_values", 'applies to law "spline"'),
        (
            {**THESIS, "law": "spline", "spline_values": (0.2, 0.5, 0.7)},
            "spline_values",
            "3 cannot be shared by 2 moves",
        ),
        (
            {**THESIS, "law": "spline", "spline_values": (0.2, 0.5, 0.7, 0.6)},
            "spline_values",
            "in move 2, 0.6 breaks the order",
        ),
        ({**ARM, "initial_angle": 30}, "base_radius", "give only one of base_radius and initial_angle"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_refusals(values, name, said):
    assert said in _refused(**values)[name]


def _limit(text, before):
    """The number that a message says something must be greater than."""
    return float(text.split(f"{before} greater than ")[1].split()[0])


@pytest.mark.parametrize(
    ("values", "blamed", "free"),
    [
        ({**THESIS, "face_offset": 40}, "face_offset", "face_offset"),
        ({**FACE, "base_radius": 20}, "base_radius", "base_radius"),
        ({**ROLLER, "base_radius": 4, "bore": None}, "base_radius", "base_radius"),
        ({**ARM, "base_radius": 3, "roller_radius": 20, "law": "4-5-6-7"}, "base_radius", "base_radius"),
    ],
    ids=["swinging face", "face", "roller", "arm"],
)
def test_a_cusp_is_refused_with_the_limit_that_would_do(values, blamed, free):
    """At the limit that is named there is a cam, a little below it there is none."""
    said = _refused(**values)[blamed]
    assert "undercut: at cam angle" in said
    limit = _limit(said, free)
    cam = gw.Cam(**{**values, free: limit * (1.0 + 1e-9)})
    assert 0.0 < cam.sizes()["least_curvature_radius"].value < 0.01 * limit
    assert "undercut" in _refused(**{**values, free: limit * 0.998})[blamed]


def test_a_cusp_is_where_it_is_said_to_be():
    """There the profile's direction turns back."""
    said = _refused(**{**THESIS, "face_offset": 40})["face_offset"]
    angle = float(said.split("cam angle ")[1].split("°")[0])
    assert angle == pytest.approx(295.2, abs=0.1)
    assert "its radius of curvature is -27.18 mm" in said


def test_a_face_faster_than_the_cam_is_refused_with_the_angle_that_would_do():
    values = {**THESIS, "sense": "same", "swing": 50, "face_offset": 9000}
    said = _refused(**values)["programme"]
    assert "at cam angle 72° the face would turn faster than the cam" in said
    least = float(said.split("more than ")[1].split("°")[0])
    assert least == pytest.approx(100.0)  # twice the swing: the cycloidal law's peak velocity is 2
    assert (
        "faster" in _refused(**{**values, "programme": f"rise {least - 0.1}, return {360 - least + 0.1}"})["programme"]
    )
    slower = _refused(**{**values, "programme": f"rise {least + 0.1}, return {360 - least - 0.1}"})
    assert "programme" not in slower


def test_a_profile_that_crosses_itself_is_refused():
    """A deep and narrow valley between two rises, in which the roller does not fit."""
    values = {
        "programme": "dwell 150, return 30, rise 30, dwell 150", "follower": "translating-roller", "lift": 30,
        "base_radius": 20, "roller_radius": 20, "thickness": 3,
    }  # fmt: skip
    values["programme"] = "rise 30, dwell 290, return 30, dwell 10"
    found = _refused(**values)
    assert any("undercut" in said for said in found.values())


@pytest.mark.parametrize(
    ("programme", "jumps"),
    [("rise 180, return 180", False), ("rise 72, return 288", True), ("rise 90 2, rise 90, return 180", True)],
)
def test_harmonic_moves_are_smooth_only_where_the_next_one_mirrors_them(programme, jumps):
    given = {"programme": programme, "follower": "translating-flat-face", "lift": 5.0, "base_radius": 60.0}
    remarks = Cam(**given, law="harmonic", thickness=5.0).remarks
    assert any("acceleration" in remark for remark in remarks) == jumps


def test_the_largest_base_circle_that_an_arm_reaches_is_quoted():
    given = {"programme": "dwell 36, rise 72, dwell 144, return 108", "follower": "oscillating-roller", "swing": 20.0}
    given |= {"roller_radius": 10.0, "pivot_distance": 80.0, "arm_length": 60.0, "thickness": 5.0}
    with pytest.raises(ParameterError, match=r"greater than 10 and at most 127\.9 mm"):
        Cam(**given, base_radius=128.0)
    assert Cam(**given, base_radius=127.9).traced.follower.base_radius == pytest.approx(127.9)


def test_least_area_is_never_more_than_a_fixed_law_needs():
    """One value a move fits no law; then the best fixed law is the answer, and is called so."""
    given = {"programme": "dwell 36, rise 72, dwell 144, return 108", "swing": 30.0, "pivot_distance": 20.0}
    cam = Cam(**given, thickness=40.0, minimise="area", free_values=1)
    assert cam.optimum.law == "harmonic"
    assert cam.optimum.area == min(one.area for one in cam.compared.values() if one.keeps_limits)
    assert "no spline of so many values is better" in cam.remarks[0]
