"""`gearwright schema`, against the designs that `gearwright build` takes and refuses."""

import json

import pytest
from jsonschema import Draft202012Validator

from gearwright import catalog
from gearwright.designs.kinds import parameters_of

from ..examples import BY_NAME, EXAMPLES

COMMANDS = sorted({element.command for element in catalog.ELEMENTS})
DESIGNS = {
    f"{name} {example}": json.loads(json.dumps({"element": BY_NAME[name].command, **parameters}))
    for name, examples in EXAMPLES.items()
    for example, parameters in examples.items()
}
BOX = {"rectangle": [3, 2]}
TURN = "rise 180, return 180"


@pytest.fixture
def validator(run):
    """A validator by the schema that the command prints."""

    def printed(*words):
        outcome = run("schema", *words)
        assert (outcome.code, outcome.err) == (0, "")
        schema = json.loads(outcome.out)
        Draft202012Validator.check_schema(schema)
        assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
        return Draft202012Validator(schema)

    return printed


@pytest.mark.parametrize("command", [None, *COMMANDS])
def test_every_example_is_valid(validator, command):
    check = validator(*([] if command is None else [command]))
    for name, design in DESIGNS.items():
        assert check.is_valid(design) == (command in (None, design["element"])), name


WRONG = [
    {},
    {"element": "spur"},
    {"element": "spurr", "teeth": 16, "module": 8, "face_width": 50},
    {"teeth": 16, "module": 8, "face_width": 50},
    *(
        {"element": "spur", "teeth": 16, "module": 8, "face_width": 50, **change}
        for change in (
            {"teeth": 2},
            {"teeth": 16.5},
            {"teeth": "16"},
            {"teeth": [16, 20, 24]},
            {"module": 0},
            {"face_width": 1e13},
            {"pressure_angle": 60},
            {"backlash": -1},
            {"root": "cut"},
            {"facewidth": 3},
            {"length_unit": "ft"},
            {"mate_teeth": 20},
        )
    ),
    *(
        {"element": "bevel", "teeth": [16, 20], "module": 4, "face_width": 15, **change}
        for change in ({"teeth": [16, 20, 24]}, {"teeth": [16, 2]}, {"bore": [1, 2, 3]}, {"mate_teeth": 20})
    ),
    *(
        {"element": "cam", "programme": TURN, "follower": "translating-flat-face", "lift": 5, "thickness": 9, **change}
        for change in (
            {"base_radius": 0},
            {"programme": ""},
            {"follower": "knife-edge"},
            {"law": "linear"},
            {"minimise": "weight"},
            {"spline_values": []},
            {"vertices": 2},
            {"thickness": None},
        )
    ),
    *(
        {"element": "sweep", "section": BOX, "length": 5, **change}
        for change in (
            {"section": 3},
            {"section": ""},
            {"section": {}},
            {"section": {"circle": 3, "rectangle": [3, 2]}},
            {"section": {"circle": -3}},
            {"section": {"circle": 3, "centre": [1, 2, 3]}},
            {"section": {"polygon": [[0, 0], [1, 0]]}},
            {"section": {"polygon": [[0, 0], [1, 0], [1, 1, 1]]}},
            {"section": {"polygon": [[0, 0], [1, 0], [1, "a"]]}},
            {"section": {"polygon": [[0, 0], [1, 0], [1, 1]], "holes": [[0, 0], [1, 0], [1, 1]]}},
            {"length": None, "path": [[0, 0, 0]]},
            {"path": {"helix": {"radius": 3}}},
            {"path": {"helix": {"radius": 3, "pitch": 3, "hand": "up"}}},
            {"path": {"helix": {"radius": 3, "pitch": -3}}},
            {"angle": 361},
            {"frame": "up"},
            {"scale": 2},
            {"scale": [1, 0]},
            {"scale": [1, 1, 1]},
            {"skew": [0, -2e12]},
            {"transform": {"f4": [1]}},
            {"transform": {"f1": []}},
            {"transform": {"f1": 1}},
        )
    ),
]


@pytest.mark.parametrize("design", WRONG, ids=range(len(WRONG)))
def test_what_is_wrong_is_neither_valid_nor_built(validator, run, tmp_path, design):
    assert not validator().is_valid(design)
    given = {key: value for key, value in design.items() if value is not None}
    lines = [f"{key} = {_toml(value)}" for key, value in given.items()]
    (tmp_path / "wrong.toml").write_text("\n".join(lines))
    assert run("build", tmp_path / "wrong.toml").code == 2


@pytest.mark.parametrize("name", DESIGNS)
def test_every_example_is_built(run, tmp_path, name):
    lines = [f"{key} = {_toml(value)}" for key, value in DESIGNS[name].items()]
    (tmp_path / "design.toml").write_text("\n".join(lines))
    outcome = run("build", tmp_path / "design.toml", "--json")
    assert outcome.code == 0, outcome.err


def _toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value)


@pytest.mark.parametrize("element", catalog.ELEMENTS, ids=lambda element: element.name)
def test_every_parameter_has_its_meaning_unit_and_default(validator, element):
    schema = validator(element.command).schema
    (own,) = (one for one in schema.get("oneOf", [schema]) if one["title"] == element.name)
    declared = parameters_of(element)
    assert list(own["properties"]) == ["element", *(d.name for d in declared)]
    assert own["required"] == ["element", *(d.name for d in declared if d.required)]
    assert own["additionalProperties"] is False
    for d in declared:
        found = own["properties"][d.name]
        assert found["description"].startswith(d.parameter.meaning)
        assert ("x-unit" in found) == bool(d.parameter.unit)
        if not d.required and d.default is not None:
            assert found["default"] == json.loads(json.dumps(d.default))


def test_limits_are_those_declared(validator):
    (single, pair) = sorted(validator("bevel").schema["oneOf"], key=lambda one: one["title"])
    assert single["properties"]["teeth"] == {
        "description": "number of teeth, z",
        "type": "integer",
        "minimum": 3,
        "maximum": 10_000,
    }
    assert pair["properties"]["teeth"]["type"] == "array"
    assert [pair["properties"]["teeth"][key] for key in ("minItems", "maxItems")] == [2, 2]
    angle = single["properties"]["pressure_angle"]
    assert (angle["exclusiveMinimum"], angle["exclusiveMaximum"], angle["x-unit"]) == (0, 60, "deg")
    assert single["properties"]["trace"]["enum"] == [
        "straight",
        "skew",
        "logarithmic",
        "circular",
        "involute",
        "epicycloid",
    ]


def test_an_unknown_element_is_refused(run):
    outcome = run("schema", "bevle")
    assert (outcome.code, outcome.out) == (2, "")
    assert (
        "choose one of bevel, spur, helical, herringbone, internal, rack, sweep, cam; did you mean bevel?"
        in outcome.err
    )
