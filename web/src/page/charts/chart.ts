// One chart with its legend, whose lines can be hidden, its reading and its enlargement.

import { element, symbol, unique } from "../dom";
import type { PlotData } from "../protocol";
import { type Domain, equalled, moved, whole, zoomed } from "./domain";
import { drawn, type Drawn, frameOf, inner, made } from "./drawing";
import { coordinates, readable, readingAt } from "./reading";
import { DARK, LIGHT, type Palette, type Stroke, strokes } from "./strokes";

const RATIO = 0.72; // height over width
const [FLATTEST, STEEPEST] = [0.55, 1.05]; // of drawings, whose height goes with what they show
const STEP = 1.4;

export class Chart {
  readonly element = element("figure", { class: "chart" });
  private readonly caption = element("figcaption");
  private readonly stage = element("div");
  private readonly legend = element("fieldset", { class: "legend-of" });
  private readonly slider = element("input", { type: "range", min: "0", step: "1", id: unique("reading") });
  private readonly reading: HTMLElement;
  private readonly output = element("output", { "aria-live": "off" });
  private readonly notes = element("ul", { class: "chart-notes" });
  private data: PlotData | null = null;
  private readonly hidden = new Set<string>();
  private domain: Domain | null = null; // null: as it is looked at first
  private places: number[] = [];
  private at: number | null = null;
  private drawing: Drawn | null = null;
  private printing = false;

  constructor() {
    this.reading = element("div", { class: "reading-at" }, element("label", { for: this.slider.id }, "Read at"), this.slider);
    this.element.append(this.caption, this.stage, this.reading, this.output, this.legend, this.notes);
    this.slider.addEventListener("input", () => this.read(this.places[this.slider.valueAsNumber] ?? null));
    new ResizeObserver(() => this.draw()).observe(this.stage);
    new MutationObserver(() => this.draw()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
    for (const [event, on] of [["beforeprint", true], ["afterprint", false]] as const) {
      window.addEventListener(event, () => {
        this.printing = on;
        this.draw();
      });
    }
    this.stage.addEventListener("pointermove", (event) => this.point(event));
    this.stage.addEventListener("pointerleave", () => this.read(null));
    this.pan();
  }

  // same: whether it is the same chart of another design, of which what is hidden and enlarged stays
  show(data: PlotData, same: boolean): void {
    this.data = data;
    if (!same) {
      this.hidden.clear();
      this.domain = null;
    }
    this.caption.textContent = data.title;
    this.notes.replaceChildren(...data.notes.map((note) => element("li", {}, note)));
    this.places = readable(data);
    this.reading.hidden = !this.places.length;
    this.slider.max = `${Math.max(0, this.places.length - 1)}`;
    this.at = null;
    this.draw();
  }

  // larger: 1 or −1; 0 for all of it
  enlarge(larger: number): void {
    if (!this.data) return;
    if (larger === 0) this.domain = this.fitting(whole(this.data, this.hidden));
    else this.domain = zoomed(this.shown(), STEP ** -larger, [0.5, 0.5], this.data.log === "both");
    this.draw();
  }

  // The chart as a file, light, with its title and its legend.
  file(): string {
    const { data } = this;
    if (!data) return "";
    const frame = frameOf(900, 620);
    const kept = strokes(data, LIGHT);
    const { svg } = drawn(data, kept, this.hidden, this.shown(), frame, LIGHT);
    const lines = data.lines.map((line, at) => ({ line, stroke: kept[at]! })).filter(({ line }) => !this.hidden.has(line.name));
    const top = 40;
    const height = top + frame.height + 10 + 18 * (lines.length + data.notes.length);
    const all = made("svg", { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 900 ${height}`, width: 900, height, "font-family": "Helvetica, Arial, sans-serif", "font-size": 13 });
    all.append(made("rect", { width: 900, height, fill: LIGHT.ground }));
    const text = (content: string, x: number, y: number, more = {}) => {
      const found = made("text", { x, y, fill: LIGHT.ink, ...more });
      found.textContent = content;
      all.append(found);
    };
    text(data.title, 16, 26, { "font-size": 17, "font-weight": 600 });
    svg.setAttribute("y", `${top}`);
    all.append(svg);
    let y = top + frame.height + 16;
    for (const { line, stroke } of lines) {
      const sample = swatch(stroke);
      sample.setAttribute("x", "64");
      sample.setAttribute("y", `${y - 9}`);
      all.append(sample);
      text(line.name, 98, y);
      y += 18;
    }
    for (const note of data.notes) {
      text(note, 64, y, { fill: LIGHT.quiet });
      y += 18;
    }
    return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(all)}\n`;
  }

  private get palette(): Palette {
    return document.documentElement.dataset.theme === "dark" && !this.printing ? DARK : LIGHT;
  }

  private frame() {
    const width = Math.max(260, Math.round(this.stage.clientWidth || 380));
    return frameOf(width, Math.max(240, Math.round(width * this.ratio)));
  }

  private get ratio(): number {
    if (!this.data?.equal) return RATIO;
    const { x, y } = this.first;
    return Math.min(STEEPEST, Math.max(FLATTEST, (y[1] - y[0]) / (x[1] - x[0])));
  }

  // What is looked at first.
  private get first(): Domain {
    const { window } = this.data!;
    return window ? { x: [window[0], window[1]], y: [window[2], window[3]] } : whole(this.data!, new Set());
  }

  private shown(): Domain {
    return this.fitting(this.domain ?? this.first);
  }

  private fitting(domain: Domain): Domain {
    return this.data!.equal ? equalled(domain, ...inner(this.frame())) : domain;
  }

  private draw(): void {
    const { data } = this;
    if (!data || !this.stage.clientWidth) return;
    const kept = strokes(data, this.palette);
    this.drawing = drawn(data, kept, this.hidden, this.shown(), this.frame(), this.palette);
    if (data.equal) this.drawing.svg.classList.add("pans");
    this.stage.replaceChildren(this.drawing.svg);
    this.entries(data, kept);
    this.read(this.at);
  }

  private entries(data: PlotData, kept: Stroke[]): void {
    const names = data.lines.map((line) => line.name).join("\n");
    if (this.legend.dataset.names === names && this.legend.dataset.colour === this.palette.ink) return;
    Object.assign(this.legend.dataset, { names, colour: this.palette.ink });
    this.legend.replaceChildren(element("legend", { class: "unseen" }, "Lines that are shown"), ...data.lines.map((line, at) => {
      const box = element("input", { type: "checkbox" });
      box.checked = !this.hidden.has(line.name);
      box.addEventListener("change", () => {
        if (box.checked) this.hidden.delete(line.name);
        else this.hidden.add(line.name);
        this.draw();
      });
      return element("label", {}, box, swatch(kept[at]!), element("span", {}, ...named(line.name)));
    }));
  }

  // The value under the pointer.
  private point(event: PointerEvent): void {
    const { data, drawing } = this;
    if (!data || !drawing) return;
    const box = drawing.svg.getBoundingClientRect();
    const frame = this.frame();
    const place = [(event.clientX - box.left) * (frame.width / box.width), (event.clientY - box.top) * (frame.height / box.height)] as const;
    const inside = place[0] >= frame.left && place[0] <= frame.width - frame.right && place[1] >= frame.top && place[1] <= frame.height - frame.bottom;
    if (!inside) return this.read(null);
    const x = drawing.x.invert(place[0]);
    if (data.equal) this.output.textContent = coordinates(data, x, drawing.y.invert(place[1]));
    else this.read(nearest(this.places, x, data.log === "both"));
  }

  private read(x: number | null): void {
    const { data, drawing } = this;
    if (!data || !drawing) return;
    this.at = x;
    drawing.svg.querySelector(".at")?.remove();
    const text = x === null ? "" : readingAt(data, this.hidden, x);
    this.output.textContent = text;
    if (x === null) return;
    this.slider.value = `${this.places.indexOf(x)}`;
    this.slider.setAttribute("aria-valuetext", text);
    const frame = this.frame();
    drawing.svg.append(made("line", {
      class: "at", x1: drawing.x(x), x2: drawing.x(x), y1: frame.top, y2: frame.height - frame.bottom, stroke: this.palette.quiet, "stroke-dasharray": "3 3",
    }));
  }

  // Drawings are moved with the pointer and enlarged with the wheel and Ctrl, as maps are.
  private pan(): void {
    let from: { x: number; y: number; domain: Domain } | null = null;
    this.stage.addEventListener("pointerdown", (event) => {
      if (!this.data?.equal || event.button !== 0) return;
      from = { x: event.clientX, y: event.clientY, domain: this.shown() };
      this.stage.setPointerCapture(event.pointerId);
    });
    this.stage.addEventListener("pointermove", (event) => {
      if (!from || !this.drawing) return;
      const [width, height] = inner(this.frame());
      this.domain = moved(from.domain, [(from.x - event.clientX) / width, (event.clientY - from.y) / height], false);
      this.draw();
    });
    for (const event of ["pointerup", "pointercancel"]) this.stage.addEventListener(event, () => { from = null; });
    this.stage.addEventListener("wheel", (event) => {
      if (!event.ctrlKey || !this.data || !this.drawing) return;
      event.preventDefault();
      const box = this.drawing.svg.getBoundingClientRect();
      const frame = this.frame();
      const [width, height] = inner(frame);
      const at: [number, number] = [(event.clientX - box.left - frame.left) / width, 1 - (event.clientY - box.top - frame.top) / height];
      this.domain = zoomed(this.shown(), STEP ** (event.deltaY / 100), at, this.data.log === "both");
      this.draw();
    }, { passive: false });
  }
}

function nearest(places: number[], x: number, log: boolean): number | null {
  const of = (value: number) => (log ? Math.log(value) : value);
  return places.reduce<number | null>((best, one) => (best === null || Math.abs(of(one) - of(x)) < Math.abs(of(best) - of(x)) ? one : best), null);
}

// A name with its symbol, "base circle d_b, pinion", as textbooks have it.
function named(name: string): (Node | string)[] {
  const [, before, sign, after] = /^(.* )(d(?:_\w+)?)(, .*|)$/.exec(name) ?? [];
  return sign ? [before!, symbol(sign), after!] : [name];
}

function swatch(stroke: Stroke): SVGSVGElement {
  const svg = made("svg", { viewBox: "0 0 26 10", width: 26, height: 10, "aria-hidden": "true" });
  if (stroke.marks) svg.append(made("circle", { cx: 13, cy: 5, r: 3.2, fill: stroke.colour }));
  if (stroke.drawn) {
    svg.append(made("line", { x1: 0, x2: 26, y1: 5, y2: 5, stroke: stroke.colour, "stroke-width": Math.max(stroke.width, 1.3), "stroke-dasharray": stroke.dash || "none" }));
  }
  return svg;
}
