from dataclasses import dataclass

import pytest

from gearwright.cli.options import given_values, offered, signature_parameters
from gearwright.parameters import Parameter, declarations, declared

COUNT = Parameter(meaning="how many", kind="integer", symbol="z", minimum=3)
SHIFT = Parameter(meaning="how far", unit="length", symbol="x")
SHAPE = Parameter(meaning="which", kind="choice", choices=("round", "1"))


@dataclass(frozen=True, kw_only=True)
class One:
    count: int = declared(COUNT)
    shape: str = declared(SHAPE, default="round")


@dataclass(frozen=True, kw_only=True)
class Two:
    count: tuple[int, int] = declared(COUNT, members="each")
    shift: float | tuple[float, float] = declared(SHIFT, default=0.0, members="both")
    shape: str = declared(SHAPE, default="round")


PARAMETERS = offered({"two": declarations(Two), "one": declarations(One)})


def test_all_parameters_of_all_kinds_are_offered_once():
    assert list(PARAMETERS) == ["count", "shift", "shape"]
    assert [one.only for one in PARAMETERS.values()] == ["", "two", ""]
    assert PARAMETERS["count"].declaration.members == "both"


def test_every_parameter_becomes_an_option():
    names = [parameter.name for parameter in signature_parameters(PARAMETERS)]
    assert names == list(PARAMETERS)


@pytest.mark.parametrize(
    ("name", "words", "value"),
    [
        ("count", ["16"], 16),
        ("count", ["16", "20"], (16, 20)),
        ("count", ["16.5"], 16.5),
        ("shift", ["0.3", "-0.3"], (0.3, -0.3)),
        ("shift", ["2"], 2.0),
        ("shift", ["abc"], "abc"),
        ("shape", ["1"], "1"),
    ],
)
def test_words_become_values(name, words, value):
    found = given_values(PARAMETERS, {name: words})[name]
    assert found == value
    assert type(found) is type(value)


def test_what_was_not_given_is_left_to_the_element():
    assert given_values(PARAMETERS, {"count": None, "shape": ["round"]}) == {"shape": "round"}
