// Volumetric properties of one part: exact, beside those of its polyhedron and by how much that one is off.

import { inShown, powerWord, told } from "./amounts";
import { capital, element, symbol } from "./dom";
import { clean, inertiaAbout, norm, type Tensor } from "./inertia";
import type { About, LengthUnit, PartDocument, Properties } from "./protocol";

interface Row {
  name: string;
  sign: string;
  unit: string;
  values: (number | null)[]; // in the unit that is shown; the exact one first
  scale: number; // what errors are measured by
  first: boolean; // of its group
}

interface Group {
  unit: string;
  scale: number;
  rows: [name: string, sign: string, values: (number | null)[]][];
}

const AXES = ["x", "y", "z"];
const PLACES: [string, number, number][] = [["xx", 0, 0], ["yy", 1, 1], ["zz", 2, 2], ["xy", 0, 1], ["yz", 1, 2], ["zx", 2, 0]];
const DIGITS = 8;
const FEWER = 6; // where there are more columns than two bodies need
const OFF = "Off by";
const OFF_MEANS = "Relative; of a point to the size of the part, of inertia to the norm of the tensor";
const MEANINGS: Record<string, string> = {
  Principal: "Principal moment of inertia about the centroid", Gyration: "Radius of gyration about a principal axis through the centroid",
  Product: "Minus the product of inertia", Inertia: "Moment of inertia about the point that is chosen",
};

type Body = Properties & { inertia: Tensor; central_inertia: Tensor; density: number; radii_of_gyration: number[]; error_bound: number | null };

export function massTable(
  name: string, part: PartDocument, approximation: Record<string, unknown> | null, unit: LengthUnit, about: About,
): HTMLElement {
  const exact = part.properties as Body;
  const beside = Object.entries((part.beside ?? {}) as Record<string, Body>);
  const polyhedron = approximation as Body | null;
  const bodies = [exact, ...beside.map(([, body]) => body), ...(polyhedron ? [polyhedron] : [])];
  const heads = ["Exact", ...beside.map(([of]) => capital(of)), ...(polyhedron ? ["Polyhedron", OFF] : [])];
  const head = element("tr", {}, element("th", { scope: "col" }, "Property"),
    ...heads.map((text) => element("th", { scope: "col", ...(text === OFF ? { title: OFF_MEANS } : {}) }, text)), element("th", { scope: "col", class: "unit" }, "Unit"));
  const rows = rowsOf(bodies, unit, about).map((row) => tableRow(row, polyhedron !== null, beside.length ? FEWER : DIGITS));
  return element("table", { class: beside.length ? "values mass many" : "values mass" }, caption(name, exact, about, unit), element("thead", {}, head),
    element("tbody", {}, ...rows));
}

// What a reader must know: density, the point, the signs.
function caption(name: string, body: Body, about: About, unit: LengthUnit): HTMLElement {
  const weighed = body.mass_unit === "kg";
  const density = weighed ? `Density ${plainly(body.density / (body.length_unit === "in" ? 0.0254 : 0.001) ** 3)} kg/m³.`
    : "Without a material the density is 1: mass is volume.";
  const bound = typeof body.error_bound === "number" ? ` Exact to ${told(Math.max(body.error_bound, 1e-16), 1)} at most.` : "";
  return element("caption", {}, capital(name || "Mass and inertia"),
    element("span", {}, `${density} Inertia about ${pointWords(about, body.length_unit, unit)}, axes along the part's; principal moments `
      + "about the centroid. Off the diagonal stand minus the products: ", symbol("I_xy"), ` = −∫xy dm.${bound}`));
}

// Without noughts that say nothing.
const plainly = (value: number) => told(value, 6).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");

function pointWords(about: About, from: LengthUnit, unit: LengthUnit): string {
  if (about === "centroid") return "the centroid";
  if (!Array.isArray(about)) return "the part's origin";
  return `the point (${about.map((x) => told(inShown(x, 1, from, unit), 6)).join(", ")}) ${unit}`;
}

function rowsOf(bodies: Body[], unit: LengthUnit, about: About): Row[] {
  return groups(bodies, unit, about).flatMap((group) =>
    group.rows.map(([name, sign, values], at) => ({ name, sign, values, unit: group.unit, scale: group.scale, first: at === 0 })));
}

function groups(bodies: Body[], unit: LengthUnit, about: About): Group[] {
  const exact = bodies[0]!;
  const weighed = exact.mass_unit === "kg";
  const length = (value: number, power: number) => inShown(value, power, exact.length_unit, unit);
  const moment = (value: number) => length(value, weighed ? 2 : 5);
  const momentUnit = weighed ? `kg\u2009${powerWord(unit, 2)}` : powerWord(unit, 5);
  const tensors = bodies.map((body) => inertiaAbout(body, about));
  const reach = Math.max(...exact.radii_of_gyration, ...exact.centroid.map(Math.abs));
  const one = (name: string, sign: string, its: string, of: (body: Body) => number | null): Group =>
    ({ unit: its, scale: Math.abs(of(exact) ?? 0), rows: [[name, sign, bodies.map(of)]] });
  const each = (names: [string, string][], its: string, scale: number, of: (at: number, body: number) => number): Group =>
    ({ unit: its, scale, rows: names.map(([name, sign], at) => [name, sign, bodies.map((_, body) => of(at, body))]) });
  return [
    one("Volume", "V", powerWord(unit, 3), (body) => length(body.volume, 3)),
    ...(weighed ? [one("Mass", "m", "kg", (body) => body.mass)] : []),
    ...(exact.area === null ? [] : [one("Surface", "A", powerWord(unit, 2), (body) => (body.area === null ? null : length(body.area, 2)))]),
    each(AXES.map((axis) => [`Centroid ${axis}`, ""]), unit, length(diagonal(exact), 1),
      (at, body) => length(clean(bodies[body]!.centroid[at]!, reach), 1)),
    each(PLACES.map(([place]) => [place[0] === place[1] ? "Inertia" : "", `I_${place}`]), momentUnit, moment(norm(tensors[0]!)),
      (at, body) => moment(tensors[body]![PLACES[at]![1]]![PLACES[at]![2]]!)),
    each([1, 2, 3].map((number) => ["Principal", `I_${number}`]), momentUnit, moment(norm(exact.central_inertia)),
      (at, body) => moment(bodies[body]!.principal_moments[at]!)),
    each([1, 2, 3].map((number) => ["Gyration", `k_${number}`]), unit, length(Math.max(...exact.radii_of_gyration), 1),
      (at, body) => length(bodies[body]!.radii_of_gyration[at]!, 1)),
  ];
}

function diagonal(body: Body): number {
  const box = body.bounding_box as number[][] | null;
  return box ? Math.hypot(...box[1]!.map((most, i) => most - box[0]![i]!)) : Math.hypot(...body.centroid) || 1;
}

function tableRow(row: Row, off: boolean, digits: number): HTMLElement {
  const cells = row.values.map((value) => {
    const cell = element("td", {}, value === null ? "–" : told(value, digits));
    if (value !== null) cell.title = `${value}`;
    return cell;
  });
  const [exact, last] = [row.values[0]!, row.values[row.values.length - 1]!];
  if (off) cells.push(element("td", { class: "off" }, exact === null || last === null ? "" : share(Math.abs(last - exact), row.scale)));
  const name = row.name || "Product";
  const head = element("th", { scope: "row", title: MEANINGS[name] ?? name }, name, ...(row.sign ? ["\u00a0", symbol(row.sign)] : []));
  return element("tr", row.first ? { class: "first" } : {}, head, ...cells,
    element("td", { class: "unit" }, row.unit));
}

// A part of a scale, as a power of ten where it is small; nought where it is rounding.
function share(error: number, scale: number): string {
  if (!(scale > 0) || error <= 1e-14 * scale) return "0";
  return `${told((100 * error) / scale, 2)}\u2009%`;
}
