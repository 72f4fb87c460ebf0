// How each line of a chart is drawn: the same member in the same colour, circles in the line kinds of drawings.

import type { PlotData } from "../protocol";

export interface Palette {
  ink: string;
  quiet: string;
  grid: string;
  ground: string;
  colours: string[];
}

// Told apart by the colour-blind, too, and of enough contrast to their ground.
export const LIGHT: Palette = {
  ink: "#1a2129", quiet: "#55606c", grid: "#e0e6ec", ground: "#ffffff",
  colours: ["#1f5fa8", "#b5541d", "#2e7d4f", "#8a3f94", "#8a6d00", "#b3263c"],
};
export const DARK: Palette = {
  ink: "#e8edf2", quiet: "#a6b1bc", grid: "#333c46", ground: "#1d232a",
  colours: ["#7ab3f5", "#f0a06a", "#78cf9d", "#d59be0", "#e0c45c", "#ff8f9c"],
};

export interface Stroke {
  colour: string;
  width: number;
  dash: string;
  marks: boolean;
  drawn: boolean; // whether a line is drawn at all
}

const DASHES: [start: string, dash: string][] = [
  ["working pitch", "14 3 2 3 2 3"], ["pitch", "12 3 2 3"], ["base", "6 3"], ["tip", "2 3"], ["root", "2 3"],
];
const OTHER = "7 4";

export function strokes(data: PlotData, palette: Palette): Stroke[] {
  const bodies = data.lines.filter((line) => line.style === "solid").map((line) => line.name);
  const colour = (at: number) => palette.colours[at % palette.colours.length]!;
  return data.lines.map((line, at) => {
    const member = bodies.findIndex((body) => line.name.endsWith(`, ${body}`));
    const alone = data.equal && member < 0 && line.style === "dashed";
    const own = data.equal && bodies.includes(line.name) ? bodies.indexOf(line.name) : at;
    return {
      colour: alone ? palette.quiet : colour(member >= 0 ? member : own),
      width: line.style === "dashed" ? (data.equal ? 1 : 1.6) : 1.8,
      dash: line.style === "dashed" ? dashOf(line.name) : "",
      drawn: line.style !== "points",
      marks: line.style === "points" || data.log === "both",
    };
  });
}

const dashOf = (name: string) => DASHES.find(([start]) => name.startsWith(start))?.[1] ?? OTHER;
