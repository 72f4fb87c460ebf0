"""Pairs of bevel gears sized by a standard: what reaches their members, what is remarked, what is refused."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import ParameterError

PAIR = {"teeth": (20, 40), "module": 3.0, "face_width": 20.0}
SPIRAL = {"trace": "logarithmic", "spiral_angle": 35.0}


def outer(pair):
    """h_ae, h_fe and s_e of both members."""
    return [(g.proportions.addendum, g.proportions.dedendum, g.outer_thickness) for g in (pair.pinion, pair.gear)]


def test_equal_addenda_are_what_gears_have_without_a_standard():
    explicit, standard = gw.BevelPair(**PAIR), gw.BevelPair(**PAIR, standard="equal-addendum")
    assert outer(standard) == [pytest.approx(values) for values in outer(explicit)]
    assert standard.remarks == explicit.remarks == []
    assert standard.pinion.properties().volume == pytest.approx(explicit.pinion.properties().volume, rel=1e-14)


@pytest.mark.parametrize(
    ("more", "pinion", "gear"),
    [
        # KHK, Gear Technical Reference: m = 3, z = 20/40, Gleason straight
        ({"standard": "gleason-straight"}, (4.035, 2.529), (1.965, 4.599)),
        # the same, Gleason spiral, β_m = 35°
        ({"standard": "gleason-spiral", **SPIRAL}, (3.4275, 2.2365), (1.6725, 3.9915)),
        # 1 ± 0.4 and 1.25 ∓ 0.4 modules of 3 mm
        ({"standard": "equal-addendum", "profile_shift": 0.4}, (4.2, 2.55), (1.8, 4.95)),
    ],
)
def test_members_have_the_heights_of_their_standard(more, pinion, gear):
    pair = gw.BevelPair(**PAIR, **more)
    heights = [values[:2] for values in outer(pair)]
    assert heights == [pytest.approx(pinion), pytest.approx(gear)]
    found = {name: size.value for name, size in pair.sizes().items()}
    assert found["working_depth"] == pytest.approx(pinion[0] + gear[0])
    assert found["clearance"] == pytest.approx(gear[1] - pinion[0])
    assert pair.pinion.outer_thickness + pair.gear.outer_thickness == pytest.approx(3.0 * np.pi)


def test_spiral_teeth_thicken_with_the_transverse_pressure_angle_that_they_keep():
    """α_t = atan(tan 20°/cos 35°) is KHK's 20° in the normal section; K = 0.060."""
    pair = gw.BevelPair(**PAIR, **SPIRAL, standard="gleason-spiral", thickness_modification=0.03)
    transverse = float(np.degrees(np.arctan(np.tan(np.radians(20.0)) / np.cos(np.radians(35.0)))))
    assert pair.pinion.pressure_angle == pytest.approx(transverse)
    assert [values[2] for values in outer(pair)] == pytest.approx([5.6722, 3.7526], abs=5.1e-5)


@pytest.mark.parametrize(
    "standard",
    # in outer transverse modules; in mean normal ones, which grow to those at the outer end of straight teeth
    ["equal-addendum", "gleason-straight", "iso-23509"],
)
def test_a_thickness_modification_moves_material_from_the_gear_to_the_pinion(standard):
    plain = outer(gw.BevelPair(**PAIR, standard=standard))
    changed = outer(gw.BevelPair(**PAIR, standard=standard, thickness_modification=0.02))
    moved = [after[2] - before[2] for before, after in zip(plain, changed, strict=True)]
    assert moved == pytest.approx([2.0 * 0.02 * 3.0, -2.0 * 0.02 * 3.0])
    assert [values[:2] for values in plain] == [values[:2] for values in changed]


def test_iso_23509_settles_outer_sizes_from_mid_face():
    """u = 2: c_ham = 0.21 + 0.29/4, h_mw = 2 m_mn; root cones pass the pitch apex, so that h_f grows with R."""
    pair = gw.BevelPair(**PAIR, standard="iso-23509")
    reach = pair.pinion.cone_distance / pair.pinion.mean_distance
    module = 3.0 / reach
    roots = [values[1] for values in outer(pair)]
    assert roots == pytest.approx([(0.2825 * 2.0 + 0.25) * module * reach, (0.7175 * 2.0 + 0.25) * module * reach])
    shifted = gw.BevelPair(**PAIR, standard="iso-23509", profile_shift=0.0)
    assert outer(shifted)[0] == pytest.approx(outer(shifted)[1])


def test_members_have_the_taper_of_their_standard():
    """Tip cones of the Gleason system are parallel to the mates' root cones."""
    pair = gw.BevelPair(**PAIR, standard="gleason-straight")
    pinion, gear = pair.pinion.proportions, pair.gear.proportions
    assert pinion.addendum_angle == pytest.approx(gear.dedendum_angle, rel=1e-14)
    assert gear.addendum_angle == pytest.approx(pinion.dedendum_angle, rel=1e-14)
    assert gear.dedendum_angle == pytest.approx(np.arctan2(4.599, pair.cone_distance), rel=1e-12)


def test_a_thickness_that_is_given_stands():
    pair = gw.BevelPair(**PAIR, standard="gleason-straight", circular_thickness=(5.0, None))
    assert [values[2] for values in outer(pair)] == pytest.approx([5.0, 3.95897], abs=1e-5)


@pytest.mark.parametrize(
    ("more", "subject", "words"),
    [
        ({"standard": "gleason-straight", **SPIRAL}, "standard = 'gleason-straight'", "gleason-spiral"),
        ({"standard": "gleason-spiral"}, "standard = 'gleason-spiral'", "usually 35°"),
        ({"standard": "iso-23509", "face_width": 67.1}, "face_width = 67.1 mm", "more than the cone distance"),
        ({"standard": "gleason-straight", "working_depth": 6.0}, "working_depth = 6 mm", "explicit"),
        ({"standard": "gleason-straight", "profile_shift": 0.2}, "profile_shift = 0.2", "equal-addendum or iso-23509"),
        ({"thickness_modification": 0.02}, "thickness_modification = 0.02", "gleason-straight"),
        ({"standard": "equal-addendum", "profile_shift": 1.0}, "profile_shift = 1.0", "less than 1"),
        ({"standard": "gleason"}, "standard = 'gleason'", "gleason-straight"),
        ({"standard": "gleason-straight", "shaft_angle": 170.0}, "shaft_angle = 170°", "internal bevel gear"),
        (
            {"standard": "equal-addendum", "teeth": (40, 9), "root": "radial"},
            "standard = 'equal-addendum'",
            "interference",
        ),
    ],
)
def test_what_a_standard_has_no_teeth_for_is_refused_by_the_parameter_at_fault(more, subject, words):
    with pytest.raises(ParameterError) as refusal:
        gw.BevelPair(**{**PAIR, **more})
    problems = {problem.subject: problem.message for problem in refusal.value.problems}
    assert list(problems) == [subject]
    assert words in problems[subject]
