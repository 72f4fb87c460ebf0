// A number: typed as text with any unit, and a slider beside it.

import { element, words } from "../dom";
import type { Parameter, Value } from "../protocol";
import type { Changed, Context, Editor } from "./editor";
import { quantity, shown, type Wanted } from "./quantity";
import { range } from "./ranges";

const TOOTH = ["module", "diametral_pitch"]; // either may be typed in the other's field
const SIZES = [...TOOTH, "transverse_module"]; // of a tooth: one of them is given

export interface Naming {
  id?: string; // of the input, where a label elsewhere names it
  label: string;
}

export function numberEditor(parameter: Parameter, naming: Naming, context: Context, changed: Changed): Editor {
  return new NumberEditor(parameter, naming, context, changed);
}

class NumberEditor implements Editor {
  readonly element: HTMLElement;
  readonly inputs: HTMLElement[];
  private readonly text: HTMLInputElement;
  private readonly slider: HTMLInputElement;
  private readonly reading = element("output", { class: "reading" });
  private value: number | null = null;
  private wrong: string | null = null;
  private held = false; // the slider is in hand: its range stays
  private lent = false; // what is being typed is another parameter's value, and stays until the field is left

  constructor(
    private readonly parameter: Parameter, naming: Naming, private readonly context: Context, private readonly changed: Changed,
  ) {
    this.text = element("input", {
      type: "text", inputmode: parameter.kind === "integer" ? "numeric" : "text", autocomplete: "off", spellcheck: "false",
      placeholder: placeholder(parameter.default), ...(naming.id ? { id: naming.id } : { "aria-label": naming.label }),
    });
    this.slider = element("input", { type: "range", "aria-label": `${naming.label}, slider`, tabindex: "0" });
    this.text.addEventListener("input", () => this.typed());
    this.text.addEventListener("change", () => this.tidy());
    this.slider.addEventListener("input", () => this.slid());
    this.slider.addEventListener("change", () => {
      this.held = false;
    });
    this.inputs = [this.text];
    this.element = element("div", { class: "number" }, this.text, this.slider, this.reading);
    this.reach();
  }

  set(value: Value | undefined): void {
    const number = typeof value === "number" ? value : null;
    const fits = number === this.value && (number !== null || this.text.value === "") && this.wrong === null;
    this.value = number;
    if (!fits && !(this.lent && number === null)) {
      this.lent = false;
      this.wrong = null;
      this.text.value = number === null ? "" : shown(number);
      this.reading.textContent = "";
    }
    this.reach();
  }

  problem(): string | null {
    return this.wrong;
  }

  private wanted(): Wanted {
    const unit = this.parameter.unit;
    return unit === "length" ? this.context.unit() : unit === "angle" ? "deg" : unit;
  }

  private typed(): void {
    const before = this.wrong;
    const found = this.text.value.trim() ? quantity(this.text.value, this.wanted(), TOOTH.includes(this.parameter.name)) : null;
    this.wrong = found && "problem" in found ? found.problem : null;
    this.reading.textContent = "";
    if (!found) this.give(null);
    else if ("problem" in found) this.context.problem();
    else if (found.other && found.other !== this.parameter.name) this.hand(found.other, found.value);
    else {
      if (!found.bare) this.reading.textContent = `= ${shown(found.value)} ${unitWord(this.wanted())}`.trim();
      this.give(found.value);
    }
    if (before && !this.wrong) this.context.problem();
  }

  // What was typed is another parameter's: a diametral pitch in place of a module, or the other way.
  private hand(other: string, value: number): void {
    this.reading.textContent = `= ${words(other)} ${shown(value)} ${other === "module" ? "mm" : "per inch"}`;
    this.value = null;
    this.lent = true;
    this.context.put({ ...Object.fromEntries(SIZES.map((name) => [name, undefined])), [other]: value });
  }

  private give(value: number | null): void {
    this.value = value;
    this.reach();
    if (!this.lent) return this.changed(value ?? undefined);
    this.lent = false; // the other one gives way again
    this.context.put({ ...Object.fromEntries(SIZES.map((name) => [name, undefined])), [this.parameter.name]: value ?? undefined });
  }

  // Once it is left, a field shows its value.
  private tidy(): void {
    if (this.wrong !== null) return;
    this.lent = false;
    this.text.value = this.value === null ? "" : shown(this.value);
    this.reading.textContent = "";
  }

  private slid(): void {
    this.held = true;
    this.lent = false;
    const value = Number(this.slider.valueAsNumber.toPrecision(10));
    this.wrong = null;
    this.text.value = shown(value);
    this.reading.textContent = "";
    this.value = value;
    this.slider.setAttribute("aria-valuetext", this.spoken());
    this.changed(value);
  }

  private spoken(): string {
    return this.value === null ? "not given" : `${shown(this.value)} ${unitWord(this.wanted())}`.trim();
  }

  private reach(): void {
    if (this.held) return;
    const { least, most, step } = range(this.parameter, this.value, this.context.scale());
    Object.assign(this.slider, { min: `${least}`, max: `${most}`, step: "any" });
    this.slider.step = `${step}`;
    const usual = typeof this.parameter.default === "number" ? this.parameter.default : least;
    this.slider.value = `${this.value ?? usual}`;
    this.slider.classList.toggle("unset", this.value === null);
    this.slider.setAttribute("aria-valuetext", this.spoken());
  }
}

export const unitWord = (wanted: Wanted) => (wanted === "deg" ? "°" : wanted === "per inch" ? "1/in" : wanted);

function placeholder(value: Value): string {
  if (value === null) return "none";
  return typeof value === "number" ? shown(value) : String(value);
}
