// A disk cam with its follower.

import { Pen } from "./pen";

export function cam(marked: string): SVGSVGElement {
  const roller = !/pivot|arm|swing|face_offset|initial/.test(marked);
  const pen = new Pen("A cam: base circle, lift, roller, offset, pivot", marked)
    .body("M60 118A42 42 0 1 0 144 118Q146 82 118 66Q102 58 86 66Q58 82 60 118Z")
    .circle([102, 118], 42, "thin")
    .centre("M40 118H164M102 170V10")
    .length([102, 118], [72, 147], "r_b", ["base_radius", "curvature_limit"], [-2, 12])
    .length([40, 76], [40, 60], "s", ["lift", "programme", "law", "swing"], [-14, 2])
    .thin("M32 76H102M32 60H102");
  return roller ? withRoller(pen) : withArm(pen);
}

function withRoller(pen: Pen): SVGSVGElement {
  return pen.circle([116, 44], 20, "line").line("M112 44V6M120 44V6").centre("M116 66V2")
    .length([116, 44], [131, 31], "r_r", ["roller_radius", "follower"], [10, -2])
    .length([102, 16], [116, 16], "ε", ["offset"], [18, 4])
    .note([110, 63], [170, 84], "α", ["pressure_angle_limit", "eccentricity_limit"]).svg;
}

function withArm(pen: Pen): SVGSVGElement {
  return pen.circle([236, 118], 5, "line").line("M236 118L104 58").centre("M102 118H256")
    .length([102, 158], [236, 158], "d", ["pivot_distance"], [-4, -4]).thin("M236 118V166")
    .length([232, 104], [116, 50], "a", ["arm_length"], [0, -6])
    .angle([236, 118], 60, 180, 156, "φ₀", ["initial_angle", "swing", "sense"], [-18, 4])
    .note([170, 86], [190, 60], "e", ["face_offset"]).svg;
}
