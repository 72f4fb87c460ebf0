// One of a few words.

import { element, options, words } from "../dom";
import type { Parameter, Value } from "../protocol";
import type { Changed, Editor } from "./editor";
import type { Naming } from "./number_editor";

export function choiceEditor(parameter: Parameter, naming: Naming, changed: Changed): Editor {
  const select = element("select", naming.id ? { id: naming.id } : { "aria-label": naming.label });
  const usual = typeof parameter.default === "string" ? `${told(parameter.default)} (usual)` : "not given";
  const others = parameter.choices.filter((choice) => choice !== parameter.default);
  options(select, [...(parameter.required ? [] : [["", usual] as [string, string]]),
    ...others.map((choice): [string, string] => [choice, told(choice)])]);
  select.addEventListener("change", () => changed(select.value || undefined));
  return {
    element: select,
    inputs: [select],
    set(value: Value | undefined) {
      select.value = typeof value === "string" && value !== parameter.default ? value : "";
    },
    problem: () => null,
  };
}

const told = (choice: string) => (/^[a-z-]+$/.test(choice) ? words(choice.replaceAll("-", " ")) : choice);
