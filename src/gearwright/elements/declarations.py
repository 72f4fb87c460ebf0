"""What the parameters shared by several elements mean, declared once."""

from __future__ import annotations

from ..curves.frames import FRAMES
from ..parameters import MILLIMETRES, Parameter
from .standards.iso_53 import BASIC_RACKS

_BODY, _FLANKS, _INSPECTION = "Body inside the teeth", "Modified flanks", "Inspection"
"""Topics under which parameters of gears are listed."""

TEETH = Parameter(meaning="number of teeth", kind="integer", symbol="z", minimum=3, maximum=10_000)
MATE_TEETH = Parameter(meaning="number of teeth of the mate", kind="integer", symbol="z", minimum=3, maximum=10_000)
MODULE = Parameter(meaning="module, always in mm", unit="mm", symbol="m", above=0)
DIAMETRAL_PITCH = Parameter(meaning="teeth per inch of pitch diameter", unit="per inch", symbol="P_d", above=0)
FACE_WIDTH = Parameter(meaning="face width, the length of the teeth", unit="length", symbol="b", above=0)
PRESSURE_ANGLE = Parameter(meaning="transverse pressure angle", unit="angle", symbol="α", above=0, below=60)
SHAFT_ANGLE = Parameter(meaning="angle between the axes", unit="angle", symbol="Σ", above=0, below=180)
PITCH_ANGLE = Parameter(meaning="half-angle of the pitch cone", unit="angle", symbol="δ", minimum=0.01, maximum=90)
ADDENDUM = Parameter(meaning="height of the tooth above the pitch line", unit="length", symbol="h_a", above=0)
DEDENDUM = Parameter(meaning="depth of the tooth below the pitch line", unit="length", symbol="h_f", above=0)
WORKING_DEPTH = Parameter(meaning="sum of the members' addenda", unit="length", symbol="h_w", above=0)
WHOLE_DEPTH = Parameter(meaning="addendum and dedendum of a member", unit="length", symbol="h", above=0)
GEAR_ADDENDUM = Parameter(meaning="addendum of the gear, the second member", unit="length", symbol="h_a2", above=0)
CIRCULAR_THICKNESS = Parameter(
    meaning="arc thickness of a tooth on the (outer) pitch circle; if not given half the pitch, and what a profile"
    " shift adds",
    unit="length",
    symbol="s",
    above=0,
)
BACKLASH = Parameter(
    meaning="circular backlash on the (outer) pitch circle, half from each member",
    unit="length",
    symbol="j_t",
    minimum=0,
)
BORE = Parameter(topic=_BODY, meaning="diameter of a cylindrical bore", unit="length", symbol="d_bore", above=0)
KEYWAY = Parameter(
    topic=_BODY,
    meaning="keyway of the bore, below the first tooth: din-6885 is that of a parallel key of form A",
    kind="choice",
    choices=("none", "din-6885"),
)
KEYWAY_WIDTH = Parameter(
    topic=_BODY, meaning="width of a keyway of one's own size", unit="length", symbol="b_k", above=0
)
KEYWAY_DEPTH = Parameter(
    topic=_BODY,
    meaning="depth of a keyway of one's own size, from the bore to its floor",
    unit="length",
    symbol="t_2",
    above=0,
)
HUB_DIAMETER = Parameter(topic=_BODY, meaning="diameter of the hub", unit="length", symbol="d_h", above=0)
HUB_LENGTH = Parameter(
    topic=_BODY, meaning="whole length of the hub; the face width if not given", unit="length", symbol="l_h", above=0
)
HUB_OFFSET = Parameter(
    topic=_BODY,
    meaning="how far the hub stands out at z = 0; what its length leaves stands out at the other end",
    unit="length",
)
RIM_DIAMETER = Parameter(
    topic=_BODY, meaning="inner diameter of the rim around a web", unit="length", symbol="d_r", above=0
)
WEB_THICKNESS = Parameter(
    topic=_BODY, meaning="thickness of the web, in the middle of the face width", unit="length", symbol="b_s", above=0
)
WEB_HOLES = Parameter(
    topic=_BODY,
    meaning="number of holes in the web, the first one below the first tooth",
    kind="integer",
    minimum=1,
    maximum=500,
)
WEB_HOLE_DIAMETER = Parameter(topic=_BODY, meaning="diameter of the holes in the web", unit="length", above=0)
WEB_HOLE_CIRCLE = Parameter(
    topic=_BODY,
    meaning="diameter of the circle of the holes' middles; midway between hub and rim if not given",
    unit="length",
    above=0,
)
TRACE = Parameter(
    meaning="tooth trace along the face; logarithmic is a spiral", kind="choice", choices=("straight", "logarithmic")
)
SPIRAL_ANGLE = Parameter(
    meaning="spiral angle at the mean cone distance", unit="angle", symbol="β_m", minimum=0, maximum=75
)
HAND = Parameter(meaning="hand of the spiral (a pair: of the pinion)", kind="choice", choices=("right", "left"))
ROOT = Parameter(
    meaning="flank below the base circle or cone: radial carries on straight to the root",
    kind="choice",
    choices=("radial",),
)
BEVEL_STANDARD = Parameter(
    meaning="sizing system that settles heights and thicknesses at the outer end; explicit takes them as given",
    kind="choice",
    choices=("explicit", "equal-addendum", "gleason-straight", "gleason-spiral", "iso-23509"),
)
BEVEL_SHIFT = Parameter(
    meaning="profile shift in modules, + of the pinion and - of the gear: long and short addenda; for iso-23509 in"
    " mean normal modules, and what it suggests if not given",
    symbol="x",
    above=-1,
    below=1,
)
THICKNESS_MODIFICATION = Parameter(
    meaning="thickness modification in modules: the pinion's teeth are thicker by twice as much, the gear's thinner",
    symbol="x_s",
    above=-0.5,
    below=0.5,
)
BEVEL_ENDS = Parameter(meaning="end faces: spheres about the apex", kind="choice", choices=("spherical",))
SWEEP_LENGTH = Parameter(meaning="length of a straight sweep along z", unit="length", symbol="L", above=0)
SWEEP_ANGLE = Parameter(
    meaning="angle of a revolution about the section's y axis, which becomes z",
    unit="angle",
    symbol="θ",
    above=0,
    maximum=360,
)
FRAME = Parameter(
    meaning="how the section turns along a path, rotation-minimising if not given",
    kind="choice",
    choices=tuple(FRAMES),
)
TWIST = Parameter(
    meaning="angle by which the far end is turned, right-handed if positive; it grows evenly",
    unit="angle",
    symbol="φ",
    minimum=-360_000,
    maximum=360_000,
)
SCALE = Parameter(
    meaning="factors of the far end along the section's x and y, reached evenly",
    symbol="s",
    above=0,
    maximum=1e6,
    components=("x", "y"),
)
SKEW = Parameter(
    meaning="offset of the far end of a straight sweep along x and y",
    unit="length",
    symbol="k",
    components=("x", "y"),
)
LENGTH_UNIT = Parameter(meaning="unit of all lengths in and out", kind="choice", choices=tuple(MILLIMETRES))

TRANSVERSE_MODULE = Parameter(
    meaning="module in the transverse section, always in mm, in place of that in the normal section",
    unit="mm",
    symbol="m_t",
    above=0,
)
NORMAL_PRESSURE_ANGLE = Parameter(
    meaning="pressure angle in the normal section", unit="angle", symbol="α_n", above=0, below=60
)
HELIX_ANGLE = Parameter(meaning="helix angle on the pitch cylinder", unit="angle", symbol="β", minimum=0, maximum=80)
HELIX_HAND = Parameter(
    meaning="hand of the helix (of a pair: of the pinion; of a herringbone gear: of its half at z = 0)",
    kind="choice",
    choices=("right", "left"),
)
PROFILE_SHIFT = Parameter(
    meaning="profile shift in modules; positive makes teeth thicker, internal ones too",
    symbol="x",
    minimum=-5,
    maximum=5,
)
BASIC_RACK = Parameter(
    meaning="proportions of the teeth where nothing else gives them",
    kind="choice",
    choices=tuple(BASIC_RACKS),
)
ADDENDUM_COEFFICIENT = Parameter(
    meaning="addendum of the basic rack in modules; with the profile shift it makes the addendum",
    symbol="h_aP*",
    above=0,
    maximum=10,
)
DEDENDUM_COEFFICIENT = Parameter(
    meaning="dedendum of the basic rack in modules; less the profile shift it makes the dedendum",
    symbol="h_fP*",
    above=0,
    maximum=10,
)
TIP_DIAMETER = Parameter(meaning="tip diameter, in place of an addendum", unit="length", symbol="d_a", above=0)
RACK_TIP_RADIUS = Parameter(
    meaning="radius at the tips of the rack that generates the fillets; at most what makes them round all over,"
    " and that where the basic rack's does not fit",
    unit="length",
    symbol="ρ",
    above=0,
)
RACK_TIP_COEFFICIENT = Parameter(meaning="that radius in modules", symbol="ρ*", above=0, maximum=10)
FILLET_RADIUS = Parameter(
    meaning="radius of the fillet between flank and root; that of the basic rack, or what fits, if not given",
    unit="length",
    symbol="ρ_f",
    above=0,
)
TIP_RELIEF = Parameter(
    topic=_FLANKS,
    meaning="tip relief, taken off along the flank's normal in the transverse section",
    unit="length",
    symbol="C_a",
    minimum=0,
)
TIP_RELIEF_HEIGHT = Parameter(
    topic=_FLANKS,
    meaning="height of the relieved part of the flank; 0.6 modules if not given",
    unit="length",
    symbol="h_Ca",
    above=0,
)
TIP_RELIEF_FORM = Parameter(
    topic=_FLANKS, meaning="how tip relief grows with the roll angle", kind="choice", choices=("linear", "parabolic")
)
CROWNING = Parameter(
    topic=_FLANKS,
    meaning="lead crowning: by how much each flank is lower at its ends than at mid-face, parabolically, along"
    " its normal in the transverse section",
    unit="length",
    symbol="C_β",
    minimum=0,
)
TIP_CHAMFER = Parameter(
    topic=_FLANKS, meaning="height of a chamfer of 45° between flank and tip", unit="length", symbol="h_K", minimum=0
)
GEAR_ROOT = Parameter(
    meaning="flank below the involute: fillet as generated by a rack with round tips, undercut included;"
    " radial carries on straight to a sharp corner",
    kind="choice",
    choices=("fillet", "radial"),
)
PIN_DIAMETER = Parameter(
    topic=_INSPECTION,
    meaning="diameter of the pins or balls for the measurement over pins; 1.728 modules if not given,"
    " 1.68 for internal gears",
    unit="length",
    symbol="D_M",
    above=0,
)
SPAN_TEETH = Parameter(
    topic=_INSPECTION,
    meaning="number of teeth to span; that which touches nearest to mid-depth if not given",
    kind="integer",
    symbol="k",
    minimum=1,
)
OUTER_DIAMETER = Parameter(
    meaning="outer diameter of an internal gear's ring; 6 modules more than its roots if not given",
    unit="length",
    symbol="d_rim",
    above=0,
)
RACK_HEIGHT = Parameter(
    meaning="height of a rack from its back to its pitch line; 2 modules more than the dedendum if not given",
    unit="length",
    symbol="H",
    above=0,
)
PAIR_KIND = Parameter(
    meaning="what the gear, the second member, is",
    kind="choice",
    choices=("spur", "helical", "herringbone", "internal", "rack"),
)
CENTRE_DISTANCE = Parameter(
    meaning="distance of the axes, or of the pinion's axis from the rack's pitch plane; the profile shifts follow"
    " from it if none are given",
    unit="length",
    symbol="a_w",
    above=0,
)
TIP_SHORTENING = Parameter(
    meaning="full shortens tips as the profile shifts need for the clearance, of an internal gear as the pinion's"
    " involute needs; none leaves them",
    kind="choice",
    choices=("full", "none"),
)
