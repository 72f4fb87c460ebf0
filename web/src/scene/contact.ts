// Where the flanks touch: lines at some turns over a pitch, of which those of the turn next to now are shown.

import * as three from "three";
import type { ContactSteps } from "./answers";
import { along, discard, strokes } from "./strokes";

const COLOUR = "#d1242f";

export class ContactLines {
  readonly group = new three.Group(); // in the frame of the scene
  private steps: three.Object3D[][] = []; // of each kind of lines
  private pitches: number[] = [];

  show(lines: readonly ContactSteps[]): void {
    for (const step of this.steps.flat()) discard(step);
    this.pitches = lines.map((line) => line.pitch);
    this.steps = lines.map((line) =>
      line.steps.map((touching) => {
        const ends = touching.flatMap(along);
        return ends.length ? strokes(ends, COLOUR, 3) : new three.Group();
      }));
    for (const step of this.steps.flat()) this.group.add(step);
  }

  // turn: of the pinion, degrees
  at(turn: number, wanted: boolean): void {
    this.steps.forEach((steps, line) => {
      const number = Math.round((turn / this.pitches[line]!) * steps.length) % steps.length;
      const now = number < 0 ? number + steps.length : number;
      steps.forEach((step, k) => (step.visible = wanted && k === now));
    });
  }
}
