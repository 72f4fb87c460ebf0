// The pitch cylinder rolled out: teeth lie at the helix angle to the axis.

import { Pen } from "./pen";

export function helix(marked: string): SVGSVGElement {
  const whole = [0, 1, 2, 3].map((i) => `M${40 + 46 * i} 150L${76 + 46 * i} 40`).join("");
  const teeth = `${whole}M20 70.6L30 40M224 150L250 70.6`;
  return new Pen("Teeth at the helix angle to the axis", marked)
    .body("M20 40H250V150H20Z")
    .line(teeth)
    .centre("M132 24V168")
    .thin("M250 40H272M250 150H272")
    .angle([132, 150], 74, 90, 72, "β", ["helix_angle", "hand"], [0, -5])
    .length([264, 40], [264, 150], "b", ["face_width"], [4, -20])
    .length([40, 160], [86, 160], "π m_t", ["transverse_module"], [-12, 14])
    .svg;
}
