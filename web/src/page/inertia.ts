// Inertia about a point, and which of its digits are no more than rounding.

import type { About, Point } from "./protocol";

export type Tensor = number[][]; // (3, 3), off the diagonal minus the products

export interface Inertial {
  mass: number;
  centroid: number[];
  central_inertia: Tensor;
}

const NOISE = 1e-14; // no more than some roundings of the largest value

// Steiner: I_p = I_c + m (d·d E − d dᵀ), d from the point to the centroid.
export function inertiaAbout(body: Inertial, about: About): Tensor {
  const d = fromPoint(body, about);
  const square = d.reduce((sum, x) => sum + x * x, 0);
  const found = body.central_inertia.map((row, i) =>
    row.map((value, j) => value + body.mass * ((i === j ? square : 0) - d[i]! * d[j]!)));
  return withoutNoise(found, Math.max(...found.flat().map(Math.abs)));
}

function fromPoint(body: Inertial, about: About): number[] {
  if (about === "centroid") return [0, 0, 0];
  const point: Point = Array.isArray(about) ? about : [0, 0, 0];
  return body.centroid.map((x, i) => x - point[i]!);
}

function withoutNoise(tensor: Tensor, scale: number): Tensor {
  return tensor.map((row) => row.map((value) => clean(value, scale)));
}

// Nought where a value is only rounding, measured by a scale of its kind.
export const clean = (value: number, scale: number) => (Math.abs(value) <= NOISE * scale ? 0 : value);

// Frobenius: what the errors of components are measured by.
export const norm = (tensor: Tensor) => Math.hypot(...tensor.flat());
