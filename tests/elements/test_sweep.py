"""Sweeps as elements: their conventions, against solids whose moments have names, and their refusals."""

from dataclasses import replace

import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.sweep import Sweep

BLOCK = {"rectangle": (20, 12)}
BAR = {"circle": 0.1, "centre": (2.0, 0.0)}
OFF = {"polygon": ((1, 0), (4, 0), (4, 2), (1, 3))}
SPRING = {"radius": 12.0, "pitch": 7.0, "turns": 1.25}


def same(one, other, turn=None):
    """Whether two bodies have the same moments, the first one turned."""
    turn = np.eye(3) if turn is None else np.array(turn)
    a, b = one.properties(), other.properties()
    assert a.volume == pytest.approx(b.volume, rel=1e-12)
    np.testing.assert_allclose(turn @ a.centroid, b.centroid, atol=1e-12 * b.volume ** (1 / 3))
    scale = np.abs(b.central_inertia).max()
    np.testing.assert_allclose(turn @ a.central_inertia @ turn.T, b.central_inertia, atol=1e-11 * scale)


def test_a_frustum():
    """h (A₁ + A₂ + √(A₁A₂)) / 3."""
    body = Sweep(section=BLOCK, length=30, scale=(0.5, 0.5)).properties()
    assert body.volume == pytest.approx(4200.0, rel=1e-13)
    # centroid of a frustum: h (A₁ + 2√(A₁A₂) + 3A₂) / (4 (A₁ + √(A₁A₂) + A₂))
    assert body.centroid[2] == pytest.approx(30 * (240 + 240 + 180) / (4 * 420), rel=1e-13)


def test_a_skewed_bar_leans_the_way_it_is_told():
    centroid = Sweep(section={"circle": 1}, length=10, skew=(3, -2)).properties().centroid
    np.testing.assert_allclose(centroid, [1.5, -1.0, 5.0], atol=1e-14)


def test_a_positive_twist_is_right_handed():
    x, y, _ = Sweep(section=BAR, length=1, twist=90).properties().centroid
    assert x == pytest.approx(y, rel=1e-12)
    assert x == pytest.approx(2.0 * 2.0 / np.pi, rel=1e-12)


@pytest.mark.parametrize(
    "changes", [{}, {"twist": 75.0}, {"scale": (0.5, 1.5)}, {"twist": -130.0, "scale": (2.0, 0.5)}]
)
def test_a_straight_path_is_an_extrusion(changes):
    """Along +z section y is +x, so that section x is −y."""
    along = Sweep(section=OFF, path=((0, 0, 0), (0, 0, 9)), **changes)
    straight = Sweep(section=OFF, length=9, **changes)
    same(straight, along, [[0, 1, 0], [-1, 0, 0], [0, 0, 1]])


@pytest.mark.parametrize(("way", "reach"), [({"length": 5.0}, 5.0), ({"path": ((0, 0, 0), (3, 0, 4))}, 1.0)])
def test_polynomials_run_in_the_height_or_in_the_fraction_of_the_path(way, reach):
    transform = {"f1": (1.0, -0.5 / reach), "g2": (1.0, 0.5 / reach)}
    same(Sweep(section=OFF, transform=transform, **way), Sweep(section=OFF, scale=(0.5, 1.5), **way))


def test_a_spring_is_as_long_as_its_helix():
    spring = Sweep(section={"circle": 2.0}, path={"helix": SPRING})
    length = 1.25 * np.hypot(2.0 * np.pi * 12.0, 7.0)
    assert spring.sizes()["path_length"].value == pytest.approx(length, rel=1e-13)
    assert spring.properties().volume == pytest.approx(4.0 * np.pi * length, rel=1e-12)


def test_hands_of_springs_are_mirror_images():
    right, left = (
        Sweep(section={"circle": 2.0}, path={"helix": {**SPRING, "hand": hand}}).properties()
        for hand in ("right", "left")
    )
    assert right.centroid[1] > 1.0
    np.testing.assert_allclose(left.centroid, right.centroid * [1, -1, 1], rtol=1e-11)


def test_a_frame_is_what_its_name_says():
    """Clockwise round a circle, section x points outwards where y is up, but inwards where it seeks the centre."""
    circle = {"helix": {"radius": 20.0, "pitch": 0.0, "turns": 0.5, "hand": "left"}}
    for frame, reach in (("fixed-up", 24.0), ("frenet", 18.0)):
        body = Sweep(section={"circle": 1.0, "centre": (3.0, 0.0)}, path=circle, frame=frame)
        assert body.properties().bounding_box[1][0] == pytest.approx(reach, rel=1e-9)


def test_without_a_frame_the_section_turns_least():
    bent = ((0, 0, 0), (30, 0, 20), (60, 30, 20))
    unspoken, least, upright = (
        Sweep(section=OFF, path=bent, frame=frame).properties().centroid
        for frame in (None, "rotation-minimising", "fixed-up")
    )
    assert np.array_equal(unspoken, least)
    assert np.abs(unspoken - upright).max() > 1e-3


def test_a_torus():
    """Pappus: θ r̄ A."""
    torus = Sweep(section={"circle": 1.3, "centre": (5.0, 0.0)}, angle=360)
    assert torus.properties().volume == pytest.approx(166.796314, abs=5e-7)
    assert torus.sizes()["centroid_path"].value == pytest.approx(31.41592653589793, rel=1e-13)
    part = Sweep(section={"circle": 1.3, "centre": (5.0, 0.0)}, angle=90).properties()
    assert part.volume == pytest.approx(166.796314 / 4.0, abs=2e-7)
    assert part.centroid[0] > 2.0
    assert part.centroid[1] > 2.0


def test_holes_and_splines():
    holed = Sweep(section={"polygon": ((0, 0), (4, 0), (4, 4), (0, 4)), "holes": (((1, 1), (2, 1), (2, 3)),)}, length=2)
    assert holed.sizes()["section_area"].value == pytest.approx(15.0, rel=1e-14)
    assert holed.sizes()["section_perimeter"].value == pytest.approx(16.0 + 3.0 + np.sqrt(5.0), rel=1e-13)
    assert holed.properties().volume == pytest.approx(30.0, rel=1e-13)
    spline = {"spline": ((4, 0), (0, 4), (-4, 0), (0, -4)), "holes": (((1, 0), (0, 1), (-1, 0), (0, -1)),)}
    inner, outer = (
        Sweep(section={"spline": tuple((r * x, r * y) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)))}, length=1)
        for r in (1.0, 4.0)
    )
    difference = outer.properties().volume - inner.properties().volume
    assert Sweep(section=spline, length=1).properties().volume == pytest.approx(difference, rel=1e-13)


def test_a_rectangle_has_its_width_along_x_and_its_centre_where_it_is_told():
    box = Sweep(section={"rectangle": (4, 2), "centre": (10, 5)}, length=1).properties().bounding_box
    np.testing.assert_allclose(box, [[8, 4, 0], [12, 6, 1]], atol=1e-12)


def test_files_give_what_tables_give(tmp_path):
    outline, points = tmp_path / "outline.csv", tmp_path / "points.csv"
    outline.write_text("x, y\n1, 0\n4, 0\n4, 2\n1, 3\n")
    points.write_text("# a bend\n0 0 0\n0 0 30\n20 10 60\n")
    by_file = Sweep(section=outline, path=str(points))
    same(by_file, Sweep(section=OFF, path=((0, 0, 0), (0, 0, 30), (20, 10, 60))))
    assert by_file.section == str(outline)


def test_values_may_be_arrays():
    given = Sweep(section={"polygon": np.array(OFF["polygon"])}, length=np.float64(3), scale=np.array([0.5, 1.0]))
    assert given.scale == (0.5, 1.0)
    assert given == Sweep(section=OFF, length=3.0, scale=(0.5, 1.0))
    assert replace(given, length=6.0).properties().volume == pytest.approx(2.0 * given.properties().volume, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "extruded over 5 in"),
        ({"twist": -30, "scale": (1, 2), "skew": (0, 1)}, "extruded over 5 in, twisted by -30°, scaled, skewed"),
        ({"transform": {"h1": (0, 1)}}, "extruded over 5 in, transformed"),
        ({"length": None, "path": ((0, 0, 0), (3, 0, 4))}, "along a path of 5 in"),
        ({"length": None, "angle": 30, "section": BAR}, "revolved by 30°"),
    ],
)
def test_descriptions(changes, words):
    assert Sweep(**{"section": BLOCK, "length": 5, "length_unit": "in", **changes}).description == words


REFUSALS = [
    ({"length": None}, "length", ("how the section moves", "path", "angle")),
    ({"angle": 30}, "length = 5 mm", ("not together with angle",)),
    ({"path": ((0, 0, 0), (0, 0, 1)), "angle": 30}, "length = 5 mm", ("path and angle",)),
    ({"length": -5}, "length = -5 mm", ("greater than 0",)),
    ({"frame": "frenet"}, "frame = 'frenet'", ("does not apply to a sweep with length", "path")),
    ({"length": None, "path": ((0, 0, 0), (3, 0, 4)), "frame": "frennet"}, "frame", ("did you mean frenet?",)),
    ({"scale": (1, 0)}, "scale = (1, 0)", ("greater than 0",)),
    ({"scale": 2}, "scale = 2", ("2 numbers are needed: x, y",)),
    ({"skew": (1, 2, 3)}, "skew = (1 mm, 2 mm, 3 mm)", ("2 numbers",)),
    ({"twist": 3, "transform": {"f1": (1,)}}, "transform", ("takes the place of twist",)),
    ({"transform": {"f1": (1, -0.5)}}, "transform: section point", ("determinant", "from height 2 to height 5")),
    ({"transform": {"f4": (1,)}}, "transform", ("f4: there is no such entry",)),
    ({"transform": {"f1": (1, 0, 1e6)}}, "transform", ("f1 may reach 2.5e+07 between 0 and 5", "at most 1e+06")),
    ({"transform": {"h2": (1e300, -1e308)}}, "transform", ("h2 may reach inf", "at most 1e+12")),
    ({"transform": {"g1": (0,) * 17}}, "transform", ("1 to 16 finite numbers",)),
    ({"length": None, "path": ((0, 0, 0), (0, 0, 1)), "twist": 18001}, "twist = 18001°", ("18000° along a path",)),
    ({"twist": -360001}, "twist = -360001°", ("at least -360000",)),
    ({"transform": {"f1": ()}}, "transform", ("list of coefficients",)),
    ({"transform": {"f1": (1, float("nan"))}}, "transform", ("finite",)),
    ({"section": 3}, "section = 3", ("name of a file", "polygon", "circle")),
    ({"section": {"cirle": 3}}, "section = {cirle = 3}", ("did you mean circle?",)),
    ({"section": {"circle": 3, "center": (0, 0)}}, "section", ("center", "did you mean centre?")),
    ({"section": {"circle": 3, "rectangle": (1, 2)}}, "section", ("rectangle: there is no such entry",)),
    ({"section": {"circle": -3}}, "section", ("circle = -3: must be greater than 0",)),
    ({"section": {"rectangle": (3,)}}, "section", ("2 numbers are needed: width, height",)),
    ({"section": {"polygon": ((0, 0), (1, 0))}}, "section", ("at least 3 points",)),
    ({"section": {"polygon": ((0, 0), (1, 0), (1, "a"))}}, "section", ("point 2",)),
    ({"section": {"polygon": ((0, 0), (1, 0), (1, 1e13))}}, "section", ("point 2", "at most 1e+12")),
    ({"section": {"polygon": ((0, 0), (1, 0, 0), (1, 1))}}, "section", ("point 1",)),
    ({"section": {**OFF, "holes": ((0, 0), (1, 0), (1, 1))}}, "section", ("holes", "number 1 of the list")),
    ({"section": {**OFF, "holes": 3}}, "section", ("holes", "list")),
    ({"section": {"polygon": ((0, 0), (2, 2), (2, 0), (0, 3))}}, "section: loop 1 at", ("crosses itself",)),
    ({"section": "missing.dxf"}, "section = 'missing.dxf'", ("there is no such file",)),
    ({"section": ""}, "section = ''", ("name of a file",)),
    ({"length": None, "path": "missing.csv"}, "path = 'missing.csv'", ("there is no such file",)),
    ({"length": None, "path": "path.dxf"}, "path = 'path.dxf'", (".csv",)),
    ({"length": None, "path": ((0, 0, 0),)}, "path", ("at least 2 points",)),
    ({"length": None, "path": ((0, 0, 0), (0, 1))}, "path", ("point 1",)),
    ({"length": None, "path": ((0, 0, 0), (0, 0, 1), (0, 0, 1))}, "path: points 1 and 2", ("coincide",)),
    ({"length": None, "path": {"helix": {"radius": 1}}}, "path", ("pitch is needed: rise of each turn",)),
    ({"length": None, "path": {"helix": {**SPRING, "turns": 101}}}, "path", ("turns = 101: at most 100",)),
    ({"length": None, "path": {"helix": 3}}, "path", ("helix = 3", "radius")),
    ({"length": None, "path": {"helix": {"radius": 30, "pitch": 0, "turns": 2}}}, "path: turns = 2", ("give a pitch",)),
    (
        {"length": None, "path": {"helix": {"radius": 8, "pitch": 30, "turns": 2}}},
        "path: section point",
        ("radius of curvature",),
    ),
    ({"length": None, "path": ((0, 0, 0), (0, 0, 1)), "skew": (1, 0)}, "skew", ("but to one with length",)),
    ({"length": None, "angle": 361}, "angle = 361°", ("at most 360",)),
    ({"length": None, "angle": 90}, "angle: section point", ("beyond the axis",)),
    ({"length": None, "angle": 90, "twist": 5}, "twist = 5°", ("but to one with length or path",)),
]


@pytest.mark.parametrize(("changes", "subject", "words"), REFUSALS, ids=range(len(REFUSALS)))
def test_refused_with_what_why_and_the_way_out(changes, subject, words):
    with pytest.raises(gw.ParameterError) as refused:
        Sweep(**{"section": BLOCK, "length": 5, **changes})
    own = [problem for problem in refused.value.problems if problem.subject.startswith(subject)]
    assert len(own) == 1, str(refused.value)
    assert all(word in own[0].message for word in words), str(own[0])


def test_all_problems_are_named_together():
    with pytest.raises(gw.ParameterError) as refused:
        Sweep(section="missing.svg", path="missing.csv", angle=-3, twist="a", scale=(1,), frame="up", length_unit="ft")
    subjects = {problem.subject.split(" = ")[0] for problem in refused.value.problems}
    assert subjects == {"section", "path", "angle", "twist", "scale", "frame", "length_unit"}


def test_a_file_the_machine_cannot_read_is_the_machine_s_fault(monkeypatch):
    def failing(path, layer=None):
        raise gw.MachineError("the disk is gone")

    monkeypatch.setattr("gearwright.elements.sweep.read", failing)
    with pytest.raises(gw.MachineError, match="the disk is gone"):
        Sweep(section="outline.dxf", length=3)


SHEET = """
0,0
10,0
10,5
0,5

20,0
26,0
26,3
"""


class TestDrawings:
    @pytest.fixture(autouse=True)
    def drawing(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        (tmp_path / "sheet.csv").write_text(SHEET, encoding="utf-8")

    def test_one_region_of_several(self):
        assert Sweep(section="sheet.csv", around=(5, 2), length=2).properties().volume == pytest.approx(100.0)
        assert Sweep(section="sheet.csv", around=(24, 1), length=2).properties().volume == pytest.approx(18.0)

    def test_several_regions_are_refused_with_the_way_out(self):
        with pytest.raises(
            gw.ParameterError, match=r"holds 2 regions; .* around(.|\n)*region 2: loop about \(23, 1.5\)"
        ):
            Sweep(section="sheet.csv", length=2)
        with pytest.raises(gw.ParameterError, match="no region around"):
            Sweep(section="sheet.csv", around=(15, 1), length=2)

    def test_layers_are_of_drawings(self):
        with pytest.raises(gw.ParameterError, match="no layers"):
            Sweep(section="sheet.csv", layer="CUT", around=(5, 2), length=2)
        with pytest.raises(
            gw.ParameterError, match=r"layer = 'CUT': applies to a section from a drawing(.|\n)*around = "
        ):
            Sweep(section={"circle": 2}, layer="CUT", around=(5, 2), length=2)

    def test_another_unit_and_what_is_passed_over_are_noted(self):
        import ezdxf

        drawing = ezdxf.new()
        drawing.header["$INSUNITS"] = 1
        drawing.modelspace().add_circle((0, 0), 2)
        drawing.modelspace().add_text("2 off")
        drawing.saveas("disc.dxf")
        notes = Sweep(section="disc.dxf", length=2).remarks
        assert notes[0] == "disc.dxf states in, but its numbers were taken as mm; is length_unit right?"
        assert notes[1] == "passed over in the drawing: 1 TEXT"
        assert len(Sweep(section="disc.dxf", length=2, length_unit="in").remarks) == 1
