// Results of an earlier design than the form's, marked as such: at once where no others come, else after a while.

import { element } from "./dom";

const AFTER = 400; // ms: while values follow a slider nothing is marked
const TOLD = "Of an earlier design: what is typed has no values yet.";

export class Ageing {
  private timer = 0;
  private readonly told: HTMLElement[];

  // places: tables, each of which gets a line above it; strip: says so itself
  constructor(private readonly places: HTMLElement[], private readonly strip: HTMLElement) {
    this.told = places.map((place) => {
      const told = element("p", { class: "older" }, TOLD);
      told.hidden = true;
      place.before(told);
      return told;
    });
  }

  // atOnce: no others come until something else is typed
  mark(old: boolean, atOnce: boolean): void {
    if (old && !atOnce && !this.marked) {
      this.timer ||= window.setTimeout(() => this.put(true), AFTER);
      return;
    }
    this.put(old);
  }

  // Newer ones have come, though not the newest: they are waited for as long as before.
  came(): void {
    this.put(false);
  }

  private get marked(): boolean {
    return this.strip.hasAttribute("data-old");
  }

  private put(old: boolean): void {
    clearTimeout(this.timer);
    this.timer = 0;
    for (const place of [...this.places, this.strip]) place.toggleAttribute("data-old", old);
    for (const told of this.told) told.hidden = !old;
  }
}
