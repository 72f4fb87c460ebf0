// The top of the page: which element, back and forth, open, compare, units, light or dark.

import type { Link } from "./connection";
import { button, capital, element, unique } from "./dom";
import { grouped } from "./kinds";
import type { Kind, LengthUnit } from "./protocol";

export interface Actions {
  kind(kind: Kind): void;
  undo(): void;
  redo(): void;
  open(file: File): void;
  compare(): void;
  theme(): void;
  unit(unit: LengthUnit): void;
  print(): void;
}

export class Header {
  readonly element: HTMLElement;
  private readonly link = element("span", { class: "link", role: "status" });
  private readonly kinds = element("select", { id: unique("element") });
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly compare: HTMLButtonElement;
  private readonly units: HTMLInputElement[];

  constructor(private readonly all: Kind[], actions: Actions) {
    for (const [command, kinds] of grouped(all)) {
      const group = element("optgroup", { label: capital(command) });
      group.append(...kinds.map((kind) => element("option", { value: kind.name }, capital(kind.name))));
      this.kinds.append(group);
    }
    this.kinds.addEventListener("change", () => actions.kind(all.find((kind) => kind.name === this.kinds.value)!));
    this.undo = button("↶", actions.undo, "Undo (Ctrl+Z)");
    this.redo = button("↷", actions.redo, "Redo (Ctrl+Y)");
    this.compare = button("Compare", actions.compare, "Keep this design at the side and compare with it");
    this.compare.setAttribute("aria-pressed", "false");
    const file = element("input", { type: "file", accept: ".toml", class: "unseen", tabindex: "-1", "aria-label": "Design file" });
    file.addEventListener("change", () => {
      if (file.files?.[0]) actions.open(file.files[0]);
      file.value = "";
    });
    const group = unique("unit");
    this.units = (["mm", "in"] as LengthUnit[]).map((unit) => {
      const input = element("input", { type: "radio", name: group, value: unit });
      input.addEventListener("change", () => actions.unit(unit));
      return input;
    });
    this.element = element("header", {},
      element("div", { class: "brand" }, mark(), element("h1", {}, "Gearwright")),
      element("div", { class: "chosen" }, element("label", { for: this.kinds.id }, "Element"), this.kinds),
      element("div", { class: "tools", role: "group", "aria-label": "Design" }, this.undo, this.redo, file,
        button("Open …", () => file.click(), "Open a design file (TOML)"), this.compare, button("Print", actions.print, "Print a data sheet")),
      this.link,
      element("div", { class: "display" },
        element("fieldset", { class: "units" }, element("legend", { class: "unseen" }, "Show lengths in"),
          ...this.units.map((input) => element("label", {}, input, element("span", {}, input.value)))),
        button("◐", actions.theme, "Light or dark")));
  }

  linked(link: Link): void {
    this.link.textContent = { connecting: "connecting …", open: "", lost: "The server does not answer; trying again …" }[link];
  }

  show(kind: Kind, unit: LengthUnit, undoable: boolean, redoable: boolean, comparing: boolean): void {
    this.kinds.value = this.all.includes(kind) ? kind.name : "";
    for (const input of this.units) input.checked = input.value === unit;
    able(this.undo, undoable);
    able(this.redo, redoable);
    this.compare.setAttribute("aria-pressed", `${comparing}`);
    this.compare.textContent = comparing ? "Stop comparing" : "Compare";
    const label = comparing ? "Leave the comparison" : "Keep this design at the side and compare with it";
    this.compare.setAttribute("aria-label", label);
    this.compare.title = label;
  }
}

// A button without use keeps the focus that it has.
function able(button: HTMLButtonElement, on: boolean): void {
  button.setAttribute("aria-disabled", `${!on}`);
}

// Two wheels in mesh.
function mark(): SVGSVGElement {
  const NS = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(NS, "svg");
  svg.setAttribute("viewBox", "0 0 32 32");
  svg.setAttribute("aria-hidden", "true");
  svg.classList.add("mark");
  const wheel = (cx: number, cy: number, r: number, z: number, start: number) => {
    const points = Array.from({ length: 4 * z }, (_, i) => {
      const radius = i % 4 < 2 ? r + 1.7 : r - 1.5;
      const angle = start + ((i + [0.25, -0.2, 0.2, -0.25][i % 4]!) * 2 * Math.PI) / (4 * z);
      return `${cx + radius * Math.cos(angle)},${cy + radius * Math.sin(angle)}`;
    });
    const made = document.createElementNS(NS, "polygon");
    made.setAttribute("points", points.join(" "));
    return made;
  };
  svg.append(wheel(12, 18, 9, 14, 0.1), wheel(25, 7.5, 5, 8, 0));
  return svg;
}
