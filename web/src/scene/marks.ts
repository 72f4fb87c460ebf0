// What is drawn about one body beside itself, and moves with it: its axis, its centroid, its reference surfaces.

import * as three from "three";
import type { Spread, Surface } from "./answers";
import type { Body } from "./body";
import { inertia, type Measure } from "./inertia";
import { reference } from "./reference";
import { centreLine, discard, strokes } from "./strokes";

const PAST = 0.12; // of the scene's radius, that an axis stands out at either end

export interface Wanted {
  axes: boolean;
  centroid: boolean;
  measure: Measure;
  kinds: ReadonlySet<string>; // of reference surfaces
}

export class Marks {
  spread: Spread | null = null;
  surfaces: readonly Surface[] = [];
  private group = new three.Group();

  constructor(readonly body: Body) {}

  // unit: of the scene; shown: what is read out
  refresh(wanted: Wanted, radius: number, ink: string, unit: string, shown: string, cut: three.Plane | null): void {
    discard(this.group);
    this.group = new three.Group();
    const [least, most] = this.body.ends();
    const { spin, slide } = this.body.solid;
    const turns = spin !== 0 || slide.every((one) => one === 0); // what only slides has no axis
    if (wanted.axes && turns) this.group.add(strokes(centreLine(least - PAST * radius, most + PAST * radius), ink, 1.6));
    if (wanted.centroid && this.spread) this.group.add(inertia(this.spread, wanted.measure, unit, 0.5 * radius, shown));
    for (const surface of this.surfaces) if (wanted.kinds.has(surface.kind)) this.group.add(reference(surface, cut));
    this.body.placed.add(this.group);
  }

  dispose(): void {
    discard(this.group);
  }
}
