// Half an axial section of a gear's body.

import { Pen } from "./pen";

export function blank(marked: string): SVGSVGElement {
  return new Pen("Half an axial section of a gear: bore, hub, web, rim, face width", marked, 280, 192)
    .body("M70 134H190V104H148V66H178V26H92V66H122V104H70Z")
    .line("M92 36H178")
    .centre("M30 164H250M114 84H156")
    .thin("M92 26V6M178 26V6M70 134V178M190 134V178M190 104H224M178 66H264M190 134H206")
    .length([92, 11], [178, 11], "b", ["face_width"], [-4, -3])
    .length([200, 164], [200, 134], "d_bore", ["bore", "keyway", "keyway_width", "keyway_depth"], [-40, 2])
    .length([220, 164], [220, 104], "d_h", ["hub_diameter"], [4, -2])
    .length([258, 164], [258, 66], "d_r", ["rim_diameter", "outer_diameter", "rack_height"], [-18, -8])
    .length([70, 172], [190, 172], "l_h", ["hub_length"], [-4, 14])
    .length([122, 94], [148, 94], "b_s", ["web_thickness"], [18, -2])
    .length([70, 118], [92, 118], "", ["hub_offset"])
    .note([135, 84], [46, 60], "holes", ["web_holes", "web_hole_diameter", "web_hole_circle"])
    .length([30, 26], [30, 164], "A", ["mounting_distance"], [-14, -20])
    .svg;
}
