// A value that is more than a number or a word: which form it has, and what that form needs.

import { capital, element, options, unique, words } from "../dom";
import { unitWord } from "../amounts";
import { formOf, type Values } from "../design";
import type { Form, Parameter, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import { fileEditor } from "./file_editor";
import type { Naming } from "./number_editor";
import { holeIn, isOutline } from "./inside";
import { pointsEditor } from "./points_editor";
import { numbersEditor, textEditor } from "./text_editor";

type Make = (parameter: Parameter, naming: Naming, context: Context, changed: Changed) => Editor;

export function formsEditor(forms: Form[], naming: Naming, context: Context, changed: Changed, make: Make): Editor {
  if (forms.length === 1) return formEditor(forms[0]!, naming, context, changed, make);
  let current: Editor | null = null;
  let form: Form | null = null;
  const kept = new Map<Form, Value | undefined>(); // what each form held, should it be chosen again
  const select = element("select", naming.id ? { id: naming.id } : { "aria-label": naming.label });
  options(select, [["", "not given"], ...forms.map((one, i): [string, string] => [`${i}`, titleOf(one)])]);
  const host = element("div", { class: "form-of" });
  const choose = (wanted: Form | null) => {
    form = wanted;
    select.value = wanted ? `${forms.indexOf(wanted)}` : "";
    current = wanted && formEditor(wanted, { label: naming.label }, context, (value) => {
      kept.set(wanted, value);
      changed(value);
    }, make);
    host.replaceChildren(...(current ? [current.element] : []));
  };
  select.addEventListener("change", () => {
    choose(select.value ? forms[Number(select.value)]! : null);
    const value = form ? kept.get(form) ?? exampleOf(form, context.scale()) : undefined;
    current?.set(value);
    if (form) kept.set(form, value);
    changed(value);
  });
  return {
    element: element("div", { class: "forms" }, select, host),
    get inputs() {
      return [select, ...(current?.inputs ?? [])];
    },
    set(value) {
      const wanted = value === undefined ? null : formOf(forms, value);
      if (wanted !== form && (wanted || value === undefined)) choose(wanted);
      if (form) kept.set(form, value);
      current?.set(value);
    },
    problem: () => current?.problem() ?? null,
  };
}

function formEditor(form: Form, naming: Naming, context: Context, changed: Changed, make: Make): Editor {
  switch (form.form) {
    case "file": return fileEditor(form, naming, context, changed);
    case "text": return textEditor(form.words, naming, changed);
    case "numbers": return numbersEditor(form, naming, context, changed);
    case "points": return pointsEditor(form, naming, context, changed);
    case "several": return severalEditor(form, naming, context, changed, make);
    case "table": return tableEditor(form, naming, context, changed, make);
  }
}

function tableEditor(
  form: Form & { form: "table" }, naming: Naming, context: Context, changed: Changed, make: Make,
): Editor {
  let values: Values = {};
  const drawn = form.entries.find((entry) => entry.required && entry.forms.some((one) => one.form === "points"));
  const inner: Context = { ...context, outline: () => (drawn ? values[drawn.name] : undefined) };
  const entries = form.entries.map((entry) => {
    const id = unique(entry.name);
    const editor = make(entry, { id, label: `${naming.label}, ${words(entry.name)}` }, inner, (value) => {
      values = { ...values };
      if (value === undefined) delete values[entry.name];
      else values[entry.name] = value;
      changed(values);
    });
    const unit = element("span", { class: "unit" }, unitWord(entry.unit, context.unit()));
    const label = element("label", { for: id, title: entry.meaning }, capital(words(entry.name)), " ", unit);
    return { entry, editor, unit, row: element("div", { class: "entry" }, label, editor.element) };
  });
  return {
    element: element("div", { class: "table-of", role: "group", "aria-label": naming.label }, ...entries.map(({ row }) => row)),
    inputs: entries.flatMap(({ editor }) => editor.inputs),
    set(value) {
      values = typeof value === "object" && value !== null && !Array.isArray(value) ? value : {};
      for (const { entry, editor, unit } of entries) {
        unit.textContent = unitWord(entry.unit, context.unit());
        editor.set(values[entry.name]);
      }
    },
    problem: () => entries.map(({ editor }) => editor.problem()).find((one) => one !== null) ?? null,
  };
}

function severalEditor(
  form: Form & { form: "several" }, naming: Naming, context: Context, changed: Changed, make: Make,
): Editor {
  let values: (Value | undefined)[] = [];
  let editors: Editor[] = [];
  const list = element("div");
  const add = element("button", { type: "button", ...(naming.id ? { id: naming.id } : {}), "aria-label": `Add one to ${naming.label}` }, "add one");
  const tell = () => changed(values.filter((value) => value !== undefined) as Value[]);
  const show = () => {
    editors = values.map((value, index) => {
      const editor = formEditor(form.of, { label: `${naming.label} ${index + 1}` }, context, (given) => {
        values[index] = given;
        tell();
      }, make);
      editor.set(value);
      return editor;
    });
    list.replaceChildren(...editors.map((editor, index) => {
      const remove = element("button", { type: "button", "aria-label": `Remove ${naming.label} ${index + 1}` }, "remove");
      remove.addEventListener("click", () => {
        values.splice(index, 1);
        show();
        tell();
        add.focus();
      });
      return element("div", { class: "one-of" }, editor.element, remove);
    }));
  };
  add.addEventListener("click", () => {
    const [outline, others] = [context.outline?.(), values.filter(isOutline)];
    values.push((isOutline(outline) ? holeIn(outline, others) : undefined) ?? exampleOf(form.of, 0.3 * context.scale()));
    show();
    tell();
  });
  return {
    element: element("div", { class: "several" }, list, add),
    get inputs() {
      return [add, ...editors.flatMap((editor) => editor.inputs)];
    },
    set(value) {
      const given = Array.isArray(value) ? value : [];
      const same = given.length === values.length;
      values = [...given];
      if (same) editors.forEach((editor, index) => editor.set(values[index]));
      else show();
    },
    problem: () => editors.map((editor) => editor.problem()).find((one) => one !== null) ?? null,
  };
}

function titleOf(form: Form): string {
  if (form.form === "file") return `a file (${form.suffixes.join(", ")})`;
  if (form.form === "points") return "points typed as a list";
  if (form.form !== "table") return form.words;
  const [key] = form.keys;
  if (key === "polygon") return "drawn section: polygon";
  if (key === "spline") return "drawn section: smooth curve";
  return key ? words(key) : `by ${form.entries.slice(0, 3).map((entry) => words(entry.name)).join(", ")} …`;
}

// Something to begin with, of about this size; undefined where nothing can be guessed.
export function exampleOf(form: Form, size: number): Value | undefined {
  const half = Number((size / 2).toPrecision(2));
  if (form.form === "points") {
    if (form.coordinates.length === 2) return [[-half, -half], [half, -half], [half, half], [-half, half]];
    const end = form.coordinates.map((_, i) => (i === form.coordinates.length - 1 ? size : 0));
    return [end.map(() => 0), end.map((one) => one / 2), end];
  }
  if (form.form !== "table") return undefined;
  const needed = form.entries.filter((entry) => entry.required).map((entry): [string, Value | undefined] => {
    if (entry.kind === "form") return [entry.name, exampleOf(entry.forms[0]!, size)];
    if (entry.kind === "choice") return [entry.name, entry.choices[0]];
    const one = entry.unit === "length" ? half : Math.max(1, entry.minimum ?? 1);
    return [entry.name, entry.components.length ? entry.components.map(() => one) : one];
  });
  return Object.fromEntries(needed.filter(([, value]) => value !== undefined)) as Value;
}
