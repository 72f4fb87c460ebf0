import pytest

from gearwright import catalog

from ..examples import EXAMPLES, built, every_part


@pytest.mark.parametrize("entry", catalog.ELEMENTS, ids=lambda entry: entry.name)
def test_every_element_of_the_catalog_has_examples(entry):
    """Three; one does for pairs whose kind a command settles: their members are elements with examples of their own."""
    least = 1 if entry.settled else 3
    assert len(EXAMPLES.get(entry.name, {})) >= least, "add parameter sets to tests/examples.py"


def test_there_are_no_examples_of_unknown_elements():
    assert set(EXAMPLES) == {entry.name for entry in catalog.ELEMENTS}


@every_part
def test_sizes_are_finite_and_named(part):
    for name, size in built(part).sizes().items():
        assert abs(size.value) < 1e6, name
        assert size.symbol
        assert size.meaning
