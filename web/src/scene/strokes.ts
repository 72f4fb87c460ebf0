// Lines some pixels wide, whatever the zoom, which shine through the bodies.

import * as three from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Triple } from "./solid";

const DASHES = 8;
const ABOVE = 2000; // drawn after all bodies

// ends: two points a segment, six numbers
export function strokes(ends: number[], colour: string, width: number): LineSegments2 {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(ends);
  const material = new LineMaterial({ color: new three.Color(colour), linewidth: width, depthTest: false, transparent: true });
  material.toneMapped = false;
  const made = new LineSegments2(geometry, material);
  made.renderOrder = ABOVE;
  made.frustumCulled = false;
  return made;
}

// Segments along a polyline.
export function along(points: readonly Triple[]): number[] {
  return points.slice(1).flatMap((point, k) => [...points[k]!, ...point]);
}

// A centre line as in a drawing: long dashes with dots between them, from z to z.
export function centreLine(least: number, most: number): number[] {
  const period = (most - least) / (DASHES - 1 + 0.64); // begins and ends with a dash
  const ends: number[] = [];
  for (let dash = 0; dash < DASHES; dash++) {
    const z = least + dash * period;
    ends.push(0, 0, z, 0, 0, Math.min(z + 0.64 * period, most));
    if (dash < DASHES - 1) ends.push(0, 0, z + 0.78 * period, 0, 0, z + 0.86 * period);
  }
  return ends;
}

export function discard(group: three.Object3D): void {
  group.traverse((part) => {
    const { geometry, material } = part as Partial<three.Mesh>;
    if (!(part as Partial<three.Sprite>).isSprite) geometry?.dispose(); // sprites share one
    for (const one of material ? [material].flat() : []) {
      (one as three.SpriteMaterial).map?.dispose();
      one.dispose();
    }
  });
  group.removeFromParent();
}
