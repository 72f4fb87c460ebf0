// Numbers as engineers type them: "12,7", "1 1/2 in", "20°30'", "DP 8".

import type { LengthUnit } from "../protocol";

export const INCH = 25.4; // mm

export type Wanted = LengthUnit | "deg" | "per inch" | "";

// bare: whether no unit was named; other: the parameter that the words belong to, where it is another
export type Quantity = { value: number; bare: boolean; other?: "diametral_pitch" | "module" } | { problem: string };

const MILLIMETRES: Record<string, number> = {
  mm: 1, cm: 10, dm: 100, m: 1000, "µm": 1e-3, "μm": 1e-3, um: 1e-3,
  in: INCH, inch: INCH, inches: INCH, '"': INCH, "″": INCH, "”": INCH, mil: INCH / 1000, thou: INCH / 1000, ft: 12 * INCH,
};
const DEGREES: Record<string, number> = {
  deg: 1, degree: 1, degrees: 1, "°": 1, rad: 180 / Math.PI, "'": 1 / 60, "′": 1 / 60, "’": 1 / 60, min: 1 / 60,
};

const MEASURES: Record<Wanted, string> = { mm: "length", in: "length", deg: "angle", "per inch": "pitch", "": "plain number" };
const VULGAR: Record<string, string> = { "½": "1/2", "¼": "1/4", "¾": "3/4", "⅛": "1/8", "⅜": "3/8", "⅝": "5/8", "⅞": "7/8", "⅓": "1/3", "⅔": "2/3" };

const NUMBER = String.raw`\d+(?:[.,]\d*)?(?:e[+-]?\d+)?|[.,]\d+(?:e[+-]?\d+)?`;
const FRACTION = new RegExp(String.raw`^(?:(\d+)[ -]+)?(\d+)\s*/\s*(\d+)\s*`);
const PLAIN = new RegExp(`^(?:${NUMBER})`, "i");
const SEXAGESIMAL = new RegExp(
  String.raw`^(\d+)\s*(?:°|deg)\s*(${NUMBER})\s*(?:['′’]|min)\s*(?:(${NUMBER})\s*(?:"|″|”|''|sec)\s*)?$`, "i",
);
const FEET = new RegExp(String.raw`^(${NUMBER})\s*(?:'|′|’|ft|feet|foot)\s*(?:(\d[^"″”i]*)\s*(?:"|″|”|''|in|inch|inches)?)?$`, "i");

// The value of what was typed, in the wanted unit. ofTooth: whether it is for a module or a pitch, which name each other
export function quantity(typed: string, wanted: Wanted, ofTooth = false): Quantity {
  const text = typed.trim().replaceAll("−", "-").replace(/[\u00a0\u202f\u2009]/g, " ")
    .replace(/[½¼¾⅛⅜⅝⅞⅓⅔]/g, (sign) => ` ${VULGAR[sign]} `).trim();
  const pitch = /^(?:DP|Pd|P)\s*=?\s*(\d.*)$/i.exec(text) ?? /^(.+?)\s*DP$/i.exec(text);
  const module = /^(?:module|m)\s*=?\s*(\d.*)$/i.exec(text);
  if (ofTooth && pitch) return named(pitch[1]!, "per inch", "diametral_pitch", wanted);
  if (ofTooth && module) return named(module[1]!, "mm", "module", wanted);
  if (pitch || module) return { problem: `${text} is no ${MEASURES[wanted]}; it belongs to the module or the pitch of a gear` };
  const negative = text.startsWith("-");
  const found = magnitude(text.replace(/^[+-]\s*/, ""), wanted);
  return "problem" in found || !negative ? found : { ...found, value: -found.value };
}

// Feet and inches: 1' 6", 1 ft 6 1/2 in
function feet(text: string, wanted: LengthUnit): Quantity | null {
  const parts = FEET.exec(text);
  if (!parts) return null;
  const inches = parts[2] ? quantity(parts[2], "in") : { value: 0 };
  if ("problem" in inches) return inches;
  const found = 12 * decimal(parts[1]!) + inches.value;
  return { value: rounded(wanted === "in" ? found : found * INCH), bare: false };
}

function named(text: string, unit: Wanted, other: "diametral_pitch" | "module", wanted: Wanted): Quantity {
  const found = quantity(text, unit);
  if ("problem" in found) return found;
  return wanted === unit ? { ...found, bare: false } : { ...found, bare: false, other };
}

function magnitude(text: string, wanted: Wanted): Quantity {
  if (wanted === "deg") {
    const parts = SEXAGESIMAL.exec(text);
    if (parts) {
      const [degrees, minutes, seconds] = [parts[1]!, parts[2]!, parts[3] ?? "0"].map(decimal) as [number, number, number];
      return { value: rounded(degrees + minutes / 60 + seconds / 3600), bare: false };
    }
  }
  const whole = wanted === "mm" || wanted === "in" ? feet(text, wanted) : null;
  if (whole) return whole;
  const fraction = FRACTION.exec(text);
  const plain = PLAIN.exec(text);
  const head = fraction?.[0] ?? plain?.[0];
  if (head === undefined) return { problem: text ? "a number is needed, with a unit if you like" : "a number is needed" };
  const value = fraction ? Number(fraction[1] ?? 0) + Number(fraction[2]) / Number(fraction[3]) : decimal(head);
  const unit = text.slice(head.length).trim();
  if (!Number.isFinite(value)) return { problem: "a finite number is needed" };
  if (/^[\d.,' ]/.test(unit) && /\d/.test(unit)) return { problem: "one number without thousands' marks is needed, such as 1234.5" };
  return unit ? converted(value, unit, wanted) : { value: fraction ? rounded(value) : value, bare: !fraction };
}

function converted(value: number, unit: string, wanted: Wanted): Quantity {
  const lower = unit.toLowerCase();
  if (wanted === "deg") {
    const degrees = DEGREES[lower];
    return degrees ? { value: rounded(value * degrees), bare: false } : { problem: `${unit} is no unit of angle; deg, ' and rad are` };
  }
  if (wanted === "mm" || wanted === "in") {
    const length = MILLIMETRES[lower];
    if (!length) return { problem: `${unit} is no unit of length; mm, cm, µm and in are` };
    return { value: rounded((value * length) / (wanted === "in" ? INCH : 1)), bare: false };
  }
  if (wanted === "per inch" && ["1/in", "/in", "per inch", "per in"].includes(lower)) return { value, bare: false };
  return { problem: wanted ? "teeth per inch are needed, such as 8" : `a plain number is needed, without ${unit}` };
}

const decimal = (text: string) => Number(text.replace(",", "."));

// Without the noise that a conversion leaves in the last digits of a number that has few.
export function rounded(value: number): number {
  const short = Number(value.toPrecision(12));
  return Math.abs(short - value) <= 1e-14 * Math.abs(value) ? short : value;
}

// As a field shows it.
export const shown = (value: number) => `${Number(value.toPrecision(14))}`.replace(/^-/, "−").replace("e-", "e−");
