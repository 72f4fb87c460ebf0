"""Transmission error of a bevel pair: how far the driven gear is from where its teeth numbers say."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array, Indices
from ..elements.bevel.bevel_pair import BevelPair
from ..errors import GeometryError, Problem
from .approach import Approach
from .mesh import Mesh, Side, mesh_of
from .misalignment import ALIGNED, Misalignment

_HEADLINE = "The transmission error cannot be found"
_SPARE = 2  # pitches to either side of the pitch line in which the transverse path of contact ends


@dataclass(frozen=True, kw_only=True)
class TransmissionError:
    """Where the driven gear stands over one pitch of the pinion, without load.

    pinion_turn       (n,) from a tooth on the pitch line, in the sense in which the side drives, radians
    lead              (n,) of the gear ahead of its ideal position, the middle of the play, in the sense in which it
                      is driven, radians: about minus half the play
    distance, polar   (n,) cone distance and polar angle on the pinion where they touch
    tooth             (n,) which of the pinion's teeth touches, 0 the one that is nearest to the pitch line at turn 0
    """

    side: Side
    pinion_turn: Array
    lead: Array
    distance: Array
    polar: Array
    tooth: Indices

    @cached_property
    def error(self) -> Array:
        """The lead about its mean (n,), radians of the gear: what varies, without the play."""
        return self.lead - self.lead.mean()

    @property
    def peak_to_peak(self) -> float:
        """Greatest less least error, radians of the gear."""
        return float(np.ptp(self.lead))


def transmission_error(
    pair: BevelPair,
    *,
    shaft_angle_error: float = 0.0,
    mounting_errors: tuple[float, float] = (0.0, 0.0),
    offset_error: float = 0.0,
    samples: int = 64,
    side: Side = "drive",
) -> TransmissionError:
    """Transmission error over one pitch, from first contact of the true flanks, of all teeth that can touch.

    shaft_angle_error   added to the shaft angle, degrees
    mounting_errors     shifts of pinion and gear along their axes, away from the apex, length
    offset_error        distance of the axes, the gear shifted along +y where pinion axis is +z and the gear's in +x

    Counted are the flanks from form circle to tip; fillets and rims are not. Raises GeometryError where the
    members do not reach each other at some turn, or the input is none.
    """
    misalignment = Misalignment(
        shaft_angle=float(np.radians(shaft_angle_error)),
        pinion=mounting_errors[0],
        gear=mounting_errors[1],
        offset=offset_error,
    )
    return running_error(mesh_of(pair), misalignment, samples=samples, side=side)


def running_error(
    mesh: Mesh, misalignment: Misalignment = ALIGNED, *, samples: int = 64, side: Side = "drive"
) -> TransmissionError:
    """The same for any flanks on the sphere. Raises GeometryError."""
    _require(samples, side, misalignment)
    teeth = _teeth_that_may_touch(mesh)
    sense = 1.0 if side == "drive" else -1.0
    turns = np.arange(samples) * mesh.pitch / samples
    all_turns = sense * turns[:, None] + mesh.pitch * teeth
    touch = Approach(mesh=mesh, side=side, misalignment=misalignment).touch(all_turns.ravel())
    lead = touch.lead.reshape(all_turns.shape)
    lead = np.where(np.abs(lead) < np.pi / mesh.gear.teeth, lead, -np.inf)  # half a pitch off it is another tooth's
    first, rows = np.argmax(lead, axis=1), np.arange(samples)
    if not np.all(np.isfinite(lead[rows, first])):
        where = float(np.degrees(turns[np.argmin(lead[rows, first])]))
        problem = Problem(
            f"pinion turned by {where:.4g}°",
            "no flank reaches its mate: the errors of mounting are larger than the depth of the teeth; "
            "lengths are in the pair's unit and angles in degrees",
        )
        raise GeometryError(_HEADLINE, [problem])
    return TransmissionError(
        side=side,
        pinion_turn=turns,
        lead=lead[rows, first],
        distance=touch.distance.reshape(lead.shape)[rows, first],
        polar=touch.polar.reshape(lead.shape)[rows, first],
        tooth=teeth[first],
    )


def least_backlash(drive: TransmissionError, coast: TransmissionError) -> float:
    """The least angle, radians, by which the gear can turn between the flanks at some position of the pinion.

    Both sides sampled at the same turns, of which the coast side's run the other way.
    """
    backwards = np.roll(coast.lead[::-1], 1)
    return float(np.min(-(drive.lead + backwards)))


def _teeth_that_may_touch(mesh: Mesh) -> Indices:
    """Numbers of the pinion's teeth whose flanks may be in mesh while the first one passes a pitch."""
    lag = max(map(abs, mesh.pinion.turned))
    reach = _SPARE + int(np.ceil(lag / mesh.pitch))
    return np.arange(-reach - 1, reach + 1, dtype=np.int64)


def _require(samples: int, side: str, misalignment: Misalignment) -> None:
    problems = []
    if samples < 2:
        problems.append(Problem(f"samples = {samples}", "at least 2 turns of the pinion over a pitch"))
    if side not in ("drive", "coast"):
        problems.append(
            Problem(
                f"side = {side!r}",
                "drive, the flanks that push as the pinion turns positively about +z, or coast, the other ones",
            )
        )
    errors = (misalignment.shaft_angle, misalignment.pinion, misalignment.gear, misalignment.offset)
    if not np.all(np.isfinite(errors)):
        problems.append(Problem("errors of mounting", "finite numbers are needed"))
    if problems:
        raise GeometryError(_HEADLINE, problems)
