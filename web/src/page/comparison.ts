// Two designs beside each other: what they have in common, and by how much it differs.

import { inShown, partsOf, powerWord, told } from "./amounts";
import { capital, element, words } from "./dom";
import type { Document, LengthUnit, PartDocument } from "./protocol";
import { isModule } from "./size_rows";

export interface Line {
  part: string;
  name: string;
  unit: string;
  a: number | null;
  b: number | null;
}

type Found = Map<string, { part: string; name: string; unit: string; value: number }>;

// What either of them has, in the order of the first.
export function lines(a: Document, b: Document, unit: LengthUnit): Line[] {
  const [one, other] = [amounts(a, unit), amounts(b, unit)];
  return [...new Set([...one.keys(), ...other.keys()])].map((key) => {
    const { part, name, unit: its } = (one.get(key) ?? other.get(key))!;
    return { part, name, unit: its, a: one.get(key)?.value ?? null, b: other.get(key)?.value ?? null };
  });
}

function amounts(document: Document, unit: LengthUnit): Found {
  const found: Found = new Map();
  for (const [part, one] of partsOf(document)) {
    const put = (name: string, value: unknown, its: string) => {
      if (typeof value === "number") found.set(`${part}/${name}`, { part, name: words(name), unit: its, value });
    };
    for (const [name, size] of Object.entries(one.sizes ?? {})) {
      const power = ["", "mm", "mm^2", "mm^3"].indexOf(size.unit.replace(/^in/, "mm"));
      if (power > 0 && typeof size.value === "number") {
        const to = isModule(name) ? "mm" : unit;
        put(name, inShown(size.value, power, size.unit.startsWith("in") ? "in" : "mm", to), powerWord(to, power));
      } else put(name, size.value, size.unit === "deg" ? "°" : size.unit);
    }
    properties(one, unit, put);
  }
  return found;
}

function properties(part: PartDocument, unit: LengthUnit, put: (name: string, value: unknown, unit: string) => void): void {
  const given = part.properties;
  if (!given) return;
  const length = (value: number, power: number) => inShown(value, power, given.length_unit, unit);
  const mass = given.mass_unit;
  const weighed = mass === "kg";
  put("volume", length(given.volume, 3), powerWord(unit, 3));
  if (given.area !== null) put("surface", length(given.area, 2), powerWord(unit, 2));
  if (weighed) put("mass", given.mass, mass);
  given.centroid.forEach((x, i) => put(`centroid ${"xyz"[i]}`, length(x, 1), unit));
  if (weighed) {
    given.principal_moments.forEach((moment, i) =>
      put(`principal moment ${i + 1}`, length(moment, 2), `${mass}\u2009${powerWord(unit, 2)}`));
  }
}

export class Comparison {
  private readonly differing = element("input", { type: "checkbox" });
  private readonly tables = element("div");
  readonly element = element("div", { class: "comparison" },
    element("label", { class: "only" }, this.differing, " only what differs"), this.tables);
  private given: [Document | null, Document | null, LengthUnit, string] = [null, null, "mm", ""];

  constructor() {
    this.differing.addEventListener("change", () => this.show(...this.given));
  }

  // why: why values are not there; "" where they are on their way
  show(a: Document | null, b: Document | null, unit: LengthUnit, why = ""): void {
    this.given = [a, b, unit, why];
    if (!a || !b) {
      this.tables.replaceChildren(element("p", { class: "hint" }, why || "Values follow."));
      return;
    }
    const all = lines(a, b, unit).filter((line) => !this.differing.checked || change(line) !== 0);
    const parts = [...new Set(all.map((line) => line.part))];
    this.tables.replaceChildren(...parts.map((part) => table(part, all.filter((line) => line.part === part))),
      ...(all.length ? [] : [element("p", { class: "hint" }, "Nothing differs.")]));
  }
}

// By how much they differ; null where one of them has no such thing. What rounding leaves is nothing.
function change({ a, b }: Line): number | null {
  if (a === null || b === null) return null;
  return Math.abs(a - b) <= 1e-12 * Math.max(Math.abs(a), Math.abs(b)) ? 0 : a - b;
}

function table(part: string, lines: Line[]): HTMLElement {
  const head = ["", "A, being edited", "B, pinned", "A − B", "unit"].map((text) => element("th", { scope: "col" }, text));
  const rows = lines.map((line) => {
    const by = change(line);
    const cells = [line.a, line.b, by].map((value) => element("td", {}, value === null ? "–" : value === 0 ? "0" : told(value, 5)));
    if (by) cells[2]!.className = "changed";
    return element("tr", {}, element("th", { scope: "row" }, capital(line.name)), ...cells, element("td", { class: "unit" }, line.unit));
  });
  return element("table", {}, element("caption", {}, capital(part || "part")), element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...rows));
}
