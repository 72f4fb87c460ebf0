"""Densities against what scales and rulers say, and names that find them."""

import math

import pytest

import gearwright as gw
from gearwright.materials import MATERIALS, material
from gearwright.parameters import LENGTH_UNITS, MILLIMETRES


def test_a_litre_of_water_in_every_unit_is_a_kilogram():
    # a litre is a cube of 10 cm, whose side in each unit a ruler shows
    sides = {"um": 1e5, "mm": 100, "cm": 10, "m": 0.1, "in": 100 / 25.4, "ft": 100 / 25.4 / 12}
    assert sides.keys() == LENGTH_UNITS.keys()
    for unit, side in sides.items():
        assert gw.density("water", length_unit=unit) * side**3 == pytest.approx(0.998, rel=1e-14)
        assert gw.density(1000, length_unit=unit) * side**3 == pytest.approx(1, rel=1e-14)


def test_elements_keep_their_two_units():
    assert MILLIMETRES == {"mm": 1.0, "in": 25.4}


def test_steel_is_what_the_readme_says():
    assert gw.density("steel") == pytest.approx(7.85e-6, rel=1e-14)


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("aluminum", "aluminium"),
        ("Delrin", "POM"),
        ("acetal", "POM"),
        ("pa66_gf30", "PA66-GF30"),
        ("PA66 GF30", "PA66-GF30"),
        ("Stainless-Steel", "stainless steel"),
        ("nylon", "PA66"),
    ],
)
def test_aliases_and_spellings_find_materials(given, name):
    assert material(given).name == name


def test_every_name_and_alias_finds_its_own_material():
    for one in MATERIALS:
        for name in (one.name, *one.aliases):
            assert material(name) is one


def test_every_material_is_between_plastic_foam_and_the_heaviest_metal_and_has_a_remark():
    assert len(MATERIALS) >= 25
    for one in MATERIALS:
        assert 500 < one.density < 23_000
        assert one.remark


def test_what_is_wrong_is_said_together():
    with pytest.raises(gw.ParameterError) as caught:
        gw.density("stel", length_unit="inch")
    assert [problem.subject for problem in caught.value.problems] == ["material = 'stel'", "length_unit = 'inch'"]
    assert "did you mean steel?" in str(caught.value)


@pytest.mark.parametrize("value", [0, -1, math.nan, math.inf, None, True])
def test_densities_that_are_none_are_refused(value):
    with pytest.raises(gw.ParameterError, match="density"):
        gw.density(value)
