// A chart drawn as SVG with all its colours in it, so that it is the same in a file and on paper.

import { scaleLinear, scaleLog } from "d3-scale";
import { line } from "d3-shape";
import type { PlotData } from "../protocol";
import type { Domain } from "./domain";
import type { Palette, Stroke } from "./strokes";

export interface Frame {
  width: number;
  height: number;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export type Scale = ((value: number) => number) & { invert(pixel: number): number };
export interface Drawn {
  svg: SVGSVGElement;
  x: Scale;
  y: Scale;
}

const NAMESPACE = "http://www.w3.org/2000/svg";
const FONT = "system-ui, 'Segoe UI', Helvetica, Arial, sans-serif";

export function frameOf(width: number, height: number): Frame {
  return { width, height, left: width < 420 ? 54 : 64, right: 14, top: 12, bottom: 46 };
}

export const inner = (frame: Frame): [number, number] =>
  [frame.width - frame.left - frame.right, frame.height - frame.top - frame.bottom];

let clips = 0;

export function drawn(
  data: PlotData, strokes: Stroke[], hidden: ReadonlySet<string>, domain: Domain, frame: Frame, palette: Palette,
): Drawn {
  const log = data.log === "both";
  const [right, bottom] = [frame.width - frame.right, frame.height - frame.bottom];
  const x = (log ? scaleLog() : scaleLinear()).domain(domain.x).range([frame.left, right]);
  const y = (log ? scaleLog() : scaleLinear()).domain(domain.y).range([bottom, frame.top]);
  const svg = made("svg", {
    xmlns: NAMESPACE, viewBox: `0 0 ${frame.width} ${frame.height}`, width: frame.width, height: frame.height, role: "img",
    "font-family": FONT, "font-size": 12, "aria-label": spoken(data),
  });
  const title = made("title", {});
  title.textContent = data.title;
  svg.append(title, made("rect", { width: frame.width, height: frame.height, fill: palette.ground }));
  const [across, up] = [Math.max(2, Math.round((right - frame.left) / 80)), Math.max(2, Math.round((bottom - frame.top) / 44))];
  axis(svg, "x", ticksOf(x, across, log, data.x.unit === "°"), x, frame, palette);
  axis(svg, "y", ticksOf(y, up, log, data.y.unit === "°"), y, frame, palette);
  labels(svg, data, frame, palette);
  const id = `chart-clip-${++clips}`;
  const clip = made("clipPath", { id });
  clip.append(made("rect", { x: frame.left, y: frame.top, width: right - frame.left, height: bottom - frame.top }));
  const lines = made("g", { "clip-path": `url(#${id})`, fill: "none", "stroke-linejoin": "round" });
  data.lines.forEach((one, at) => {
    if (!hidden.has(one.name)) paint(lines, one, strokes[at]!, x, y, log);
  });
  svg.append(clip, lines, made("path", {
    d: `M${frame.left},${frame.top}V${bottom}H${right}`, stroke: palette.quiet, fill: "none",
  }));
  return { svg, x: x as unknown as Scale, y: y as unknown as Scale };
}

// What a reader who does not see it is told.
function spoken(data: PlotData): string {
  const axes = [data.y, data.x].map((one) => one.label + (one.unit ? ` in ${one.unit}` : "")).join(" over ");
  return `${data.title}. ${axes}. ${data.lines.map((one) => one.name).join("; ")}.`;
}

type Ticks = { value: number; text: string }[];

interface Ticked {
  domain(): number[];
  ticks(count: number): number[];
  tickFormat(count: number): (value: number) => string;
}

const PARTS_OF_A_TURN = [15, 30, 45, 90, 180]; // degrees

function ticksOf(scale: Ticked, count: number, log: boolean, angle: boolean): Ticks {
  const [least = 0, most = 1] = scale.domain();
  const step = angle && most - least >= 60 ? PARTS_OF_A_TURN.find((part) => (most - least) / part <= Math.max(4, count)) : undefined;
  if (step) {
    const first = Math.ceil(least / step);
    return Array.from({ length: Math.floor(most / step) - first + 1 }, (_, at) => ({ value: (first + at) * step, text: `${(first + at) * step}` }));
  }
  if (!log) {
    const format = scale.tickFormat(count);
    return scale.ticks(count).map((value) => ({ value, text: format(value) }));
  }
  const all = scale.ticks(count);
  const decades = all.filter((value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9);
  const few = decades.length < 2;
  return all.map((value) => ({ value, text: few || decades.includes(value) ? power(value) : "" }));
}

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// 0.001 as 10⁻³, 0.003 as 3·10⁻³; numbers from 0.01 to 1000 as they are
export function power(value: number): string {
  if (value >= 0.0099 && value <= 1001) return `${Number(value.toPrecision(3))}`;
  const exponent = Math.floor(Math.log10(value) + 1e-9);
  const head = Number((value / 10 ** exponent).toPrecision(3));
  const digits = [...`${Math.abs(exponent)}`].map((digit) => SUPERSCRIPT[Number(digit)]).join("");
  return `${head === 1 ? "" : `${head}·`}10${exponent < 0 ? "⁻" : ""}${digits}`;
}

function axis(svg: SVGElement, which: "x" | "y", ticks: Ticks, at: (value: number) => number, frame: Frame, palette: Palette): void {
  const [right, bottom] = [frame.width - frame.right, frame.height - frame.bottom];
  let last = -Infinity;
  for (const { value, text } of ticks) {
    const place = at(value);
    const along = which === "x"
      ? { x1: place, x2: place, y1: frame.top, y2: bottom } : { x1: frame.left, x2: right, y1: place, y2: place };
    svg.append(made("line", { ...along, stroke: palette.grid, "stroke-width": text ? 1 : 0.5 }));
    if (!text || (which === "x" && place - last < 7 * text.length + 8)) continue; // labels do not touch
    last = place;
    const label = which === "x"
      ? made("text", { x: place, y: bottom + 16, "text-anchor": "middle", fill: palette.quiet })
      : made("text", { x: frame.left - 7, y: place + 4, "text-anchor": "end", fill: palette.quiet });
    label.textContent = text;
    svg.append(label);
  }
}

function labels(svg: SVGElement, data: PlotData, frame: Frame, palette: Palette): void {
  const said = ({ label, unit }: PlotData["x"]) => (unit ? `${label}, ${unit}` : label);
  const x = made("text", { x: (frame.left + frame.width - frame.right) / 2, y: frame.height - 8, "text-anchor": "middle", fill: palette.ink });
  x.textContent = said(data.x);
  const middle = (frame.top + frame.height - frame.bottom) / 2;
  const y = made("text", { transform: `translate(13 ${middle}) rotate(-90)`, "text-anchor": "middle", fill: palette.ink });
  y.textContent = said(data.y);
  svg.append(x, y);
}

function paint(group: SVGElement, one: PlotData["lines"][number], stroke: Stroke, x: (v: number) => number, y: (v: number) => number, log: boolean): void {
  const there = (at: number) => one.x[at] !== null && one.y[at] !== null && !(log && (one.x[at]! <= 0 || one.y[at]! <= 0));
  const places = one.x.map((_, at) => at);
  if (stroke.drawn) {
    const d = line<number>().defined(there).x((at) => x(one.x[at]!)).y((at) => y(one.y[at]!)).digits(2)(places);
    const dash: Record<string, string> = stroke.dash ? { "stroke-dasharray": stroke.dash } : {};
    group.append(made("path", { d: d ?? "", stroke: stroke.colour, "stroke-width": stroke.width, ...dash }));
  }
  if (!stroke.marks) return;
  for (const at of places.filter(there)) {
    group.append(made("circle", { cx: x(one.x[at]!).toFixed(2), cy: y(one.y[at]!).toFixed(2), r: 3.2, fill: stroke.colour, stroke: "none" }));
  }
}

export function made<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string | number>): SVGElementTagNameMap[K] {
  const found = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) found.setAttribute(name, `${value}`);
  return found;
}
