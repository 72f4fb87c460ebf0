// Where in an outline there is most room, and an outline to begin with there.

import type { Value } from "../protocol";

type XY = [number, number];

const CELLS = 24; // a side of the grid that is tried
const SHARE = 0.5; // of the room there is

export const isOutline = (value: Value | undefined): value is XY[] =>
  Array.isArray(value) && value.length >= 3
  && value.every((point) => Array.isArray(point) && point.length === 2 && point.every((x) => typeof x === "number"));

// A square hole in an outline, clear of the holes that are there; undefined where there is no room.
export function holeIn(outline: XY[], others: XY[][]): XY[] | undefined {
  const all = [outline, ...others];
  const [[x0, x1], [y0, y1]] = [0, 1].map((axis) => {
    const values = outline.map((point) => point[axis]!);
    return [Math.min(...values), Math.max(...values)];
  }) as [XY, XY];
  let [best, middle]: [number, XY] = [0, [0, 0]];
  for (let i = 1; i < CELLS; i++) {
    for (let j = 1; j < CELLS; j++) {
      const point: XY = [x0 + ((x1 - x0) * i) / CELLS, y0 + ((y1 - y0) * j) / CELLS];
      if (!within(point, outline) || others.some((other) => within(point, other))) continue;
      const room = Math.min(...all.map((one) => distanceTo(point, one)));
      if (room > best * (1 + 1e-9)) [best, middle] = [room, point];
    }
  }
  if (!(best > 0)) return undefined;
  const step = 10 ** Math.floor(Math.log10(best) - 1);
  const short = (x: number) => Number((Math.round(x / step) * step).toPrecision(12));
  const half = (SHARE * best) / Math.SQRT2;
  return ([[-1, -1], [1, -1], [1, 1], [-1, 1]] as XY[]).map(([u, v]) => [short(middle[0] + u * half), short(middle[1] + v * half)]);
}

// By how often a ray towards +x leaves it.
function within([x, y]: XY, outline: XY[]): boolean {
  return outline.filter(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length]!;
    return ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay);
  }).length % 2 === 1;
}

const distanceTo = (point: XY, outline: XY[]) =>
  Math.min(...outline.map((a, i) => distance(point, a, outline[(i + 1) % outline.length]!)));

// Of a point from the straight line between two others.
export function distance([x, y]: XY, [ax, ay]: XY, [bx, by]: XY): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
