// Points as rows to type, and, where they lie in a plane, as a drawing to pull at.

import { button, element } from "../dom";
import type { Form, Value } from "../protocol";
import { Drawing } from "./drawing";
import type { Changed, Context, Editor } from "./editor";
import type { Naming } from "./number_editor";
import { quantity, shown } from "./quantity";

type Row = number[];

// Rows of text: coordinates with spaces, semicolons, tabs, or commas and a space between.
export function rowsOf(text: string, coordinates: string[], unit: "mm" | "in"): Row[] | string {
  const rows: Row[] = [];
  for (const [index, line] of text.split("\n").entries()) {
    if (!line.trim()) continue;
    const parts = split(line.trim(), coordinates.length);
    const found = parts.map((part) => quantity(part, unit));
    const bad = found.find((one) => "problem" in one);
    if (parts.length !== coordinates.length || bad) return `row ${index + 1}: ${coordinates.join(", ")} are needed, such as ${coordinates.map((_, i) => 10 * i).join(", ")}`;
    rows.push(found.map((one) => ("value" in one ? one.value : 0)));
  }
  return rows;
}

// A design's value as rows; none where it is anything but points of so many finite numbers.
export function rowsGiven(value: Value | undefined, count: number): Row[] {
  const isRow = (row: Value): row is Row =>
    Array.isArray(row) && row.length === count && row.every((one) => typeof one === "number" && Number.isFinite(one));
  return Array.isArray(value) && value.every(isRow) ? value.map((row) => [...row]) : [];
}

// "1,5 2" and "1.5, 2" and "1.5,2" are all two numbers.
function split(line: string, count: number): string[] {
  const ways = [/\s*;\s*/, /,?\s+/, /\s*[,;]\s*|\s+/].map((mark) => line.split(mark).filter(Boolean));
  return ways.find((parts) => parts.length === count) ?? ways[2]!;
}

export function pointsEditor(form: Form & { form: "points" }, naming: Naming, context: Context, changed: Changed): Editor {
  let wrong: string | null = null;
  let rows: Row[] = [];
  const text = element("textarea", {
    rows: "5", spellcheck: "false", placeholder: form.coordinates.join(", "),
    ...(naming.id ? { id: naming.id } : {}), "aria-label": `${naming.label}: one point a row, ${form.coordinates.join(", ")}`,
  });
  const write = () => {
    text.value = rows.map((row) => row.map(shown).join(", ")).join("\n");
    text.rows = Math.min(12, Math.max(4, rows.length + 1));
  };
  const tell = () => {
    wrong = rows.length < form.least ? `at least ${form.least} points are needed` : null;
    context.problem();
    if (!wrong) changed(rows.map((row) => [...row]));
  };
  const drawing = form.coordinates.length === 2
    ? new Drawing(naming.label, context.unit, (points) => {
      rows = points;
      write();
      tell();
    })
    : null;
  text.addEventListener("input", () => {
    const found = rowsOf(text.value, form.coordinates, context.unit());
    if (typeof found === "string") {
      wrong = found;
      context.problem();
      return;
    }
    rows = found;
    drawing?.show(rows as [number, number][]);
    tell();
  });
  const clear = button("clear", () => {
    rows = [];
    write();
    drawing?.show([]);
    tell();
  }, `Clear ${naming.label}`);
  return {
    element: element("div", { class: "points" }, drawing?.element ?? null, text, clear),
    inputs: [text],
    set(value: Value | undefined) {
      const given = rowsGiven(value, form.coordinates.length);
      if (JSON.stringify(given) === JSON.stringify(rows) && !wrong) return;
      [rows, wrong] = [given, null];
      write();
      drawing?.show(rows as [number, number][]);
    },
    problem: () => wrong,
  };
}
