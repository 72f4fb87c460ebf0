"""What a page is told of a design: the shape first, then the values of the command line; refusals before anything."""

import json
import math

import pytest

import gearwright as gw
from gearwright import catalog
from gearwright.contact.running import running
from gearwright.designs.forms import kind_forms
from gearwright.designs.live import answers
from gearwright.errors import GeometryError, ProblemsError

from ..viewer.frames import read

FORMS = {form["name"]: form for form in kind_forms()}


def start(name):
    """As a browser would send it."""
    return json.loads(json.dumps(FORMS[name]["start"]))


@pytest.mark.parametrize("kind", catalog.ELEMENTS, ids=lambda kind: kind.name)
def test_every_kind_has_an_example_to_begin_with_and_is_told_whole(kind):
    mesh, values, overlays, approximation = answers({"design": start(kind.name), "material": "steel"})
    header, bodies = read(mesh)
    assert header["answer"] == "mesh"
    assert list(bodies) == (["pinion", "gear"] if kind.members == 2 else [kind.name])
    assert [one["answer"] for one in (values, overlays, approximation)] == ["values", "overlays", "approximation"]
    json.dumps([values, overlays, approximation], allow_nan=False)
    parts = values["document"] if kind.members == 2 else {kind.name: values["document"]}
    for name in bodies:
        properties = parts[name]["properties"]
        assert properties["mass"] == pytest.approx(7.85e-6 * properties["volume"])
        assert approximation["parts"][name]["volume"] == pytest.approx(properties["volume"], rel=1e-3)
        assert 0 < approximation["errors"][name]["volume"] < 1e-3
    assert [one["name"] for one in overlays["bodies"]] == list(bodies)
    assert bool(overlays["lines"]) == (kind.members == 2)


def test_the_shape_and_the_rest_are_what_is_told_whole():
    design = {"design": start("spur pair"), "id": 3}
    whole = list(answers(design))
    assert [*answers({**design, "part": "shape"}), *answers({**design, "part": "rest"})] == whole


def test_the_pair_turns_as_its_teeth_say():
    pair = start("spur pair")
    header, _ = read(next(answers({"design": pair})))
    pinion, gear = header["bodies"]
    assert (pinion["spin"], gear["spin"]) == pytest.approx((1, -17 / 40))
    rack, _ = read(next(answers({"design": start("rack and pinion")})))
    assert rack["bodies"][1]["spin"] == 0
    assert any(rack["bodies"][1]["slide"])
    assert [(body["name"], body["called"]) for body in rack["bodies"]] == [("pinion", "pinion"), ("gear", "rack")]


def test_cones_and_cylinders_are_the_sizes():
    found = list(answers({"design": start("bevel pair")}))
    pinion = found[2]["bodies"][0]
    sizes = found[1]["document"]["pinion"]["sizes"]
    angles = {one["kind"]: one["half_angle"] for one in pinion["surfaces"]}
    assert angles["pitch"] == pytest.approx(33.690067525979785)
    assert angles["root"] < angles["base"] < angles["pitch"] < angles["face"] == sizes["face_angle"]["value"]
    found = list(answers({"design": start("spur gear")}))
    radii = {one["kind"]: one["radius"] for one in found[2]["bodies"][0]["surfaces"]}
    assert radii["pitch"] == 24
    assert radii["tip"] == 26
    assert all(one["least"] == pytest.approx(0, abs=1e-9) for one in found[2]["bodies"][0]["surfaces"])


def test_what_cannot_be_built_is_refused_before_anything_is_told():
    with pytest.raises(ProblemsError, match="face_width"):
        next(answers({"design": {**start("bevel pair"), "face_width": 90}}))
    with pytest.raises(ProblemsError, match="names no element"):
        next(answers({"design": {"element": "spurr"}}))
    with pytest.raises(ProblemsError, match="greater than 0"):
        next(answers({"design": start("spur gear"), "density": -1}))
    with pytest.raises(ProblemsError, match="no such one"):
        next(answers({"design": start("spur gear"), "material": "stel"}))


def test_forms_name_every_parameter_of_the_catalog_and_can_be_sent():
    text = json.dumps(kind_forms(), allow_nan=False)
    for kind in catalog.ELEMENTS:
        names = {one["name"] for one in FORMS[kind.name]["parameters"]}
        assert set(kind.start) <= names
        assert set(kind.settled).isdisjoint(names)
    assert '"only": {"kind"' not in text
    assert {one["suffix"] for one in FORMS["bevel gear"]["formats"] if one["what"] == "drawing"} == set()
    assert {one["suffix"] for one in FORMS["cam"]["formats"] if one["needs_density"]} >= {".urdf", ".sdf", ".mjcf"}


def test_face_cones_of_tapered_teeth_pass_through_the_crown():
    pair = {"element": "bevel", "teeth": [16, 40], "module": 4, "face_width": 25, "standard": "gleason-straight"}
    _, values, overlays, _ = answers({"design": pair})
    for body in overlays["bodies"]:
        sizes = {name: size["value"] for name, size in values["document"][body["name"]]["sizes"].items()}
        (cone,) = (one for one in body["surfaces"] if one["kind"] == "face")
        assert abs(sizes["face_apex"]) > 0.5
        slope = math.tan(math.radians(cone["half_angle"]))
        assert (sizes["crown_to_apex"] - cone["apex"]) * slope == pytest.approx(sizes["outside_diameter"] / 2)


def test_what_cannot_be_drawn_is_still_told_in_numbers():
    """A gear a million times as large as it is wide: no picture of it has few enough points."""
    told = list(answers({"design": {"element": "spur", "teeth": 24, "module": 1e9, "face_width": 16}}))
    assert [one["answer"] for one in told] == ["undrawn", "values", "overlays", "approximation"]
    assert "try" in told[0]["text"]
    assert told[1]["document"]["properties"]["volume"] > 1e20
    assert "try" in told[3]["missing"]


def test_a_face_too_narrow_for_lines_of_contact_has_none():
    pair = {"element": "bevel", "teeth": [16, 24], "module": 5, "face_width": 0.01}
    told = [one["answer"] if isinstance(one, dict) else "mesh" for one in answers({"design": pair})]
    assert told == ["mesh", "values", "overlays", "approximation"]
    with pytest.raises(GeometryError, match="make it wider"):
        running(gw.BevelPair(teeth=(16, 24), module=5, face_width=0.01))


def test_what_the_elements_name_says_is_not_said_again():
    for kind in ("helical", "spur", None):
        design = {"element": "spur", "kind": kind, "teeth": [16, 40], "module": 2, "face_width": 16}
        with pytest.raises(ProblemsError, match=r"kind = .*: the element's name, spur, says so already"):
            next(answers({"design": design}))
