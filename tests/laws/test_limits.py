"""Bevel gears whose apex moves away become spur gears."""

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.cylindrical.spur_gear import SpurGear

from ..examples import SHARP

ANGLES = np.array([8.0, 4.0, 2.0, 1.0])
SHAPE = {"teeth": 18, "face_width": 10.0, "addendum": 2.8, "dedendum": 3.4, "pressure_angle": 22.0, "backlash": 0.1}
SPUR = SpurGear(module=3.0, root="radial", **SHAPE)


def _bevel(angle, *, mean_module, **more):
    """A bevel gear of small pitch angle with the spur gear's sizes at the outer end, or half-way along the teeth."""
    cone_distance = SHAPE["teeth"] * 3.0 / 2.0 / np.sin(np.radians(angle))
    if not mean_module:
        return BevelGear(module=3.0, pitch_angle=angle, **SHAPE, **SHARP, **more)
    # cone distance to mid-face is the one at which the module is 3
    scale = (cone_distance + SHAPE["face_width"] / 2.0) / cone_distance
    sizes = {name: SHAPE[name] * scale for name in ("addendum", "dedendum", "backlash")}
    return BevelGear(module=3.0 * scale, pitch_angle=angle, **{**SHAPE, **sizes}, **SHARP, **more)


def _errors(**more):
    spur = SPUR.properties()
    found = [_bevel(angle, **more).properties() for angle in ANGLES]
    volume = [abs(one.volume / spur.volume - 1.0) for one in found]
    inertia = [abs(one.inertia[2, 2] / spur.inertia[2, 2] - 1.0) for one in found]
    across = [abs(one.central_inertia[0, 0] / spur.central_inertia[0, 0] - 1.0) for one in found]
    return np.array([volume, inertia, across])


def _orders(errors):
    return [np.polyfit(np.log(ANGLES), np.log(row), 1)[0] for row in errors]


@pytest.mark.parametrize("more", [{}, {"trace": "logarithmic", "spiral_angle": 25.0}], ids=["straight", "spiral"])
@pytest.mark.parametrize(("mean_module", "order"), [(False, 1.0), (True, 2.0)], ids=["outer sizes", "mean sizes"])
def test_small_pitch_angles_approach_the_spur_gear(more, mean_module, order):
    """Sizes at the outer end are larger than the mean ones by O(γ); sizes at mid-face leave O(γ²)."""
    errors = _errors(mean_module=mean_module, **more)
    np.testing.assert_allclose(_orders(errors), order, atol=0.1)
    assert errors[:, -1].max() < (0.02 if order == 1.0 else 5e-4)


@pytest.mark.parametrize("part", [{"bore": 20.0}, {"circular_thickness": 4.0}], ids=str)
def test_so_do_gears_with_a_bore_or_another_thickness(part):
    scaled = {name: value for name, value in part.items() if name == "bore"}
    spur = SpurGear(module=3.0, root="radial", **SHAPE, **part).properties()
    errors = []
    for angle in (2.0, 1.0, 0.5):
        gear = _bevel(angle, mean_module=True, **(scaled or part)).properties()
        errors.append([abs(gear.volume / spur.volume - 1.0), abs(gear.inertia[2, 2] / spur.inertia[2, 2] - 1.0)])
    assert np.all(np.diff(errors, axis=0) < 0.0)
    assert np.max(errors[-1]) < 2e-3


def test_the_teeth_of_a_spiral_bevel_become_a_helix():
    """The turn along the face tends to b tan β / r, that of a helical gear of the same helix angle."""
    gear = _bevel(0.5, mean_module=True, trace="logarithmic", spiral_angle=25.0)
    tip = next(patch for patch in gear.boundary.patches if patch.name == "loop 1.3")
    ends = tip.point(np.array([0.5, 0.5]), np.array([0.0, 1.0]))
    turned = np.diff(np.arctan2(ends[:, 1], ends[:, 0]))[0]
    assert turned == pytest.approx(SHAPE["face_width"] * np.tan(np.radians(25.0)) / 27.0, rel=5e-3)
