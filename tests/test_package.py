import subprocess
import sys

import pytest

import gearwright
from gearwright import catalog


def test_importing_the_package_loads_no_numpy():
    script = "import sys, gearwright; gearwright.__version__; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", script], check=False, timeout=60).returncode == 0


@pytest.mark.parametrize("name", gearwright.__all__)
def test_every_public_name_loads(name):
    assert getattr(gearwright, name) is not None
    assert name in dir(gearwright)


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="HypoidGear"):
        gearwright.HypoidGear  # noqa: B018


@pytest.mark.parametrize("element", catalog.ELEMENTS, ids=lambda element: element.name)
def test_every_element_of_the_catalog_loads(element):
    assert catalog.load(element.source).__doc__


@pytest.mark.parametrize("format_", catalog.FILE_FORMATS, ids=lambda format_: format_.name)
def test_every_file_format_of_the_catalog_loads(format_):
    assert all(callable(catalog.load(source)) for source in (format_.parser, format_.writer) if source)
