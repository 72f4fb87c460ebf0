"""What sheets say: numbers of tables and views against sizes, volumes and angles found otherwise."""

import math

import numpy as np
import pytest
import shapely

import gearwright as gw
from gearwright.elements.bevel import bevel_views
from gearwright.elements.cams.cam_views import lift_table
from gearwright.elements.cylindrical.gear_views import body_region
from gearwright.elements.sheets import SheetLabels, element_sheet
from gearwright.sheets.marks import Text
from gearwright.sheets.numbers import decimal

from ..examples import BEVEL_PARTS, built, every_part

HUBBED = {
    "teeth": 30, "module": 2.0, "face_width": 20.0, "bore": 16.0, "hub_diameter": 30.0, "hub_length": 35.0,
    "hub_offset": 5.0, "rim_diameter": 50.0, "web_thickness": 6.0,
}  # fmt: skip


def number(text):
    return float(text.split()[0].removesuffix("°").replace("−", "-"))


@every_part
def test_the_table_has_the_sizes_to_the_digits_printed(part):
    element = built(part)
    sizes = {(size.symbol, size.unit): size.value for size in element.sizes().values()}
    checked = 0
    for row in element.data_rows():
        unit = "angle" if row.value.endswith("°") else "length" if row.value.endswith(element.length_unit) else ""
        value = sizes.get((row.symbol, unit))
        if value is not None and row.symbol not in ("x", "m_n"):
            decimals = len(row.value.split()[0].removesuffix("°").partition(".")[2])
            assert number(row.value) == pytest.approx(value, abs=0.51 * 10.0**-decimals), row
            assert abs(number(row.value) - value) <= 1e-3 * abs(value) + 1e-12
            checked += 1
    assert checked >= 2


def test_published_measurements_of_a_gear_stand_in_its_table():
    """Span and tip diameter of z = 24, m = 2, 20° from the tables of any handbook: W_3 = 15.433, d_a = 52."""
    rows = {row.name: row.value for row in gw.SpurGear(teeth=24, module=2.0, face_width=20.0).data_rows()}
    assert (rows["Span"], rows["Teeth spanned"], rows["Tip diameter"]) == ("15.433 mm", "3", "52 mm")


def test_a_pairs_sheets_say_what_the_mate_is(tmp_path):
    pair = gw.GearPair(kind="helical", teeth=(12, 35), module=3.0, face_width=20.0, helix_angle=15.0, backlash=0.1)
    pair.save_sheet(tmp_path / "pair.svg")
    text = (tmp_path / "pair.svg").read_text(encoding="utf-8")
    first, second = text.split("<g transform")[1:]
    for page, mate, hand in ((first, "35", "right"), (second, "12", "left")):
        said = [piece.split("</text>")[0] for piece in page.split('xml:space="preserve">')[1:]]
        assert said[said.index("Teeth of the mate") + 1] == mate
        assert hand in said
        assert "72.987 mm" in said  # 47 × 3/(2 cos 15°)


def test_mass_is_volume_times_density():
    gear = gw.SpurGear(teeth=24, diametral_pitch=8.0, face_width=1.0, length_unit="in")
    said = [m.text for m in element_sheet(gear, SheetLabels(material="steel"), title="x").marks if isinstance(m, Text)]
    mass = float(next(text for text in said if text.endswith(" kg")).split()[0])
    assert mass == pytest.approx(gear.properties().volume * 0.0254**3 * 7850.0, rel=1e-4)


def revolved(region):
    """Volume that the part of a region (z, ρ) with ρ > 0 sweeps about ρ = 0 (Pappus)."""
    upper = shapely.intersection(region, shapely.box(-1e4, 0.0, 1e4, 1e4))
    return 2.0 * math.pi * upper.area * upper.centroid.y


def test_what_is_cut_of_a_gear_is_its_body():
    """Revolved, it and the teeth, the profile beyond the root circle, are the volume of the solid."""
    gear = gw.SpurGear(**HUBBED)
    region = body_region(gear.blank.zones(gear.root_radius, gear.face_width), gear.blank)
    area = gw.SpurGear(teeth=30, module=2.0, face_width=20.0).profile.properties().area
    teeth = (area - math.pi * gear.root_radius**2) * gear.face_width
    assert revolved(region) + teeth == pytest.approx(gear.properties().volume, rel=1e-9)


def test_a_keyway_is_cut_above_the_bore_only():
    keyed = gw.SpurGear(**HUBBED, keyway="din-6885")
    region = body_region(keyed.blank.zones(keyed.root_radius, keyed.face_width), keyed.blank)
    cut = region.intersection(shapely.LineString([(10.0, -100.0), (10.0, 100.0)])).bounds
    assert (cut[1], cut[3]) == pytest.approx((-keyed.root_radius, keyed.root_radius))
    assert not region.intersects(shapely.Point(10.0, 10.2))  # t₂ = 2.3 of a bore of 16
    assert region.intersects(shapely.Point(10.0, 10.4))
    assert region.intersects(shapely.Point(10.0, -8.1))


@pytest.mark.parametrize("part", BEVEL_PARTS, ids=str)
def test_what_is_cut_of_a_bevel_gear_lies_within_its_body(part):
    """Revolved, without the teeth it is less than the solid, with them filled more."""
    gear = built(part)
    region = bevel_views._region(gear)
    teeth, inner, outer = gear.bevel_teeth, gear.inner_distance, gear.cone_distance
    ring = [
        bevel_views._at(gear, polar, at)
        for polar, at in (
            (teeth.inner.root_angle, inner),
            (teeth.inner.face_angle, inner),
            (teeth.outer.face_angle, outer),
            (teeth.outer.root_angle, outer),
        )
    ]
    volume, body, filled = gear.properties().volume, revolved(region), revolved(shapely.Polygon(ring))
    slack = 0.02 * volume if gear.ends == "spherical" else 0.0  # chords of the spheres; a bore's rim
    assert body - slack < volume < body + filled + slack
    if gear.ends != "spherical" and gear.blank.keyed_bore is None:
        assert volume == pytest.approx(body + 0.5 * filled, abs=0.35 * filled)


def test_the_lift_table_is_the_programme():
    cam = gw.Cam(
        programme="rise 120, dwell 60, return 180",
        follower="translating-roller",
        lift=12.0,
        base_radius=30.0,
        roller_radius=6.0,
        thickness=10.0,
    )
    cells = [cell for row in lift_table(cam).rows[1:] for cell in row]
    lift = dict(zip(map(int, cells[::2]), map(float, cells[1::2]), strict=True))
    assert sorted(lift) == list(range(0, 360, 10))
    assert [lift[k] for k in (0, 60, 120, 150, 180, 270)] == [0.0, 6.0, 12.0, 12.0, 12.0, 6.0]
    cycloid = 12.0 * (0.25 - math.sin(0.5 * math.pi) / (2.0 * math.pi))  # a quarter of the rise
    assert lift[30] == pytest.approx(cycloid, abs=5.1e-4)


@pytest.mark.parametrize(
    ("value", "text"), [(52.0, "52"), (0.0123456, "0.012346"), (-3.25, "−3.25"), (0.0, "0"), (1e-9, "0.000000001")]
)
def test_numbers_have_five_digits_at_least(value, text):
    assert decimal(value, 3) == text
    assert np.isfinite(value)


@pytest.mark.parametrize(("hub_length", "shown"), [(None, False), (20.0, False), (30.0, True)])
def test_a_hub_as_wide_as_the_teeth_has_no_dimension(hub_length, shown):
    gear = gw.SpurGear(teeth=24, module=3, face_width=20, bore=20, hub_diameter=36, hub_length=hub_length)
    widths = [abs(d.end[1] - d.start[1]) for d in gear.views()[0].dimensions if getattr(d, "prefix", "") == "Ø"]
    assert (36.0 in widths) == shown
    assert 20.0 in widths
