// A file that is handed to the server; what stands for it there stands in the design.

import { ApiError } from "../api";
import { element } from "../dom";
import type { Form, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import type { Naming } from "./number_editor";

export function fileEditor(form: Form & { form: "file" }, naming: Naming, context: Context, changed: Changed): Editor {
  let wrong: string | null = null;
  let sending = 0; // the newest upload; an older one, or one that something else has replaced, is dropped
  let held: Value | undefined;
  const input = element("input", {
    type: "file", accept: form.suffixes.join(","), ...(naming.id ? { id: naming.id } : { "aria-label": `${naming.label}, file` }),
  });
  const told = element("output", { class: "reading" });
  input.addEventListener("change", async () => {
    const file = input.files?.[0];
    if (!file) return;
    told.textContent = `sending ${file.name} …`;
    const mine = ++sending;
    const dropped = () => mine !== sending || !box.isConnected;
    try {
      const { value, name } = await context.api.upload(file);
      if (dropped()) return;
      wrong = null;
      told.textContent = name;
      held = value;
      changed(value);
    } catch (error) {
      if (dropped()) return;
      wrong = error instanceof ApiError ? error.message : `${file.name} could not be read`;
      told.textContent = "";
    }
    context.problem();
  });
  const box = element("div", { class: "file" }, input, told);
  return {
    element: box,
    inputs: [input],
    set(value: Value | undefined) {
      wrong = null;
      if (value !== held) sending += 1;
      held = value;
      told.textContent = typeof value === "string" ? value.replace(/^.*\//, "") : "";
      if (value === undefined) input.value = "";
    },
    problem: () => wrong,
  };
}
