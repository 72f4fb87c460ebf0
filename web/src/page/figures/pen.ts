// Draws figures as an engineer sketches them: a body, centre lines, dimensions with arrows.

const NS = "http://www.w3.org/2000/svg";

type XY = [number, number];

export class Pen {
  readonly svg = document.createElementNS(NS, "svg");

  // marked: the parameter whose dimension stands out
  constructor(title: string, private readonly marked: string, width = 280, height = 180) {
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("role", "img");
    this.svg.setAttribute("aria-label", title);
    this.svg.classList.add("figure");
  }

  body(d: string): this {
    return this.add("path", { d, class: "body" });
  }

  line(d: string): this {
    return this.add("path", { d, class: "line" });
  }

  centre(d: string): this {
    return this.add("path", { d, class: "centre" });
  }

  thin(d: string): this {
    return this.add("path", { d, class: "thin" });
  }

  // A length between two points, its text aside of the middle. names: the parameters that it stands for
  length(from: XY, to: XY, text: string, names: string[], aside: XY = [5, 4]): this {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const short = Math.hypot(to[0] - from[0], to[1] - from[1]) < 18;
    const outward = short ? -1 : 1;
    const kind = this.kind(names);
    if (short) {
      const [dx, dy] = [12 * Math.cos(angle), 12 * Math.sin(angle)];
      this.add("path", { d: `M${from[0] - dx} ${from[1] - dy}L${to[0] + dx} ${to[1] + dy}`, class: `dimension ${kind}` });
    } else this.add("path", { d: `M${from}L${to}`, class: `dimension ${kind}` });
    this.arrow(from, outward > 0 ? angle : angle + Math.PI, kind);
    this.arrow(to, outward > 0 ? angle + Math.PI : angle, kind);
    return this.text([(from[0] + to[0]) / 2 + aside[0], (from[1] + to[1]) / 2 + aside[1]], text, kind);
  }

  // An angle about a point, from one direction to the other, in degrees, anticlockwise.
  angle(at: XY, radius: number, from: number, to: number, text: string, names: string[], aside: XY = [4, 4]): this {
    const kind = this.kind(names);
    const end = (degrees: number): XY => [
      at[0] + radius * Math.cos((degrees * Math.PI) / 180), at[1] - radius * Math.sin((degrees * Math.PI) / 180),
    ];
    const large = Math.abs(to - from) > 180 ? 1 : 0;
    this.add("path", { d: `M${end(from)}A${radius} ${radius} 0 ${large} ${to > from ? 0 : 1} ${end(to)}`, class: `dimension ${kind}` });
    const turn = to > from ? 90 : -90;
    this.arrow(end(to), (-(to + turn - 180) * Math.PI) / 180, kind);
    const [x, y] = end((from + to) / 2);
    return this.text([x + aside[0], y + aside[1]], text, kind);
  }

  // A note with a line to what it is about.
  note(at: XY, from: XY, text: string, names: string[]): this {
    const kind = this.kind(names);
    this.add("path", { d: `M${from}L${at}`, class: `dimension ${kind}` });
    this.arrow(at, Math.atan2(from[1] - at[1], from[0] - at[0]), kind);
    return this.text([from[0] + 2, from[1] - 3], text, kind);
  }

  circle(at: XY, radius: number, kind: string): this {
    return this.add("circle", { cx: `${at[0]}`, cy: `${at[1]}`, r: `${radius}`, class: kind });
  }

  private text(at: XY, text: string, kind: string): this {
    const made = document.createElementNS(NS, "text");
    made.setAttribute("x", `${at[0]}`);
    made.setAttribute("y", `${at[1]}`);
    made.setAttribute("class", kind);
    const [, head = "", foot = "", rest = ""] = /^([^_]*)(?:_([^\s*]*))?(.*)$/.exec(text) ?? [];
    made.append(head);
    if (foot) {
      const lower = document.createElementNS(NS, "tspan");
      lower.setAttribute("dy", "3");
      lower.setAttribute("font-size", "8");
      lower.textContent = foot;
      made.append(lower);
    }
    made.append(rest);
    this.svg.append(made);
    return this;
  }

  private kind(names: string[]): string {
    return names.includes(this.marked) ? "marked" : "other";
  }

  private arrow([x, y]: XY, angle: number, kind: string): void {
    const corner = (turn: number) => `${x + 7 * Math.cos(angle + turn)} ${y + 7 * Math.sin(angle + turn)}`;
    this.add("path", { d: `M${x} ${y}L${corner(0.3)}L${corner(-0.3)}Z`, class: `arrow ${kind}` });
  }

  private add(tag: string, attributes: Record<string, string>): this {
    const made = document.createElementNS(NS, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    this.svg.append(made);
    return this;
  }
}
