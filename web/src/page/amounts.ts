// Numbers as a person reads them, in the unit that is shown.

import { INCH } from "./form/quantity";
import type { Document, LengthUnit, Parameter, PartDocument, Properties } from "./protocol";

// So many digits that count, thousands apart.
export function told(value: number, digits = 4): string {
  if (value === 0 || !Number.isFinite(value)) return `${value}`;
  const size = Math.floor(Math.log10(Math.abs(Number(value.toPrecision(digits)))));
  if (size < -4 || size > 11) return value.toExponential(digits - 1).replace("e+", "e").replaceAll("-", "−");
  const text = Number(value.toPrecision(digits)).toFixed(Math.max(0, digits - 1 - size));
  const [whole = "", part] = text.split(".");
  const apart = whole.replace(/\B(?=(\d{3})+$)/g, "\u202f").replace("-", "−");
  return part ? `${apart}.${part}` : apart;
}

// A length, an area, …: in the unit that is shown.
export function inShown(value: number, power: number, from: LengthUnit, to: LengthUnit): number {
  if (from === to) return value;
  return to === "in" ? value / INCH ** power : value * INCH ** power;
}

// The unit that a parameter is given in, as it is shown.
export const unitWord = (unit: Parameter["unit"], length: LengthUnit) =>
  ({ length, angle: "°", mm: "mm", "per inch": "1/in", "": "" })[unit];

export const powerWord = (unit: LengthUnit, power: number) => `${unit}${["", "", "²", "³", "⁴", "⁵"][power] ?? ""}`;

// The parts of a document, by their names; "" for one that stands alone.
export function partsOf(document: Document): [name: string, part: PartDocument][] {
  if ("properties" in document || "sizes" in document) return [["", document as PartDocument]];
  return Object.entries(document as Record<string, PartDocument>)
    .filter(([, part]) => typeof part === "object" && part !== null && ("properties" in part || "sizes" in part));
}

// What people call a part. mate: what they call the second of a pair
export const called = (name: string, mate: string) => (name === "gear" ? mate : name);

// "Volume 41 230 mm³, mass 0.324 kg", of each part.
export function summary(document: Document, unit: LengthUnit, mate = "gear"): string {
  const told_ = partsOf(document).filter(([, part]) => part.properties)
    .map(([name, part]) => `${name ? `${called(name, mate)}: volume` : "Volume"} ${ofOne(part.properties!, unit)}`);
  const text = told_.join("; ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function ofOne(properties: Properties, unit: LengthUnit): string {
  const volume = inShown(properties.volume, 3, properties.length_unit, unit);
  const mass = properties.mass_unit === "kg" ? `, mass ${told(properties.mass, 3)} kg` : "";
  return `${told(volume)} ${powerWord(unit, 3)}${mass}`;
}
