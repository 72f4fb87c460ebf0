// A state as the part of the page's address after "#", for people to read and share, and back.

import type { Wish } from "./connection";
import type { About, Design, LengthUnit, Value } from "./protocol";

export interface State {
  design: Design;
  density: number | null; // kg/m³
  material: string | null;
  about: About;
  unit: LengthUnit | null; // shown; as the design where null
  tab: string; // "" for the first
}

export const plain = (design: Design): State =>
  ({ design, density: null, material: null, about: null, unit: null, tab: "" });

// #spur?teeth=16,40&module=3&~material=steel
export function hashOf(state: State): string {
  const { element, ...values } = state.design;
  const beside = {
    density: state.density, material: state.material, about: state.about, unit: state.unit, tab: state.tab || null,
  };
  const entries = [
    ...Object.entries(values).map(([name, value]) => [name, textOf(value)]),
    ...Object.entries(beside).filter(([, value]) => value !== null).map(([name, value]) => [`~${name}`, textOf(value as Value)]),
  ];
  return `#${escaped(element)}${entries.length ? "?" : ""}${entries.map(([n, t]) => `${escaped(n!)}=${escaped(t!)}`).join("&")}`;
}

// null where it is no state.
export function stateOf(hash: string): State | null {
  const match = /^#([^?&=]+)(?:\?(.*))?$/s.exec(hash);
  if (!match) return null;
  try {
    const state = plain({ element: bare(match[1]!) });
    for (const entry of (match[2] ?? "").split("&").filter(Boolean)) {
      const at = entry.indexOf("=");
      if (at < 1) return null;
      put(state, bare(entry.slice(0, at)), valueOf(bare(entry.slice(at + 1))));
    }
    return state;
  } catch {
    return null; // such as a broken escape
  }
}

function put(state: State, name: string, value: Value): void {
  if (!name.startsWith("~")) state.design[name] = value;
  else if (name === "~density" && typeof value === "number" && value > 0) state.density = value;
  else if (name === "~material" && typeof value === "string") state.material = value;
  else if (name === "~about" && (value === "origin" || value === "centroid" || isPoint(value))) state.about = value;
  else if (name === "~unit" && (value === "mm" || value === "in")) state.unit = value;
  else if (name === "~tab" && typeof value === "string") state.tab = value;
}

// Whether two designs are the same, with what they are made of and the point of reference.
export const sameWish = (a: Wish, b: Wish): boolean => hashOf({ ...plain(a.design), ...a }) === hashOf({ ...plain(b.design), ...b });

const isPoint = (value: Value): value is [number, number, number] =>
  Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number");

// Why an address is not shown, in words.
export function faultOf(hash: string): string {
  const beyond = /[=,[:+-](\d+(?:\.\d+)?(?:e[+-]?\d+)?)(?![\d.e])/gi;
  const number = [...hash.matchAll(beyond)].map(([, text]) => text!).find((text) => !Number.isFinite(Number(text)));
  return number ? `The address holds a number beyond all range: ${number}.` : "The address holds no design that is known here.";
}

const NUMBER = /^-?\d+(\.\d+)?(e[+-]?\d+)?$/i;

// A number or a word as it is, numbers with commas, all else as JSON.
function textOf(value: Value): string {
  const text = simple(value);
  return text !== null && comesBack(text, value) ? text : JSON.stringify(value);
}

function comesBack(text: string, value: Value): boolean {
  try {
    return same(valueOf(text), value);
  } catch {
    return false; // it begins as JSON does, and is none
  }
}

function simple(value: Value): string | null {
  if (typeof value === "string") return value;
  if (typeof value === "number") return String(value);
  if (!Array.isArray(value) || value.length < 2) return null;
  return value.every((one) => one === null || typeof one === "number") ? value.map((one) => one ?? "none").join(",") : null;
}

function valueOf(text: string): Value {
  if (NUMBER.test(text)) return finite(Number(text));
  if (/^[[{"]|^(true|false|null)$/.test(text)) return finite(JSON.parse(text) as Value);
  const parts = text.split(",");
  if (parts.length > 1 && parts.every((part) => part === "none" || NUMBER.test(part))) {
    return parts.map((part) => (part === "none" ? null : finite(Number(part))));
  }
  return text;
}

// Throws where a number in it is beyond all range.
function finite<T extends Value>(value: T): T {
  if (typeof value === "number" && !Number.isFinite(value)) throw new RangeError("beyond all range");
  if (typeof value === "object" && value !== null) Object.values(value).forEach((one) => finite(one));
  return value;
}

const same = (a: Value, b: Value) => JSON.stringify(a) === JSON.stringify(b);

const escaped = (text: string) =>
  encodeURIComponent(text).replace(/%(2C|3A|2F|7E|5B|5D|7B|7D|22)/gi, (code) => decodeURIComponent(code)).replaceAll("%20", "+");
const bare = (text: string) => decodeURIComponent(text.replaceAll("+", " "));
