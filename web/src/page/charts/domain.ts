// Which part of a chart is looked at: all of it with a margin, or a window; of drawings with one scale on both axes.

import type { PlotData } from "../protocol";

export interface Domain {
  x: [number, number];
  y: [number, number];
}

const MARGIN = 0.05; // of the extent, at each side

// All of the lines that are shown. hidden: names of those that are not
export function whole(data: PlotData, hidden: ReadonlySet<string>): Domain {
  const shown = data.lines.filter((line) => !hidden.has(line.name));
  const lines = shown.length ? shown : data.lines;
  const log = data.log === "both";
  const x = extent(lines.flatMap((line) => line.x), log);
  const y = extent(lines.flatMap((line) => line.y), log);
  if (log) return { x: padded(x, log), y: padded(y, log) };
  return data.equal ? { x: padded(x, false), y: padded(y, false) } : { x, y: padded(y, false) };
}

function extent(values: (number | null)[], log: boolean): [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || (log && value <= 0)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  if (least > most) return log ? [0.1, 1] : [0, 1];
  if (least < most) return [least, most];
  const room = log ? 0 : Math.abs(least) * 0.5 || 1; // a level line has room around it
  return log ? [least / 2, most * 2] : [least - room, most + room];
}

function padded([least, most]: [number, number], log: boolean): [number, number] {
  if (log) {
    const factor = (most / least) ** MARGIN;
    return [least / factor, most * factor];
  }
  const room = MARGIN * (most - least);
  return [least - room, most + room];
}

// The least domain around one that has the same scale on both axes in a frame of so many pixels.
export function equalled({ x, y }: Domain, width: number, height: number): Domain {
  const scale = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
  return { x: about(x, scale * width), y: about(y, scale * height) };
}

const about = ([least, most]: [number, number], length: number): [number, number] =>
  [(least + most - length) / 2, (least + most + length) / 2];

// Larger (factor < 1) or smaller about a place given as shares of the frame; on logarithmic axes in their logarithms.
export function zoomed(domain: Domain, factor: number, at: [number, number], log: boolean): Domain {
  return { x: stretched(domain.x, factor, at[0], log), y: stretched(domain.y, factor, at[1], log) };
}

function stretched(range: [number, number], factor: number, share: number, log: boolean): [number, number] {
  const [least, most] = log ? range.map(Math.log) as [number, number] : range;
  const middle = least + share * (most - least);
  const found: [number, number] = [middle + (least - middle) * factor, middle + (most - middle) * factor];
  return log ? found.map(Math.exp) as [number, number] : found;
}

// Moved by shares of the frame.
export function moved(domain: Domain, by: [number, number], log: boolean): Domain {
  const shift = (range: [number, number], share: number): [number, number] => {
    if (log) {
      const factor = (range[1] / range[0]) ** share;
      return [range[0] * factor, range[1] * factor];
    }
    const way = share * (range[1] - range[0]);
    return [range[0] + way, range[1] + way];
  };
  return { x: shift(domain.x, by[0]), y: shift(domain.y, by[1]) };
}
