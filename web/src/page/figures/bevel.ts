// Bevel gears: the section through both axes, and the rolled-out crown gear with its cutter.

import { Pen } from "./pen";

export function bevel(marked: string): SVGSVGElement {
  return new Pen("A bevel gear in axial section: cone distance, pitch angle, face width, shaft angle", marked)
    .body("M150 52L208 18L226 50L226 96H168Z")
    .centre("M30 120H262M30 120V14M30 120L226 20")
    .thin("M30 120L208 18M30 120L226 50M140 64L124 40M217 34L200 2")
    .angle([30, 120], 96, 0, 27, "δ", ["pitch_angle", "mate_teeth", "teeth"], [4, 4])
    .angle([30, 120], 34, 0, 90, "Σ", ["shaft_angle"], [6, -2])
    .length([130, 50], [206, 10], "b", ["face_width"], [-10, -4])
    .angle([30, 120], 178, 27, 29.8, "", ["addendum_angle", "addendum"])
    .note([196, 28], [236, 16], "θ_a", ["addendum_angle", "addendum", "gear_addendum", "taper"])
    .note([222, 46], [240, 62], "θ_f", ["dedendum_angle", "dedendum", "whole_depth", "working_depth"])
    .length([30, 136], [226, 136], "A", ["mounting_distance"], [-4, 14])
    .note([90, 89], [60, 60], "R", ["module", "diametral_pitch", "ends"])
    .svg;
}

export function spiral(marked: string): SVGSVGElement {
  return new Pen("The crown gear: a tooth trace cut by a cutter of given radius at the spiral angle", marked)
    .body("M34 160A166 166 0 0 1 143.2 4L167.9 71.7A94 94 0 0 0 106 160Z")
    .line("M75.7 50.3A143 143 0 0 0 116 118")
    .circle([214, 14], 143, "thin")
    .centre("M200 160L50 60")
    .thin("M91 87L52 22")
    .angle([91, 87], 60, 146, 121, "β_m", ["spiral_angle", "hand", "trace"], [-14, -6])
    .length([214, 14], [91, 87], "r_c0", ["cutter_radius", "blade_groups"], [14, -2])
    .note([200, 160], [222, 150], "apex", [])
    .svg;
}
