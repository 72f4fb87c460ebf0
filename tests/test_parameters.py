"""Parameters: declared once, checked together, read from mappings."""

from dataclasses import dataclass

import pytest

from gearwright import catalog
from gearwright.errors import GearwrightError, ParameterError, Problem
from gearwright.parameters import (
    Declaration,
    Parameter,
    Problems,
    declarations,
    declared,
    from_mapping,
    in_words,
    member_value,
)

COUNT = Parameter(meaning="how many", kind="integer", minimum=2, maximum=9)
LENGTH = Parameter(meaning="how long", unit="length", above=0)
SHIFT = Parameter(meaning="how far", unit="length")
ANGLE = Parameter(meaning="how steep", unit="angle", minimum=0, below=90)
WORD = Parameter(meaning="which one", kind="choice", choices=("this", "that"))


@dataclass(frozen=True, kw_only=True)
class Thing:
    """An element with one parameter of each kind."""

    count: int = declared(COUNT)
    length: float = declared(LENGTH, default=3.0)
    angle: float | None = declared(ANGLE, default=None)
    both: float | tuple[float, float] = declared(LENGTH, default=1.0, members="both")
    each: tuple[int, int] = declared(COUNT, default=(3, 4), members="each")
    word: str = declared(WORD, default="this")
    length_unit: str = "in"

    def __post_init__(self):
        Problems(self).raise_any()


@pytest.mark.parametrize(
    ("parameter", "good", "bad"),
    [
        (COUNT, [2, 9], [1, 10, 2.5, float("nan"), float("inf"), "3", None, True, [3]]),
        (
            LENGTH,
            [1e-12, 1, 2.5, 1e12],
            [0, -1e13, 1e-13, 1e13, 10**400, -1e-300, float("nan"), float("-inf"), "1", None, False, (1.0,)],
        ),
        (SHIFT, [-1e12, -3, -1e-13, 0, 1e-13, 1e12], [-1.1e12, 1.1e12, "1", None]),
        (ANGLE, [0, 0.0, 89.999999], [-1e-9, 90, 90.0, float("inf"), "9", None, True]),
        (WORD, ["this", "that"], ["", "THIS", "thisthat", None, 1, True]),
    ],
    ids=lambda value: getattr(value, "meaning", ""),
)
def test_single_values(parameter, good, bad):
    assert [parameter.problem(value) for value in good] == [None] * len(good)
    for value in bad:
        assert parameter.problem(value), value
    assert all(parameter.computable(value) for value in good)


@pytest.mark.parametrize(
    ("parameter", "value", "words"),
    [
        (COUNT, 1, "at least 2"),
        (COUNT, 10, "at most 9"),
        (COUNT, 2.5, "whole number"),
        (COUNT, True, "not bool"),
        (LENGTH, 0, "greater than 0"),
        (LENGTH, "1", "number is needed"),
        (SHIFT, 1e13, "right unit"),
        (SHIFT, -1e13, "right unit"),
        (LENGTH, float("nan"), "finite"),
        (ANGLE, 90, "less than 90"),
        (WORD, "these", "this, that"),
    ],
)
def test_why_a_value_is_refused(parameter, value, words):
    assert words in parameter.problem(value)


@pytest.mark.parametrize(
    ("parameter", "value", "computable"),
    [
        (COUNT, 1, True),
        (COUNT, 0, False),
        (COUNT, 12, True),
        (LENGTH, 0, False),
        (ANGLE, 90, False),
        (Parameter(meaning="either way", minimum=-9, maximum=9), -10, True),
        (WORD, "x", False),
    ],
)
def test_formulas_make_sense_of_values_beyond_a_limit_but_not_of_signs(parameter, value, computable):
    assert parameter.computable(value) is computable


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (90.0, "length", "90 in"),
        (0.1 + 0.2, "length", "0.3 in"),
        ((16, 2), "", "(16, 2)"),
        ((1.5, 2.0), "length", "(1.5 in, 2 in)"),
        (35.0, "angle", "35°"),
        (4, "mm", "4 mm"),
        (2.0, "per inch", "2 /in"),
        ("wavy", "", "'wavy'"),
        ("15", "length", "'15'"),
        (True, "length", "True"),
        ({"circle": 3.0, "centre": (1, 2)}, "", "{circle = 3.0, centre = (1, 2)}"),
    ],
)
def test_values_in_words(value, unit, words):
    assert in_words(value, unit, "in") == words


def _subjects(error):
    return [problem.subject for problem in error.value.problems]


def test_all_problems_at_once_in_the_order_of_the_fields():
    with pytest.raises(ParameterError) as error:
        Thing(count=1, length=-2.0, angle=95.0, both=(1.0, -1.0), each=(3, 40), word="those")
    assert _subjects(error) == [
        "count = 1",
        "length = -2 in",
        "angle = 95°",
        "both = (1 in, -1 in)",
        "each = (3, 40)",
        "word = 'those'",
    ]
    assert str(error.value).splitlines()[0] == "Thing cannot be built from these parameters:"
    assert len(str(error.value).splitlines()) == 7
    assert isinstance(error.value, GearwrightError)
    assert isinstance(error.value, ValueError)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"each": 3}, "two values are needed"),
        ({"each": (3,)}, "two members"),
        ({"each": (3, 4, 5)}, "two members"),
        ({"each": ()}, "two members"),
        ({"both": (1.0, 2.0, 3.0)}, "two members"),
        ({"both": []}, "two members"),
        ({"length": (1.0, 2.0)}, "one value"),
        ({"each": (1, 3)}, "at least 2 each"),
        ({"count": None}, "whole number"),
        ({"length": None}, "number"),
        ({"word": None}, "this, that"),
    ],
)
def test_numbers_of_values(values, words):
    with pytest.raises(ParameterError) as error:
        Thing(**{"count": 3, **values})
    assert len(error.value.problems) == 1
    assert words in error.value.problems[0].message


def test_what_is_left_out_by_default_may_be_left_out():
    thing = Thing(count=3, angle=None, both=(1.0, 2.0))
    assert thing.angle is None


def test_declarations():
    found = {one.name: one for one in declarations(Thing)}
    assert list(found) == ["count", "length", "angle", "both", "each", "word"]
    assert all(isinstance(one, Declaration) for one in found.values())
    assert found["count"].required
    assert not found["length"].required
    assert found["length"].default == 3.0
    assert [found[name].members for name in ("count", "both", "each")] == ["one", "both", "each"]
    assert found["angle"].parameter is ANGLE


@pytest.mark.parametrize("entry", catalog.ELEMENTS, ids=lambda entry: entry.name)
def test_every_field_of_every_element_is_declared_with_a_meaning(entry):
    element = catalog.load(entry.source)
    found = declarations(element)
    assert {one.name for one in found} == set(element.__dataclass_fields__)
    for one in found:
        assert one.parameter.meaning
        assert one.parameter.kind != "choice" or one.parameter.choices
        assert one.parameter.kind != "form" or one.parameter.forms
        if not one.required:
            assert one.problems(one.default) == []


def test_member_values():
    assert [member_value((3.0, 4.0), member) for member in (0, 1)] == [3.0, 4.0]
    assert [member_value([3.0, 4.0], member) for member in (0, 1)] == [3.0, 4.0]
    assert [member_value(5.0, member) for member in (0, 1)] == [5.0, 5.0]
    assert member_value(None, 1) is None


class TestFromMapping:
    def test_builds(self):
        thing = from_mapping(Thing, {"count": 4, "each": [5, 6], "word": "that"})
        assert (thing.count, thing.each, thing.word, thing.length) == (4, (5, 6), "that", 3.0)

    def test_names_unknown_and_missing_together(self):
        with pytest.raises(ParameterError) as error:
            from_mapping(Thing, {"lenght": 3.0, "weight": 4})
        assert _subjects(error) == ["lenght = 3.0", "weight = 4", "count"]
        assert "no such parameter" in error.value.problems[0].message
        assert "length" in error.value.problems[0].message
        assert "how many" in error.value.problems[2].message

    def test_problems_of_values_are_the_element_s_own(self):
        with pytest.raises(ParameterError) as error:
            from_mapping(Thing, {"count": 4, "length": "3"})
        assert _subjects(error) == ["length = '3'"]


class TestMembers:
    @dataclass(frozen=True, kw_only=True)
    class Couple:
        length: float = declared(LENGTH)
        count: int = declared(COUNT, default=3)
        length_unit: str = "mm"

    def _problems(self, *, first=(), second=(), settled=(), **values):
        couple = self.Couple(**{"length": 1.0, **values})
        problems = Problems(couple)

        def build(found):
            def refuse():
                if found:
                    raise ParameterError("Thing", [Problem(*one) for one in found])

            return refuse

        problems.add_members({"first": build(first), "second": build(second)}, settled=settled)
        with pytest.raises(ParameterError) as error:
            problems.raise_any()
        return [str(problem) for problem in error.value.problems]

    def test_a_shared_problem_is_said_once(self):
        shared = ("length = 1 mm", "too short")
        assert self._problems(first=[shared], second=[shared]) == ["length = 1 mm: too short"]

    def test_a_problem_of_one_member_says_whose(self):
        assert self._problems(second=[("bore = 2 mm", "too wide")]) == ["second bore = 2 mm: too wide"]

    def test_what_is_known_is_not_said_again(self):
        found = self._problems(length=-1.0, first=[("length = -1 mm", "again"), ("depth = 1 mm", "too deep")])
        assert found == ["length = -1 mm: must be greater than 0", "first depth = 1 mm: too deep"]

    def test_what_the_pair_settles_is_left_out(self):
        found = self._problems(first=[("mate = 2", "too few"), ("depth = 1 mm", "too deep")], settled=("mate",))
        assert found == ["first depth = 1 mm: too deep"]

    def test_problems_of_both_members_each_with_its_own_value(self):
        found = self._problems(first=[("bore = 2 mm", "below 1")], second=[("bore = 2 mm", "below 1.5")])
        assert found == ["first bore = 2 mm: below 1", "second bore = 2 mm: below 1.5"]


def test_soundness_by_name():
    thing = Thing(count=3)
    problems = Problems(thing)
    assert problems.sound()
    problems.add("length", "odd")
    assert not problems.sound()
    assert not problems.sound("length")
    assert problems.sound("count", "angle")
    with pytest.raises(ParameterError, match="length = 3 in: odd"):
        problems.raise_any()
