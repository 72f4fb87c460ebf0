"""Several bodies in a file, their densities, units, shells, sums and differences."""

import json

import numpy as np
import pytest

from .bodies import FACES, box, put

SHAFT, RIM = box("shaft", [2, 2, 10]), box("rim", [4, 4, 1], [5, 0, 0])


@pytest.fixture
def wheel(monkeypatch):
    put(monkeypatch, wheel=[SHAFT, RIM])


def document(run, *words):
    outcome = run("properties", *words, "--json")
    assert outcome.code == 0, outcome.err
    return json.loads(outcome.out)


def refusal(run, *words):
    outcome = run("properties", *words)
    assert (outcome.code, outcome.out) == (2, "")
    return outcome.err


def test_bodies_are_apart_and_together(run, wheel):
    found = document(run, "wheel")
    assert list(found["bodies"]) == ["shaft", "rim"]
    assert [one["volume"] for one in found["bodies"].values()] == pytest.approx([40, 16])
    assert found["volume"] == pytest.approx(56)
    assert found["centroid"][2] == pytest.approx((40 * 5 + 16 * 0.5) / 56)
    assert found["area"] == pytest.approx(88 + 48)


def test_a_density_for_each_body(run, wheel):
    found = document(run, "wheel", "--density", "shaft=7850", "--material", "rim=aluminum")
    masses = [40 * 7.85e-6, 16 * 2.7e-6]
    assert [one["mass"] for one in found["bodies"].values()] == pytest.approx(masses, rel=1e-14)
    assert found["mass"] == pytest.approx(sum(masses), rel=1e-14)
    assert found["centroid"][0] == pytest.approx((masses[0] * 1 + masses[1] * 7) / sum(masses), rel=1e-14)
    assert (found["mass_unit"], found["area"]) == ("kg", pytest.approx(136))


def test_a_density_without_a_name_is_of_all_others(run, wheel):
    found = document(run, "wheel", "--density", "1000", "--density", "rim=2000")
    assert [one["density"] for one in found["bodies"].values()] == pytest.approx([1e-6, 2e-6])


def test_like_densities_by_name_are_as_one_for_all(run, wheel):
    apart = document(run, "wheel", "--density", "shaft=7850", "--density", "rim=7850")
    assert apart == document(run, "wheel", "--material", "steel")


def test_names_of_no_body_are_refused_with_those_there_are(run, wheel):
    said = refusal(run, "wheel", "--density", "shat=1", "--density", "rim=1")
    assert "shat = 1 kg/m³: no body has this name; did you mean shaft?; there are shaft, rim" in said


def test_a_body_without_a_density_is_refused(run, wheel):
    assert "shaft: no density is given" in refusal(run, "wheel", "--density", "rim=1")


def test_bodies_that_close_only_together_are_one(run, monkeypatch):
    put(monkeypatch, box=[box("a", [1, 2, 3], faces=FACES[:2]), box("b", [1, 2, 3], faces=FACES[2:])])
    outcome = run("properties", "box", "--json", "--density", "1000")
    found = json.loads(outcome.out)
    assert (found["volume"], found["mass"]) == (pytest.approx(6), pytest.approx(6e-6))
    assert "bodies" not in found
    assert "note: box: its 2 bodies bound a solid only together and are taken as one" in outcome.err


def test_bodies_that_close_not_even_together_are_refused(run, monkeypatch):
    put(monkeypatch, box=[box("a", [1, 2, 3], faces=FACES[:2]), box("b", [1, 2, 3], faces=FACES[3:])])
    said = refusal(run, "box")
    assert "2 bodies, of which some bound no solid:\n  a: 8 open edges" in said


def test_a_void_that_is_a_body_of_its_own_belongs_to_the_other(run, monkeypatch):
    void = box("void", [1, 1, 1], [1, 1, 1], faces=[face[::-1] for face in FACES])
    put(monkeypatch, hollow=[box("skin", [4, 4, 4]), void])
    outcome = run("properties", "hollow", "--json")
    found = json.loads(outcome.out)
    assert found["volume"] == pytest.approx(63)
    assert "bodies" not in found
    assert "its 2 bodies bound a solid only together" in outcome.err
    assert any("bound a solid only together" in remark for remark in found["remarks"])
    assert "different densities" in refusal(run, "hollow", "--density", "skin=1", "--density", "void=2")


def test_bodies_one_inside_another_are_refused(run, monkeypatch):
    put(monkeypatch, twice=[box("skin", [4, 4, 4]), box("core", [1, 1, 1], [1, 1, 1])])
    assert "inside another" in refusal(run, "twice")
    assert "inside another" in refusal(run, "twice", "--density", "skin=1", "--density", "core=2")


def test_one_part_in_inches_and_in_millimetres_weighs_the_same(run, monkeypatch):
    size = np.array([1.0, 2.0, 3.0])
    factors = {"um": 25400, "mm": 25.4, "cm": 2.54, "m": 0.0254, "in": 1, "ft": 1 / 12}
    put(monkeypatch, **{unit: (unit, [box("part", size * factor)]) for unit, factor in factors.items()})
    for unit in factors:
        found = document(run, unit, "--material", "steel")
        assert found["length_unit"] == unit
        assert found["mass"] == pytest.approx(6 * 0.0254**3 * 7850, rel=1e-13)


@pytest.mark.parametrize(
    ("unit", "litres"), [("um", 1e-15), ("mm", 1e-6), ("cm", 1e-3), ("m", 1e3), ("ft", 28.316846592)]
)
def test_any_length_unit_goes_for_files_that_state_none(run, monkeypatch, unit, litres):
    put(monkeypatch, cube=[box("cube", [1, 1, 1])])
    assert document(run, "cube", "--length-unit", unit, "--density", "1000")["mass"] == pytest.approx(litres, rel=1e-14)


def test_four_bodies_are_side_by_side_and_five_below_each_other(run, monkeypatch):
    boxes = [box(f"part {k}", [1, 1, k + 1], [2 * k, 0, 0]) for k in range(5)]
    put(monkeypatch, four=boxes[:4], five=boxes)
    four, five = run("properties", "four").out, run("properties", "five").out
    assert "part 3" in four.splitlines()[2]
    (row,) = [line.split() for line in five.splitlines() if "part 3" in line]
    assert row == ["part", "3", "4", "6.5", "0.5", "2"]
    assert max(map(len, five.splitlines())) <= 100
    (total,) = [line for line in five.splitlines() if line.startswith(" volume ")]
    assert total.split()[-1] == "15"


def test_names_with_brackets_are_no_markup(run, monkeypatch):
    put(monkeypatch, odd=[box("[red]a[/red]", [1, 1, 1]), box("[b", [1, 1, 1], [3, 0, 0])])
    assert "[red]a[/red]" in run("properties", "odd").out


def test_a_sum_is_one_more_line(run, monkeypatch):
    put(monkeypatch, one=[SHAFT], other=[RIM], wheel=[SHAFT, RIM])
    lines = [json.loads(line) for line in run("properties", "one", "other", "--sum", "--json").out.splitlines()]
    assert [line["file"] for line in lines] == ["one", "other", None]
    whole = document(run, "wheel")
    for key in ("volume", "centroid", "inertia", "bounding_box"):
        np.testing.assert_allclose(lines[2][key], whole[key], rtol=1e-13, atol=1e-12)


def test_files_of_several_units_have_no_sum(run, monkeypatch):
    put(monkeypatch, one=("mm", [SHAFT]), other=("in", [RIM]))
    outcome = run("properties", "one", "other", "--sum", "--json")
    assert outcome.code == 2
    assert "other: it is in in and in^3, not mm and mm^3" in outcome.err
    assert len(outcome.out.splitlines()) == 2


def test_a_sum_says_what_is_not_in_it(run, monkeypatch):
    put(monkeypatch, one=[SHAFT])
    outcome = run("properties", "one", "missing.stl", "--sum", "--json")
    assert outcome.code == 2
    assert "could not be used are not in the sum" in outcome.err
    assert len(outcome.out.splitlines()) == 2


def test_a_part_is_taken_away(run, monkeypatch):
    put(monkeypatch, whole=[SHAFT], part=[box("hole", [1, 1, 10], [0.5, 0.5, 0])])
    found = document(run, "whole", "--subtract", "part", "--density", "1000")
    assert found["mass"] == pytest.approx(30e-6)
    assert found["central_inertia"][2][2] == pytest.approx(1e-6 * (40 * 8 / 12 - 10 * 2 / 12))
    assert found["subtracted"] == ["part"]


def test_what_cannot_be_taken_away(run, monkeypatch):
    put(monkeypatch, whole=("mm", [SHAFT]), wheel=[SHAFT, RIM], inches=("in", [RIM]))
    assert "inches: its lengths are in in, not mm" in refusal(run, "whole", "--subtract", "inches")
    assert "no part of the other" in refusal(run, "whole", "--subtract", "wheel")
    by_name = ("--density", "shaft=1", "--density", "rim=2")
    assert "its density is not known" in refusal(run, "wheel", "--subtract", "whole", *by_name)
    assert "missing.stl" in refusal(run, "whole", "--subtract", "missing.stl")


def test_shells_by_thickness_and_by_surface_density(run, monkeypatch):
    put(monkeypatch, can=("in", [box("can", [2, 3, 4], faces=FACES[1:])]))
    area, square_metre = 52 - 12, 0.0254**2
    thick = document(run, "can", "--shell", "0.1", "--density", "1000")
    assert thick["volume"] == pytest.approx(area * 0.1)
    assert thick["mass"] == pytest.approx(area * square_metre * 0.00254 * 1000, rel=1e-13)
    assert thick["shell"] == {"thickness": 0.1, "surface_density": None}
    light = document(run, "can", "--surface-density", "2.54")
    assert light["mass"] == pytest.approx(thick["mass"], rel=1e-13)
    np.testing.assert_allclose(light["inertia"], thick["inertia"], rtol=1e-12, atol=1e-18)
    assert light["volume"] is light["density"] is None
    assert "volume" not in run("properties", "can", "--surface-density", "2.54").out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--shell", "1", "--surface-density", "1"], "--surface-density: leave it out, or --shell"),
        (["--surface-density", "1", "--density", "1"], "it takes the place of a density"),
        (["--shell", "1", "--subtract", "a"], "--subtract: applies to solids"),
        (["--shell", "0"], "--shell = 0: must be greater than 0"),
        (["--density", "1", "--material", "steel"], "--material steel: the density is given already"),
        (["--density", "a=1", "--material", "a=steel"], "--material a=steel: the density of a is given already"),
        (["--density", "steel"], "--density steel: a number in kg/m³ is needed"),
        (["--density", "a=-1"], "--density a=-1: must be greater than 0"),
        (["--density", "nan"], "--density nan: a finite number is needed"),
        (["--material", "stel"], "did you mean steel?"),
        (["--length-unit", "inch"], "--length-unit inch: choose one of um, mm, cm, m, in, ft"),
        (["--jobs", "0"], "--jobs = 0: at least 1"),
        (["--about", "1", "2", "inf"], "--about 1.0 2.0 inf: three numbers of at most 1e+12"),
        (["--axes", "1,2,3,4"], "--axes 1,2,3,4: give file, principal, a unit quaternion"),
        (["--axes", "1,0,0,0,1,0,0,0,-1"], "a right-handed rotation is needed"),
        (["--json", "--format", "csv"], "--json asks for another"),
        (["--format", "urdf"], "--format urdf: it is in kg; a --density or --material is needed"),
        (["--format", "mjcf", "--density", "1", "--axes", "0,1,0,0"], "MJCF takes tensors along"),
        (["--format", "sdf", "--density", "1", "--about", "0", "0", "0"], "about the centre of mass only"),
        (["--allow", "holes"], 'Invalid value "holes" for --allow. Choose from: "open", "flipped"'),
        (["--jsn"], "--jsn: there is no such option; did you mean --json?"),
    ],
)
def test_options_that_cannot_be_used_are_refused(run, wheel, words, said):
    assert said in refusal(run, "wheel", *words)


def test_all_problems_of_options_are_said_together(run):
    said = refusal(run, "wheel", "--shell", "-1", "--jobs", "0", "--axes", "x", "--density", "a", "--length-unit", "yd")
    assert len(said.splitlines()) == 6


def test_allowed_problems_are_answered_with_a_warning(run, monkeypatch):
    put(monkeypatch, open=[box("box", [1, 2, 3], faces=FACES[1:])])
    said = refusal(run, "open")
    assert "or --allow open with the command" in said
    outcome = run("properties", "open", "--allow", "open", "--json")
    found = json.loads(outcome.out)
    assert found["volume"] == pytest.approx(5)  # without the pyramid from the missing side to the middle
    assert "another point would give another volume" in found["warnings"][0]
    assert "another point would give another volume" in outcome.err
    put(monkeypatch, flip=[box("box", [1, 2, 3], faces=[FACES[0][::-1], *FACES[1:]])])
    assert "flipped" in refusal(run, "flip", "--allow", "open")


def test_a_large_binary_stl_file_is_read_in_passing(run, tmp_path, monkeypatch):
    from gearwright import Polyhedron
    from gearwright.cli import measuring

    from .. import shapes

    vertices, triangles = shapes.torus(40, 30)
    path = tmp_path / "torus.stl"
    Polyhedron(vertices, triangles).save(path, length_unit="in")
    loaded = document(run, path, "--density", "1000")
    monkeypatch.setattr(measuring, "STREAMED", 1000)
    outcome = run("properties", path, "--json", "--density", "1000")
    found = json.loads(outcome.out)
    assert "read in passing" in outcome.err
    assert found["length_unit"] == "in"
    for key in ("mass", "volume", "area"):
        assert found[key] == pytest.approx(loaded[key], rel=1e-14)
    assert np.allclose(found["central_inertia"], loaded["central_inertia"], rtol=1e-13, atol=1e-15)
    Polyhedron(vertices, triangles[1:]).save(path, length_unit="in")
    assert "closure residual" in refusal(run, path)
    assert "it says itself that lengths are in in" in refusal(run, path, "--length-unit", "mm")
    # what has to be loaded is
    assert "3 open edges" in refusal(run, path, "--allow", "flipped")


def test_smooth_shapes_of_a_step_file_are_measured(run, tmp_path):
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer

    writer = STEPControl_Writer()
    writer.Transfer(BRepPrimAPI_MakeCylinder(3.0, 8.0).Shape(), STEPControl_AsIs)
    path = tmp_path / "cylinder.step"
    writer.Write(str(path))
    found = document(run, path, "--material", "steel")
    assert found["method"] == "quadrature"
    assert found["volume"] == pytest.approx(np.pi * 9 * 8, rel=1e-12)
    assert found["central_inertia"][2][2] == pytest.approx(found["mass"] * 9 / 2, rel=1e-10)
    assert found["area"] == pytest.approx(2 * np.pi * 3 * 11, rel=1e-3)


def test_bodies_whose_boxes_overlap_are_remarked(run, monkeypatch):
    put(monkeypatch, over=[box("a", [2, 2, 2]), box("b", [2, 2, 2], [1, 1, 1])])
    put(monkeypatch, beside=[box("a", [2, 2, 2]), box("b", [2, 2, 2], [2, 0, 0])])
    assert "the boxes of 1 pair of bodies overlap" in run("properties", "over").err
    assert run("properties", "beside").err == ""


def test_a_part_beyond_the_whole_is_not_subtracted(run, monkeypatch):
    put(monkeypatch, whole=[box("a", [4, 4, 4])], part=[box("b", [1, 1, 1], [3.5, 0, 0])])
    assert "reaches beyond the body" in refusal(run, "whole", "--subtract", "part")


def test_an_inverted_body_can_be_measured(run, monkeypatch):
    put(monkeypatch, inverted=[box("a", [1, 2, 3], faces=[face[::-1] for face in FACES])])
    assert "--allow inward" in refusal(run, "inverted")
    found = document(run, "inverted", "--allow", "inward")
    assert found["volume"] == pytest.approx(6)
    assert found["error_bound"] is None
