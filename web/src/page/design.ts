// What the form holds and the design that it makes; lengths in another unit.

import type { About, Design, Form, Kind, LengthUnit, Parameter, Value } from "./protocol";
import { INCH, rounded } from "./form/quantity";

export type Values = Record<string, Value>; // by the parameters' names; those that were not given are not there

// Whether a parameter applies beside the choices of the others.
export function applies(parameter: Parameter, kind: Kind, values: Values): boolean {
  return Object.entries(parameter.only).every(([name, words]) => {
    const other = kind.parameters.find((one) => one.name === name);
    if (!other) return true; // settled by the kind, which lists only what applies to it
    const chosen = values[name] ?? other.default;
    const all = Array.isArray(chosen) ? chosen : [chosen];
    return all.some((one) => words.includes(one as string));
  });
}

// The design of what was given and applies, in the order of the parameters; names unknown to the kind stay.
export function designOf(kind: Kind, values: Values): Design {
  const design: Design = { element: kind.command };
  for (const parameter of kind.parameters) {
    const value = values[parameter.name];
    if (value !== undefined && applies(parameter, kind, values)) design[parameter.name] = value;
  }
  const known = new Set(kind.parameters.map((parameter) => parameter.name));
  for (const [name, value] of Object.entries(values)) if (!known.has(name)) design[name] = value;
  return design;
}

// A design's values; those of kept that do not apply to it are remembered.
export function valuesOf(kind: Kind, design: Design, kept: Values = {}): Values {
  const { element: _, ...values } = design;
  const found: Values = { ...values };
  for (const parameter of kind.parameters) {
    const value = kept[parameter.name];
    if (value !== undefined && !(parameter.name in found) && !applies(parameter, kind, found)) found[parameter.name] = value;
  }
  return found;
}

export const unitOf = (design: Design): LengthUnit => (design.length_unit === "in" ? "in" : "mm");

// The same lengths in another unit.
export function inUnit(kind: Kind, values: Values, from: LengthUnit, to: LengthUnit): Values {
  if (from === to) return values;
  const factor = to === "in" ? 1 / INCH : INCH;
  const found = Object.fromEntries(Object.entries(values).map(([name, value]) => {
    const parameter = kind.parameters.find((one) => one.name === name);
    return [name, parameter ? scaled(parameter, value, factor) : value];
  }));
  return { ...found, length_unit: to };
}

// The same point of reference beside a design in another unit.
export function aboutIn(about: About, from: LengthUnit, to: LengthUnit): About {
  if (from === to || !Array.isArray(about)) return about;
  return times(about, to === "in" ? 1 / INCH : INCH) as About;
}

function scaled(parameter: Parameter, value: Value, factor: number): Value {
  if (parameter.unit === "length") return times(value, factor);
  const form = parameter.kind === "form" ? formOf(parameter.forms, value) : null;
  return form ? scaledForm(form, value, factor) : value;
}

function scaledForm(form: Form, value: Value, factor: number): Value {
  if (form.form === "points") return times(value, factor);
  if (form.form === "several") return (value as Value[]).map((one) => scaledForm(form.of, one, factor));
  if (form.form !== "table" || typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value as Values).map(([name, entry]) => {
    const parameter = form.entries.find((one) => one.name === name);
    return [name, parameter ? scaled(parameter, entry, factor) : entry];
  }));
}

function times(value: Value, factor: number): Value {
  if (Array.isArray(value)) return value.map((one) => times(one, factor));
  return typeof value === "number" ? rounded(value * factor) : value;
}

// The form that a value is meant to have.
export function formOf(forms: Form[], value: Value | undefined): Form | null {
  return forms.find((form) => {
    if (form.form === "file" || form.form === "text") return typeof value === "string";
    if (form.form === "table") {
      return typeof value === "object" && value !== null && !Array.isArray(value) && form.keys.every((key) => key in value);
    }
    return Array.isArray(value);
  }) ?? null;
}
