// A closed outline in a plane: points are put, pulled and removed by mouse, touch or keys.

import { element, unique } from "../dom";
import { distance } from "./inside";
import { shown } from "./quantity";

type XY = [number, number];

const NS = "http://www.w3.org/2000/svg";
const SIDE = 300; // of the drawing, in its own units
const MARGIN = 30;
const HELP = "Click to add a point, drag to move one. Keys: Tab to a point, arrows move it, with Shift by ten, "
  + "Insert adds one after it, Delete removes it.";

export class Drawing {
  readonly element: HTMLElement;
  private readonly svg = document.createElementNS(NS, "svg");
  private readonly told = element("output", { class: "reading", "aria-live": "off" });
  private points: XY[] = [];
  private scale = 1; // units of the drawing for one of length
  private middle: XY = [0, 0];

  constructor(label: string, private readonly unit: () => string, private readonly changed: (points: XY[]) => void) {
    const help = element("p", { class: "hint", id: unique("drawing") }, HELP);
    this.svg.setAttribute("viewBox", `0 0 ${SIDE} ${SIDE}`);
    this.svg.setAttribute("role", "group");
    this.svg.setAttribute("aria-label", `${label}, drawing`);
    this.svg.setAttribute("aria-describedby", help.id);
    this.svg.classList.add("drawing");
    this.svg.addEventListener("pointerdown", (event) => this.pressed(event));
    this.element = element("div", { class: "drawn" }, this.svg, this.told, help);
    this.show([]);
  }

  show(points: XY[]): void {
    this.points = points.map(([x, y]) => [x, y]);
    this.fit();
    this.draw();
  }

  private fit(): void {
    const xs = this.points.map(([x]) => x);
    const ys = this.points.map(([, y]) => y);
    const least: XY = [Math.min(0, ...xs), Math.min(0, ...ys)];
    const most: XY = [Math.max(0, ...xs), Math.max(0, ...ys)];
    const span = Math.max(most[0] - least[0], most[1] - least[1]) || 20;
    this.middle = [(least[0] + most[0]) / 2, (least[1] + most[1]) / 2];
    this.scale = (SIDE - 2 * MARGIN) / span;
  }

  // Whether a point has left the drawing.
  private outside(index: number): boolean {
    return this.at(this.points[index]!).some((place) => place < 0 || place > SIDE);
  }

  private at([x, y]: XY): XY {
    return [SIDE / 2 + this.scale * (x - this.middle[0]), SIDE / 2 - this.scale * (y - this.middle[1])];
  }

  // Where the pointer is, on a grid that the eye can follow.
  private under(event: PointerEvent): XY {
    const box = this.svg.getBoundingClientRect();
    const [u, v] = [((event.clientX - box.left) / box.width) * SIDE, ((event.clientY - box.top) / box.height) * SIDE];
    return [this.snapped(this.middle[0] + (u - SIDE / 2) / this.scale), this.snapped(this.middle[1] - (v - SIDE / 2) / this.scale)];
  }

  private get step(): number {
    return 10 ** Math.floor(Math.log10(6 / this.scale));
  }

  private snapped(value: number): number {
    return Number((Math.round(value / this.step) * this.step).toPrecision(12));
  }

  private pressed(event: PointerEvent): void {
    const handle = (event.target as Element).closest<SVGElement>("[data-point]");
    let index = handle ? Number(handle.dataset.point) : -1;
    if (index < 0) {
      const point = this.under(event);
      index = this.gap(point);
      this.points.splice(index, 0, point);
      this.changed(this.points);
      this.draw();
    }
    event.preventDefault();
    this.handle(index)?.focus();
    this.svg.setPointerCapture(event.pointerId);
    const move = (moved: PointerEvent) => this.put(index, this.under(moved));
    const up = () => {
      this.svg.removeEventListener("pointermove", move);
      this.svg.removeEventListener("pointerup", up);
      this.svg.removeEventListener("pointercancel", up);
      this.fit();
      this.draw();
      this.handle(index)?.focus();
    };
    this.svg.addEventListener("pointermove", move);
    this.svg.addEventListener("pointerup", up);
    this.svg.addEventListener("pointercancel", up);
  }

  // The side of the outline that is nearest: a new point goes between its ends.
  private gap(point: XY): number {
    if (this.points.length < 3) return this.points.length;
    const distances = this.points.map((a, i) => distance(point, a, this.points[(i + 1) % this.points.length]!));
    return distances.indexOf(Math.min(...distances)) + 1;
  }

  private put(index: number, point: XY): void {
    this.points[index] = point;
    this.changed(this.points);
    this.draw();
    this.told.textContent = `point ${index + 1}: ${shown(point[0])}, ${shown(point[1])} ${this.unit()}`;
  }

  private keyed(event: KeyboardEvent, index: number): void {
    const ways: Record<string, XY> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const way = ways[event.key];
    const [x, y] = this.points[index]!;
    if (way) {
      const step = this.step * (event.shiftKey ? 10 : 1);
      this.put(index, [this.snapped(x + step * way[0]), this.snapped(y + step * way[1])]);
      if (this.outside(index)) {
        this.fit();
        this.draw();
      }
    } else if (event.key === "Delete" || event.key === "Backspace") {
      this.points.splice(index, 1);
      this.changed(this.points);
      this.draw();
      index = Math.max(0, index - 1);
    } else if (event.key === "Insert" || event.key === "Enter") {
      const next = this.points[(index + 1) % this.points.length]!;
      this.points.splice(++index, 0, [this.snapped((x + next[0]) / 2), this.snapped((y + next[1]) / 2)]);
      this.changed(this.points);
      this.draw();
    } else return;
    event.preventDefault();
    this.handle(index)?.focus();
  }

  private handle(index: number): SVGElement | null {
    return this.svg.querySelector(`[data-point="${index}"]`);
  }

  private draw(): void {
    const focused = (document.activeElement as SVGElement | null)?.dataset?.point;
    const inside = this.svg.contains(document.activeElement);
    const [x0, y0] = this.at([0, 0]);
    const axes = shape("path", { d: `M0 ${y0}H${SIDE}M${x0} 0V${SIDE}`, class: "axes" });
    const outline = shape("polygon", { points: this.points.map((point) => this.at(point).join(",")).join(" "), class: "outline" });
    const handles = this.points.map((point, index) => {
      const [cx, cy] = this.at(point);
      const label = `point ${index + 1}: ${shown(point[0])}, ${shown(point[1])}`;
      const made = shape("circle", {
        cx: `${cx}`, cy: `${cy}`, r: "7", tabindex: "0", role: "button", "aria-label": label, "data-point": `${index}`, class: "handle",
      });
      made.addEventListener("keydown", (event) => this.keyed(event as KeyboardEvent, index));
      return made;
    });
    this.svg.replaceChildren(axes, outline, ...handles);
    if (inside && focused) this.handle(Number(focused))?.focus();
  }
}

function shape(tag: string, attributes: Record<string, string>): SVGElement {
  const made = document.createElementNS(NS, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made as SVGElement;
}
