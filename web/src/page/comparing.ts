// A second design at the side, kept as it was, and a table of what differs.

import { Comparison } from "./comparison";
import type { Wish } from "./connection";
import { element } from "./dom";
import { Pane } from "./pane";
import type { LengthUnit, ValuesAnswer } from "./protocol";
import type { Tabs } from "./tabs";
import type { Theme } from "./theme";

export class Comparing {
  private pane: Pane | null = null;
  private readonly table = new Comparison();
  readonly element = element("div", {}, this.table.element);
  private a: ValuesAnswer | null = null;
  private b: ValuesAnswer | null = null;
  private why = ""; // why there is no b
  private shown: LengthUnit = "mm";
  private look: Theme = "light";

  constructor(private readonly views: HTMLElement, private readonly tabs: Tabs, private readonly note: (text: string) => void) {}

  get results(): HTMLElement {
    return this.table.element;
  }

  get on(): boolean {
    return this.pane !== null;
  }

  // values: of the design that is being edited, A
  pin(wish: Wish, values: ValuesAnswer | null, unit: LengthUnit): void {
    this.shown = unit;
    this.a = values;
    this.b = null;
    this.why = "";
    this.pane = new Pane("Model of the pinned design, B", {
      values: (given) => {
        this.b = given;
        this.why = "";
        this.refresh();
      },
      built: () => {},
      refused: (headline) => {
        this.why = `The pinned design, B, has no values: ${headline}`;
        this.note(this.why);
        this.refresh();
      },
      link: () => {},
      note: this.note,
    });
    this.pane.element.prepend(element("p", { class: "badge" }, "B, pinned"));
    this.views.append(this.pane.element);
    this.views.classList.add("two-views");
    this.views.firstElementChild!.prepend(element("p", { class: "badge" }, "A, being edited"));
    this.pane.theme(this.look);
    this.pane.unit(unit);
    this.pane.ask(wish);
    this.tabs.add("compared", "Compared", this.element);
    this.tabs.choose("compared", true);
    this.refresh();
  }

  leave(): void {
    this.pane?.close();
    this.pane = null;
    this.views.classList.remove("two-views");
    this.views.querySelector(".badge")?.remove();
    this.tabs.remove("compared");
  }

  show(values: ValuesAnswer): void {
    this.a = values;
    this.refresh();
  }

  unit(unit: LengthUnit): void {
    this.shown = unit;
    this.pane?.unit(unit);
    this.refresh();
  }

  theme(theme: Theme): void {
    this.look = theme;
    this.pane?.theme(theme);
  }

  private refresh(): void {
    if (this.pane) this.table.show(this.a?.document ?? null, this.b?.document ?? null, this.shown, this.why);
  }
}
