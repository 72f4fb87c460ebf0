// The plane that cuts the bodies: across x, y or z, at a place between their ends.

import * as three from "three";
import type { Body } from "./body";

export type Axis = "x" | "y" | "z";

export class Section {
  axis: Axis | null = null;
  flipped = false;
  readonly plane = new three.Plane();
  private readonly box = new three.Box3();
  private readonly middle = new three.Vector3();

  // box: what the bodies take in the scene; middle: what has become the origin
  contain(box: three.Box3, middle: three.Vector3): void {
    this.box.copy(box);
    this.middle.copy(middle);
  }

  // From where to where, in the frame of the scene.
  limits(axis: Axis): [number, number] {
    return [this.box.min[axis], this.box.max[axis]];
  }

  // Takes away the side of the eye, so that the cut is seen.
  choose(axis: Axis | null, eye: three.Vector3): void {
    this.axis = axis;
    if (axis) this.flipped = eye[axis] < 0;
  }

  cut(bodies: readonly Body[], position: number): void {
    if (this.axis) {
      const sign = this.flipped ? 1 : -1;
      this.plane.normal.set(0, 0, 0)[this.axis] = sign;
      this.plane.constant = -sign * (position - this.middle[this.axis]);
    }
    for (const body of bodies) body.cutBy(this.axis ? this.plane : null);
  }
}
