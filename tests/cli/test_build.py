"""`gearwright build design.toml`."""

import json
import shlex

import pytest

import gearwright as gw
from gearwright.elements.sweep import Sweep

SPUR = 'element = "spur"\nteeth = 16\nmodule = 8\nface_width = 50\n'
PAIR = 'element = "bevel"\nteeth = [16, 20]\nmodule = 4\nface_width = 15\nroot = "radial"\n'
SWEEP = 'element = "sweep"\nlength = 5\nsection = {polygon = [[1, 0], [4, 0], [4, 2], [1, 3]]}\n'


@pytest.fixture
def build(run, tmp_path):
    """Builds a design by its text or bytes, in a folder of its own."""

    def built(design, *options):
        path = tmp_path / "designs" / "design.toml"
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(design if isinstance(design, bytes) else design.encode())
        return run("build", path, *options)

    return built


@pytest.mark.parametrize(
    ("design", "command"),
    [
        (SPUR.replace("16", "18") + "bore = 20.5\n", "spur --teeth 18 --module 8 --face-width 50 --bore 20.5"),
        (PAIR, "bevel --teeth 16 20 --module 4 --face-width 15 --root radial"),
        (PAIR + "bore = [10, 12]\n", "bevel --teeth 16 20 --module 4 --face-width 15 --root radial --bore 10 12"),
        (
            PAIR.replace("[16, 20]", "16") + "mate_teeth = 20\n",
            "bevel --teeth 16 --mate-teeth 20 --module 4 --face-width 15 --root radial",
        ),
    ],
)
def test_a_design_is_what_the_command_would_build(run, build, design, command):
    outcome, typed = build(design, "--json"), run(*shlex.split(command), "--json")
    assert (outcome.code, outcome.err) == (0, "")
    assert json.loads(outcome.out) == json.loads(typed.out)


@pytest.mark.parametrize(
    ("design", "parameters"),
    [
        ("", {}),
        ("twist = 30.5\nscale = [1, 2]\nskew = [-1, 0]\n", {"twist": 30.5, "scale": (1, 2), "skew": (-1, 0)}),
        ("[transform]\nf1 = [1, 0.1]\ng1 = [0, 0.5]\n", {"transform": {"f1": (1, 0.1), "g1": (0, 0.5)}}),
    ],
)
def test_a_sweep_by_tables(build, design, parameters):
    found = json.loads(build(SWEEP + design, "--json").out)
    element = Sweep(section={"polygon": ((1, 0), (4, 0), (4, 2), (1, 3))}, length=5, **parameters)
    assert found["properties"]["volume"] == element.properties().volume
    assert found["properties"]["centroid"] == element.properties().centroid.tolist()
    assert found["parameters"]["section"] == {"polygon": [[1, 0], [4, 0], [4, 2], [1, 3]]}


@pytest.mark.parametrize(
    "section",
    [
        "spline = [[4, 0], [0, 4], [-4, 0], [0, -4]]\nholes = [[[1, 0], [0, 1], [-1, 0]]]",
        "circle = 2\ncentre = [3, 1.5]",
        "rectangle = [2, 3]",
    ],
)
@pytest.mark.parametrize(
    "path", ["path = [[0, 0, 0], [0, 0, 30], [2, 10, 60]]", "path.helix = {radius = 20, pitch = 9, turns = 2}"]
)
def test_every_form_is_built(build, section, path):
    outcome = build(f'element = "sweep"\n{path}\n[section]\n{section}\n', "--json")
    assert outcome.code == 0, outcome.err
    assert json.loads(outcome.out)["properties"]["volume"] > 0


def test_file_names_are_relative_to_the_design(build, tmp_path, monkeypatch):
    (tmp_path / "designs" / "drawings").mkdir(parents=True)
    (tmp_path / "designs" / "drawings" / "outline.csv").write_text("1,0\n4,0\n4,2\n1,3\n")
    (tmp_path / "bend.csv").write_text("0,0,0\n0,0,30\n20,10,60\n")
    monkeypatch.chdir("/")
    outcome = build('element = "sweep"\nsection = "drawings/outline.csv"\npath = "../bend.csv"\n', "--json")
    assert outcome.code == 0, outcome.err
    absolute = build(f'element = "sweep"\nsection = "drawings/outline.csv"\npath = "{tmp_path}/bend.csv"\n', "--json")
    assert json.loads(absolute.out)["properties"] == json.loads(outcome.out)["properties"]
    missing = build('element = "sweep"\nsection = "outline.csv"\nlength = 3\n')
    assert f"section = '{tmp_path}/designs/outline.csv': there is no such file" in missing.err


def test_files_and_pictures_are_written_where_the_command_runs(build, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = build(SWEEP, "-o", "out/part.stl", "--picture", "out/part.png", "--tolerance", "0.1", "--density", "1000")
    assert outcome.code == 0, outcome.err
    assert gw.Polyhedron.load(tmp_path / "out/part.stl").properties().volume == pytest.approx(37.5, rel=1e-6)
    assert (tmp_path / "out/part.png").exists()
    assert "kg" in outcome.out


def test_remarks_keep_the_names_of_the_design(build):
    outcome = build(PAIR + "working_depth = 1\nwhole_depth = 1.1\ngear_addendum = 0.4\n")
    assert outcome.code == 0, outcome.err
    assert "note: working_depth = 1 mm" in outcome.err


REFUSALS = [
    (
        "",
        (
            "this names no element",
            "element: one of bevel, spur, helical, herringbone, internal, rack, sweep, cam is needed at the top",
        ),
    ),
    ("teeth = 3\n", ("element: one of bevel",)),
    ('elemnt = "spur"\n', ("elemnt: there is no such key; did you mean element?",)),
    ('element = "spurr"\n', ("element = 'spurr'", "did you mean spur?")),
    ("element = 3\n", ("element = 3: one of bevel",)),
    ('element = ["spur"]\n', ("element = ['spur']",)),
    (
        SPUR.replace("teeth", "teth") + "bore = -3\nfoo = 1\n",
        ("teth = 16", "did you mean teeth?", "bore = -3", "foo = 1"),
    ),
    (SPUR.replace("16", '"16"'), ("teeth = '16': a whole number is needed, not text",)),
    (SPUR.replace("16", "16.0"), ("teeth = 16.0: a whole number is needed",)),
    (SPUR.replace("16", "[16, 20, 24]"), ("teeth = (16, 20, 24): give one value for each",)),
    (SPUR.replace("16", "true"), ("teeth = True: a whole number is needed, not bool",)),
    (SPUR.replace("50", "inf"), ("face_width = inf mm: a finite number is needed",)),
    (SPUR.replace("50", "2024-01-31"), ("face_width", "not date")),
    (SPUR.replace("50", "{a = 1}"), ("face_width = {a = 1}", "a number is needed, not a table")),
    ('element = "spur"\n', ("teeth: is needed: number of teeth", "face_width: is needed", "module: give one of")),
    (
        PAIR + "mate_teeth = 3\n",
        ("a bevel pair (teeth with two numbers)", "mate_teeth: applies to a bevel gear (teeth w"),
    ),
    (PAIR.replace("[16, 20]", "[16, 20, 24]"), ("teeth = (16, 20, 24): give one value for each of the two members",)),
    (SPUR + "module = 3\n", ("design.toml: line 5, column", "no TOML")),
    ('element = "spur"\nteeth = \n', ("design.toml: line 2, column 9: this is no TOML",)),
    ('element = "spur"\nteeth = [1,\n\n', ("design.toml: line 3, the last: this is no TOML",)),
    ('element = "spur"\nteeth = [1,', ("design.toml: line 2, the last: this is no TOML",)),
    (b'element = "spur"\n# \xff\n', ("design.toml: line 2: this is no text in UTF-8",)),
    ("a = " + "[" * 3000, ("nested",)),
    (SWEEP.replace("polygon", "poligon"), ("section", "did you mean polygon?")),
    (SWEEP.replace("length = 5", ""), ("length: how the section moves is not said",)),
    (SWEEP + "angle = 30\n", ("length = 5 mm: not together with angle",)),
    (SWEEP + "[transform]\nf1 = 1\n", ("transform", "f1 = 1: give a list of coefficients")),
    (SWEEP + 'transform = "x*y"\n', ("transform = 'x*y': give a table",)),
]


@pytest.mark.parametrize(("design", "words"), REFUSALS, ids=range(len(REFUSALS)))
def test_refused_in_the_words_of_the_design(build, design, words):
    outcome = build(design, "--json")
    assert outcome.code == 2
    assert outcome.out == ""
    assert "design.toml" in outcome.err.splitlines()[0]
    assert "Traceback" not in outcome.err
    assert all(word in outcome.err for word in words), outcome.err


def test_options_and_parameters_are_refused_together(build):
    outcome = build(SPUR + "bore = -3\n", *"--density -1 -o a.igs --turn 3".split())
    assert outcome.code == 2
    for text in ("bore = -3 mm", "--density = -1", "--output a.igs", "--turn: applies to a pair"):
        assert text in outcome.err


def test_what_is_no_file_is_refused(run, tmp_path):
    for name, words in ((tmp_path / "none.toml", "there is no such file"), (tmp_path, "this is a folder")):
        outcome = run("build", name)
        assert outcome.code == 2
        assert outcome.err.startswith(f"{name}: {words}")
    assert "DESIGN.toml: a value is needed" in run("build").err


def test_a_byte_order_mark_is_no_part_of_a_design(build):
    assert build(b"\xef\xbb\xbf" + SPUR.encode()).code == 0
