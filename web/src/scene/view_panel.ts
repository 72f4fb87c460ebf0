// What the view of the page is operated with: views, and under "View" all that is drawn, and how.

import type { Measure } from "./inertia";
import { button, check, choice, element, slider } from "./panel";
import { colourOf } from "./reference";

// What can be chosen, as it is when the view opens.
export class Choices {
  edges = true;
  opacity = 1;
  axes = true;
  centroid = false;
  measure: Measure = "radii";
  kinds = new Set<string>();
  contact = false;
}

export interface Actions {
  look: (axis: number | null) => void; // along an axis; null: as it was first seen
  drawn: () => void; // faces and edges are to look otherwise
  marked: () => void; // what is drawn beside the bodies changes
  contact: () => void;
}

const KINDS = ["pitch", "base", "tip", "root", "face"];
const MOST_RPM = 60;
const FASTEST = 600;

export class ViewPanel {
  readonly views: HTMLElement;
  readonly panel: HTMLElement;
  readonly disclosure: HTMLDetailsElement;
  private readonly surfaces = element("div", { class: "mv-kinds", role: "group", "aria-label": "Reference surfaces" });
  private readonly contact: HTMLElement;
  private readonly inertia: HTMLElement;
  private readonly speed: HTMLElement;
  private shownKinds = "";

  constructor(private readonly choices: Choices, private readonly actions: Actions, section: HTMLElement, speed: HTMLElement) {
    this.speed = speed;
    const opacity = slider("Transparency of the bodies, per cent", (value) => `${Math.round(value)} %`, (value) => {
      choices.opacity = 1 - value / 100;
      actions.drawn();
    });
    opacity.limit(0, 90);
    opacity.set(0);
    this.contact = this.tick("lines of contact", "contact", "Lines of contact", actions.contact);
    this.inertia = this.inertiaRows();
    this.panel = element("div", { class: "mv-panel" },
      this.tick("edges", "edges", "Sharp edges", actions.drawn),
      element("div", { class: "row" }, element("span", { class: "name" }, "transparency"), opacity.row),
      section, speed,
      this.tick("axes of the parts", "axes", "Axes of the parts", actions.marked),
      this.inertia, this.contact, this.surfaces);
    this.disclosure = element("details", { class: "mv-more" }, element("summary", {}, "View"), this.panel);
    this.views = element("div", { class: "mv-views", role: "group", "aria-label": "Views" },
      button("fit", "fit: show all, from where it was first seen (0)", () => actions.look(null)),
      ...["x", "y", "z"].map((name, axis) =>
        button(name, `Look from +${name} (${name.toUpperCase()})`, () => actions.look(axis))),
      this.disclosure);
    this.surfaces.hidden = true;
    this.offer([], false, false, false);
  }

  // What there is to be shown just now; what there is not is not offered.
  offer(kinds: readonly string[], contact: boolean, inertia: boolean, turns: boolean): void {
    this.contact.hidden = !contact;
    this.inertia.hidden = !inertia;
    this.speed.hidden = !turns;
    const sorted = [...KINDS.filter((kind) => kinds.includes(kind)), ...kinds.filter((kind) => !KINDS.includes(kind))];
    if (this.shownKinds === sorted.join()) return; // so that none loses the focus
    this.shownKinds = sorted.join();
    this.surfaces.hidden = !sorted.length;
    this.surfaces.replaceChildren(element("span", {}, "reference surfaces"), ...sorted.map((kind) => this.kind(kind)));
  }

  private kind(kind: string): HTMLElement {
    const swatch = element("i");
    swatch.style.background = colourOf(kind);
    return check([swatch, kind], `Show ${kind} surfaces`, this.choices.kinds.has(kind), (on) => {
      if (on) this.choices.kinds.add(kind);
      else this.choices.kinds.delete(kind);
      this.actions.marked();
    });
  }

  private inertiaRows(): HTMLElement {
    const measure = choice("Lengths of the principal axes", { radii: "radii of gyration", moments: "moments" }, (value) => {
      this.choices.measure = value as Measure;
      this.actions.marked();
    });
    return element("div", { class: "mv-pair" },
      this.tick("centroid, principal axes", "centroid", "Centroid and principal axes", this.actions.marked), measure);
  }

  private tick(
    text: string, which: "edges" | "axes" | "centroid" | "contact", label: string, changed: () => void,
  ): HTMLElement {
    return check([text], label, this.choices[which], (on) => {
      this.choices[which] = on;
      changed();
    });
  }
}

// Revolutions a minute of the pinion, typed or by feel. settled: whether the field was left, and shows what is taken
export function speedRow(first: number, changed: (rpm: number, settled: boolean) => void): HTMLElement {
  const typed = element("input", {
    type: "number", min: "0", max: `${FASTEST}`, step: "any", value: `${first}`, "aria-label": "Speed of the pinion, rpm",
  });
  const felt = element("input", {
    type: "range", min: "0.5", max: `${MOST_RPM}`, step: "0.5", value: `${first}`, "aria-label": "Speed of the pinion by feel, rpm",
  });
  let taken = first;
  const take = (from: HTMLInputElement, other: HTMLInputElement) => {
    if (Number.isNaN(from.valueAsNumber)) return;
    taken = Math.min(Math.max(from.valueAsNumber, 0), FASTEST);
    other.value = `${taken}`;
    changed(taken, false);
  };
  typed.addEventListener("input", () => take(typed, felt));
  typed.addEventListener("change", () => {
    typed.value = `${taken}`;
    changed(taken, true);
  });
  felt.addEventListener("input", () => take(felt, typed));
  return element("div", { class: "row" }, element("span", { class: "name" }, "speed"),
    element("span", { class: "slider" }, felt), typed, "rpm");
}
