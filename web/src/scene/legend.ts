// The bodies by name and colour, each to be hidden; hidden ones stay so when they change.

import type { Body } from "./body";
import { check, element } from "./panel";

export class Legend {
  readonly element = element("div", { class: "mv-legend", role: "group", "aria-label": "Bodies" });
  private readonly hidden = new Set<string>();
  private told = "";

  constructor(private readonly changed: () => void) {}

  show(bodies: readonly Body[]): void {
    for (const body of bodies) body.group.visible = bodies.length < 2 || !this.hidden.has(body.solid.name);
    const told = bodies.map((body) => `${body.solid.called ?? body.solid.name} ${body.colour.getHexString()}`).join();
    if (this.told === told) return; // so that none loses the focus
    this.told = told;
    this.element.replaceChildren(...(bodies.length < 2 ? [] : bodies).map((body) => this.entry(body)));
  }

  private entry(body: Body): HTMLElement {
    const { name, called = name } = body.solid;
    const swatch = element("i");
    swatch.style.background = `#${body.colour.getHexString()}`;
    return check([swatch, called], `Show ${called}`, !this.hidden.has(name), (on) => {
      if (on) this.hidden.delete(name);
      else this.hidden.add(name);
      body.group.visible = on;
      this.changed();
    });
  }
}
