"""Parameter sets of every element in the catalog, for tests that state laws over all of them.

A new element is covered once it has an entry in EXAMPLES; a test holds the catalog to that.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import pytest

from gearwright import catalog
from gearwright.boundary.extent import rough_diagonal
from gearwright.elements.element import Element
from gearwright.solids.polyhedron import Polyhedron

README_PAIR = {
    "teeth": (16, 20),
    "diametral_pitch": 2.0,
    "length_unit": "in",
    "face_width": 1.5,
    "working_depth": 0.8,
    "whole_depth": 0.85,
    "gear_addendum": 0.4,
    "root": "radial",
    "ends": "spherical",
}
"""Al-Daccak 1989, table 3.1."""

SHARP = {"root": "radial", "ends": "spherical"}
"""Bevel teeth without fillets, between spheres: the shape that Al-Daccak 1989 has."""

_SPIRAL = {"trace": "logarithmic", "spiral_angle": 35.0}

EXAMPLES: dict[str, dict[str, dict[str, Any]]] = {
    "spur gear": {
        "radial root below the base circle": {"teeth": 16, "module": 8.0, "face_width": 50.0, "root": "radial"},
        "radial root above the base circle, bored": {
            "teeth": 45,
            "module": 2.0,
            "face_width": 12.0,
            "bore": 20.0,
            "root": "radial",
        },
        "fillets": {"teeth": 24, "module": 3.0, "face_width": 20.0},
        "undercut": {"teeth": 8, "module": 4.0, "face_width": 15.0, "bore": 8.0},
        "shifted, full-radius, relieved, chamfered": {
            "teeth": 19,
            "module": 2.5,
            "face_width": 11.0,
            "profile_shift": 0.4,
            "basic_rack": "agma-full-radius",
            "tip_relief": 0.03,
            "tip_chamfer": 0.2,
        },
        "three teeth": {
            "teeth": 3,
            "module": 5.0,
            "face_width": 4.0,
            "addendum": 2.0,
            "dedendum": 3.0,
            "root": "radial",
        },
        "in inches, with backlash, long": {
            "teeth": 12,
            "diametral_pitch": 4.0,
            "length_unit": "in",
            "face_width": 9.0,
            "pressure_angle": 25.0,
            "circular_thickness": 0.4,
            "backlash": 0.02,
            "bore": 0.5,
        },
    },
    "bevel gear": {
        "pitch angle 45°": {"teeth": 20, "module": 4.0, "pitch_angle": 45.0, "face_width": 15.0, **SHARP},
        "crown": {"teeth": 30, "module": 3.0, "pitch_angle": 90.0, "face_width": 12.0, **SHARP},
        "spiral crown, bored": {
            "teeth": 30,
            "module": 3.0,
            "pitch_angle": 90.0,
            "face_width": 12.0,
            "bore": 15.0,
            "hand": "left",
            **_SPIRAL,
        },
        "pitch angle 3°": {"teeth": 20, "module": 4.0, "pitch_angle": 3.0, "face_width": 30.0, "bore": 25.0, **SHARP},
        "steep spiral, left": {
            "teeth": 12,
            "module": 5.0,
            "pitch_angle": 20.0,
            "face_width": 25.0,
            "trace": "logarithmic",
            "spiral_angle": 50.0,
            "hand": "left",
            "root": "radial",
            "ends": "flat",
        },
        "root above the base cone, backlash": {
            "teeth": 44,
            "module": 2.5,
            "pitch_angle": 73.54,
            "face_width": 16.0,
            "pressure_angle": 25.0,
            "backlash": 0.3,
            "bore": 30.0,
            **SHARP,
        },
        "zerol, left": {
            "teeth": 17,
            "module": 3.0,
            "mate_teeth": 25,
            "face_width": 12.0,
            "trace": "circular",
            "cutter_radius": 40.0,
            "hand": "left",
            "bore": 12.0,
        },
        "epicycloid": {
            "teeth": 14,
            "module": 4.0,
            "pitch_angle": 35.0,
            "face_width": 14.0,
            "trace": "epicycloid",
            "spiral_angle": 30.0,
            "cutter_radius": 55.0,
            "blade_groups": 5,
            "bore": 11.0,
        },
        "three teeth, down to near the apex": {
            "teeth": 3,
            "module": 8.0,
            "mate_teeth": 9,
            "shaft_angle": 70.0,
            "face_width": 30.0,
            "addendum": 3.0,
            "dedendum": 5.0,
            **SHARP,
        },
    },
    "bevel pair": {
        "16/20 straight": README_PAIR,
        "16/20 spiral": {**README_PAIR, **_SPIRAL},
        "16/20 circular, left": {
            "teeth": (16, 20),
            "module": 4.0,
            "face_width": 16.0,
            "trace": "circular",
            "spiral_angle": 35.0,
            "cutter_radius": 50.0,
            "hand": "left",
            "bore": 14.0,
        },
        "20/40 Gleason": {
            "teeth": (20, 40),
            "module": 3.0,
            "face_width": 20.0,
            "standard": "gleason-straight",
            "bore": 12.0,
        },
        "Σ 60°, spiral left, bored": {
            "teeth": (18, 27),
            "module": 3.0,
            "shaft_angle": 60.0,
            "face_width": 20.0,
            "bore": (14.0, 22.0),
            "hand": "left",
            **_SPIRAL,
        },
        "Σ 110°, backlash": {
            "teeth": (20, 31),
            "module": 3.0,
            "shaft_angle": 110.0,
            "face_width": 14.0,
            "backlash": 0.2,
            **SHARP,
        },
        "13/44 spiral": {
            "teeth": (13, 44),
            "module": 3.0,
            "face_width": 18.0,
            "gear_addendum": 2.4,
            "bore": 12.0,
            **_SPIRAL,
        },
    },
}

SQUARE_WITH_HOLES = {
    "polygon": ((-10, -6), (10, -6), (12, 7), (-8, 6)),
    "holes": (((-6, -2), (-3, -2), (-3, 2)), ((2, -2), (6, -2), (6, 2), (2, 2))),
}

EXAMPLES["sweep"] = {
    "twisted, scaled and skewed, with two holes": {
        "section": SQUARE_WITH_HOLES,
        "length": 40.0,
        "twist": 50.0,
        "scale": (0.6, 0.8),
        "skew": (5.0, -3.0),
    },
    "by polynomials, a spline, in inches": {
        "section": {"spline": ((2, 0), (1, 1.5), (-1, 1), (-2, -0.5), (0, -1))},
        "length": 5.0,
        "transform": {"f1": (1.0, -0.05), "g1": (0.0, 0.04), "h1": (0.0, 0.0, 0.02), "g2": (1.0, 0.0, -0.01)},
        "length_unit": "in",
    },
    "a spring": {
        "section": {"rectangle": (3.0, 2.0), "centre": (0.5, 0.0)},
        "path": {"helix": {"radius": 12.0, "pitch": 8.0, "turns": 2.5, "hand": "left"}},
        "frame": "frenet",
    },
    "along a bent path, twisted and tapered": {
        "section": {"rectangle": (6.0, 4.0)},
        "path": ((0, 0, 0), (0, 0, 30), (20, 10, 60)),
        "twist": 120.0,
        "scale": (0.5, 0.7),
    },
    "revolved by 200°": {"section": {"circle": 3.0, "centre": (10.0, 2.0)}, "angle": 200.0},
    "a ring": {"section": {"polygon": ((6, 0), (10, 1), (9, 5), (7, 4))}, "angle": 360.0},
}

PROGRAMME = "dwell 36, rise 72, dwell 144, return 108"
"""Al-Daccak 1989, ch. 4.5.1."""

EXAMPLES["cam"] = {
    "oscillating flat face": {
        "programme": PROGRAMME,
        "swing": 30.0,
        "pivot_distance": 20.0,
        "face_offset": 70.0,
        "initial_angle": 20.0,
        "thickness": 40.0,
    },
    "oscillating flat face that lifts with the cam, bored": {
        "programme": "rise 150, dwell 30, return 180",
        "swing": 15.0,
        "pivot_distance": 50.0,
        "face_offset": -2.0,
        "initial_angle": 40.0,
        "sense": "same",
        "law": "modified-sine",
        "thickness": 10.0,
        "bore": 20.0,
    },
    "translating flat face, in inches": {
        "programme": "rise 80 0.2, dwell 40, rise 70, return 140, dwell 30",
        "follower": "translating-flat-face",
        "lift": 0.5,
        "base_radius": 1.5,
        "law": "3-4-5",
        "thickness": 0.4,
        "bore": 0.5,
        "length_unit": "in",
    },
    "translating roller, offset": {
        "programme": PROGRAMME,
        "follower": "translating-roller",
        "lift": 12.0,
        "base_radius": 25.0,
        "roller_radius": 8.0,
        "offset": 4.0,
        "law": "4-5-6-7",
        "thickness": 12.0,
        "bore": 16.0,
    },
    "oscillating roller": {
        "programme": PROGRAMME,
        "follower": "oscillating-roller",
        "swing": 25.0,
        "pivot_distance": 80.0,
        "arm_length": 60.0,
        "base_radius": 28.0,
        "roller_radius": 9.0,
        "law": "harmonic",
        "thickness": 12.0,
    },
    "oscillating roller that lifts with the cam, a spline": {
        "programme": "rise 120, dwell 60, return 180",
        "follower": "oscillating-roller",
        "swing": 20.0,
        "pivot_distance": 70.0,
        "arm_length": 55.0,
        "initial_angle": 35.0,
        "roller_radius": 6.0,
        "sense": "same",
        "law": "spline",
        "spline_values": (0.1, 0.3, 0.6, 0.9, 0.05, 0.2, 0.7, 0.95),
        "thickness": 12.0,
        "bore": 14.0,
    },
}

EXAMPLES |= {
    "helical gear": {
        "fillets, left": {"teeth": 17, "module": 2.0, "face_width": 9.0, "helix_angle": 20.0, "hand": "left"},
        "undercut, relieved, chamfered, bored": {
            "teeth": 9,
            "transverse_module": 3.0,
            "face_width": 8.0,
            "helix_angle": 12.0,
            "tip_relief": 0.02,
            "tip_relief_form": "parabolic",
            "tip_chamfer": 0.3,
            "bore": 6.0,
        },
        "steep, radial, in inches": {
            "teeth": 12,
            "diametral_pitch": 6.0,
            "length_unit": "in",
            "face_width": 0.6,
            "helix_angle": 42.0,
            "root": "radial",
        },
        "crowned": {"teeth": 11, "module": 3.0, "face_width": 8.0, "helix_angle": 15.0, "crowning": 0.05},
    },
    "herringbone gear": {
        "fillets": {"teeth": 14, "module": 3.0, "face_width": 20.0, "helix_angle": 30.0},
        "shifted, left, bored": {
            "teeth": 10,
            "module": 3.0,
            "face_width": 12.0,
            "helix_angle": 25.0,
            "hand": "left",
            "profile_shift": 0.4,
            "bore": 8.0,
        },
        "relieved": {"teeth": 16, "module": 2.0, "face_width": 10.0, "helix_angle": 20.0, "tip_relief": 0.02},
    },
    "internal gear": {
        "fillets": {"teeth": 36, "module": 2.0, "face_width": 6.0},
        "helical, left, shifted": {
            "teeth": 40,
            "module": 1.5,
            "face_width": 6.0,
            "helix_angle": 18.0,
            "hand": "left",
            "profile_shift": -0.3,
            "fillet_radius": 0.4,
        },
        "sharp corners, relieved, chamfered": {
            "teeth": 33,
            "module": 3.0,
            "face_width": 8.0,
            "pressure_angle": 25.0,
            "root": "radial",
            "tip_relief": 0.03,
            "tip_chamfer": 0.2,
            "outer_diameter": 125.0,
        },
    },
    "rack": {
        "straight": {"teeth": 5, "module": 4.0, "face_width": 10.0},
        "helical, full radius": {
            "teeth": 4,
            "module": 2.0,
            "face_width": 9.0,
            "helix_angle": 30.0,
            "basic_rack": "agma-full-radius",
        },
        "left, in inches, with backlash": {
            "teeth": 3,
            "diametral_pitch": 5.0,
            "length_unit": "in",
            "face_width": 0.5,
            "helix_angle": 15.0,
            "hand": "left",
            "backlash": 0.02,
            "fillet_radius": 0.03,
        },
    },
    "spur pair": {
        "shifted, bored, unlike widths": {
            "teeth": (13, 17),
            "module": 2.0,
            "face_width": (6.0, 5.0),
            "profile_shift": (0.3, 0.0),
            "bore": (6.0, 10.0),
        },
    },
    "helical pair": {
        "left, with backlash": {
            "teeth": (12, 19),
            "module": 2.0,
            "face_width": 6.0,
            "helix_angle": 20.0,
            "hand": "left",
            "backlash": 0.1,
        },
    },
    "herringbone pair": {
        "transverse module": {"teeth": (13, 14), "transverse_module": 2.0, "face_width": 8.0, "helix_angle": 20.0},
    },
    "internal pair": {
        "helical, at a distance": {
            "teeth": (16, 44),
            "module": 1.5,
            "face_width": 5.0,
            "helix_angle": 15.0,
            "centre_distance": 22.0,
        },
    },
    "rack and pinion": {
        "helical, shifted": {
            "teeth": (14, 4),
            "module": 2.0,
            "face_width": 6.0,
            "helix_angle": 18.0,
            "profile_shift": (0.4, 0.0),
        },
    },
}

BY_NAME = {entry.name: entry for entry in catalog.ELEMENTS}


@dataclass(frozen=True)
class Part:
    """One solid to hold to the laws: an element of one part, or one member of a pair."""

    element: str
    example: str
    member: str | None = None

    def __str__(self) -> str:
        return " ".join(word for word in (self.element, self.example, self.member) if word)


def parts_of(name: str) -> list[Part]:
    """The parts of an element's examples."""
    members = ("pinion", "gear") if BY_NAME[name].members == 2 else (None,)
    return [Part(name, example, member) for example in EXAMPLES.get(name, {}) for member in members]


PARTS = [part for name in BY_NAME for part in parts_of(name)]
BEVEL_PARTS = [part for part in PARTS if part.element.startswith("bevel")]
SHARP_PARTS = [part for part in BEVEL_PARTS if SHARP.items() <= EXAMPLES[part.element][part.example].items()]
"""Bevel gears of the thesis's kind, whose faces lie on spheres and cones about the apex."""

every_part = pytest.mark.parametrize("part", PARTS, ids=str)
every_bevel_part = pytest.mark.parametrize("part", BEVEL_PARTS, ids=str)


@cache
def built(part: Part) -> Element:
    """The part's element, built once a process."""
    entry = BY_NAME[part.element]
    element = catalog.load(entry.source)(**entry.settled, **EXAMPLES[part.element][part.example])
    return getattr(element, part.member) if part.member else element


@cache
def size(part: Part) -> float:
    """Diagonal of the part's bounding box."""
    return rough_diagonal(built(part).boundary)


@cache
def polyhedron(part: Part, relative_tolerance: float) -> Polyhedron:
    """The part's polyhedron at a tolerance relative to its size, built once a process."""
    return built(part).polyhedron(relative_tolerance * size(part))
