// What a slider goes from and to: sensible for the hand, within the limits, and around the value.

import type { Parameter } from "../protocol";

export interface Range {
  least: number;
  most: number;
  step: number;
}

const USUAL: Record<string, [number, number]> = {
  profile_shift: [-1, 1], thickness_modification: [-0.5, 0.5], pressure_angle: [10, 35], helix_angle: [-45, 45],
  spiral_angle: [0, 50], addendum_coefficient: [0.5, 1.5], dedendum_coefficient: [0.8, 1.8], rack_tip_coefficient: [0.05, 0.5],
  shaft_angle: [30, 150], twist: [-360, 360], angle: [5, 360], scale: [0.1, 2], vertices: [3, 400], diametral_pitch: [2, 48],
  turns: [0.25, 10], web_holes: [3, 12],
};
const FINE = ["backlash", "tip_relief", "crowning", "chamfer", "tip_radius", "fillet_radius"]; // parts of a tooth
const SPEC = 240; // steps of a slider, at least

// scale: how large the design is, in its own unit of length; value: null where none is given
export function range(parameter: Parameter, value: number | null, scale: number): Range {
  const lower = parameter.above ?? parameter.minimum;
  const upper = parameter.maximum ?? parameter.below;
  const size = Math.abs(value ?? (typeof parameter.default === "number" ? parameter.default : 0));
  let [least, most] = USUAL[parameter.name] ?? spread(parameter, size, scale);
  if (value !== null && value < least) least = value > 0 ? 0 : -up(-1.25 * value);
  if (value !== null && value > most) most = value < 0 ? 0 : up(1.25 * value);
  if (lower !== null) least = Math.max(least, lower);
  if (upper !== null) most = Math.min(most, upper);
  const step = parameter.kind === "integer" ? 1 : nice((most - least) / SPEC);
  if (parameter.above !== null && least <= parameter.above) least = parameter.above + step;
  if (parameter.below !== null && most >= parameter.below) most = parameter.below - step;
  return { least, most: Math.max(most, least + step), step };
}

function spread(parameter: Parameter, size: number, scale: number): [number, number] {
  const signed = parameter.above === null && parameter.minimum === null;
  if (parameter.kind === "integer") return [parameter.minimum ?? 0, Math.max(60, up(2 * size))];
  if (parameter.unit === "angle") return signed ? [-Math.max(90, size), Math.max(90, size)] : [0, Math.max(90, size)];
  let most = 2.5 * size;
  if (parameter.unit === "length") {
    const usual = FINE.some((word) => parameter.name.includes(word)) ? 0.02 * scale : 0.8 * scale;
    most = size > 0 ? Math.max(most, usual / 4) : usual;
  } else if (size === 0) most = parameter.unit ? 10 : 1;
  most = up(most);
  return [signed ? -most : 0, most];
}

// The next number of one digit and a half: 1, 1.5, 2, 2.5, 3, 4, …
function up(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((one) => one * power >= value * (1 - 1e-12)) ?? 10;
  return Number((digit * power).toPrecision(3));
}

// The next step down of 1, 2 or 5.
function nice(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = [5, 2, 1].find((one) => one * power <= value * (1 + 1e-12)) ?? 1;
  return Number((digit * power).toPrecision(3));
}

// The size of a design: its largest length, its pitch diameters among them.
export function sizeOf(values: Record<string, unknown>, unit: "mm" | "in"): number {
  const numbers = (value: unknown): number[] =>
    Array.isArray(value) ? value.flatMap(numbers) : typeof value === "number" ? [Math.abs(value)] : [];
  const teeth = Math.max(0, ...numbers(values.teeth));
  const [module] = numbers(values.module);
  const [pitch] = numbers(values.diametral_pitch);
  const tooth = module ?? (pitch ? 25.4 / pitch : 0);
  const lengths = ["face_width", "base_radius", "thickness", "length", "lift"].flatMap((name) => numbers(values[name]));
  return Math.max((tooth * teeth) / (unit === "in" ? 25.4 : 1), ...lengths) || (unit === "in" ? 1 : 20);
}
