"""What stands where on a sheet: for every element of the catalog, and for extreme ones."""

import math

import numpy as np
import pytest
import shapely

import gearwright as gw
from gearwright.elements.data_rows import CYLINDRICAL_SIZES
from gearwright.elements.sheets import SheetLabels, element_sheet
from gearwright.sheets import lettering
from gearwright.sheets.content import Row
from gearwright.sheets.marks import Dimension, Text
from gearwright.sheets.papers import PAPERS
from gearwright.sheets.scales import in_words, scales
from gearwright.sheets.tables import data_cells

from ..examples import built, every_part

EXTREME = {
    "three teeth, long": lambda: gw.SpurGear(
        teeth=3, module=5.0, face_width=400.0, addendum=2.0, dedendum=3.0, root="radial"
    ),
    "300 teeth, thin": lambda: gw.SpurGear(teeth=300, module=2.0, face_width=0.5, bore=60.0, keyway="din-6885"),
    "a long rack": lambda: gw.Rack(teeth=700, module=1.0, face_width=10.0),
    "thousandths of an inch": lambda: gw.SpurGear(
        teeth=18, diametral_pitch=2000.0, length_unit="in", face_width=0.001, bore=0.003
    ),
    "20 m": lambda: gw.SpurGear(
        teeth=200, module=100.0, face_width=500.0, bore=60.0, hub_diameter=300.0, hub_offset=20.0, hub_length=600.0
    ),
    "a crown gear": lambda: gw.BevelGear(teeth=30, module=3.0, pitch_angle=90.0, face_width=12.0, bore=15.0),
    "a pitch cone of 3°": lambda: gw.BevelGear(teeth=20, module=4.0, pitch_angle=3.0, face_width=30.0, bore=25.0),
    "a web": lambda: gw.BevelGear(
        teeth=60,
        module=3.0,
        mate_teeth=12,
        face_width=12.0,
        bore=35.0,
        hub_diameter=60.0,
        hub_length=55.0,
        rim_diameter=130.0,
        web_thickness=3.0,
        web_holes=5,
        web_hole_diameter=12.0,
        mounting_distance=74.0,
    ),
}


def texts(sheet):
    for mark in sheet.marks:
        if isinstance(mark, Text | Dimension):
            yield mark.text if isinstance(mark, Dimension) else mark


def assert_in_order(sheet):
    """Nothing outside the frame, no text upon another, all of it large enough to be read."""
    (width, height), shown = sheet.size, list(texts(sheet))
    for mark in sheet.marks:
        points = mark.samples()
        assert np.all(points >= np.array([20.0, 10.0]) - 1e-9)
        assert np.all(points <= np.array([width, height]) - 10.0 + 1e-9)
    boxes = [shapely.convex_hull(shapely.MultiPoint(text.samples())) for text in shown]
    tree = shapely.STRtree(boxes)
    for k, box in enumerate(boxes):
        for other in tree.query(box):
            assert other == k or box.intersection(boxes[other]).area < 0.05, (shown[k].text, shown[other].text)
    assert min(text.height for text in shown) >= 1.25


@every_part
@pytest.mark.parametrize("paper", PAPERS)
def test_every_element_has_a_sheet_in_order(part, paper):
    assert_in_order(element_sheet(built(part), SheetLabels(paper=paper, material="steel"), title="Part"))


@pytest.mark.parametrize("name", EXTREME)
@pytest.mark.parametrize("paper", PAPERS)
def test_extreme_elements_stay_within_the_frame(name, paper):
    assert_in_order(element_sheet(EXTREME[name](), SheetLabels(paper=paper), title="Part"))


@every_part
def test_a_dimension_says_what_is_drawn(part):
    """The number is the distance on paper, or the angle, by the scale of its view."""
    element = built(part)
    sheet = element_sheet(element, SheetLabels(), title="Part")
    dimensions = [mark for mark in sheet.marks if isinstance(mark, Dimension)]
    assert dimensions
    for one in dimensions:
        text = one.text.text.removeprefix("Ø").removesuffix("°").replace("−", "-")
        if one.kind == "linear":
            way = np.array([math.cos(math.radians(one.angle)), math.sin(math.radians(one.angle))])
            measured = abs(float((one.points[1] - one.points[0]) @ way)) / one.factor
        else:
            first, second, _, vertex = one.points
            a, b = first - vertex, second - vertex
            measured = math.degrees(math.acos(float(a @ b) / float(np.hypot(*a) * np.hypot(*b))))
        decimals = len(text.partition(".")[2])
        assert float(text) == pytest.approx(measured, abs=0.51 * 10.0**-decimals)


@every_part
def test_dimensions_span_the_whole_body(part):
    """Among them are the body's extent along its axis, or its length, and its largest diameter, or height."""
    element = built(part)
    values = [m.value for m in element_sheet(element, SheetLabels(), title="x").marks if isinstance(m, Dimension)]
    tolerance = 1e-4 * float(np.linalg.norm(np.ptp(element.polyhedron().vertices, axis=0)))
    vertices = element.polyhedron(tolerance).vertices
    if isinstance(element, gw.Rack):
        wanted = [np.ptp(vertices[:, 0]), np.ptp(vertices[:, 2])]
    elif hasattr(element, "teeth"):
        outside = 2.0 * float(np.hypot(vertices[:, 0], vertices[:, 1]).max())
        wanted = [outside] if isinstance(element, gw.BevelGear) else [outside, np.ptp(vertices[:, 2])]
    else:
        wanted = [np.ptp(vertices[:, 2])]
    for size in wanted:
        assert min(abs(value - size) for value in values) < 40.0 * tolerance, (size, values)


def test_cells_hold_their_text():
    rows = [Row(name="x" * n, symbol="abc_" + "d" * n, value="8" * n) for n in (1, 10, 40, 90)]
    for paper in PAPERS.values():
        for cell in data_cells(rows, paper, 100.0, 200.0, paper.row):
            low, high = cell.mark.samples().min(axis=0), cell.mark.samples().max(axis=0)
            assert np.all(low[0] >= cell.low[0])
            assert np.all(high[0] <= cell.high[0])
            assert np.all(high[1] <= cell.high[1])


def test_widths_are_those_that_matplotlib_draws():
    from matplotlib.textpath import TextPath

    for text in ("Reference diameter", "δ = 33.69°", "Ø106"):
        drawn = TextPath((0.0, 0.0), text, size=10.0).get_extents().width
        assert lettering.width(text, 10.0 * lettering.CAPITALS) == pytest.approx(drawn, rel=0.06)
    assert TextPath((0, 0), "E", size=1.0).get_extents().height == pytest.approx(lettering.CAPITALS, rel=0.01)


def test_scales_are_one_two_and_five_times_powers_of_ten():
    words = [in_words(scale) for scale in scales()]
    at = words.index("1:1")
    assert words[at - 4 : at + 5] == ["20:1", "10:1", "5:1", "2:1", "1:1", "1:2", "1:5", "1:10", "1:20"]


def test_labels_that_are_none_are_refused():
    gear = gw.SpurGear(teeth=20, module=1.0, face_width=5.0)
    with pytest.raises(gw.ParameterError, match=r"paper = 'A7': choose A3 or A4"):
        element_sheet(gear, SheetLabels(paper="A7"), title="x")
    with pytest.raises(gw.ParameterError, match="unobtainium"):
        element_sheet(gear, SheetLabels(material="unobtainium"), title="x")
    with pytest.raises(gw.ParameterError, match="not both"):
        element_sheet(gear, SheetLabels(material="steel", density=7850.0), title="x")


def test_labels_are_for_sizes_that_there_are():
    gears = (
        gw.HelicalGear(teeth=20, module=1.0, face_width=5.0, helix_angle=10.0, bore=8.0, keyway="din-6885"),
        gw.InternalGear(teeth=60, module=1.0, face_width=5.0),
        gw.Rack(teeth=9, module=1.0, face_width=5.0),
    )
    known = set().union(*(gear.sizes() for gear in gears))
    assert set(CYLINDRICAL_SIZES) <= known
