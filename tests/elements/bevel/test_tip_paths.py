"""How deep tips cut, against all points of the outlines placed at many turns; and what refusals tell is true."""

import re
from dataclasses import replace

import numpy as np
import pytest

from gearwright import ParameterError
from gearwright.curves.curve import turn
from gearwright.curves.parallel import Parallel
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.bevel.meshing import meshing_placements
from gearwright.elements.bevel.tip_paths import cut_depth

from ...laws.contact import unmapped
from .teeth import pair, polar_and_azimuth

TURNS = 181  # over a pitch
POINTS = 301  # of a curve


def outline(tooth):
    """Points of both sides and the tip of a tooth on azimuth 0."""
    curves = tooth.section().loops[0].curves
    points = np.concatenate([curve.point(curve.parameter(np.linspace(0.0, 1.0, POINTS))) for curve in curves])
    return np.concatenate([points, points * [1.0, -1.0, 1.0]])


def profile(tooth):
    """(polar angles, half angles) of the side of a tooth, from root to tip."""
    sides = [curve for curve in tooth.section().loops[0].curves if not isinstance(unmapped(curve), Parallel)]
    points = np.concatenate([curve.point(curve.parameter(np.linspace(0.0, 1.0, 4001))) for curve in sides])
    polar, azimuth = polar_and_azimuth(points)
    pitch = 2.0 * np.pi / tooth.teeth
    half = np.abs(azimuth - pitch * np.round(azimuth / pitch))
    order = np.argsort(polar, kind="stable")
    return polar[order], half[order]


def deepest(teeth, shaft, member, below=False):
    """Greatest depth of any point of the other's addendum, or of all of it, in a member, at turns over a pitch."""
    own, mate = teeth[member], teeth[1 - member]
    points = outline(mate)
    if not below:
        points = points[polar_and_azimuth(points)[0] >= mate.pitch_angle]
    table, pitch = profile(own), 2.0 * np.pi / own.teeth
    found = []
    for angle in np.arange(TURNS) / TURNS * 2.0 * np.pi / teeth[0].teeth:
        placed = meshing_placements(np.radians(shaft), teeth[0].teeth, teeth[1].teeth, angle)
        for k in range(-2, 3):
            image = placed[1 - member][:3, :3] @ turn(2.0 * np.pi * k / mate.teeth, 3)
            polar, azimuth = polar_and_azimuth(points @ (placed[member][:3, :3].T @ image).T)
            off = np.abs(azimuth - pitch * np.round(azimuth / pitch))
            depth = (np.interp(polar, *table) - off) * np.sin(polar)
            depth = np.maximum(depth, own.root_angle - polar)
            found.append(np.max(depth[polar <= own.face_angle], initial=-np.inf))
    return max(found)


CASES = {
    "as usual": ((16, 20), 90.0, {}, {}),
    "octoids at 60°": ((16, 20), 60.0, {"form": "octoid"}, {}),
    "at 110°": ((24, 31), 110.0, {}, {}),
    "with backlash": ((16, 20), 90.0, {"backlash": 0.05}, {}),
    "long pinion": ((16, 20), 90.0, {}, {0: {"face_angle": 0.07}}),
    "long gear": ((12, 31), 90.0, {}, {1: {"face_angle": 0.04}}),
    "long gear of octoids": ((12, 31), 60.0, {"form": "octoid"}, {1: {"face_angle": 0.03}}),
    "radial roots of few teeth": ((9, 30), 90.0, {"rho": None}, {}),
    "round roots": ((16, 20), 90.0, {"rho": 0.4}, {1: {"face_angle": 0.015}}),
    "involute and octoid": ((16, 20), 90.0, {}, {0: {"form": "octoid"}}),
    "octoid and involute": ((16, 31), 70.0, {}, {1: {"form": "octoid"}}),
}


def teeth_of(name):
    numbers, shaft, given, changes = CASES[name]
    teeth = pair(numbers, shaft, given.get("form", "involute"), **{k: v for k, v in given.items() if k != "form"})
    for member, change in changes.items():
        longer = {"face_angle": teeth[member].face_angle + change["face_angle"]} if "face_angle" in change else change
        teeth[member] = replace(teeth[member], **longer)
    return teeth, shaft


@pytest.mark.parametrize("name", CASES)
def test_the_depth_is_that_of_the_deepest_point_of_the_whole_outline(name):
    """2e-6: what 181 turns and chords between points leave open; depths are told apart from none at 1e-7."""
    teeth, shaft = teeth_of(name)
    found = [cut_depth(teeth[member], teeth[1 - member], np.radians(shaft)) for member in (0, 1)]
    brute = [deepest(teeth, shaft, member) for member in (0, 1)]
    assert max(brute) == pytest.approx(max(found), rel=0.02, abs=2e-6)
    if max(found) < 1e-7:
        assert max(deepest(teeth, shaft, member, below=True) for member in (0, 1)) < 2e-6


@pytest.mark.parametrize(
    ("name", "cuts"), [("as usual", []), ("long pinion", [1]), ("long gear", [0]), ("octoid and involute", [1])]
)
def test_it_is_known_which_member_is_cut(name, cuts):
    teeth, shaft = teeth_of(name)
    found = [cut_depth(teeth[member], teeth[1 - member], np.radians(shaft)) for member in (0, 1)]
    assert [member for member in (0, 1) if found[member] > 1e-5] == cuts


BASIC = {"teeth": (16, 20), "module": 4.0, "face_width": 10.0}


def refusal(**given):
    """What is said of a pair; nothing where it can be built."""
    try:
        BevelPair(**{**BASIC, **given})
    except ParameterError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("forms", [("involute", "octoid"), ("octoid", "involute")])
@pytest.mark.parametrize(
    "more", [{}, {"teeth": (25, 25), "shaft_angle": 135.0}, {"trace": "logarithmic", "spiral_angle": 35.0}]
)
def test_the_play_that_two_forms_need_is_enough_and_little_less_is_not(forms, more):
    said = refusal(tooth_form=forms, **more)
    (told,) = re.findall(r"backlash = 0 mm: interference: flanks of two forms .*; (\S+) mm more on the outer", said)
    assert not refusal(tooth_form=forms, **more, backlash=float(told))
    assert "interference" in refusal(tooth_form=forms, **more, backlash=0.85 * float(told))


@pytest.mark.parametrize("taper", [None, "uniform"])
@pytest.mark.parametrize("teeth", [(9, 30), (12, 60)])
def test_the_addendum_that_radial_roots_allow_is_the_largest(teeth, taper):
    def said(addendum):
        given = {"teeth": teeth, "root": "radial", "taper": taper, "standard": "explicit"}
        return refusal(**given, whole_depth=10.0, working_depth=addendum + 2.0, gear_addendum=addendum)

    (told,) = re.findall(r"the gear's tip, .* at most (\S+) mm for that addendum", said(4.0))
    assert "the gear's tip," not in said(float(told))
    assert "the gear's tip," in said(1.002 * float(told))
