// The images of a pattern: a gear's shell is sent as one tooth, and stands for all of them.

import { FULL } from "./packed";
import type { Index, Triple } from "./solid";

export type Rigid = readonly number[]; // 4 × 4, by rows

const SAME: Rigid = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

// The powers 0, 1, … order - 1 of a map.
export function powers(map: Rigid | null, order: number): Rigid[] {
  const all: Rigid[] = [SAME];
  while (all.length < order) all.push(product(map ?? SAME, all[all.length - 1]!));
  return all;
}

function product(a: Rigid, b: Rigid): Rigid {
  return a.map((_, at) => {
    const [row, column] = [at - (at % 4), at % 4];
    return a[row]! * b[column]! + a[row + 1]! * b[column + 4]! + a[row + 2]! * b[column + 8]! + a[row + 3]! * b[column + 12]!;
  });
}

// Points of one image, relative to a centre, from place `start` (in numbers) of out on.
export function pointsInto(out: Float32Array, start: number, points: Float64Array, map: Rigid, centre: Triple): void {
  const [a, b, c, x, d, e, f, y, g, h, i, z] = map as number[] as Twelve;
  const [u, v, w] = [x - centre[0], y - centre[1], z - centre[2]];
  for (let k = 0; k < points.length; k += 3) {
    const [p, q, r] = [points[k]!, points[k + 1]!, points[k + 2]!];
    out[start + k] = a * p + b * q + c * r + u;
    out[start + k + 1] = d * p + e * q + f * r + v;
    out[start + k + 2] = g * p + h * q + i * r + w;
  }
}

// Unit normals of one image, of 32767; one normal stands for all of a flat shell.
export function normalsOfImage(out: Int16Array, start: number, count: number, normals: Float64Array, map: Rigid): void {
  const [a, b, c, , d, e, f, , g, h, i] = map as number[] as Twelve;
  const flat = normals.length === 3;
  for (let k = 0; k < 3 * count; k += 3) {
    const at = flat ? 0 : k;
    const [p, q, r] = [normals[at]!, normals[at + 1]!, normals[at + 2]!];
    out[start + k] = Math.round(FULL * (a * p + b * q + c * r));
    out[start + k + 1] = Math.round(FULL * (d * p + e * q + f * r));
    out[start + k + 2] = Math.round(FULL * (g * p + h * q + i * r));
  }
}

type Twelve = [number, number, number, number, number, number, number, number, number, number, number, number];

export interface Repeated {
  order: number;
  vertices: number; // of one image
  index: Index; // of one image
}

// Triangles and edges of all images of all shells, over their vertices one after another.
export function joined(shells: readonly Repeated[]): Index {
  const total = (which: keyof Index) => shells.reduce((sum, shell) => sum + shell.order * shell.index[which].length, 0);
  const all: Index = { triangles: new Uint32Array(total("triangles")), edges: new Uint32Array(total("edges")) };
  for (const which of ["triangles", "edges"] as const) {
    let [at, first] = [0, 0];
    for (const { order, vertices, index } of shells) {
      const one = index[which];
      for (let image = 0; image < order; image++, first += vertices) {
        for (let k = 0; k < one.length; k++) all[which][at++] = one[k]! + first;
      }
    }
  }
  return all;
}
