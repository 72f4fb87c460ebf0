// The form of a kind of element: what is needed first, the rest by topic; designs in and out.

import type { Api } from "../api";
import { applies, designOf, inUnit, unitOf, type Values, valuesOf } from "../design";
import { button, element, words } from "../dom";
import { memberNames } from "../kinds";
import type { Design, Kind, Parameter, Problem, Value } from "../protocol";
import type { Context } from "./editor";
import { Field } from "./field";
import { sizeOf } from "./ranges";

const TOGETHER = ["module", "diametral_pitch"]; // one of them is needed, so both stand first, and one takes the other's place

// changed: the design, or null where a field holds no value yet
export class DesignForm {
  readonly element: HTMLElement;
  private readonly fields: Field[];
  private readonly top = element("div", { class: "refusals" });
  private values: Values = {};

  constructor(readonly kind: Kind, api: Api, private readonly changed: (design: Design | null) => void) {
    const context: Context = {
      api,
      members: memberNames(kind),
      unit: () => (this.values.length_unit === "in" ? "in" : "mm"),
      scale: () => sizeOf(this.values, this.values.length_unit === "in" ? "in" : "mm"),
      put: (values) => this.put(values),
      problem: () => this.rethink(),
    };
    this.fields = kind.parameters.map((parameter) =>
      new Field(parameter, kind, context, (value) => this.take(parameter, value)));
    this.element = element("div", { class: "design-form" }, this.top, ...this.groups());
  }

  // Takes over a design without stealing the focus; what does not apply to it is remembered.
  set(design: Design): void {
    this.values = valuesOf(this.kind, design, this.values);
    for (const field of this.fields) {
      field.units(unitOf(design));
      field.set(this.values[field.parameter.name]);
    }
    this.hide();
  }

  // The server's words at the fields that they are about, the others on top.
  refuse(headline: string, problems: Problem[]): void {
    const known = new Set(this.fields.filter((field) => !field.element.hidden).map((field) => field.parameter.name));
    for (const field of this.fields) {
      const own = problems.filter((problem) => problem.parameter === field.parameter.name);
      field.refuse(own);
      if (own.length) field.element.closest("details")?.setAttribute("open", "");
    }
    const others = problems.filter((problem) => problem.parameter === null || !known.has(problem.parameter));
    const lines = others.map((problem) =>
      element("li", {}, problem.subject ? `${problem.subject}: ` : "", problem.message, this.removal(problem, known)));
    const told = headline && (lines.length > 0 || problems.length === 0); // else it is all at the fields
    this.top.replaceChildren(...(told ? [element("p", {}, headline), ...(lines.length ? [element("ul", {}, ...lines)] : [])] : []));
  }

  // What a field that is shown does not hold can only be left out.
  private removal(problem: Problem, known: Set<string>): HTMLElement | null {
    const names = Object.keys(this.values).filter((name) => !known.has(name));
    const name = names.find((one) => problem.parameter === one || problem.subject === one || problem.subject.startsWith(`${one} = `));
    return name === undefined ? null
      : button("leave it out", () => this.put({ [name]: undefined }), `Leave out ${words(name)}`, "removal");
  }

  // Problems that keep the form from being a design at all.
  get broken(): string[] {
    return this.fields.filter((field) => !field.element.hidden && field.problem !== null)
      .map((field) => `${field.parameter.name}: ${field.problem}`);
  }

  private take(parameter: Parameter, value: Value | undefined): void {
    if (parameter.name === "length_unit") this.convert(value === "in" ? "in" : "mm");
    const instead = TOGETHER.includes(parameter.name) && value !== undefined ? TOGETHER.filter((name) => name in this.values) : [];
    this.put({ ...Object.fromEntries(instead.map((name) => [name, undefined])), [parameter.name]: value }, parameter.name);
  }

  // The same part in another unit of length.
  private convert(to: "mm" | "in"): void {
    this.values = inUnit(this.kind, this.values, this.values.length_unit === "in" ? "in" : "mm", to);
    for (const field of this.fields) {
      field.units(to);
      if (field.parameter.name !== "length_unit") field.set(this.values[field.parameter.name]);
    }
  }

  // from: the field that gave them and shows them already
  private put(values: Record<string, Value | undefined>, from = ""): void {
    this.values = { ...this.values };
    for (const [name, value] of Object.entries(values)) {
      if (value === undefined) delete this.values[name];
      else this.values[name] = value;
      if (name !== from) this.fields.find((field) => field.parameter.name === name)?.set(value);
    }
    this.hide();
    this.rethink();
  }

  private rethink(): void {
    for (const field of this.fields) field.show();
    this.changed(this.broken.length ? null : designOf(this.kind, this.values));
  }

  private hide(): void {
    for (const field of this.fields) field.element.hidden = !applies(field.parameter, this.kind, this.values);
    for (const group of this.element.querySelectorAll("details")) {
      group.hidden = ![...group.querySelectorAll<HTMLElement>(".field")].some((field) => !field.hidden);
    }
  }

  private groups(): HTMLElement[] {
    const last = this.fields.filter((field) => field.parameter.name === "length_unit"); // says how to read those above
    const first = [...this.fields.filter((field) => this.leads(field.parameter) && !last.includes(field)), ...last];
    const rest = this.fields.filter((field) => !first.includes(field));
    const topics = [...new Set(rest.map((field) => field.parameter.topic))];
    return [
      element("div", { class: "needed" }, ...first.map((field) => field.element)),
      ...topics.map((topic) => element("details", {},
        element("summary", {}, topic || "Shape"),
        ...rest.filter((field) => field.parameter.topic === topic).map((field) => field.element))),
    ];
  }

  private leads(parameter: Parameter): boolean {
    return parameter.required || parameter.name in this.kind.start || TOGETHER.includes(parameter.name);
  }
}
