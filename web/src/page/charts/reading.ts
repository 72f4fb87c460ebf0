// What a chart says at a place: of curves over an axis all values there, of drawings the coordinates.

import { told } from "../amounts";
import type { PlotData } from "../protocol";

// Places at which curves can be read, ascending; none of drawings, marks and logarithmic charts of few points.
export function readable(data: PlotData): number[] {
  if (data.equal) return [];
  const places = data.lines.flatMap((line) => line.x.filter((x): x is number => x !== null));
  return [...new Set(places)].sort((a, b) => a - b);
}

// The value of a line at x between its points; null beyond its ends and in its gaps.
export function valueAt(line: PlotData["lines"][number], x: number, log: boolean): number | null {
  const of = (value: number) => (log ? Math.log(value) : value);
  for (let at = 0; at < line.x.length; at++) {
    const [here, y] = [line.x[at]!, line.y[at]!];
    if (here === null || y === null) continue;
    if (here === x) return y;
    const [next, beyond] = [line.x[at + 1] ?? null, line.y[at + 1] ?? null];
    if (next === null || beyond === null || line.style === "points") continue;
    if ((here < x && x < next) || (next < x && x < here)) {
      const share = (of(x) - of(here)) / (of(next) - of(here));
      const found = of(y) + share * (of(beyond) - of(y));
      return log ? Math.exp(found) : found;
    }
  }
  return null;
}

const unit = (text: string) => (text ? `\u2009${text}` : "");

export function readingAt(data: PlotData, hidden: ReadonlySet<string>, x: number): string {
  const values = data.lines.filter((line) => !hidden.has(line.name)).map((line) => {
    const y = valueAt(line, x, data.log === "both");
    return y === null ? "" : `${short(line.name)} ${told(y, 5)}${unit(data.y.unit)}`;
  });
  return [`${data.x.label} ${told(x, 5)}${unit(data.x.unit)}`, ...values.filter(Boolean)].join("; ");
}

export const coordinates = (data: PlotData, x: number, y: number) =>
  `x ${told(x, 5)}, y ${told(y, 5)}${unit(data.x.unit)}; distance from the origin ${told(Math.hypot(x, y), 5)}${unit(data.x.unit)}`;

// A name without what it says of its whole line.
const short = (name: string) => name.split(/: (?=none|[\d.])|, order /)[0]!;
