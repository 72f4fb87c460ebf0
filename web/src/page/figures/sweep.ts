// A section that is swept: straight, twisted, along a path, about an axis.

import { Pen } from "./pen";

export function sweep(marked: string): SVGSVGElement {
  return new Pen("A section S swept over a length, twisted, scaled and shifted on its way", marked)
    .body("M40 150L90 150L90 110L40 110ZM180 74L216 88L229 54L193 40Z")
    .line("M40 150L180 74M90 150L216 88M90 110L229 54M40 110L193 40")
    .centre("M65 130L205 64")
    .length([98, 160], [224, 98], "L", ["length", "path", "angle"], [4, 12])
    .angle([205, 64], 46, 0, 24, "φ", ["twist", "frame"], [4, 4])
    .thin("M205 64H262M205 64L250 44")
    .note([40, 130], [8, 92], "S", ["section", "layer", "around"])
    .note([193, 40], [150, 18], "s, k", ["scale", "skew", "transform"])
    .svg;
}
