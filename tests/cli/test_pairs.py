"""`gearwright spur|helical|herringbone|internal|rack --teeth Z1 Z2`."""

import json

import ezdxf
import numpy as np
import pytest
from shapely import Polygon

import gearwright as gw
from gearwright.sections import drawings

SPUR = "spur --teeth 12 24 --module 3 --face-width 20 --profile-shift 0.6 0.36".split()
HELICAL = "helical --teeth 17 24 --module 2 --face-width 12 --helix-angle 20".split()
HERRINGBONE = "herringbone --teeth 17 24 --module 2 --face-width 12 --helix-angle 20".split()
INTERNAL = "internal --teeth 20 50 --module 2 --face-width 12".split()
RACK = "rack --teeth 17 8 --module 2 --face-width 12 --profile-shift 0.2".split()
PAIRS = {words[0]: words for words in (SPUR, HELICAL, HERRINGBONE, INTERNAL, RACK)}

every_pair = pytest.mark.parametrize("words", PAIRS.values(), ids=PAIRS)


def _python(words):
    """The pair that Python builds from the same words."""
    values = {"kind": words[0]}
    for word in words[1:]:
        if word.startswith("--"):
            name = word[2:].replace("-", "_")
            values[name] = []
        else:
            values[name].append(int(word) if name == "teeth" else float(word))
    return gw.GearPair(**{k: v if k == "kind" else tuple(v) if len(v) > 1 else v[0] for k, v in values.items()})


@every_pair
def test_json_is_what_python_says(run, words):
    outcome = run(*words, "--json", "--turn", 7)
    assert (outcome.code, outcome.err) == (0, "")
    found, pair = json.loads(outcome.out), _python(words)
    assert set(found) == {"pinion", "gear", "pair"}
    placements = pair.placements(7.0)
    for name, member, placement in (("pinion", pair.pinion, placements[0]), ("gear", pair.gear, placements[1])):
        assert set(found[name]) == {"parameters", "sizes", "placement", "properties"}
        assert found[name]["properties"]["volume"] == member.properties().volume
        np.testing.assert_array_equal(found[name]["placement"], placement)
        assert found[name]["sizes"].keys() == member.sizes().keys()
    assert found["pair"]["parameters"]["teeth"] == list(pair.teeth)
    for name, size in pair.sizes().items():
        own = found["pair"]["sizes"][name]
        assert (own["value"], own["symbol"]) == (size.value, size.symbol)
    symbols = [size.symbol for size in pair.sizes().values()]
    assert len(set(symbols)) == len(symbols)
    assert {"a_w", "α_wt", "ε_α", "ε_β", "ε_γ", "j_wt", "j_bn"} <= set(symbols)


def test_published_sizes_on_the_page(run):
    outcome = run(*SPUR)
    assert outcome.code == 0
    assert max(map(len, outcome.out.splitlines())) <= 100
    for text in ("a_w", "56.49987", "26.08856", "1.202102", "44.83974", "79.39974", "pinion", "gear", "mm³"):
        assert text in outcome.out


@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
@every_pair
def test_a_drawing_has_both_members_in_mesh(run, tmp_path, words, suffix):
    path = tmp_path / f"pair{suffix}"
    outcome = run(*words, "--drawing", path)
    assert outcome.code == 0, outcome.err
    pair, polygons = _python(words), {}
    for layer, member in (("pinion", pair.pinion), ("gear", pair.gear)):
        section = gw.Section.load(path, layer=layer)
        assert section.properties().area == pytest.approx(member.profile.properties().area, rel=1e-6)
        polygons[layer] = _polygon(section)
    common = polygons["pinion"].intersection(polygons["gear"]).area
    assert common < 1e-3
    assert polygons["pinion"].distance(polygons["gear"]) < 1e-3
    middle = polygons["pinion"].centroid
    assert (middle.x, middle.y) == pytest.approx((0.0, 0.0), abs=1e-4)


def _polygon(section):
    """A section as a polygon of many chords."""
    loops = [
        np.concatenate([curve.point(np.linspace(*curve.interval, 24, endpoint=False)) for curve in loop.curves])
        for loop in section.loops
    ]
    return Polygon(loops[0], loops[1:])


def test_layers_of_a_drawing_are_the_members(run, tmp_path):
    assert run(*SPUR, "--drawing", tmp_path / "pair.dxf").code == 0
    drawing = ezdxf.readfile(tmp_path / "pair.dxf")
    assert {entity.dxf.layer for entity in drawing.modelspace()} == {"pinion", "gear"}
    assert drawings.read(tmp_path / "pair.dxf").length_unit == "mm"


@every_pair
def test_a_folder_has_both_and_a_file_the_assembly(run, tmp_path, words):
    outcome = run(*words, "-o", tmp_path / "pair", "--tolerance", 0.05, "--json")
    assert outcome.code == 0, outcome.err
    exact = json.loads(outcome.out)
    assert sorted(path.name for path in (tmp_path / "pair").iterdir()) == ["gear.stl", "pinion.stl"]
    volumes = []
    for name in ("pinion", "gear"):
        found = gw.Polyhedron.load(tmp_path / "pair" / f"{name}.stl").properties()
        assert found.volume == pytest.approx(exact[name]["properties"]["volume"], rel=0.02)
        assert found.centroid == pytest.approx(exact[name]["properties"]["centroid"], abs=0.1)
        volumes.append(found.volume)
    assert run(*words, "-o", tmp_path / "both.stl", "--tolerance", 0.05).code == 0
    both = gw.Polyhedron.load(tmp_path / "both.stl").properties()
    assert both.volume == pytest.approx(sum(volumes), rel=1e-6)
    pair = _python(words)
    seats = pair.placements()
    parts = [(m.properties(), s) for m, s in zip((pair.pinion, pair.gear), seats, strict=True)]
    middle = sum(p.volume * (s[:3, :3] @ p.centroid + s[:3, 3]) for p, s in parts) / sum(p.volume for p, _ in parts)
    assert both.centroid == pytest.approx(middle, abs=0.05)


@every_pair
def test_a_design_file_gives_the_same_pair(run, tmp_path, words):
    pair = _python(words)
    lines = [f'element = "{words[0]}"', f"teeth = {list(pair.teeth)}", f"module = {pair.module}"]
    lines += [f"face_width = {pair.face_width}", *([f"helix_angle = {pair.helix_angle}"] if pair.helix_angle else [])]
    if pair.profile_shift is not None:
        lines.append(f"profile_shift = {json.dumps(pair.profile_shift)}")
    (tmp_path / "pair.toml").write_text("\n".join(lines))
    built, typed = run("build", tmp_path / "pair.toml", "--json"), run(*words, "--json")
    assert built.code == 0, built.err
    found, expected = json.loads(built.out), json.loads(typed.out)
    for name in ("pinion", "gear", "pair"):
        assert found[name]["sizes"] == expected[name]["sizes"]


def test_centre_distance_in_place_of_shifts(run):
    found = json.loads(run(*SPUR[:-3], "--centre-distance", 56.4999, "--json").out)
    assert found["pair"]["sizes"]["sum_of_profile_shifts"]["value"] == pytest.approx(0.96, abs=2e-5)


@pytest.mark.parametrize(
    ("words", "texts"),
    [
        ("spur --teeth 12 24 --module 3 --face-width 20 --helix-angle 20", ["Unknown option: --helix-angle"]),
        ("spur --teeth 12 24 --module 3 --face-width 20 --outer-diameter 90", ["Unknown option: --outer-diameter"]),
        ("rack --teeth 12 24 --module 3 --face-width 20 --outer-diameter 90", ["Unknown option: --outer-diameter"]),
        (
            "rack --teeth 12 24 --module 3 --face-width 20 --profile-shift 0.2 0.3",
            ["a rack has none"],
        ),
        ("internal --teeth 20 50 --module 3 --face-width 20 --rack-height 90", ["Unknown option: --rack-height"]),
        ("internal --teeth 50 20 --module 3 --face-width 20", ["--teeth = (50, 20)", "more teeth"]),
        ("internal --teeth 55 60 --module 3 --face-width 20", ["--teeth = (55, 60)", "interference"]),
        ("helical --teeth 20 30 --module 3 --face-width 20", ["--helix-angle: is needed"]),
        ("herringbone --teeth 20 30 --module 3 --face-width 20", ["--helix-angle: is needed"]),
        (
            "herringbone --teeth 20 30 --module 3 --face-width 20 22 --helix-angle 20",
            ["--face-width = (20 mm, 22 mm)", "mid-face"],
        ),
        (
            "spur --teeth 20 30 --module 2 --face-width 20 --centre-distance 46",
            ["too near"],
        ),
        ("spur --teeth 20 30 --module 2 --face-width 20 --centre-distance 54.9", ["--centre-distance = 54.9 mm"]),
        (
            "spur --teeth 20 30 --module 2 --face-width 20 --centre-distance 49 --profile-shift 0",
            ["--centre-distance = 49 mm", "at least 50 mm"],
        ),
        ("spur --teeth 20 30 --module 2 --face-width 20 --profile-shift 0 1.3", ["gear --profile-shift = 1.3"]),
        ("spur --teeth 20 30 --module -2 --face-width 0", ["--module = -2 mm", "--face-width = 0 mm"]),
        ("spur --teeth 20 30 40 --module 2 --face-width 20", ["--teeth: one or two values are accepted, not 3"]),
    ],
)
def test_refused_in_the_words_of_the_command_line(run, tmp_path, words, texts):
    outcome = run(*words.split(), "-o", tmp_path / "pair")
    assert (outcome.code, outcome.out) == (2, "")
    for text in texts:
        assert text in outcome.err
    assert "Traceback" not in outcome.err
    assert not list(tmp_path.iterdir())


def test_a_kind_is_not_an_option(run):
    outcome = run(*SPUR, "--kind", "rack")
    assert outcome.code == 2
    assert "--kind" in outcome.err
