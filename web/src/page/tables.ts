// Sizes and volumetric properties as tables: a column a member, exact values beside those of the polyhedra.

import { called, partsOf } from "./amounts";
import { capital, element, symbol, words } from "./dom";
import { massTable } from "./mass_table";
import type { About, ApproximationAnswer, LengthUnit, PartDocument, Size, ValuesAnswer } from "./protocol";
import { isModule, shownSize, toldSize } from "./size_rows";
import "./data.css";

type Sizes = Record<string, Size>;

export function tables(hosts: { sizes: HTMLElement; mass: HTMLElement }) {
  const sizes = region("Sizes", hosts.sizes);
  const mass = region("Mass and inertia", hosts.mass);
  return {
    // about: the point that inertia is told about, null for the part's origin; mate: what a pair's second member is called
    show(values: ValuesAnswer, approximation: ApproximationAnswer | null, unit: LengthUnit, about: About = null, mate = "gear"): void {
      const parts = partsOf(values.document).filter(([, part]) => part.properties);
      const pair = (values.document as Record<string, PartDocument>).pair;
      sizes.replaceChildren(
        ...remarks(values.remarks),
        sizesTable(parts.length > 1 ? "Members" : "Sizes", parts.map(([name, part]) => [called(name, mate), part.sizes ?? {}]), unit),
        ...(pair?.sizes ? [sizesTable("Pair", [["", pair.sizes]], unit)] : []),
        ...(pair?.running ? [sizesTable("Running", [["", pair.running as Sizes]], unit)] : []),
      );
      const polyhedra = approximation?.parts ?? {};
      mass.replaceChildren(...parts.map(([name, part]) => {
        const polyhedron = name ? polyhedra[name] : Object.values(polyhedra)[0];
        return massTable(called(name, mate), part, polyhedron ?? null, unit, about);
      }));
    },
    clear(): void {
      sizes.replaceChildren();
      mass.replaceChildren();
    },
  };
}

// What scrolls sideways where it is narrow, by keys, too; it stays while tables come and go.
function region(label: string, host: HTMLElement): HTMLElement {
  const made = element("div", { class: "scrolls", role: "region", "aria-label": label, tabindex: "0" });
  host.append(made);
  return made;
}

function remarks(texts: string[]): HTMLElement[] {
  return texts.length ? [element("ul", { class: "remarks" }, ...texts.map((text) => element("li", {}, text)))] : [];
}

function sizesTable(title: string, columns: [name: string, sizes: Sizes][], unit: LengthUnit): HTMLElement {
  const names = [...new Set(columns.flatMap(([, sizes]) => Object.keys(sizes)))];
  const head = element("tr", {}, element("th", { scope: "col" }, "Size"), element("th", { scope: "col", class: "sign" }, "Symbol"),
    ...columns.map(([name]) => element("th", { scope: "col" }, capital(name || "value"))), element("th", { scope: "col", class: "unit" }, "Unit"));
  return element("table", { class: "values" }, element("caption", {}, title), element("thead", {}, head),
    element("tbody", {}, ...names.map((name) => sizeRow(name, columns, unit))));
}

function sizeRow(name: string, columns: [string, Sizes][], unit: LengthUnit): HTMLElement {
  const found = columns.map(([, sizes]) => sizes[name]);
  const first = found.find((size) => size !== undefined)!;
  const shown = found.map((size) => (size ? shownSize(size, unit, isModule(name)) : null));
  const cells = shown.map((size, i) => {
    const cell = element("td", {}, size ? toldSize(size) : "");
    if (size && typeof size.value === "number") cell.title = `${found[i]!.value} ${found[i]!.unit}`.trim();
    return cell;
  });
  return element("tr", {}, element("th", { scope: "row" }, capital(words(name))),
    element("td", { class: "sign" }, ...(first.symbol ? [symbol(first.symbol)] : [])), ...cells,
    element("td", { class: "unit" }, shown.find((size) => size !== null)!.unit));
}
