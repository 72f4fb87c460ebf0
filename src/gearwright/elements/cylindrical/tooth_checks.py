"""Why a tooth cannot be built, with the limits that could be kept."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...parameters import rounded_down
from .. import refusals
from ..gear_loop import NEXT_TO_NOTHING
from .external_tooth import ExternalTooth
from .internal_tooth import InternalTooth
from .toothing import Toothing

Found = tuple[str, str]
"""The name of a parameter and what is wrong with it."""


def check_external(tooth: ExternalTooth, nominal_thickness: float, own_thickness: bool, unit: str) -> list[Found]:
    """What is wrong with an external tooth; the first kind of trouble only, since the rest follows from it.

    own_thickness   whether the thickness was asked for, and does not follow from the profile shift
    """
    toothing = tooth.toothing
    blank = list(_external_blank(toothing, unit)) + list(_thickness(toothing, nominal_thickness, unit))
    return (
        blank
        or list(_fillet(tooth, nominal_thickness if own_thickness else None, unit))
        or list(_external_tip(tooth, unit))
        or list(_flank(tooth, unit))
    )


def _external_blank(toothing: Toothing, unit: str) -> Iterator[Found]:
    if toothing.root_radius <= 0.0:
        yield (
            "dedendum",
            f"the root circle vanishes; less than the pitch radius, {rounded_down(toothing.pitch_radius)} {unit}",
        )
    yield from _depth(toothing)


def _depth(toothing: Toothing) -> Iterator[Found]:
    if toothing.dedendum <= 0.0:
        limit = toothing.profile_shift + toothing.dedendum / toothing.module
        yield "profile_shift", f"leaves no dedendum; less than the dedendum of the basic rack, {limit:.4g}"
    if toothing.addendum <= 0.0:
        yield (
            "addendum",
            "leaves no addendum; the tips must lie beyond the pitch circle, by a larger one or a larger profile shift",
        )


def _thickness(toothing: Toothing, nominal: float, unit: str) -> Iterator[Found]:
    if nominal <= 0.0:
        yield "profile_shift", "leaves no tooth on the pitch circle; a larger one does"
    elif toothing.thickness <= 0.0:
        yield "backlash", refusals.no_tooth_left(2.0 * nominal, unit)
    elif toothing.internal and toothing.thickness >= toothing.circular_pitch:
        yield "circular_thickness", refusals.meeting_teeth(toothing.circular_pitch + nominal - toothing.thickness, unit)


def _fillet(tooth: ExternalTooth, nominal: float | None, unit: str) -> Iterator[Found]:
    """Of the tooth below its involute."""
    toothing, fillet = tooth.toothing, tooth.fillet
    if fillet is None:
        if tooth.form_radius >= toothing.pitch_radius:
            yield "dedendum", refusals.no_involute("circle")
        elif tooth.root_space <= 0.0:
            limit = (nominal or toothing.thickness) + tooth.root_space * toothing.pitch_radius
            yield "circular_thickness", refusals.meeting_teeth(limit, unit)
        return
    largest = fillet.rack_tip.largest_radius
    if largest <= 0.0 and nominal is not None:
        taken = 2.0 * (toothing.dedendum * np.tan(toothing.transverse_pressure_angle) - fillet.rack_tip.half_width)
        yield "circular_thickness", refusals.meeting_teeth(nominal - taken, unit)
    elif largest <= 0.0 and fillet.rack_tip.half_width <= 0.0:
        yield "profile_shift", "leaves no space between the teeth on the pitch circle; a smaller one does"
    elif largest <= 0.0:
        deepest = fillet.rack_tip.half_width / np.tan(toothing.transverse_pressure_angle)
        yield "dedendum", refusals.pointed_rack(deepest, unit)
    elif fillet.tip_radius > largest * (1.0 + 1e-12):
        yield "rack_tip_radius", refusals.wide_rack_tip(largest, toothing.module, unit)
    elif not fillet.regular:
        yield "profile_shift", refusals.STEEP_FILLET
    elif fillet.waist <= 0.0:
        yield "teeth", refusals.undercut_through("its root", toothing.teeth)
    elif fillet.form_radius >= toothing.tip_radius and not fillet.undercuts:
        yield "rack_tip_radius", refusals.FILLET_TO_THE_TIP
    elif fillet.form_radius >= toothing.tip_radius:
        yield "teeth", refusals.undercut_through("its tip", toothing.teeth)


def _external_tip(tooth: ExternalTooth, unit: str) -> Iterator[Found]:
    toothing = tooth.toothing
    if toothing.tip_radius >= toothing.pointed_radius:
        most = toothing.pointed_radius - toothing.pitch_radius
        yield "addendum", refusals.pointed_tooth(most, unit, 2.0 * toothing.pointed_radius)


def check_crowning(tooth: ExternalTooth | InternalTooth, angle: float, unit: str) -> Iterator[Found]:
    """What is wrong with flanks that turn into the tooth by so much (radians) at the ends of the face."""
    half, where = tooth.tip_half, "tips"
    if isinstance(tooth, ExternalTooth) and tooth.fillet is not None and tooth.fillet.waist < half:
        half, where = tooth.fillet.waist, "waists of the undercut teeth"
    if angle >= half:
        limit = half * tooth.toothing.base_radius
        yield "crowning", f"leaves nothing of the {where} at the ends; less than {rounded_down(limit)} {unit}"
    elif angle and (tooth.root_half if isinstance(tooth, InternalTooth) else tooth.root_space) <= NEXT_TO_NOTHING:
        yield "crowning", "needs a land at the root, however narrow; take a smaller radius of the fillets"


def check_internal(tooth: InternalTooth, nominal_thickness: float, unit: str) -> list[Found]:
    """What is wrong with an internal tooth; the first kind of trouble only."""
    toothing = tooth.toothing
    blank = list(_depth(toothing)) + list(_thickness(toothing, nominal_thickness, unit))
    return (
        blank or list(_internal_ends(tooth, unit)) or list(_internal_fillet(tooth, unit)) or list(_flank(tooth, unit))
    )


def _internal_ends(tooth: InternalTooth, unit: str) -> Iterator[Found]:
    toothing = tooth.toothing
    if toothing.tip_radius < toothing.base_radius:
        yield "addendum", refusals.tip_below_base(toothing.pitch_radius - toothing.base_radius, unit)
    elif toothing.thickness_at(toothing.tip_radius) <= 0.0:
        yield "addendum", "the tooth comes to a point before its tip; a smaller one does not, nor does a thicker tooth"
    if toothing.root_radius >= toothing.pointed_radius:
        yield "dedendum", refusals.pointed_space(toothing.pointed_radius - toothing.pitch_radius, unit)


def _internal_fillet(tooth: InternalTooth, unit: str) -> Iterator[Found]:
    if tooth.fillet_radius > tooth.largest_fillet_radius * (1.0 + 1e-12):
        yield "fillet_radius", refusals.wide_fillet(tooth.largest_fillet_radius, unit)
    elif tooth.form_radius <= tooth.toothing.tip_radius:
        yield "fillet_radius", "leaves no involute between fillet and tip; a smaller one does"


def _flank(tooth: ExternalTooth | InternalTooth, unit: str) -> Iterator[Found]:
    """Of what is taken off at the tip."""
    toothing, flank = tooth.toothing, tooth.flank
    room = abs(tooth.form_radius - toothing.tip_radius)
    if flank.chamfer and flank.chamfer >= room:
        yield "tip_chamfer", f"is higher than the flank; less than {rounded_down(room)} {unit}"
        return
    if flank.relief is not None:
        limit = room - flank.chamfer
        if abs(flank.relief.begin - flank.usable_tip_radius) >= limit:
            yield "tip_relief_height", f"reaches below the flank; less than {rounded_down(limit)} {unit}"
            return
    without = tooth.tip_half + (flank.relief.amount / toothing.base_radius if flank.relief else 0.0)
    if without <= 0.0:
        yield "tip_chamfer", "leaves nothing of the tip; a smaller one does"
    elif tooth.tip_half <= 0.0:
        limit = without * toothing.base_radius
        yield "tip_relief", f"leaves nothing of the tip; less than {rounded_down(limit)} {unit}"
