"""A design's texts give the same design again, whichever way they are taken."""

import shlex
import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright import catalog
from gearwright.cli.app import build
from gearwright.cli.options import given_values, offered
from gearwright.designs.design import design_of
from gearwright.designs.kinds import kinds_of, parameters_of
from gearwright.designs.texts import texts
from gearwright.designs.toml_text import toml_text

from ..examples import BY_NAME, EXAMPLES

DESIGNS = [(name, example) for name in BY_NAME for example in EXAMPLES[name]]
every_design = pytest.mark.parametrize(("name", "example"), DESIGNS)

MEMBERS_WITHOUT = {"element": "spur", "teeth": [16, 40], "module": 3, "face_width": 20, "bore": ["none", 12.5]}
"""A pair of which one member has no bore."""


def table_of(name, example):
    return {"element": BY_NAME[name].command, **EXAMPLES[name][example]}


def built(table):
    element, problems = design_of(table).element()
    assert not problems
    return element


def typed(command):
    """The design that a command line asks for."""
    words = shlex.split(command)
    assert words[0] == "gearwright"
    _, bound, _ = build().parse_args(words[1:])
    kinds = kinds_of(words[1])
    parameters = offered({kind.name: parameters_of(kind) for kind in kinds})
    return {"element": words[1], **given_values(parameters, {k: v for k, v in bound.kwargs.items() if k in parameters})}


def listed(value):
    """As TOML and JSON give it: lists in place of tuples."""
    if isinstance(value, list | tuple):
        return [listed(one) for one in value]
    return {k: listed(v) for k, v in value.items()} if isinstance(value, dict) else value


@every_design
def test_the_toml_reads_back_to_the_same_element(name, example):
    table = table_of(name, example)
    read = tomllib.loads(texts(design_of(table))["toml"])
    assert design_of(read).kind.name == name
    assert built(read) == built(table)


@every_design
def test_the_python_builds_the_same_element(name, example):
    table = table_of(name, example)
    names = {}
    exec(texts(design_of(table))["python"], names)  # noqa: S102  it is what the test is of
    (element,) = (value for value in names.values() if hasattr(value, "length_unit"))
    assert element == built(table)
    assert type(element).__name__ in gw.__all__


@pytest.mark.parametrize(
    ("weight", "words"),
    [
        ({"density": 7850.0}, " --density 7850"),
        ({"material": "grey cast iron"}, " --material 'grey cast iron'"),
        ({}, ""),
    ],
)
def test_the_command_weighs_as_the_page_does(weight, words):
    command = texts(design_of(MEMBERS_WITHOUT), **weight)["command"]
    assert command == texts(design_of(MEMBERS_WITHOUT))["command"] + words


@every_design
def test_the_command_asks_for_the_same_element(name, example):
    table = table_of(name, example)
    command = texts(design_of(table))["command"]
    if any(isinstance(table.get(key), dict) for key in ("section", "path", "transform")) or "spline_values" in table:
        assert command == "gearwright build design.toml"
    else:
        assert built(typed(command)) == built(table)


def test_a_member_without_a_value_is_none_in_every_text():
    found = texts(design_of(MEMBERS_WITHOUT))
    assert 'bore = ["none", 12.5]' in found["toml"]
    assert "bore=(None, 12.5)" in found["python"]
    assert "--bore none 12.5" in found["command"]
    assert built(typed(found["command"])).bore == (None, 12.5)


def test_only_what_differs_from_the_defaults_is_said():
    table = {"element": "spur", "teeth": 24, "module": 2, "face_width": 10, "pressure_angle": 20, "bore": None}
    assert tomllib.loads(texts(design_of(table))["toml"]) == {
        "element": "spur",
        "teeth": 24,
        "module": 2,
        "face_width": 10,
    }
    assert texts(design_of({**table, "pressure_angle": 25}))["command"].endswith("--pressure-angle 25")


def test_a_pair_says_of_which_kind_it_is_in_python_alone():
    found = texts(design_of({"element": "internal", "teeth": [16, 44], "module": 2, "face_width": 8}))
    assert 'kind="internal"' in found["python"]
    assert "kind" not in found["toml"] + found["command"]


@pytest.mark.parametrize("folder", ["upload:1f2e/", "/srv/of the server/1f2e/"])
def test_an_uploaded_file_is_called_by_its_own_name(folder):
    table = {"element": "sweep", "section": f"{folder}my section.dxf", "length": 30}
    found = texts(design_of(table))
    assert tomllib.loads(found["toml"])["section"] == "my section.dxf"
    assert 'section="my section.dxf"' in found["python"]
    assert typed(found["command"])["section"] == "my section.dxf"


@pytest.mark.parametrize("value", ["-o", "--help", "", True, [1, 2, 3], [], [[1, 2]], {"a": 1}, None], ids=repr)
def test_what_cannot_be_typed_is_left_to_a_file(value):
    table = {"element": "sweep", "section": "a.dxf", "length": 3, "layer": value}
    command = texts(design_of(table))["command"]
    if value is None:
        assert command == "gearwright sweep --section a.dxf --length 3"
    else:
        assert command == "gearwright build design.toml"


def test_a_file_beside_the_design_keeps_its_folder():
    found = texts(design_of({"element": "sweep", "section": "drawings/a.dxf", "length": 30}))
    assert tomllib.loads(found["toml"])["section"] == "drawings/a.dxf"


def test_words_of_a_shell_stay_words():
    found = texts(design_of({"element": "sweep", "section": "a;rm $HOME `b`'.dxf", "length": 3}))
    assert typed(found["command"])["section"] == "a;rm $HOME `b`'.dxf"


NUMBERS = st.integers(-(10**30), 10**30) | st.floats(allow_nan=False)
WORDS = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
VALUES = st.recursive(
    NUMBERS | WORDS | st.booleans(),
    lambda inner: st.lists(inner, max_size=12) | st.dictionaries(WORDS, inner, max_size=4),
    max_leaves=40,
)


@settings(max_examples=200, deadline=None)
@given(st.dictionaries(WORDS, VALUES, max_size=6))
def test_toml_reads_back_to_the_same_values(table):
    read = tomllib.loads(toml_text(table))
    assert repr(read) == repr(table), "numbers to the last digit and of the same kind"


@settings(max_examples=150, deadline=None)
@given(name=st.sampled_from([kind.name for kind in catalog.ELEMENTS]), data=st.data())
def test_any_values_survive_their_toml(name, data):
    """Whether they make sense or not: what the server is sent is given back as it was."""
    kind = BY_NAME[name]
    names = data.draw(st.lists(st.sampled_from([d.name for d in parameters_of(kind)]), unique=True, max_size=8))
    table = {"element": kind.command, **{one: data.draw(VALUES) for one in names if one != "teeth"}}
    table["teeth"] = [16, 40] if kind.members == 2 else 16
    design = design_of(table)
    again = design_of(tomllib.loads(texts(design)["toml"]))
    defaults = {d.name: listed(d.default) for d in parameters_of(kind) if not d.required}
    for one, value in design.values.items():
        if one in design.file_names and value.startswith("/"):
            continue  # named otherwise
        if one in again.values:
            assert repr(again.values[one]) == repr(value)
        else:
            assert listed(value) == defaults[one] or value is None


def test_half_a_pair_of_surrogates_is_no_character():
    assert tomllib.loads(toml_text({"name": "a\ud800b"})) == {"name": "a�b"}
