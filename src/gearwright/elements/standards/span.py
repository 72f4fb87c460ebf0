"""Span measurement: the distance over k teeth between parallel planes that touch flanks (base tangent length)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..cylindrical.toothing import Toothing


def span_measurement(toothing: Toothing, teeth: int) -> float:
    """W_k over so many teeth: W_k = ((k − 1) p_bt + s_bt) cos β_b, with the thickness s_bt on the base circle.

    Without backlash this is m_n cos α_n [π(k − ½) + z inv α_t] + 2 x m_n sin α_n.
    Source: ISO 21771, span measurement of external gears.
    """
    base_thickness = 2.0 * toothing.half_at_base * toothing.base_radius
    span = (teeth - 1) * toothing.base_pitch + base_thickness
    return float(span * np.cos(toothing.base_helix_angle))


def contact_radius(toothing: Toothing, teeth: int) -> float:
    """Radius at which the planes of a span of so many teeth touch the flanks, where it is measured symmetrically."""
    transverse = span_measurement(toothing, teeth) * np.cos(toothing.base_helix_angle)
    return float(np.hypot(toothing.base_radius, transverse / 2.0))


def possible_spans(toothing: Toothing, form_radius: float, tip_radius: float) -> Mapping[int, float]:
    """The numbers of teeth whose spans touch on the flank, between form and tip circle, and those radii."""
    base = toothing.base_pitch * np.cos(toothing.base_helix_angle) ** 2
    first = span_measurement(toothing, 1) * np.cos(toothing.base_helix_angle)

    def counted(radius: float) -> float:
        return float(1.0 + (2.0 * np.sqrt(max(0.0, radius**2 - toothing.base_radius**2)) - first) / base)

    lowest = max(1, int(np.floor(counted(form_radius))))
    highest = min(toothing.teeth, int(np.ceil(counted(tip_radius))))
    radii = {k: contact_radius(toothing, k) for k in range(lowest, highest + 1)}
    return {k: radius for k, radius in radii.items() if form_radius <= radius <= tip_radius}
