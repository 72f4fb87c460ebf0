// Centroid and principal axes of a part, in its own frame: lengths say the radii of gyration, or the moments.

import * as three from "three";
import type { Spread } from "./answers";
import { factor, figures } from "./lengths";
import { centroidSign, label } from "./sprites";
import { strokes } from "./strokes";

const COLOUR = "#c2410c";
const NUMBERS = ["₁", "₂", "₃"];

export type Measure = "radii" | "moments";

// reach: half of what the longest axis is drawn as, where lengths say moments; shown: the unit of the labels
export function inertia(spread: Spread, measure: Measure, unit: string, reach: number, shown: string): three.Group {
  const scale = factor(spread.unit, unit);
  const centre = new three.Vector3(...spread.centroid).multiplyScalar(scale);
  const most = Math.max(...spread.moments);
  const group = new three.Group();
  spread.axes.forEach((axis, k) => {
    const half = measure === "radii" ? spread.radii[k]! * scale : (reach * spread.moments[k]!) / most;
    const way = new three.Vector3(...axis).multiplyScalar(half);
    const [tip, tail] = [centre.clone().add(way), centre.clone().sub(way)];
    const text = label(told(spread, measure, k, shown), COLOUR);
    text.position.copy(tip);
    group.add(strokes([...tail, ...tip], COLOUR, 2.5), text);
  });
  const sign = centroidSign();
  sign.position.copy(centre);
  sign.renderOrder += 1;
  group.add(sign);
  return group;
}

function told(spread: Spread, measure: Measure, k: number, shown: string): string {
  if (measure === "radii") return `k${NUMBERS[k]} ${figures(spread.radii[k]! * factor(spread.unit, shown))} ${shown}`;
  // without a density, mass is volume
  const unit = spread.massUnit === `${spread.unit}^3` ? `${spread.unit}⁵` : `${spread.massUnit}·${spread.unit}²`;
  return `I${NUMBERS[k]} ${figures(spread.moments[k]!)} ${unit}`;
}
