"""Strategies of random bevel gears and pairs: every trace, form, taper, standard and body, most of them sensible."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.bevel.pitch_cone import pitch_cone_angle

TRACES = ("straight", "straight", "skew", "logarithmic", "circular", "involute", "epicycloid")
STANDARDS = ("explicit", "explicit", "equal-addendum", "gleason", "iso-23509", "iso-23509")


def _seldom(strategy, others=None):
    """One in four."""
    return st.integers(0, 3).flatmap(lambda k: strategy if k == 3 else st.just(others))


def _given(values):
    return {name: value for name, value in values.items() if value is not None}


@st.composite
def traces(draw, kind, mean_distance):
    if kind == "straight":
        return {}
    values = {
        "trace": kind,
        "spiral_angle": draw(st.floats(1.0, 45.0)),
        "hand": draw(st.sampled_from(["right", "left"])),
    }
    if kind in ("circular", "epicycloid"):
        values["cutter_radius"] = mean_distance * draw(st.floats(0.6, 1.6))
    if kind == "epicycloid":
        values["blade_groups"] = draw(st.integers(3, 17))
    return values


@st.composite
def sizings(draw, module, straight, pair):
    """A standard with what goes with it, or heights and angles of one's own."""
    standard = draw(st.sampled_from(STANDARDS))
    if standard == "gleason":
        standard += "-straight" if straight else "-spiral"
    values = {"standard": standard, "taper": None}
    if standard in ("explicit", "equal-addendum"):
        values["taper"] = draw(_seldom(st.sampled_from(["standard", "uniform"])))
    if standard == "iso-23509":
        values["taper"] = draw(st.sampled_from([None, None, "standard", "uniform", "duplex", "tilted"]))
        values["iso_method"] = draw(_seldom(st.integers(0, 3)))
    if standard in ("equal-addendum", "iso-23509"):
        values["profile_shift"] = draw(_seldom(st.floats(-0.4, 0.4)))
    if standard == "explicit":
        heights = ("working_depth", "whole_depth") if pair else ("addendum", "dedendum")
        low = (1.6, 2.1) if pair else (0.5, 0.7)
        for name, least in zip(heights, low, strict=True):
            share = draw(_seldom(st.floats(least, least + 0.6)))
            values[name] = None if share is None else share * module
        if not pair and values["taper"] is None:
            values["addendum_angle"] = draw(_seldom(st.floats(0.0, 8.0)))
            values["dedendum_angle"] = draw(_seldom(st.floats(0.0, 8.0)))
    else:
        values["thickness_modification"] = draw(_seldom(st.floats(-0.1, 0.1)))
    return _given(values)


@st.composite
def flanks(draw, module):
    values = {
        "tooth_form": draw(st.sampled_from(["involute", "octoid"])),
        "root": draw(st.sampled_from(["fillet", "fillet", "fillet", "radial"])),
        "pressure_angle": draw(st.sampled_from([20.0, 20.0, 25.0]) | st.floats(14.5, 30.0)),
        "ends": draw(st.sampled_from(["conical", "conical", "spherical", "flat"])),
    }
    if values["root"] == "fillet":
        values["crown_tip_radius"] = draw(_seldom(st.floats(0.02, 0.6)))
    values["tip_relief"] = draw(_seldom(st.floats(0.001, 0.03)))
    values["crowning"] = draw(_seldom(st.floats(0.001, 0.05)))
    values["backlash"] = draw(_seldom(st.floats(0.01, 0.1)))
    lengths = ("crown_tip_radius", "tip_relief", "crowning", "backlash")
    found = _given(values)
    found |= {name: found[name] * module for name in lengths if name in found}
    if "tip_relief" in found:
        found["tip_relief_form"] = draw(st.sampled_from(["linear", "parabolic"]))
    return found


@st.composite
def bodies(draw, toe_diameter, axial):
    """A body inside the teeth, most often one that fits."""
    if draw(st.booleans()):
        return {}
    bore = draw(st.floats(0.15, 0.5)) * toe_diameter
    values = {"bore": bore}
    if draw(st.booleans()):
        values |= {"keyway_width": 0.25 * bore, "keyway_depth": 0.12 * bore}
    if draw(st.booleans()):
        values["hub_diameter"] = draw(st.floats(0.5, 1.2)) * toe_diameter
        values["hub_length"] = draw(st.none() | st.floats(0.5, 2.0).map(lambda share: share * axial))
    if not draw(st.integers(0, 2)):
        web = {"rim_diameter": draw(st.floats(0.6, 1.0)) * toe_diameter, "web_thickness": 0.4 * axial}
        values |= web
        if draw(st.booleans()):
            values |= {"web_holes": draw(st.integers(1, 6)), "web_hole_diameter": 0.05 * toe_diameter}
    return _given(values)


@st.composite
def gears(draw, fewest=6):
    module, z = draw(st.floats(0.5, 8.0)), draw(st.integers(fewest, 45))
    kind = draw(st.sampled_from(TRACES))
    sizing = draw(sizings(module, kind == "straight", pair=False))
    if sizing["standard"] != "explicit" or draw(st.booleans()):
        cone = {"mate_teeth": draw(st.integers(8, 60)), "shaft_angle": draw(st.sampled_from([None, 60.0, 90.0, 100.0]))}
        angle = pitch_cone_angle(z, cone["mate_teeth"], np.radians(cone["shaft_angle"] or 90.0))
    else:
        cone = {"pitch_angle": draw(st.floats(3.0, 90.0) | st.just(90.0))}
        angle = np.radians(cone["pitch_angle"])
    outer = z * module / 2.0 / float(np.sin(angle))
    width = draw(st.floats(0.08, 0.4)) * outer
    toe = 2.0 * (outer - width) * float(np.sin(angle)) - 2.5 * module * float(np.cos(angle))
    axial = width * float(np.cos(angle)) + 2.25 * module * float(np.sin(angle))
    values = {"teeth": z, "module": module, "face_width": width, **cone, **sizing}
    values |= {
        **draw(traces(kind, outer - width / 2.0)),
        **draw(flanks(module)),
        **draw(bodies(max(toe, module), axial)),
    }
    if values["ends"] == "conical" and draw(st.integers(0, 3)) == 3:
        values["mounting_distance"] = outer * float(np.cos(angle)) + draw(st.floats(0.0, 4.0)) * module
    return BevelGear, _given(values)


@st.composite
def pairs(draw, fewest=8):
    module = draw(st.floats(0.5, 8.0))
    teeth = (draw(st.integers(fewest, 30)), draw(st.integers(fewest, 45)))
    shaft = draw(st.sampled_from([90.0, 90.0, 90.0, 60.0, 110.0]))
    angle = pitch_cone_angle(*teeth, np.radians(shaft))
    outer = teeth[0] * module / 2.0 / float(np.sin(angle))
    width = draw(st.floats(0.1, 0.35)) * outer
    values = {"teeth": teeth, "module": module, "shaft_angle": shaft, "face_width": width}
    kind = draw(st.sampled_from(TRACES))
    sizing = draw(sizings(module, kind == "straight", pair=True))
    values |= {**sizing, **draw(traces(kind, outer - width / 2.0)), **draw(flanks(module))}
    if values.get("crown_tip_radius") and draw(st.booleans()):
        del values["crown_tip_radius"]
    if draw(st.booleans()):
        values["bore"] = 0.3 * min(teeth) * module
    return BevelPair, values
