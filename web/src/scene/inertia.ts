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
    group.add(strokes([...tail, ...tip], COLOUR, 2.5));
    const same = [0, 1, 2].filter((other) => alike(spread.moments[other]!, spread.moments[k]!));
    if (same[0] !== k) return; // told with the first of those that are as long
    const text = label(told(spread, measure, same, shown), COLOUR);
    text.position.copy(tip);
    group.add(text);
  });
  const sign = centroidSign();
  sign.position.copy(centre);
  sign.renderOrder += 1;
  group.add(sign);
  return group;
}

const alike = (one: number, other: number) => Math.abs(one - other) <= 1e-9 * Math.max(one, other);

// axes: those with this length
function told(spread: Spread, measure: Measure, axes: number[], shown: string): string {
  const names = axes.map((k) => `${measure === "radii" ? "k" : "I"}${NUMBERS[k]}`).join(" = ");
  const k = axes[0]!;
  if (measure === "radii") return `${names} ${figures(spread.radii[k]! * factor(spread.unit, shown))} ${shown}`;
  // without a density, mass is volume
  const unit = spread.massUnit === `${spread.unit}^3` ? `${spread.unit}⁵` : `${spread.massUnit}·${spread.unit}²`;
  return `${names} ${figures(spread.moments[k]!)} ${unit}`;
}
