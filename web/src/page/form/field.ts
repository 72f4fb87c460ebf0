// One parameter of the form: its name in words, symbol and unit, what it means, and what is wrong with it.

import { button, capital, element, symbol, unique, words } from "../dom";
import { unitWord } from "../amounts";
import { figureOf } from "../figures";
import type { Kind, LengthUnit, Parameter, Problem, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import { valueEditor } from "./value_editor";

export class Field {
  readonly element: HTMLElement;
  private readonly editor: Editor;
  private readonly unit = element("span", { class: "unit" });
  private readonly wrong: HTMLElement;
  private served: Problem[] = [];

  constructor(readonly parameter: Parameter, kind: Kind, context: Context, changed: Changed) {
    const id = unique(parameter.name);
    const name = words(parameter.name);
    this.wrong = element("p", { class: "problem", id: `${id}-problem` });
    this.wrong.hidden = true;
    this.editor = valueEditor(parameter, { id, label: name }, context, changed);
    const label = element("label", { for: id }, capital(name), " ", parameter.symbol ? symbol(parameter.symbol) : null);
    const help = helpOf(parameter, kind, name);
    this.element = element("div", { class: "field", "data-parameter": parameter.name },
      element("div", { class: "title" }, label, this.editor.aside ?? null, this.unit, help.toggle), this.editor.element, this.wrong, help.panel);
    this.units(context.unit());
  }

  set(value: Value | undefined): void {
    this.editor.set(value);
    this.show();
  }

  get problem(): string | null {
    return this.editor.problem();
  }

  // What the server says about it.
  refuse(problems: Problem[]): void {
    this.served = problems;
    this.show();
  }

  // Its own problem first, since the server knows only what was sent.
  show(): void {
    const own = this.editor.problem();
    const told = own !== null ? [own] : this.served.map((problem) => problem.message);
    this.wrong.replaceChildren(...told.map((text) => element("span", {}, text)));
    this.wrong.hidden = told.length === 0;
    const two = this.element.querySelectorAll(".member").length === 2;
    this.editor.inputs.forEach((input, index) => {
      const bad = own !== null || this.served.some((problem) => !two || problem.member === null || problem.member === index);
      const marked = told.length > 0 && bad;
      if (marked) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
      if (marked) input.setAttribute("aria-describedby", this.wrong.id);
      else input.removeAttribute("aria-describedby");
    });
  }

  units(unit: LengthUnit): void {
    this.unit.textContent = unitWord(this.parameter.unit, unit);
  }
}

function helpOf(parameter: Parameter, kind: Kind, name: string): { toggle: HTMLElement; panel: HTMLElement } {
  const panel = element("div", { class: "help", id: unique("help") });
  panel.hidden = true;
  const toggle = button("?", () => open(panel.hidden === true), `What is ${name}?`, "tip");
  toggle.setAttribute("aria-expanded", "false");
  toggle.setAttribute("aria-controls", panel.id);
  const open = (on: boolean) => {
    panel.hidden = !on;
    toggle.setAttribute("aria-expanded", `${on}`);
    if (on && !panel.firstChild) {
      const figure = figureOf(kind.command, parameter.name, parameter.figure);
      panel.append(element("p", {}, `${capital(parameter.meaning)}${limits(parameter)}.`), ...(figure ? [figure] : []));
    }
  };
  toggle.addEventListener("keydown", (event) => {
    if (event.key === "Escape") open(false);
  });
  return { toggle, panel };
}

function limits(parameter: Parameter): string {
  const told = [
    parameter.above !== null ? `> ${parameter.above}` : "",
    parameter.minimum !== null ? `≥ ${parameter.minimum}` : "",
    parameter.maximum !== null ? `≤ ${parameter.maximum}` : "",
    parameter.below !== null ? `< ${parameter.below}` : "",
  ].filter(Boolean).join(", ");
  return told ? ` (${told})` : "";
}
