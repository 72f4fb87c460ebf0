// Where the flanks touch: lines of the pair as it stands, so shown only while it stands there.

import * as three from "three";
import type { Overlays } from "./answers";
import { along, discard, strokes } from "./strokes";

const COLOUR = "#d1242f";

export class ContactLines {
  readonly group = new three.Group(); // in the frame of the scene
  private lines = new three.Group();

  show(lines: Overlays["lines"]): void {
    discard(this.lines);
    this.lines = new three.Group();
    const ends = lines.flatMap((line) => line.points.flatMap(along));
    if (ends.length) this.lines.add(strokes(ends, COLOUR, 3));
    this.group.add(this.lines);
  }

  at(turn: number, wanted: boolean): void {
    this.group.visible = wanted && Math.abs(turn) < 1e-9;
  }
}
