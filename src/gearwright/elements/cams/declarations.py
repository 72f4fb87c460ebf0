"""What the parameters of a cam mean."""

from __future__ import annotations

from ...parameters import Numbers, Parameter, Text
from .kinds import KINDS, SENSES
from .laws import FIXED_LAWS, SPLINE

PROGRAMME = Parameter(
    meaning='what the follower does over one turn, such as "dwell 36, rise 72, dwell 144, return 108": angles in'
    " degrees, after them an amount where a rise or return does not go all the way",
    kind="form",
    forms=(Text(words='a programme such as "dwell 36, rise 72, dwell 144, return 108"', word="TEXT"),),
)
LAW = Parameter(
    meaning="motion law of rises and returns; cycloidal if not given, for the least area a spline with free values",
    kind="choice",
    choices=(*FIXED_LAWS, SPLINE),
)
SPLINE_VALUES = Parameter(
    meaning="control values of the spline law between 0 and 1, as many for each move, move after move",
    kind="form",
    forms=(Numbers(most=2_000),),
)
FOLLOWER = Parameter(meaning="kind of the follower", kind="choice", choices=tuple(KINDS))
SWING = Parameter(meaning="angle that an oscillating follower swings", unit="angle", symbol="s", above=0, below=170)
LIFT = Parameter(meaning="way that a translating follower lifts", unit="length", symbol="s", above=0)
SENSE = Parameter(
    meaning="whether an oscillating follower, as it lifts, turns against the cam (opposite, if not given) or with it",
    kind="choice",
    choices=tuple(SENSES),
)
PIVOT_DISTANCE = Parameter(
    meaning="distance of an oscillating follower's pivot from the cam's axis", unit="length", symbol="d", above=0
)
FACE_OFFSET = Parameter(
    meaning="distance of an oscillating flat face from its pivot, positive away from the cam's axis; 0 if not given",
    unit="length",
    symbol="e",
)
INITIAL_ANGLE = Parameter(
    meaning="angle between the face or arm of an oscillating follower, at the start, and the line from its pivot to the"
    " cam's axis",
    unit="angle",
    symbol="φ₀",
    above=-90,
    below=180,
)
ARM_LENGTH = Parameter(
    meaning="length of an oscillating roller's arm, from pivot to roller", unit="length", symbol="a", above=0
)
ROLLER_RADIUS = Parameter(meaning="radius of the roller", unit="length", symbol="r_r", above=0)
BASE_RADIUS = Parameter(
    meaning="radius of the base circle, the least of the disk", unit="length", symbol="r_b", above=0
)
OFFSET = Parameter(
    meaning="distance by which a translating roller's stem misses the cam's axis, positive towards where its profile"
    " comes from; 0 if not given",
    unit="length",
    symbol="ε",
)
THICKNESS = Parameter(meaning="thickness of the disk", unit="length", symbol="b", above=0)
VERTICES = Parameter(
    meaning="number of vertices of the polygon that the true profile is compared with",
    kind="integer",
    symbol="n",
    minimum=3,
    maximum=1_000_000,
)
MINIMISE = Parameter(
    meaning="choose the dimensions that are not given, and the values of the spline, for the least area of the disk",
    kind="choice",
    choices=("area",),
)
FREE_VALUES = Parameter(
    meaning="with minimise, number of free values of the spline in each move; 8 if not given",
    kind="integer",
    symbol="m",
    minimum=1,
    maximum=40,
)
ECCENTRICITY_LIMIT = Parameter(
    meaning="with minimise, greatest eccentricity of the contact, × base radius; 0.5 if not given",
    symbol="q/r_b",
    above=0,
    maximum=100,
)
CURVATURE_LIMIT = Parameter(
    meaning="with minimise, least radius of curvature of the profile; 0.001 × base radius if not given",
    unit="length",
    symbol="ρ",
    above=0,
)
PRESSURE_ANGLE_LIMIT = Parameter(
    meaning="with minimise, greatest pressure angle; for rollers 30° (translating) or 45° if not given, for flat faces"
    " none",
    unit="angle",
    symbol="α",
    above=0,
    below=90,
)
