// The page as a whole: one state, shown by form, view and tables, kept in the address.

import { partsOf, summary } from "./amounts";
import { Announcer } from "./announcer";
import { Address } from "./address";
import { Ageing } from "./ageing";
import { type Api, ApiError, lineOf } from "./api";
import { Comparing } from "./comparing";
import type { Wish } from "./connection";
import { copying } from "./copying";
import { beginning } from "./beginning";
import { aboutIn, unitOf } from "./design";
import { element } from "./dom";
import { DesignForm } from "./form/form";
import { faultOf, hashOf, plain, type State, stateOf } from "./hash";
import { Header } from "./header";
import { kindOf, startOf } from "./kinds";
import { listenForFiles } from "./opening";
import { outputs } from "./outputs";
import { arranged, type Parts } from "./page_parts";
import { Pane } from "./pane";
import { alike, lastKept, Past } from "./past";
import { plots } from "./plots";
import type { ApproximationAnswer, Design, Elements, Kind, LengthUnit, Material, ValuesAnswer } from "./protocol";
import { Sheet } from "./sheet";
import { Standing } from "./standing";
import { tables } from "./tables";
import { Tabs } from "./tabs";
import type { Themes } from "./theme";
import { listenForUndo } from "./undoing";
import { Weighing } from "./weighing";

const STEEL = "steel";

export class Designer {
  private state: State;
  private kind: Kind;
  private form: DesignForm;
  private readonly seen = new Map<string, Design>(); // the last design of each kind
  private readonly past: Past;
  private readonly announcer = new Announcer();
  private readonly sheet = new Sheet();
  private readonly header: Header;
  private readonly parts: Parts;
  private readonly tabs: Tabs;
  private readonly weighing: Weighing;
  private readonly comparing: Comparing;
  private readonly pane: Pane;
  private readonly tables: ReturnType<typeof tables>;
  private readonly plots: ReturnType<typeof plots>;
  private readonly outputs: ReturnType<typeof outputs>;
  private readonly copying: ReturnType<typeof copying>;
  private readonly standing: Standing;
  private readonly address = new Address();
  private readonly steel: string | null;

  constructor(
    host: HTMLElement, themes: Themes, private readonly api: Api, private readonly elements: Elements, materials: Material[],
  ) {
    const first = elements.kinds.find((kind) => kind.command === "spur" && kind.members === 2) ?? elements.kinds[0]!;
    this.steel = materials.some((one) => one.name === STEEL) ? STEEL : null;
    const example = this.example(first);
    const { state, again, note } = beginning(elements.kinds, location.hash, lastKept(), example);
    this.state = example;
    this.kind = first;
    this.past = new Past(again ? example : state, state, () => this.state, () => this.head());
    this.header = new Header(elements.kinds, {
      kind: (kind) => this.choose(kind), undo: () => this.step("undo"), redo: () => this.step("redo"),
      open: (file) => void this.open(file), compare: () => this.compare(), theme: () => themes.toggle(),
      unit: (unit) => this.change({ unit: unit === unitOf(this.state.design) ? null : unit }), print: () => window.print(),
    });
    this.tabs = new Tabs("Results", (tab) => this.change({ tab: tab === "sizes" ? "" : tab }));
    const [sizes, mass, plot, copies, files] = [element("div"), element("div"), element("div"), element("div"), element("div")];
    this.weighing = new Weighing(materials, () => unitOf(this.state.design), (weight) => this.change(weight));
    this.tabs.add("sizes", "Sizes", sizes);
    this.tabs.add("mass", "Mass & inertia", this.weighing.element, mass);
    this.tabs.add("plots", "Plots", plot);
    this.tabs.add("files", "Files", files, copies);
    this.parts = arranged(host, this.header.element, this.tabs.element,
      [this.announcer.spoken, this.announcer.toasts, this.sheet.element]);
    this.pane = new Pane("Model", {
      values: (values, approximation) => this.take(values, approximation),
      built: () => {
        this.form.refuse("", []);
        this.standing.mark();
      },
      refused: (headline, problems) => {
        this.form.refuse(headline, problems);
        this.standing.mark();
        this.announcer.say([headline, ...problems.map(lineOf)].join(". "));
      },
      link: (link) => {
        this.header.linked(link);
        this.standing?.linked(link);
        if (link === "open") this.plots?.again();
      },
      note: (text) => this.announcer.note(text),
    });
    this.parts.views.append(this.pane.element);
    this.comparing = new Comparing(this.parts.views, this.tabs, (text) => this.announcer.note(text));
    this.tables = tables({ sizes, mass });
    this.plots = plots(plot, api);
    this.copying = copying(copies, () => this.standing.current);
    const tabled = [...sizes.children, ...mass.children, this.comparing.results] as HTMLElement[];
    this.standing = new Standing(this.pane, new Ageing(tabled, this.parts.strip),
      () => ({ wish: this.wish, broken: this.form.broken.length > 0 }));
    this.outputs = outputs(files, api);
    this.form = this.formOf(this.kind);
    themes.follow((theme) => {
      this.pane.theme(theme);
      this.comparing.theme(theme);
    });
    listenForUndo(() => this.step("undo"), () => this.step("redo"));
    listenForFiles(document.body, (file) => void this.open(file));
    window.addEventListener("hashchange", () => this.addressed());
    window.addEventListener("beforeprint", () => this.print());
    document.addEventListener("change", () => this.past.soon());
    if (note) this.announcer.note(note);
    if (!this.shows(state)) {
      this.past.begin(example);
      if (again) this.past.settle(); // what cannot be shown is not kept for the next time either
    }
    this.publish("replace");
  }

  // With a mass, since that is what many come for.
  private example(kind: Kind): State {
    return { ...plain({ ...kind.start }), material: this.steel };
  }

  private formOf(kind: Kind): DesignForm {
    const form = new DesignForm(kind, this.api, (design) => {
      if (form === this.form) this.edited(design); // one that was taken away tells nothing
    });
    this.parts.form.replaceChildren(form.element);
    this.plots.kind(kind);
    this.outputs.kind(kind);
    return form;
  }

  // What somebody does in the form. null: a field holds no value
  private edited(design: Design | null): void {
    if (!design) {
      this.standing.mark();
      this.announcer.say(this.form.broken.join(". "));
      return;
    }
    if (hashOf({ ...this.state, design }) === hashOf(this.state)) {
      if (this.pane.element.dataset.state === "old") this.ask();
      this.standing.mark();
      return;
    }
    const state = this.with(design);
    const moved = state.about !== this.state.about;
    this.change(state);
    if (moved) this.weighing.set(state, this.kind.origin);
    else this.weighing.units();
  }

  // Another design in the state; a point of reference stays where it is, whatever lengths are counted in.
  private with(design: Design): State {
    return { ...this.state, design, about: aboutIn(this.state.about, unitOf(this.state.design), unitOf(design)) };
  }

  private change(part: Partial<State>): void {
    const before = this.state;
    this.state = { ...this.state, ...part };
    this.publish("replace");
    this.past.soon();
    this.furnish(before);
  }

  private choose(kind: Kind): void {
    this.past.settle();
    this.seen.set(this.kind.name, this.state.design);
    const design = this.seen.get(kind.name) ?? startOf(kind, this.kind, this.state.design);
    this.go(this.with(design), "push");
    this.past.settle();
  }

  // Shows a state that did not come from the form. Gives whether that was possible.
  private go(state: State, how: "replace" | "push" = "replace"): boolean {
    const shown = this.shows(state);
    this.publish(how);
    return shown;
  }

  // A state that cannot be shown is told, and the one before it stays.
  private shows(state: State): boolean {
    const before = this.state;
    this.state = state;
    try {
      this.show();
      return true;
    } catch (error) {
      console.error(error);
      this.state = before;
      this.show();
      this.announcer.note(`This design of the element ${state.design.element} cannot be shown, so the one before it stays.`);
      return false;
    }
  }

  private show(): void {
    const kind = kindOf(this.elements.kinds, this.state.design) ?? this.kind;
    if (kind !== this.kind) {
      this.kind = kind;
      this.form = this.formOf(kind);
      this.pane.forget();
      this.tables.clear();
      this.copying.clear();
      this.parts.strip.textContent = "";
    }
    this.form.set(this.state.design);
    this.weighing.set(this.state, kind.origin);
    this.tabs.choose(this.state.tab || "sizes", false);
    this.furnish(null);
  }

  // Brings all but the form up to date. before: the state until now, null where all may differ
  private furnish(before: State | null): void {
    const state = this.state;
    const unit = this.unit;
    if (!before || this.unitOf(before) !== unit) {
      this.pane.unit(unit);
      this.comparing.unit(unit);
      this.tell();
    }
    this.head();
    if (before && alike(before, state)) return;
    this.plots.design(state.design);
    this.outputs.design(state.design, { density: state.density, material: state.material });
    this.ask();
  }

  private head(): void {
    this.header.show(this.kind, this.unit, this.past.undoable, this.past.redoable, this.comparing.on);
  }

  private ask(): void {
    this.pane.ask(this.wish);
    this.standing.mark();
  }

  private get wish(): Wish {
    const { design, density, material, about } = this.state;
    return { design, density, material, about };
  }

  private get unit(): LengthUnit {
    return this.unitOf(this.state);
  }

  private unitOf(state: State): LengthUnit {
    return state.unit ?? unitOf(state.design);
  }

  private take(values: ValuesAnswer, approximation: ApproximationAnswer | null): void {
    this.tables.show(values, approximation, this.unit, this.state.about, this.kind.mate);
    this.comparing.show(values);
    this.standing.came();
    if (approximation) return;
    this.copying.show(values);
    this.tell();
  }

  private tell(): void {
    const values = this.pane?.values;
    if (!values || !partsOf(values.document).length) return;
    const text = summary(values.document, this.unit, this.kind.mate);
    this.parts.strip.textContent = text;
    this.announcer.say([text, ...values.remarks].join(". "));
  }

  private compare(): void {
    if (this.comparing.on) this.comparing.leave();
    else this.pin();
    this.head();
  }

  // What can be compared is what can be built: where the form's design cannot, the last one that was.
  private pin(): void {
    const { values, valued } = this.pane;
    const wish = this.standing.unbuilt ? valued : this.wish;
    if (!wish) return this.announcer.note("There is nothing to compare with yet: the design cannot be built as it is.");
    if (wish === valued) this.announcer.note("B is the last design that was built, since what is typed is not.");
    this.comparing.pin(wish, values, this.unit);
  }

  private async open(file: File): Promise<void> {
    try {
      const design = await this.api.read(await file.text());
      if (!kindOf(this.elements.kinds, design)) throw new ApiError("It holds no element that is known here", [], 0);
      this.past.settle();
      const shown = this.go(this.with(design));
      this.past.settle();
      if (shown) this.announcer.note(`${file.name} is open.`);
    } catch (error) {
      this.announcer.note(error instanceof ApiError ? `${file.name}: ${error.message}` : `${file.name} could not be read`, 20_000);
    }
  }

  private step(way: "undo" | "redo"): void {
    const state = this.past.step(way);
    if (!state) return;
    this.go(state);
    this.announcer.say(way === "undo" ? "Undone" : "Done again");
  }

  private publish(how: "replace" | "push"): void {
    this.address.put(hashOf(this.state), how);
    document.title = `${this.kind.name} – Gearwright`;
  }

  // Back, forward, or an address that somebody typed.
  private addressed(): void {
    const state = stateOf(location.hash);
    if (!state || !kindOf(this.elements.kinds, state.design)) {
      this.announcer.note(faultOf(location.hash));
      return;
    }
    if (hashOf(state) === hashOf(this.state)) return;
    this.past.settle();
    this.go(state);
    this.past.settle();
  }

  private print(): void {
    this.standing.print(this.sheet, ({ design }) => kindOf(this.elements.kinds, design) ?? this.kind);
  }
}
