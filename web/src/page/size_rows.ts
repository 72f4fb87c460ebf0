// Derived sizes as rows: converted into the unit that is shown, to the digits that a shop works with.

import { inShown, told } from "./amounts";
import type { LengthUnit, Size } from "./protocol";

export interface ShownSize {
  value: number | string | null;
  unit: string;
}

const POWERS: Record<string, number> = { "": 1, "^2": 2, "^3": 3, "^5": 5 };
const WORDS: Record<string, string> = { deg: "°", urad: "µrad", "1/in": "1/in", "": "" };
const DECIMALS: Record<string, number> = { mm: 3, "mm²": 2, in: 4, "in²": 4, "°": 4, "µrad": 3, "1/in": 4, "": 4 };

// A size in the unit that is shown; modules stay in mm and pitches per inch, as everybody names them.
export function shownSize(size: Size, unit: LengthUnit, ofModule = false): ShownSize {
  const [, length, power = ""] = /^(mm|in)(\^\d)?$/.exec(size.unit) ?? [];
  if (ofModule && length === "in" && typeof size.value === "number") return { value: inShown(size.value, 1, "in", "mm"), unit: "mm" };
  if (!length || ofModule) return { value: size.value, unit: WORDS[size.unit] ?? size.unit };
  const exponent = POWERS[power] ?? 1;
  const value = typeof size.value === "number" ? inShown(size.value, exponent, length as LengthUnit, unit) : size.value;
  return { value, unit: unit + ["", "", "²", "³", "⁴", "⁵"][exponent]! };
}

// Whether a size is a module, which is told in mm whatever lengths are told in.
export const isModule = (name: string) => /(^|_)module$/.test(name);

// A value to at least four digits that count, and to a fixed place where that is more.
export function toldSize({ value, unit }: ShownSize): string {
  if (value === null) return "–";
  if (typeof value === "string") return value;
  if (unit === "" && Number.isInteger(value)) return told(value, Math.max(1, `${Math.abs(value)}`.length));
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(value)));
  return told(value, Math.max(4, size + 1 + (DECIMALS[unit] ?? 4)));
}
