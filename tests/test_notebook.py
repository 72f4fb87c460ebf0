"""What a notebook shows of the objects of this package: quickly, escaped, and as a person reads it."""

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from IPython.core.formatters import DisplayFormatter

import gearwright as gw
from gearwright import html_tables
from gearwright.catalog import ELEMENTS, load

from .examples import EXAMPLES

GEAR = gw.SpurGear(teeth=17, module=2, face_width=10)
PAIR = gw.GearPair(teeth=(17, 30), module=2, face_width=10)
BOX = gw.extrude(gw.Section.rectangle(2, 3), 4)


def shown(value):
    data, _ = DisplayFormatter().format(value)
    return data


def cells(html):
    """Texts of the rows of all tables by their first cells."""
    rows = re.findall(r"<tr>(.*?)</tr>", html)
    texts = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in rows]
    return {row[0]: row[1:] for row in texts}


@pytest.mark.parametrize("kind", ELEMENTS, ids=lambda kind: kind.name)
def test_every_element_shows_its_sizes_and_says_how_it_is_made(kind):
    element = load(kind.source)(**kind.settled, **next(iter(EXAMPLES[kind.name].values())))
    html = element._repr_html_()
    found = cells(html)
    for name in element.sizes():
        assert name.replace("_", " ") in found
    assert element.description.split(",")[0] in html
    assert len(repr(element)) < 1000


def test_an_element_shows_its_volume_to_ten_digits_and_a_picture():
    html = shown(GEAR)["text/html"]
    assert float(cells(html)["volume"][1].removesuffix(" mm³")) == pytest.approx(GEAR.properties().volume, rel=1e-9)
    assert re.search(r'<img src="data:image/png;base64,iVBOR', html)
    assert cells(html)["pitch diameter"] == ["d", "34", "mm"]


def test_a_pair_shows_both_members_side_by_side():
    found = cells(shown(PAIR)["text/html"])
    assert found["pitch diameter"] == ["d", "34", "60", "mm"]
    assert found["centre distance"] == ["a_w", "47", "mm"]


def test_a_box_shows_its_moments():
    found = cells(shown(BOX)["text/html"])
    assert found["volume"] == ["", "24"]
    assert found["centroid x, y, z"] == ["origin", "0, 0, 2"]
    assert found["principal moments"] == ["centroid", "26, 40, 50"]
    assert cells(shown(BOX.properties(2.0))["text/html"])["mass"] == ["2 per length unit³", "48"]


def test_a_polyhedron_shows_what_is_wrong_with_it():
    box = BOX.polyhedron()
    assert cells(shown(box)["text/html"])["volume"] == ["", "24"]
    faces = [*box.faces][1:]
    found = shown(gw.Polyhedron(box.vertices, faces))["text/html"]
    assert "volume" not in cells(found)
    assert "open" in found


def test_a_large_polyhedron_is_counted_and_not_examined():
    many = np.tile([[0, 1, 2]], (300_001, 1))
    found = cells(gw.Polyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0]], many)._repr_html_())
    assert list(found) == ["", "faces", "vertices"]
    assert found["faces"] == ["", "300,001"]


def test_a_section_is_drawn_with_its_holes_upright_and_its_size_below():
    section = gw.Section.polygon([[0, 0], [40, 0], [0, 20]], holes=[[[2, 2], [2, 6], [6, 2]]])
    root = ET.fromstring(shown(section)["image/svg+xml"])  # noqa: S314  our own
    names = {"svg": "http://www.w3.org/2000/svg"}
    path = root.find("svg:path", names)
    assert path.get("d").count("Z") == 2
    assert root.find("svg:text", names).text == "40 × 20"
    x, y, scale = map(float, re.findall(r"-?[\d.]+", path.get("transform")))
    corner = [float(value) for value in re.match(r"M(\S+),(\S+)", path.get("d")).groups()]
    width, height = float(root.get("width")), float(root.get("height"))
    assert scale == pytest.approx(9.0)
    assert 0 <= x + scale * corner[0] < 0.1 * width  # (0, 0) is at the left and below
    assert 0.75 * height < y + scale * corner[1] < height
    assert 0 < y - scale * 20.0 < 0.1 * height  # the upper corner (0, 20) is above


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (GEAR, "SpurGear(teeth=17, module=2, face_width=10)"),
        (PAIR, "GearPair(teeth=(17, 30), module=2, face_width=10)"),
        (BOX, "<Swept: <Section of 1 loop, 4 curves> by Straight>"),
        (BOX.moved(np.eye(3), (1, 0, 0)), "<Moved: <Swept: <Section of 1 loop, 4 curves> by Straight>>"),
        (gw.Section.circle(2), "<Section of 1 loop, 1 curve>"),
        (BOX.properties(), "<MassProperties: volume 24, centroid (0, 0, 2), exact>"),
        (BOX.properties(2.0), "<MassProperties: volume 24, mass 48, centroid (0, 0, 2), exact>"),
    ],
)
def test_what_is_printed_is_short(value, said):
    assert repr(value) == said


def test_what_an_element_prints_makes_it_again():
    gear = gw.HelicalGear(teeth=20, module=3, face_width=12.5, helix_angle=15, hand="left", root="radial")
    assert eval(repr(gear), vars(gw)) == gear  # noqa: S307  our own text


def test_tables_are_escaped_and_their_headings_are_marked():
    html = html_tables.table("a < b", ("", "x & y"), [("<b>", '"1"')])
    assert "<b>" not in html
    assert '<caption style="text-align:left;font-weight:bold">a &lt; b</caption>' in html
    assert html.count('scope="col"') == 2
    assert html.count('scope="row"') == 1
    assert "x &amp; y" in html
    assert "color" not in html  # the page's own, light or dark


def test_rounding_beside_a_large_number_is_shown_as_nought():
    assert html_tables.numbers([1.0, -1e-15, 1e-13]) == "1, 0, 1e-13"
