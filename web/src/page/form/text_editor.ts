// Words, and lists of numbers typed in a line.

import { element } from "../dom";
import type { Form, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import type { Naming } from "./number_editor";
import { quantity, shown } from "./quantity";

export function textEditor(words: string, naming: Naming, changed: Changed): Editor {
  const text = element("textarea", {
    rows: "1", spellcheck: "false", placeholder: words, ...(naming.id ? { id: naming.id } : { "aria-label": naming.label }),
  });
  const grow = () => {
    text.rows = Math.min(6, Math.max(1, Math.ceil(text.value.length / 34)));
  };
  text.addEventListener("input", () => {
    grow();
    changed(text.value.replaceAll("\n", " ").trim() || undefined);
  });
  return {
    element: text,
    inputs: [text],
    set(value: Value | undefined) {
      const given = typeof value === "string" ? value : "";
      if (given !== text.value.replaceAll("\n", " ").trim()) text.value = given;
      grow();
    },
    problem: () => null,
  };
}

// Numbers between spaces or semicolons, since a comma may be a decimal one.
export function listed(text: string): number[] | string {
  const parts = text.split(/[;\s]+/).filter(Boolean);
  const found: number[] = [];
  for (const part of parts) {
    const one = quantity(part.replace(/,$/, ""), "");
    if ("problem" in one) return `${part}: ${one.problem}`;
    found.push(one.value);
  }
  return found;
}

export function numbersEditor(form: Form & { form: "numbers" }, naming: Naming, context: Context, changed: Changed): Editor {
  let wrong: string | null = null;
  let given: number[] = [];
  const text = element("input", {
    type: "text", autocomplete: "off", spellcheck: "false", placeholder: "numbers, with spaces between",
    ...(naming.id ? { id: naming.id } : { "aria-label": naming.label }),
  });
  text.addEventListener("input", () => {
    const found = listed(text.value);
    wrong = typeof found === "string" ? found : found.length > form.most ? `at most ${form.most} numbers are possible` : null;
    if (!wrong) {
      given = found as number[];
      changed(given.length ? given : undefined);
    }
    context.problem();
  });
  return {
    element: text,
    inputs: [text],
    set(value: Value | undefined) {
      const numbers = Array.isArray(value) && value.every((one) => typeof one === "number") ? value : [];
      if (JSON.stringify(numbers) !== JSON.stringify(given) || wrong) text.value = numbers.map(shown).join("  ");
      [given, wrong] = [numbers, null];
    },
    problem: () => wrong,
  };
}
