// A tooth between its neighbours: heights, thickness, pressure angle, profile shift.

import { Pen } from "./pen";

export function tooth(marked: string): SVGSVGElement {
  return new Pen("A tooth: module, addendum, dedendum, thickness, pressure angle", marked)
    .body("M0 170V142H30Q38 142 41 134L62 84Q68 58 80 46H120Q132 58 138 84L159 134Q162 142 170 142H192Q200 142 203 134"
      + "L224 84Q230 58 242 46H280V170Z")
    .centre("M0 88H280")
    .thin("M120 46H212M62 88V24M224 88V24M138 88L162 30M138 88V28")
    .length([62, 28], [224, 28], "p = π m", ["module", "transverse_module", "diametral_pitch", "teeth"], [-16, -4])
    .length([63, 100], [137, 100], "s", ["circular_thickness", "backlash", "normal_backlash", "thickness_modification"], [-4, 14])
    .length([206, 46], [206, 88], "h_a", ["addendum", "addendum_coefficient", "tip_diameter", "gear_addendum", "tip_shortening"], [4, 2])
    .length([206, 88], [206, 142], "h_f", ["dedendum", "dedendum_coefficient", "whole_depth", "working_depth"], [4, 0])
    .angle([138, 88], 48, 90, 68, "α", ["pressure_angle"], [1, -4])
    .note([160, 136], [180, 163], "ρ", ["rack_tip_radius", "rack_tip_coefficient", "fillet_radius", "crown_tip_radius", "root"])
    .note([129, 62], [186, 66], "C_a", ["tip_relief", "tip_relief_height", "tip_relief_form"])
    .note([82, 46], [96, 38], "h_K", ["tip_chamfer"])
    .svg;
}

// The rack that generates a gear, moved away from it.
export function shift(marked: string): SVGSVGElement {
  return new Pen("A gear and the rack that generates it, moved away from it by the profile shift", marked)
    .body("M0 20H280V62H232L214 112H172L154 62H126L108 112H66L48 62H0Z")
    .body("M22 180A178 178 0 0 1 258 180Z")
    .centre("M0 86H280M10 161A190 190 0 0 1 270 161")
    .thin("M140 110H250M140 86H250")
    .length([244, 110], [244, 86], "x m", ["profile_shift", "centre_distance"], [5, 2])
    .note([98, 115], [112, 166], "pitch circle", [])
    .note([14, 86], [6, 140], "datum", ["basic_rack"])
    .svg;
}

// What an inspector measures.
export function measured(marked: string): SVGSVGElement {
  return new Pen("Measurement over pins and across several teeth", marked)
    .body("M0 170V120Q10 118 14 104L24 70H58L68 104Q72 118 82 120H98Q108 118 112 104L122 70H156L166 104Q170 118 180 120"
      + "H196Q206 118 210 104L220 70H254L264 104Q268 118 280 120V170Z")
    .circle([90, 84], 25, "line")
    .circle([188, 84], 25, "line")
    .length([65, 84], [115, 84], "D_M", ["pin_diameter"], [-8, -6])
    .thin("M16 100L10 30M262 100L268 30")
    .length([10, 34], [268, 34], "W over k teeth", ["span_teeth"], [-36, -5])
    .svg;
}
