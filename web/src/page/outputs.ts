// Files of a design: which format, with which options; each comes when the server has made it.

import type { Api } from "./api";
import { unitOf } from "./design";
import { button, element, options, unique } from "./dom";
import { Job } from "./file_job";
import { quantity } from "./form/quantity";
import type { Design, FileFormat, FileWish, Kind } from "./protocol";

export interface Weights {
  density: number | null;
  material: string | null;
}

const GROUPS: Record<FileFormat["what"], string> = {
  body: "Bodies", drawing: "Drawing of the section", sheet: "Drawing sheet", design: "Design",
};
const STEP = [".step", ".stp", ".p21"];

export function outputs(host: HTMLElement, api: Api) {
  return new Outputs(host, api);
}

class Outputs {
  private readonly format = element("select", { id: unique("format") });
  private readonly tolerance = typed("tolerance", "as fine as shown");
  private readonly clearance = typed("clearance", "none");
  private readonly schema = options(element("select", { id: unique("schema") }), [["", "AP214"], ["AP242", "AP242"]]);
  private readonly paper = options(element("select", { id: unique("paper") }), [["A3", "A3"], ["A4", "A4"]]);
  private readonly apart = element("input", { type: "checkbox" });
  private readonly unplaced = element("input", { type: "checkbox" });
  private readonly fields: Record<"tolerance" | "clearance" | "schema" | "paper" | "apart" | "unplaced", HTMLElement>;
  private readonly lengths = [element("span", { class: "unit" }), element("span", { class: "unit" })];
  private readonly wrong = element("p", { class: "problem", role: "status", id: unique("file-problem") });
  private readonly weightless: HTMLElement;
  private readonly jobs = element("ul", { class: "jobs", "aria-label": "Files" });
  private kindShown: Kind | null = null;
  private wanted: Design | null = null;
  private weights: Weights = { density: null, material: null };

  constructor(host: HTMLElement, private readonly api: Api) {
    this.fields = {
      tolerance: field("Chord tolerance", this.tolerance, this.lengths[0]), clearance: field("Clearance for printing", this.clearance, this.lengths[1]),
      schema: field("STEP schema", this.schema), paper: field("Paper", this.paper),
      apart: element("label", { class: "whether" }, this.apart, "Members in files of their own (zip)"),
      unplaced: element("label", { class: "whether" }, this.unplaced, "Each in its own frame, not in mesh"),
    };
    this.weightless = element("p", { class: "problem" }, "This format holds masses: choose a material or a density. ",
      button("Choose a material", () => document.querySelector<HTMLElement>('[role="tab"][data-tab="mass"]')?.click()));
    const form = element("form", { class: "making" }, element("h2", {}, "Make a file"), field("Format", this.format),
      element("fieldset", {}, element("legend", { class: "unseen" }, "Options"), ...Object.values(this.fields)), this.weightless, this.wrong,
      element("button", { type: "submit", class: "go" }, "Make the file"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.start();
    });
    form.addEventListener("input", () => this.tell("", null));
    this.format.addEventListener("change", () => this.arrange());
    host.append(form, this.jobs);
  }

  kind(kind: Kind): void {
    const before = this.format.value;
    this.kindShown = kind;
    this.wanted = null;
    const groups = (Object.keys(GROUPS) as FileFormat["what"][]).map((what) => {
      const entries = kind.formats.map((one, at): [string, FileFormat] => [`${at}`, one]).filter(([, one]) => one.what === what);
      const group = element("optgroup", { label: GROUPS[what] });
      group.append(...entries.map(([, one]) => element("option", { value: valueOf(one) }, `${one.words} (${one.suffix})`)));
      return group;
    });
    this.format.replaceChildren(...groups.filter((group) => group.children.length));
    const values = kind.formats.map(valueOf);
    this.format.value = [before, "body .step", values[0] ?? ""].find((value) => values.includes(value)) ?? "";
    this.arrange();
  }

  design(design: Design, weights: Weights): void {
    this.wanted = design;
    this.weights = weights;
    for (const unit of this.lengths) unit.textContent = unitOf(design);
    this.arrange();
  }

  private get chosen(): FileFormat | undefined {
    return this.kindShown?.formats.find((one) => valueOf(one) === this.format.value);
  }

  // Shows the options that apply.
  private arrange(): void {
    const one = this.chosen;
    const body = one?.what === "body";
    const pair = this.kindShown?.members === 2 && body && !one!.needs_density;
    const show: Record<keyof typeof this.fields, boolean> = {
      tolerance: body, clearance: Boolean(one?.has_clearance), schema: body && STEP.includes(one!.suffix), paper: one?.what === "sheet",
      apart: Boolean(pair), unplaced: Boolean(pair),
    };
    for (const [name, shown] of Object.entries(show)) this.fields[name as keyof typeof this.fields].hidden = !shown;
    this.weightless.hidden = !one?.needs_density || this.weights.density !== null || this.weights.material !== null;
    this.tell("", null);
  }

  private start(): void {
    const [one, design] = [this.chosen, this.wanted];
    if (!one || !design) return;
    if (!this.weightless.hidden) return this.weightless.querySelector("button")!.focus();
    const wish = this.wish(one, design);
    if (!wish) return;
    const job = new Job(this.api, wish, `${this.kindShown!.name}, ${one.words} (${one.suffix})`);
    this.jobs.prepend(job.element);
    void job.run();
  }

  // What is asked of the server; null where an option holds no value.
  private wish(one: FileFormat, design: Design): FileWish | null {
    const lengths: (number | null)[] = [];
    for (const name of ["tolerance", "clearance"] as const) {
      const text = this[name].value.trim();
      const found = this.fields[name].hidden || !text ? null : quantity(text, unitOf(design));
      const problem = found && ("problem" in found ? found.problem : found.value > 0 ? "" : "must be greater than 0");
      if (problem) {
        this.tell(`${name}: ${problem}`, this[name]);
        return null;
      }
      lengths.push(found && "value" in found ? found.value : null);
    }
    const shown = (name: keyof typeof this.fields) => !this.fields[name].hidden;
    return {
      design, suffix: one.suffix, what: one.what, tolerance: lengths[0]!, clearance: lengths[1]!,
      placed: !(shown("unplaced") && this.unplaced.checked), separate: shown("apart") && this.apart.checked,
      density: this.weights.density, material: this.weights.material,
      step_schema: shown("schema") && this.schema.value === "AP242" ? "AP242" : null, paper: this.paper.value as "A3" | "A4",
    };
  }

  private tell(text: string, at: HTMLInputElement | null): void {
    this.wrong.textContent = text;
    this.wrong.hidden = !text;
    for (const input of [this.tolerance, this.clearance]) {
      if (input === at) {
        input.setAttribute("aria-invalid", "true");
        input.setAttribute("aria-describedby", this.wrong.id);
      } else {
        input.removeAttribute("aria-invalid");
        input.removeAttribute("aria-describedby");
      }
    }
    at?.focus();
  }
}

const valueOf = (one: FileFormat) => `${one.what} ${one.suffix}`;

const typed = (name: string, placeholder: string) =>
  element("input", { type: "text", id: unique(name), autocomplete: "off", placeholder });

const field = (text: string, input: HTMLElement, unit: HTMLElement | null = null) =>
  element("div", { class: "field" }, element("div", { class: "title" }, element("label", { for: input.id }, text), unit), input);
