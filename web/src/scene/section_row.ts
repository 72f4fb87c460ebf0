// What the section plane is operated with: across which axis, where, and which side is taken away.

import { button, choice, element, slider, type Slider } from "./panel";
import type { Axis, Section } from "./section";
import type { Stage } from "./stage";

const ACROSS = { "": "none", x: "across x", y: "across y", z: "across z" };

export class SectionRow {
  readonly row: HTMLElement;
  private readonly place: Slider;
  private readonly flip: HTMLButtonElement;
  private digits = 1;

  // factor and unit: a length of the scene as it is read out
  constructor(
    private readonly stage: Stage, private readonly section: Section, private readonly cut: (place: number) => void,
    private unit: string, private factor = 1,
  ) {
    this.place = slider("Place of the cut", (value) => this.told(value), cut);
    this.flip = button("⇄", "Show the other side", () => {
      section.flipped = !section.flipped;
      this.refresh();
    });
    const axes = choice("Section plane", ACROSS, (value) => this.choose(value ? (value as Axis) : null));
    this.place.row.hidden = this.flip.hidden = true;
    this.row = element("div", { class: "row" }, element("span", { class: "name" }, "section"), axes, this.place.row, this.flip);
  }

  // The bodies are other ones: the cut stays where it is, as far as they reach.
  refresh(): void {
    const { axis } = this.section;
    if (axis) this.limit(axis, this.place.value());
    this.cut(this.place.value());
  }

  readIn(unit: string, factor: number): void {
    Object.assign(this, { unit, factor });
    if (this.section.axis) this.limit(this.section.axis, this.place.value());
  }

  private choose(axis: Axis | null): void {
    this.section.choose(axis, this.stage.direction());
    this.place.row.hidden = this.flip.hidden = !axis;
    if (axis) {
      const [least, most] = this.section.limits(axis);
      this.limit(axis, (least + most) / 2);
    }
    this.cut(this.place.value());
  }

  private limit(axis: Axis, place: number): void {
    const [least, most] = this.section.limits(axis);
    this.digits = Math.max(0, 2 - Math.floor(Math.log10((most - least) * this.factor)));
    this.place.limit(least, most);
    this.place.set(Math.min(Math.max(place, least), most));
  }

  private told(value: number): string {
    return `${(value * this.factor).toFixed(this.digits).replace(/^-(?=[0.]*$)/, "")} ${this.unit}`;
  }
}
