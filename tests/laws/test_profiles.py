"""Laws of all elements that have a plane section: what is drawn is what the solid is made from."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.sweep import Sweep
from gearwright.solids.swept import Swept

from ..examples import BY_NAME, built, every_part


@every_part
def test_the_catalog_says_which_elements_have_a_profile(part):
    assert (built(part).profile is not None) == BY_NAME[part.element].plane


@every_part
@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
def test_a_profile_is_written_in_the_length_unit_and_read_again(part, suffix, tmp_path):
    element, path = built(part), tmp_path / f"profile{suffix}"
    if element.profile is None:
        with pytest.raises(gw.GeometryError, match="it has no plane section"):
            element.save_drawing(path)
        assert not path.exists()
        return
    element.save_drawing(path)
    section, drawn = element.profile.properties(), gw.sections.drawings.read(path)
    assert drawn.length_unit == element.length_unit
    loaded = gw.Section(loops=drawn.region()).properties()
    assert loaded.area == pytest.approx(section.area, rel=3e-8)  # curves are drawn to 1e-7 × the size
    np.testing.assert_allclose(loaded.centroid, section.centroid, atol=1e-8 * section.perimeter)
    np.testing.assert_allclose(loaded.second_moments, section.second_moments, rtol=0, atol=1e-8 * section.perimeter**4)


@every_part
def test_the_profile_is_the_section_of_the_solid(part):
    element = built(part)
    if element.profile is not None and isinstance(element.solid, Swept) and not element.solid.section.varies:
        own = element.solid.section.moments[0, 0]  # its bore is of as many arcs as there are teeth
        assert own == pytest.approx(element.profile.moments[0, 0], rel=1e-14)
        if not isinstance(element, Sweep):
            (length,) = {abs(z) for z in element.properties().bounding_box[:, 2]} - {0.0}
            assert element.profile.properties().area * length == pytest.approx(element.properties().volume, rel=1e-13)
