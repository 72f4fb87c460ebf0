"""The tool: a rack with rounded tips, rolled around a gear; nothing of it comes from the package."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from scipy.optimize import minimize_scalar
from shapely.affinity import translate


@dataclass(frozen=True)
class GeneratingRack:
    """The rack whose teeth fill a gear's spaces, by the numbers that the gear was asked for.

    In the normal section its tooth is a trapezium of the pressure angle with corners round by ρ: what a smaller
    trapezium covers when a disc of radius ρ is moved over it. The transverse section is that, stretched by 1/cos β.
    """

    teeth: int
    module: float
    pressure_angle: float
    helix: float
    half_width: float
    depth: float
    tip_radius: float

    @classmethod
    def of(cls, gear, tip_radius: float) -> GeneratingRack:
        """For a gear with a module in mm and thickness by its profile shift."""
        m, x, alpha = gear.normal_module, gear.profile_shift, np.radians(gear.pressure_angle)
        depth = {"iso-53-a": 1.25, "iso-53-d": 1.4, "agma-full-radius": 1.35}[gear.basic_rack] - x
        thickness = m * (np.pi / 2.0 + 2.0 * x * np.tan(alpha)) - gear.backlash / 2.0 * np.cos(gear.helix.angle)
        return cls(gear.teeth, m, float(alpha), gear.helix.angle, (np.pi * m - thickness) / 2.0, depth * m, tip_radius)

    @property
    def pitch_radius(self) -> float:
        return self.teeth * self.module / 2.0 / np.cos(self.helix)

    @property
    def corner(self) -> tuple[float, float]:
        """Middle of the round corner in the normal section: from the tooth's middle, and below the pitch line."""
        c, t = np.cos(self.pressure_angle), np.tan(self.pressure_angle)
        below = self.depth - self.tip_radius
        return self.half_width - below * t - self.tip_radius / c, below

    def clearance(self, points: np.ndarray, turned: np.ndarray) -> np.ndarray:
        """Distance in the normal section of the gear's points (..., 2) from the teeth, the gear turned by angles (...).

        The space that one of them cuts is centred on +x of the gear. Negative inside a tooth.
        """
        c, s = np.cos(turned), np.sin(turned)
        x, y = points[..., 0], points[..., 1]
        fixed_x, fixed_y = c * x - s * y, s * x + c * y
        along = (fixed_y - self.pitch_radius * turned) * np.cos(self.helix)
        along = np.abs(along - np.pi * self.module * np.round(along / (np.pi * self.module)))
        q = along - self.corner[0], self.pitch_radius - fixed_x - self.corner[1]
        sine, cosine = np.sin(self.pressure_angle), np.cos(self.pressure_angle)
        to_side, to_land = cosine * q[0] + sine * q[1], q[1]
        beside = (q[0] >= 0.0) & (sine * q[0] - cosine * q[1] <= 0.0)
        return np.where(beside, np.hypot(*q), np.maximum(to_side, to_land)) - self.tip_radius

    def least_clearance(self, point: np.ndarray) -> float:
        """The least distance of a point (2,) from the teeth while the gear rolls past it."""
        most = 2.5 * np.sqrt(2.0 * self.pitch_radius * self.depth + self.module**2) / self.pitch_radius + 0.3
        turns = np.linspace(-most, most, 4001)
        rough = self.clearance(np.broadcast_to(point, (turns.size, 2)), turns)
        step = turns[1] - turns[0]
        near = [k for k in range(1, turns.size - 1) if rough[k] <= min(rough[k - 1], rough[k + 1])]
        best = sorted(near, key=lambda k: rough[k])[:3]
        return min(
            float(
                minimize_scalar(
                    lambda turned: float(self.clearance(point, np.float64(turned))),
                    bounds=(turns[k] - step, turns[k] + step),
                    method="bounded",
                    options={"xatol": 1e-13},
                ).fun
            )
            for k in best
        )

    def outline(self) -> shapely.Polygon:
        """The tooth in the transverse plane, its middle on +x at the pitch circle, long enough to come out."""
        (e, below), rho, height = self.corner, self.tip_radius, 4.0 * self.module
        angle = np.linspace(self.pressure_angle, np.pi / 2.0, 500)
        across, down = e + rho * np.cos(angle), below + rho * np.sin(angle)
        wide = self.half_width + height * np.tan(self.pressure_angle)
        side = np.array([[wide, -height], *np.stack([across, down], axis=-1)])
        both = np.concatenate([side, side[::-1] * [-1.0, 1.0]])
        return shapely.Polygon(np.stack([self.pitch_radius - both[:, 1], both[:, 0] / np.cos(self.helix)], axis=-1))

    def cut_area(self, tip_radius: float, positions: int) -> float:
        """Area that one tooth takes off a disc of the tip radius, at so many positions on its way."""
        most = np.arccos((self.pitch_radius - self.depth) / tip_radius) * tip_radius / self.pitch_radius
        most += 2.0 * self.half_width / self.pitch_radius
        tooth = self.outline()
        places = [
            shapely.affinity.rotate(
                translate(tooth, 0.0, self.pitch_radius * turned), -turned, (0, 0), use_radians=True
            )
            for turned in np.linspace(-most, most, positions)
        ]
        disc = shapely.Point(0.0, 0.0).buffer(tip_radius, quad_segs=20_000)
        return float(shapely.union_all(places).intersection(disc).area)
