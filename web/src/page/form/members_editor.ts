// A value for both members of a pair, or one for each.

import { capital, element } from "../dom";
import type { Parameter, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import type { Naming } from "./number_editor";

type Make = (naming: Naming, changed: Changed, component?: number) => Editor;

// Always one for each.
export function eachEditor(parameter: Parameter, naming: Naming, context: Context, make: Make, changed: Changed): Editor {
  const given: (Value | undefined)[] = [undefined, undefined];
  const pairs = parameter.members === "each"; // then two empty places still say that there are two members
  const tell = () => changed(!pairs && given.every((one) => one === undefined) ? undefined : given.map((one) => one ?? parameter.default));
  const editors = context.members.map((member, index) =>
    make({ ...(index === 0 && naming.id ? { id: naming.id } : {}), label: `${naming.label}, ${member}` }, (value) => {
      given[index] = value;
      tell();
    }));
  const rows = editors.map((editor, index) => {
    if (index === 0 && naming.id) editor.inputs[0]!.setAttribute("aria-label", `${naming.label}, ${context.members[0]}`);
    return element("div", { class: "member" },
      element("span", { class: "of", "aria-hidden": "true" }, capital(context.members[index]!)), editor.element);
  });
  return {
    element: element("div", { class: "members", role: "group", "aria-label": naming.label, "data-parameter-group": parameter.name }, ...rows),
    inputs: editors.flatMap((editor) => editor.inputs),
    set(value) {
      editors.forEach((editor, index) => {
        given[index] = (Array.isArray(value) ? value[index] : value) ?? undefined;
        editor.set(given[index]);
      });
    },
    problem: () => editors.map((editor) => editor.problem()).find((one) => one !== null) ?? null,
  };
}

// One for both, or, where the toggle is pressed, one for each.
export function bothEditor(parameter: Parameter, naming: Naming, context: Context, make: Make, changed: Changed): Editor {
  let last: Value | undefined;
  let inputs: HTMLElement[] = [];
  let current: Editor;
  let two = false;
  const host = element("div");
  const keep: Changed = (value) => {
    last = value;
    changed(value);
  };
  const toggle = element("button", {
    type: "button", class: "two", "aria-pressed": "false", "aria-label": `Two values of ${naming.label}`,
    title: `One value for both, or one for ${context.members.join(" and ")}`,
  }, "two values");
  const make_ = (pair: boolean) => {
    two = pair;
    toggle.setAttribute("aria-pressed", `${pair}`);
    current = pair ? eachEditor(parameter, naming, context, make, keep) : make(naming, keep);
    inputs = current.inputs;
    host.replaceChildren(current.element);
    current.set(last);
  };
  toggle.addEventListener("click", () => {
    const first = Array.isArray(last) ? last.find((one) => one !== null) : last;
    last = two ? first ?? undefined : first === undefined ? undefined : [first, first];
    make_(!two);
    changed(last);
  });
  make_(false);
  return {
    element: host,
    aside: toggle,
    get inputs() {
      return inputs;
    },
    set(value) {
      last = value;
      const pair = Array.isArray(value);
      if (pair !== two && (pair || value !== undefined)) make_(pair);
      else current.set(value);
    },
    problem: () => current.problem(),
  };
}

// Numbers that make up one value, such as x and y.
export function componentsEditor(parameter: Parameter, naming: Naming, context: Context, make: Make, changed: Changed): Editor {
  const given: (Value | undefined)[] = parameter.components.map(() => undefined);
  const usual = Array.isArray(parameter.default) ? parameter.default : [];
  let wrong: string | null = null;
  const tell = () => {
    const none = given.every((one) => one === undefined);
    const whole = given.map((one, i) => one ?? usual[i]);
    const missing = none ? [] : parameter.components.filter((_, i) => whole[i] === undefined);
    const before = wrong;
    wrong = missing.length ? `${missing.join(" and ")} is needed too` : null;
    if (wrong !== before) context.problem();
    if (!wrong) changed(none ? undefined : (whole as Value[]));
  };
  const editors = parameter.components.map((component, index) =>
    make({ ...(index === 0 && naming.id ? { id: naming.id } : {}), label: `${naming.label}, ${component}` }, (value) => {
      given[index] = value;
      tell();
    }, index));
  const rows = editors.map((editor, index) => {
    if (index === 0 && naming.id) editor.inputs[0]!.setAttribute("aria-label", `${naming.label}, ${parameter.components[0]}`);
    return element("div", { class: "member" },
      element("span", { class: "of", "aria-hidden": "true" }, parameter.components[index]!), editor.element);
  });
  return {
    element: element("div", { class: "members", role: "group", "aria-label": naming.label }, ...rows),
    inputs: editors.flatMap((editor) => editor.inputs),
    set(value) {
      wrong = null;
      editors.forEach((editor, index) => {
        given[index] = (Array.isArray(value) ? value[index] : undefined) ?? undefined;
        editor.set(given[index]);
      });
    },
    problem: () => wrong ?? editors.map((editor) => editor.problem()).find((one) => one !== null) ?? null,
  };
}
