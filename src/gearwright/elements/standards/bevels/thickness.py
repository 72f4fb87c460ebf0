"""Transverse thicknesses of the teeth of a pair that share the pitch of their outer circles."""

from __future__ import annotations

import numpy as np

from .design import BevelDesign


def thicknesses(design: BevelDesign, excess: float, modification: float) -> tuple[float, float]:
    """s_e1 = πm/2 + Δh tan α_t + 2x_s m and s_e2 = πm − s_e1, of the members as they are named.

    excess         Δh = h_a1 − h_a2
    modification   x_s, in outer transverse modules: half of what the first member's teeth are thicker by
    Source: KHK, Gear Technical Reference, chordal thickness of Gleason bevel gears, where K = 2x_s; on the pitch
    circle it is the thickness of a tooth whose rack, of pressure angle α_t, is moved by Δh/2.
    """
    half_pitch = np.pi * design.module / 2.0
    wider = excess * np.tan(design.transverse_pressure_angle) + 2.0 * modification * design.module
    return float(half_pitch + wider), float(half_pitch - wider)
