"""Rows of the data table of a sheet: what a shop makes and an inspector measures, from parameters and sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..parameters import Size
from ..sheets.content import Row
from ..sheets.numbers import of_unit

Labels = Mapping[str, str]

CYLINDRICAL_SIZES: Labels = {
    "transverse_pressure_angle": "Transverse pressure angle",
    "base_helix_angle": "Base helix angle",
    "lead": "Lead",
    "pitch_diameter": "Reference diameter",
    "base_diameter": "Base diameter",
    "outside_diameter": "Tip diameter",
    "root_diameter": "Root diameter",
    "form_diameter": "Root form diameter",
    "tooth_depth": "Tooth depth",
    "circular_pitch": "Transverse pitch",
    "normal_thickness": "Normal tooth thickness",
    "tip_thickness": "Tip thickness, transverse",
    "chordal_thickness": "Chordal thickness, normal",
    "chordal_height": "Height above that chord",
    "span_teeth": "Teeth spanned",
    "span": "Span",
    "pin_diameter": "Diameter of pins or balls",
    "over_pins": "Over (between) two pins or balls",
    "fillet_radius": "Fillet radius",
    "rack_height": "Back to pitch plane",
    "length": "Length",
    "outer_diameter": "Outer diameter",
    "keyway_width": "Keyway width",
    "keyway_depth": "Keyway depth from bore",
}

BEVEL_SIZES: Labels = {
    "transverse_pressure_angle": "Transverse pressure angle",
    "pitch_angle": "Pitch angle",
    "face_angle": "Face (tip) angle",
    "root_angle": "Root angle",
    "addendum_angle": "Addendum angle",
    "dedendum_angle": "Dedendum angle",
    "cone_distance": "Outer cone distance",
    "mean_cone_distance": "Mean cone distance",
    "pitch_diameter": "Outer pitch diameter",
    "outside_diameter": "Outside diameter",
    "addendum": "Outer addendum",
    "dedendum": "Outer dedendum",
    "tooth_depth": "Outer whole depth",
    "circular_thickness": "Outer transverse thickness",
    "chordal_thickness": "Outer chordal thickness",
    "chordal_height": "Height above that chord",
    "mean_chordal_thickness": "Mean normal chordal thickness",
    "mean_chordal_height": "Height above that chord, mean",
    "crown_to_apex": "Tip to apex",
    "mounting_distance": "Mounting distance",
    "crown_to_back": "Tip to mounting face",
    "keyway_width": "Keyway width",
    "keyway_depth": "Keyway depth from bore",
}

PAIR_SIZES: Labels = {
    "centre_distance": "Centre distance",
    "shaft_angle": "Shaft angle",
    "gear_ratio": "Gear ratio",
    "working_pressure_angle": "Working pressure angle",
    "backlash": "Circumferential backlash",
    "normal_backlash": "Normal backlash",
    "contact_ratio": "Transverse contact ratio",
    "total_contact_ratio": "Total contact ratio",
}


_OBLIQUE = ("transverse_pressure_angle", "base_helix_angle")
"""Sizes that straight teeth do not have apart from others."""


def size_rows(sizes: Mapping[str, Size], labels: Labels, length_unit: str) -> list[Row]:
    """Rows of the sizes that have a label, in the order of the labels."""
    return [Row.of(label, sizes[name], length_unit) for name, label in labels.items() if name in sizes]


def all_rows(sizes: Mapping[str, Size], length_unit: str) -> list[Row]:
    """Rows of all sizes, by their names."""
    return size_rows(sizes, {name: name.replace("_", " ").capitalize() for name in sizes}, length_unit)


def _teeth(element: Any) -> list[Row]:
    return [Row(name="Number of teeth", symbol="z", value=f"{element.teeth}")]


def _pitch(element: Any, symbol: str, label: str, module: float) -> list[Row]:
    unit = element.length_unit
    rows = [Row(name=label, symbol=symbol, value=of_unit(module, "length", unit))]
    if element.diametral_pitch is not None:
        value = f"{of_unit(element.diametral_pitch, '', unit)} /in"
        rows.append(Row(name="Diametral pitch", symbol="P_d", value=value))
    return rows


def _given(element: Any, fields: Sequence[tuple[str, str, str, Any]]) -> list[Row]:
    """Rows (parameter, label, symbol, unit) of parameters that are given and not 0."""
    found = []
    for name, label, symbol, unit in fields:
        value = getattr(element, name, None)
        if value:
            text = value if isinstance(value, str) else of_unit(float(value), unit, element.length_unit)
            found.append(Row(name=label, symbol=symbol, value=text))
    return found


def cylindrical_rows(gear: Any) -> tuple[Row, ...]:
    """Data of a gear or rack on parallel axes, with the symbols of ISO 21771."""
    unit = gear.length_unit
    sizes = {name: size for name, size in gear.sizes().items() if gear.helix.angle or name not in _OBLIQUE}
    shift = getattr(gear, "profile_shift", None)
    return (
        *_teeth(gear),
        *_pitch(gear, "m_n", "Normal module", gear.normal_module),
        Row(name="Pressure angle, normal", symbol="α_n", value=of_unit(gear.pressure_angle, "angle", unit)),
        *(_helix(gear) if gear.helix.angle else [Row(name="Teeth", symbol="", value="straight")]),
        *([] if shift is None else [Row(name="Profile shift coefficient", symbol="x", value=of_unit(shift, "", unit))]),
        Row(name="Basic rack", symbol="", value=gear.basic_rack),
        *size_rows(sizes, CYLINDRICAL_SIZES, unit),
        Row(name="Face width", symbol="b", value=of_unit(gear.face_width, "length", unit)),
        *_given(
            gear,
            (
                ("backlash", "Backlash allowance, transverse", "j_t", "length"),
                ("tip_relief", "Tip relief", "C_a", "length"),
                ("crowning", "Lead crowning", "C_β", "length"),
                ("tip_chamfer", "Tip chamfer, 45°", "h_K", "length"),
            ),
        ),
    )


def _helix(gear: Any) -> list[Row]:
    rows = [Row(name="Helix angle", symbol="β", value=of_unit(gear.helix_angle, "angle", gear.length_unit))]
    if getattr(gear, "flank_width", gear.face_width) != gear.face_width:
        return [*rows, Row(name="Herringbone, hand at z = 0", symbol="", value=gear.hand)]
    return [*rows, Row(name="Hand of helix", symbol="", value=gear.hand)]


def bevel_rows(gear: Any) -> tuple[Row, ...]:
    """Data of a bevel gear, with the symbols of ISO 23509."""
    import numpy as np

    unit = gear.length_unit
    spiral = gear.trace != "straight"
    normal = float(np.degrees(gear.normal_pressure_angle))
    return (
        *_teeth(gear),
        *_pitch(gear, "m_et", "Outer module", gear.outer_module),
        Row(name="Pressure angle, normal", symbol="α_n", value=of_unit(normal, "angle", unit)),
        Row(name="Tooth trace", symbol="", value=f"{gear.trace}, {gear.hand} hand" if spiral else "straight"),
        *(
            [Row(name="Mean spiral angle", symbol="β_m", value=of_unit(gear.spiral_angle, "angle", unit))]
            if spiral
            else []
        ),
        Row(name="Tooth form", symbol="", value=gear.tooth_form),
        *_mate_of_bevel(gear),
        *size_rows(gear.sizes(), BEVEL_SIZES, unit),
        Row(name="Face width", symbol="b", value=of_unit(gear.face_width, "length", unit)),
        *_given(
            gear,
            (
                ("cutter_radius", "Cutter radius", "r_c0", "length"),
                ("circular_backlash", "Backlash, outer transverse", "j_et", "length"),
                ("tip_relief", "Tip relief", "C_a", "length"),
                ("profile_crowning", "Profile crowning", "C_α", "length"),
                ("crowning", "Lead crowning", "C_β", "length"),
            ),
        ),
    )


def _mate_of_bevel(gear: Any) -> list[Row]:
    if gear.mate_teeth is None:
        return []
    angle = 90.0 if gear.shaft_angle is None else gear.shaft_angle
    return [
        Row(name="Teeth of the mate", symbol="", value=f"{gear.mate_teeth}"),
        Row(name="Shaft angle", symbol="Σ", value=of_unit(angle, "angle", gear.length_unit)),
    ]


def mate_rows(pair: Any, member: int, have: Sequence[Row]) -> tuple[Row, ...]:
    """What the sheet of a pair's member says of its mate and of both."""
    known = {row.name for row in have}
    rows = [
        Row(name="Teeth of the mate", symbol="", value=f"{pair.teeth[1 - member]}"),
        *size_rows(pair.sizes(), PAIR_SIZES, pair.length_unit),
    ]
    return tuple(row for row in rows if row.name not in known)
