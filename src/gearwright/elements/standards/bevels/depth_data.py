"""Depths of teeth at the middle of the face, in mean normal modules, and the two ways in which they are given."""

from __future__ import annotations

from dataclasses import dataclass

from .design import BevelDesign


@dataclass(frozen=True, kw_only=True)
class DepthData:
    """Coefficients of m_mn at the mean point (data of type I of ISO 23509).

    addendum                 k_hap of the basic rack
    dedendum                 k_hfp of the basic rack
    profile_shift            x_hm of the first member; −x_hm of the second
    thickness_modification   x_smn of the first member, half of what its teeth are thicker by; −x_smn of the second
    """

    addendum: float = 1.0
    dedendum: float = 1.25
    profile_shift: float = 0.0
    thickness_modification: float = 0.0


def depth_data(
    *, depth: float = 2.0, clearance: float = 0.125, gear_addendum: float = 0.5, thickness: float = 0.0
) -> DepthData:
    """The same data from the factors of type II, of a pinion named first.

    depth           k_d, working depth in modules: h_mw = k_d m_mn
    clearance       k_c, in working depths
    gear_addendum   c_ham = h_am2/h_mw
    thickness       k_t, by which the pinion's teeth are thicker, in modules
    k_hap = k_d/2, k_hfp = k_d (½ + k_c), x_hm1 = k_d (½ − c_ham), x_smn1 = k_t/2. Source: ISO 23509, conversion of
    data of type II into type I.
    """
    return DepthData(
        addendum=depth / 2.0,
        dedendum=depth * (0.5 + clearance),
        profile_shift=depth * (0.5 - gear_addendum),
        thickness_modification=thickness / 2.0,
    )


def usual_depth_data(design: BevelDesign) -> DepthData:
    """k_d = 2, k_c = 0.125, c_ham = 0.21 + 0.29/κ for the gear, k_t = 0.

    κ = (z₂ cos δ₁)/(z₁ cos δ₂), u² on axes at right angles, so that equal members have c_ham = ½ and a crown
    gear's mate the longest addendum. Source: ISO 23509, suggested data of type II; ANSI/AGMA 2005-D03, mean addendum
    factor.
    """
    share = 0.21 + 0.29 * design.levelness
    of_second = design.of_members(1.0 - share, share)[1]
    return depth_data(gear_addendum=of_second)


def depth_data_of(method: int, design: BevelDesign) -> DepthData:
    """What a method of ISO 23509 takes by itself: usual_depth_data for 0 and 1, DepthData() for 2 and 3."""
    return usual_depth_data(design) if method in (0, 1) else DepthData()


def strength_thickness_factor(design: BevelDesign) -> float:
    """k_t = −0.088 + 0.092u − 0.004u² + 0.0016(z₁ − 30)(u − 1) of the pinion: teeth of about equal bending strength.

    A suggestion for `thickness` of depth_data with pinions and gears of like material; 0 or nearly so of equal members.
    Source: ANSI/AGMA 2005-D03, thickness factor.
    """
    pinion, gear = min(design.teeth), max(design.teeth)
    ratio = gear / pinion
    return -0.088 + 0.092 * ratio - 0.004 * ratio**2 + 0.0016 * (pinion - 30) * (ratio - 1.0)
