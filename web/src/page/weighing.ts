// What the part is made of, and about which point its inertia is told.

import { element, options, unique } from "./dom";
import { quantity, shown } from "./form/quantity";
import type { About, LengthUnit, Material, Point } from "./protocol";

export interface Weight {
  density: number | null; // kg/m³
  material: string | null;
  about: About;
}

const POUND = 0.45359237; // kg
const [IN3, FT3] = [0.0254 ** 3, 0.3048 ** 3]; // m³
const UNITS: Record<string, number> = {
  "kg/m3": 1, "g/cm3": 1000, "g/cc": 1000, "g/ml": 1000, "kg/dm3": 1000, "kg/l": 1000, "lb/in3": POUND / IN3, "lb/ft3": POUND / FT3,
};

// kg/m³ of what was typed; a text that says what is wrong with it
export function density(typed: string): number | string {
  const [, number = "", unit = ""] = /^(.*?)\s*((?:kg|g|lb)\s*\/.*)?$/i.exec(typed.trim()) ?? [];
  const factor = unit ? UNITS[unit.replaceAll(" ", "").replace(/³|\^3/, "3").toLowerCase()] : 1;
  if (!factor) return `${unit} is no unit of density; kg/m³, g/cm³, kg/dm³, lb/in³ and lb/ft³ are`;
  const found = quantity(number, "");
  if ("problem" in found) return found.problem;
  return found.value > 0 ? Number((found.value * factor).toPrecision(12)) : "must be greater than 0";
}

// A doubt about a number that is hardly one of kg/m³: most handbooks tell g/cm³.
export function lightness(typed: string): string {
  const found = density(typed);
  return typeof found === "number" && found < LIGHTEST && /^[\d.,\s]*$/.test(typed)
    ? `${shown(found)} kg/m³ is lighter than any solid; if g/cm³ is meant, type ${shown(found)} g/cm³.` : "";
}

const LIGHTEST = 25; // kg/m³; but for foams
const TYPED = "typed";

export class Weighing {
  readonly element: HTMLElement;
  private readonly material = element("select", { id: unique("material") });
  private readonly density = element("input", { id: unique("density"), type: "text", autocomplete: "off", placeholder: "7850, or 7.85 g/cm³" });
  private readonly about = element("select", { id: unique("about") });
  private readonly coordinates = ["x", "y", "z"].map((axis) =>
    element("input", { type: "text", autocomplete: "off", "aria-label": `${axis} of the point`, placeholder: axis }));
  private readonly typed: HTMLElement;
  private readonly lengths = element("span", { class: "unit" });
  private readonly point: HTMLElement;
  private readonly wrong = element("p", { class: "problem", id: unique("weight-problem") });
  private readonly origin = element("p", { class: "hint" });
  private readonly light = element("p", { class: "hint", role: "status" });
  private weight: Weight = { density: null, material: null, about: null };

  constructor(materials: Material[], private readonly unit: () => LengthUnit, private readonly changed: (weight: Weight) => void) {
    options(this.material, [["", "none: density 1"],
      ...materials.map((one): [string, string] => [one.name, `${one.name} (${one.density} kg/m³)`]), [TYPED, "another density …"]]);
    options(this.about, [["", "the part's origin"], ["centroid", "its centroid"], ["point", "a point …"]]);
    this.typed = element("div", { class: "field" },
      element("div", { class: "title" }, element("label", { for: this.density.id }, "Density ", element("i", {}, "ρ")),
        element("span", { class: "unit" }, "kg/m³")), this.density, this.light);
    const units = element("div", { class: "title" }, element("span", {}, "Point"), this.lengths);
    this.point = element("div", { class: "field" }, units,
      element("div", { class: "point", role: "group", "aria-label": "Point of reference" }, ...this.coordinates));
    this.element = element("div", { class: "weighing" },
      element("div", { class: "field" }, element("label", { for: this.material.id }, "Material"), this.material), this.typed,
      element("div", { class: "field" }, element("label", { for: this.about.id }, "Inertia about"), this.about), this.point,
      this.wrong, this.origin);
    this.material.addEventListener("change", () => this.take());
    this.about.addEventListener("change", () => this.take());
    for (const input of [this.density, ...this.coordinates]) input.addEventListener("input", () => this.take());
    this.set(this.weight, "");
  }

  // origin: where the part's origin is, in words
  set(weight: Weight, origin: string): void {
    this.weight = weight;
    this.material.value = weight.material ?? (weight.density !== null ? TYPED : "");
    if (weight.density !== null && density(this.density.value) !== weight.density) this.density.value = shown(weight.density);
    const about = weight.about;
    this.about.value = Array.isArray(about) ? "point" : about === "centroid" ? "centroid" : "";
    if (Array.isArray(about)) this.coordinates.forEach((input, i) => {
      const now = quantity(input.value, this.unit());
      if (!("value" in now) || now.value !== about[i]) input.value = shown(about[i]!);
    });
    this.origin.textContent = origin ? `Origin: ${origin}.` : "";
    this.arrange();
  }

  // The unit that a point is typed in.
  units(): void {
    this.lengths.textContent = this.unit();
  }

  private arrange(): void {
    this.units();
    this.typed.hidden = this.material.value !== TYPED;
    this.point.hidden = this.about.value !== "point";
    this.light.textContent = lightness(this.density.value);
    this.tell("", []);
  }

  // A field that holds no value leaves the last one in force, and says so; the others count all the same.
  private take(): void {
    this.arrange();
    const { material, density, wrong } = this.matter();
    const point = this.reference();
    this.weight = { density, material, about: point.about };
    if (wrong) this.tell(wrong, [this.density]);
    else if (point.wrong) this.tell(point.wrong, [point.at!]);
    this.changed(this.weight);
  }

  private matter(): { density: number | null; material: string | null; wrong?: string } {
    if (this.material.value !== TYPED) return { density: null, material: this.material.value || null };
    const found = this.density.value.trim() ? density(this.density.value) : "a density is needed";
    if (typeof found === "number") return { density: found, material: null };
    const { density: last, material } = this.weight;
    const of = last !== null ? `${shown(last)} kg/m³` : material ?? "density 1";
    return { density: last, material, wrong: `${found}; the masses are still those of ${of}` };
  }

  private reference(): { about: About; wrong?: string; at?: HTMLElement } {
    if (this.about.value !== "point") return { about: this.about.value === "centroid" ? "centroid" : null };
    const found = this.coordinates.map((input) => quantity(input.value || "0", this.unit()));
    const bad = found.findIndex((one) => "problem" in one);
    if (bad < 0) return { about: found.map((one) => ("value" in one ? one.value : 0)) as Point };
    const { about } = this.weight;
    const of = about === null ? "the part's origin" : about === "centroid" ? "the centroid" : "the point before";
    return { about, wrong: `${"xyz"[bad]}: ${(found[bad] as { problem: string }).problem}; inertia is still about ${of}`, at: this.coordinates[bad]! };
  }

  private tell(text: string, at: HTMLElement[]): void {
    this.wrong.textContent = text;
    this.wrong.hidden = !text;
    for (const input of [this.density, ...this.coordinates]) {
      if (at.includes(input)) {
        input.setAttribute("aria-invalid", "true");
        input.setAttribute("aria-describedby", this.wrong.id);
      } else {
        input.removeAttribute("aria-invalid");
        input.removeAttribute("aria-describedby");
      }
    }
  }
}
