import math

import pytest

from gearwright.designs.design_file import toml_table
from gearwright.errors import FileError, GearwrightError
from gearwright.server.jobs import read

HEAD = 'element = "spur"\n'
MIB = 1 << 20


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("module = " + "9" * 5000, "a number"),
        ("module = 0x" + "f" * 5000, "module: a whole number of more than 64 bits"),
        (f"module = {2**63}", "module: a whole number of more than 64 bits"),
        ("bore = " + "[" * 300 + "]" * 300, "nested more deeply"),
        ("bore = " + "[" * 30_000 + "]" * 30_000, "nested more deeply"),
        ("bore = " + "{a = " * 100 + "1" + "}" * 100, "nested more deeply"),
        (".".join("a" * 3000) + " = 1", "line 2: a key has more than"),
        ("[" + " . ".join(['"a b"'] * 3000) + "]", "line 2: a key has more than"),
        ("".join(f"a{k} = 1\n" for k in range(3000)), "keys"),
        ("bore = 1 #" + "x" * MIB, "too long"),
    ],
)
def test_what_no_design_needs_of_toml_is_refused_in_words(text, told):
    with pytest.raises(FileError, match=f"^spur.toml: .*{told}"):
        toml_table((HEAD + text).encode(), "spur.toml")


def test_keys_of_very_many_parts_are_refused_before_they_are_parsed(monkeypatch):
    monkeypatch.setattr("tomllib.loads", lambda _: pytest.fail("this takes minutes"))
    for key in (".".join(["a"] * 300_000), " . ".join(["'a'"] * 150_000)):
        with pytest.raises(FileError, match="a key has more than"):
            toml_table(f"{HEAD}{key} = 1".encode(), "spur.toml")


def test_what_large_designs_hold_is_read():
    points = [[k * 0.5, -k / 3] for k in range(20_000)]
    deep = "a." * 12 + "b"
    table = toml_table(f"{HEAD}polygon = {points}\nwhole = {2**63 - 1}\n{deep} = 1e300".encode(), "sweep.toml")
    assert table["polygon"] == points
    assert table["whole"] == 2**63 - 1


@pytest.mark.parametrize("number", ["inf", "-inf", "nan", "1e999", "[1.0, inf]", "{r = [nan]}"])
def test_a_number_without_an_end_is_not_read_as_a_gap(number):
    with pytest.raises(
        GearwrightError, match=r"(?s)module = .*: numbers are to be finite.*bore = inf: numbers are to be finite"
    ) as caught:
        list(read({"toml": f"{HEAD}module = {number}\nface_width = 1e300\nbore = inf"}))
    assert "face_width" not in str(caught.value)
    assert math.isfinite(next(read({"toml": f"{HEAD}module = 1e300"}))["design"]["module"])


@pytest.mark.parametrize("name", ["[1]", "{a = 1}", "3", "2020-01-01", "[[]]"])
def test_an_element_that_is_no_name_is_refused(name):
    with pytest.raises(GearwrightError, match="this names no element"):
        list(read({"toml": f"element = {name}"}))
