import json

import numpy as np
import pytest

import gearwright
from gearwright import catalog
from gearwright.designs.kinds import parameters_of


@pytest.mark.parametrize("element", catalog.ELEMENTS, ids=lambda element: element.name)
def test_every_declared_parameter_is_on_the_help_page(run, element):
    outcome = run(element.command, "--help")
    assert outcome.code == 0
    for declaration in parameters_of(element):
        if not declaration.parameter.typed:
            assert f"--{declaration.name}" not in outcome.out
            continue
        assert f"--{declaration.name.replace('_', '-')}" in outcome.out
        assert declaration.parameter.symbol in outcome.out


def test_a_pair_shows_its_sizes_with_symbols_and_units(run, pair_options):
    outcome = run("bevel", *pair_options)
    assert outcome.code == 0
    for text in ("pinion", "gear", "outside diameter", "contact ratio", "clearance", "mm³", "about the centroid"):
        assert text in outcome.out
    assert "δ" in outcome.out
    assert max(map(len, outcome.out.splitlines())) <= 100


def test_json_of_a_pair_and_of_one_of_its_members(run, pair_options):
    pair = json.loads(run("bevel", *pair_options, "--json").out)
    assert set(pair) == {"pinion", "gear", "pair"}
    assert set(pair["gear"]) == {"parameters", "sizes", "placement", "properties"}
    assert pair["pair"]["parameters"]["teeth"] == [16, 20]
    options = "--teeth 20 --mate-teeth 16 --module 4 --face-width 15 --root radial --ends spherical".split()
    single = json.loads(run("bevel", *options, "--json").out)
    assert single["properties"]["volume"] == pytest.approx(pair["gear"]["properties"]["volume"], rel=1e-14)
    assert single["placement"] == np.eye(4).tolist()
    assert single["sizes"]["pitch_angle"]["unit"] == "deg"
    assert single["sizes"]["pitch_angle"]["value"] + pair["pinion"]["sizes"]["pitch_angle"]["value"] == pytest.approx(
        90
    )


def test_json_numbers_are_complete(run, pair_options):
    found = json.loads(run("bevel", *pair_options, "--json").out)
    element = gearwright.BevelPair(teeth=(16, 20), module=4.0, face_width=15.0, root="radial", ends="spherical")
    assert found["pinion"]["properties"]["volume"] == element.pinion.properties().volume
    assert found["pinion"]["properties"]["mass_unit"] == "mm^3"


@pytest.mark.parametrize(("unit", "metres"), [("mm", 1e-3), ("in", 0.0254)])
def test_density_is_si_whatever_the_length_unit(run, unit, metres):
    options = f"--teeth 30 --mate-teeth 40 --module 30 --face-width 3 --length-unit {unit} --density 7850".split()
    found = json.loads(run("bevel", *options, "--json").out)["properties"]
    assert found["mass_unit"] == "kg"
    assert found["mass"] == pytest.approx(7850 * found["volume"] * metres**3, rel=1e-12)


def test_all_problems_are_named_together(run):
    options = "--teeth 16 20 --module -3 --face-width nan --trace strait --pressure-angle abc".split()
    outcome = run("bevel", *options)
    assert outcome.code == 2
    assert outcome.out == ""
    for text in ("module = -3", "--face-width = nan", "straight, skew, logarithmic", "abc"):
        assert text in outcome.err
    assert "Traceback" not in outcome.err


def test_what_is_needed_is_named_together(run):
    outcome = run("bevel")
    assert outcome.code == 2
    assert "teeth: is needed" in outcome.err
    assert "--face-width: is needed" in outcome.err


def test_errors_are_those_of_the_element_with_options_for_names(run):
    outcome = run("bevel", *"--teeth 16 20 --module 4 --face-width 100 --gear-addendum 9".split())
    with pytest.raises(gearwright.ParameterError) as raised:
        gearwright.BevelPair(teeth=(16, 20), module=4.0, face_width=100.0, gear_addendum=9.0)
    assert outcome.code == 2
    assert outcome.err.splitlines()[0] == "A bevel pair (--teeth with two numbers) cannot be built with these options:"
    said = str(raised.value).replace("face_width", "--face-width").replace("gear_addendum", "--gear-addendum")
    assert outcome.err.splitlines()[1:] == said.splitlines()[1:]


def test_common_options_are_refused_together_with_the_others(run):
    outcome = run("bevel", *"--teeth 16 2 --module 4 --face-width 10 --density -1 --tolerance 1 -o a.igs".split())
    assert outcome.code == 2
    for text in ("--teeth = (16, 2)", "--density = -1", "--output a.igs"):
        assert text in outcome.err


def test_what_is_unusual_is_noted(run):
    options = (
        "--teeth 16 20 --diametral-pitch 2 --working-depth 0.8 --whole-depth 0.85 --root radial --face-width".split()
    )
    outcome = run("bevel", *options, "30")
    assert outcome.code == 0
    assert "note: --working-depth = 0.8 mm is 0.063 modules of 12.7 mm; about 2 is usual" in outcome.err
    assert "cone distance" not in outcome.err
    assert "note: --face-width = 60 mm is 0.37 × the cone distance" in run("bevel", *options, "60").err


def test_negative_numbers_are_values_not_options(run, pair_options):
    outcome = run("bevel", *pair_options, "--circular-thickness", 6.3, -0.3)
    assert outcome.code == 2
    assert "--circular-thickness = (6.3 mm, -0.3 mm)" in outcome.err


def test_three_values_are_too_many(run):
    outcome = run("bevel", *"--teeth 16 20 24 --module 4 --face-width 15".split())
    assert outcome.code == 2
    assert outcome.err.startswith("--teeth: one or two values are accepted, not 3.")


def test_an_option_of_the_other_kind_is_refused(run, pair_options):
    outcome = run("bevel", *pair_options, "--mate-teeth", 20)
    assert outcome.code == 2
    assert "--mate-teeth: applies to a bevel gear (--teeth with one number)" in outcome.err


@pytest.mark.parametrize("option", [["--placed"], ["--turn", "3"]])
def test_an_option_of_pairs_is_refused_for_one(run, option):
    outcome = run("bevel", *"--teeth 16 --mate-teeth 20 --module 4 --face-width 15".split(), *option)
    assert outcome.code == 2
    assert f"{option[0]}: applies to a pair" in outcome.err


@pytest.mark.parametrize(
    ("option", "text"),
    [
        (["--tolerance", "-1"], "--tolerance = -1: must be greater than 0"),
        (["--tolerance", "nan"], "--tolerance = nan: a finite number is needed"),
        (["--density", "0"], "--density = 0: must be greater than 0"),
        (["--density", "steel"], "--density"),
        (["-o", "gear.igs"], "gear.igs"),
        (["-o", "gear.step", "--step-schema", "AP203"], "choose AP214 or AP242"),
        (["-o", "gear.stl", "--step-schema", "AP242"], "applies to STEP files"),
        (["--picture", "gear.gif"], ".png"),
    ],
)
def test_common_options_are_checked(run, pair_options, tmp_path, monkeypatch, option, text):
    monkeypatch.chdir(tmp_path)
    outcome = run("bevel", *pair_options, *option)
    assert outcome.code == 2
    assert text in outcome.err
    assert not list(tmp_path.iterdir())


def test_a_folder_gets_one_file_a_member_in_its_own_frame(run, pair_options, tmp_path):
    folder = tmp_path / "pair"
    outcome = run("bevel", *pair_options, "-o", folder, "--tolerance", 0.1, "--json")
    assert outcome.code == 0, outcome.err
    assert sorted(path.name for path in folder.iterdir()) == ["gear.stl", "pinion.stl"]
    exact = json.loads(outcome.out)
    for name in ("pinion", "gear"):
        found = gearwright.Polyhedron.load(folder / f"{name}.stl").properties()
        assert found.volume == pytest.approx(exact[name]["properties"]["volume"], rel=0.02)
        assert found.centroid == pytest.approx(exact[name]["properties"]["centroid"], abs=0.1)
        assert f"{name}.stl" in outcome.err


def test_placed_members_and_the_assembly_are_where_json_puts_them(run, pair_options, tmp_path):
    outcome = run("bevel", *pair_options, "-o", tmp_path, "--placed", "--turn", 5, "--tolerance", 0.1, "--json")
    found = json.loads(outcome.out)
    placement = np.array(found["gear"]["placement"])
    expected = placement[:3, :3] @ found["gear"]["properties"]["centroid"] + placement[:3, 3]
    gear = gearwright.Polyhedron.load(tmp_path / "gear.stl").properties()
    assert gear.centroid == pytest.approx(expected, abs=0.1)
    assert abs(gear.centroid[0]) > 10
    assert run("bevel", *pair_options, "-o", tmp_path / "both.stl", "--tolerance", 0.1).code == 0
    both = gearwright.Polyhedron.load(tmp_path / "both.stl").properties()
    pinion = gearwright.Polyhedron.load(tmp_path / "pinion.stl").properties()
    assert both.volume == pytest.approx(gear.volume + pinion.volume, rel=1e-6)


def test_a_picture_is_drawn(run, pair_options, tmp_path):
    assert run("bevel", *pair_options, "--picture", tmp_path / "pair.png", "--tolerance", 0.2).code == 0
    assert (tmp_path / "pair.png").read_bytes().startswith(b"\x89PNG")


def test_a_spur_gear(run, tmp_path):
    options = "--teeth 16 --module 8 --face-width 50 --root radial".split()
    outcome = run("spur", *options, "--json", "-o", tmp_path / "spur.stl", "--tolerance", 0.05)
    assert outcome.code == 0, outcome.err
    exact = json.loads(outcome.out)["properties"]
    assert gearwright.Polyhedron.load(tmp_path / "spur.stl").properties().volume == pytest.approx(
        exact["volume"], rel=0.01
    )


def test_a_picture_is_told_the_length_unit(run, monkeypatch, tmp_path):
    drawn = []
    monkeypatch.setattr("gearwright.pictures.picture", lambda bodies, path, **options: drawn.append(options))
    options = "--teeth 16 20 --diametral-pitch 2 --face-width 1.5 --length-unit in --tolerance 0.05".split()
    assert run("bevel", *options, "--picture", tmp_path / "pair.png").code == 0
    assert drawn[0]["length_unit"] == "in"
    assert drawn[0]["title"] == "bevel pair: 16/20 teeth, straight, Σ = 90°"


def test_turn_turns_the_pinion(run, pair_options):
    placements = [
        np.array(json.loads(run("bevel", *pair_options, "--json", "--turn", turn).out)["pinion"]["placement"])
        for turn in (0, 5)
    ]
    between = placements[1][:3, :3] @ placements[0][:3, :3].T
    assert np.degrees(np.arccos((np.trace(between) - 1) / 2)) == pytest.approx(5, rel=1e-9)


def test_a_material_is_a_density(run):
    spur = "spur --teeth 16 --module 8 --face-width 50 --root radial --json".split()
    by_name, by_number = (
        json.loads(run(*spur, *words).out) for words in (["--material", "Steel"], ["--density", 7850])
    )
    assert by_name == by_number
    assert by_name["properties"]["mass_unit"] == "kg"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--material", "steel", "--density", 1], "--material steel: give either a material or a --density, not both"),
        (["--material", "stel"], "--material stel: there is no such one; did you mean steel?"),
    ],
)
def test_materials_that_cannot_be_used_are_refused_with_all_else(run, words, said):
    outcome = run(*"spur --teeth 2 --module 8 --face-width 50 --root radial".split(), *words)
    assert outcome.code == 2
    assert said in outcome.err
    assert "--teeth = 2" in outcome.err
