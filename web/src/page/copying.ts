// A design to copy: its values as text for a spreadsheet or as JSON, itself as TOML, Python or a command line.

import { capital, button, element, words } from "./dom";
import { partsOf } from "./amounts";
import type { Document, PartDocument, Size, ValuesAnswer } from "./protocol";

type Kind = "text" | "json" | "toml" | "python" | "command";

const KINDS: Record<Kind, [title: string, said: string]> = {
  command: ["Command line", "the command line"],
  toml: ["TOML", "TOML"],
  python: ["Python", "Python"],
  json: ["JSON", "the values as JSON"],
  text: ["Table", "the values as a table"],
};

// current: whether the values are of the design as it is typed
export function copying(host: HTMLElement, current: () => boolean = () => true) {
  let values: ValuesAnswer | null = null;
  const said = element("p", { class: "hint", role: "status" });
  const shown = element("pre", { tabindex: "0", "aria-label": "What was copied" });
  const buttons = (Object.keys(KINDS) as Kind[]).map((kind) =>
    button(KINDS[kind][0], () => void copy(kind), `Copy ${KINDS[kind][1]}`));
  const made = element("section", { class: "copies", "aria-label": "Copy" }, element("h2", {}, "Copy"),
    element("p", { class: "hint" }, "The design as a file, code or a command; its values to the last digit for a spreadsheet or a program."),
    element("div", { class: "buttons" }, ...buttons), said, shown);
  made.hidden = shown.hidden = true;
  host.append(made);

  async function copy(kind: Kind): Promise<void> {
    if (!values) return;
    if (!current()) {
      said.textContent = "Not copied: what is typed is not built yet, or cannot be.";
      shown.hidden = true;
      return;
    }
    const text = textOf(kind, values);
    said.textContent = "";
    const done = await copied(text);
    said.textContent = done ? `Copied ${KINDS[kind][1]}.` : "The browser does not let the page copy; take it from here.";
    shown.textContent = text.length > 20_000 ? `${text.slice(0, 20_000)}\n…` : text;
    shown.hidden = false;
  }

  return {
    show(answer: ValuesAnswer): void {
      values = answer;
      made.hidden = false;
    },
    clear(): void {
      values = null;
      made.hidden = shown.hidden = true;
      said.textContent = "";
    },
  };
}

export function textOf(kind: Kind, values: ValuesAnswer): string {
  if (kind === "json") return `${JSON.stringify(values.document, null, 2)}\n`;
  return kind === "text" ? table(values.document) : values.texts[kind];
}

// A row a value: part, name, symbol, value in full, unit; apart by tabs, as spreadsheets take them.
export function table(document: Document): string {
  const rows = [["part", "name", "symbol", "value", "unit"]];
  for (const [part, one] of partsOf(document)) {
    for (const group of [one.sizes, one.running as Record<string, Size> | undefined]) {
      for (const [name, size] of Object.entries(group ?? {})) {
        rows.push([part, capital(words(name)), size.symbol, `${size.value ?? ""}`, size.unit]);
      }
    }
    rows.push(...properties(part, one));
  }
  return rows.map((row) => `${row.join("\t")}\n`).join("");
}

function properties(part: string, one: PartDocument): string[][] {
  const given = one.properties;
  if (!given) return [];
  const [length, mass] = [given.length_unit, given.mass_unit];
  const moment = mass === "kg" ? `kg ${length}^2` : `${length}^5`;
  const row = (name: string, value: unknown, unit: string) => [part, name, "", `${value ?? ""}`, unit];
  const axes = ["x", "y", "z"];
  const tensor = (name: string, about: string) => ((given[name] ?? []) as number[][]).flatMap((line, i) =>
    line.flatMap((value, j) => (j < i ? [] : [row(`Inertia I${axes[i]}${axes[j]} about the ${about}`, value, moment)])));
  return [
    row("Volume", given.volume, `${length}^3`),
    row("Mass", given.mass, mass),
    row("Surface", given.area, `${length}^2`),
    ...given.centroid.map((value, i) => row(`Centroid ${axes[i]}`, value, length)),
    ...tensor("inertia", "origin"),
    ...tensor("central_inertia", "centroid"),
    ...given.principal_moments.map((value, i) => row(`Principal moment ${i + 1}`, value, moment)),
    ...((given.radii_of_gyration ?? []) as number[]).map((value, i) => row(`Radius of gyration ${i + 1}`, value, length)),
  ];
}

// Whether it is in the clipboard; where pages may not write there, by a field that is copied from.
export async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const had = document.activeElement;
    const field = element("textarea", { class: "unseen", "aria-hidden": "true", tabindex: "-1" });
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    if (had instanceof HTMLElement) had.focus();
    return done;
  }
}
