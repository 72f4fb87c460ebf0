"""What the page on validity shows is what happens, and it names every kind."""

import pytest

from gearwright.solids.validity.kinds import PROBLEMS

from .pages import ROOT, assert_blocks_print_what_stands_below

PAGE = ROOT / "docs/validity.md"


def test_each_block_prints_what_stands_below_it(capsys):
    assert_blocks_print_what_stands_below(PAGE, capsys)


@pytest.mark.parametrize("kind", PROBLEMS)
def test_each_kind_of_problem_has_its_row(kind):
    rows = [line for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith(f"| `{kind}` |")]
    assert len(rows) == 1
    assert ("cannot be allowed" in rows[0]) == (not PROBLEMS[kind].allowed)
