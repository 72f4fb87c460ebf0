// A pair that runs: the turn as a slider, and by itself when asked to.

import { button, element, slider, type Slider } from "./panel";

const DEGREES_A_SECOND = 30;

export class Running {
  readonly row: HTMLElement;
  private readonly turn: Slider;
  private readonly play: HTMLButtonElement;
  private last: number | null = null; // when the last step was, ms; null at rest
  private sense = 1;

  // most: degrees either way; a full turn begins anew, less goes back and forth
  constructor(private readonly most: number, private readonly turned: (degrees: number) => void) {
    this.turn = slider("Turn of the pinion, degrees", (degrees) => `${degrees.toFixed(1)}°`, turned);
    this.turn.limit(-most, most);
    this.turn.set(0);
    this.play = button("▶", "Run", () => this.toggle());
    this.row = element("div", { class: "row" }, element("span", { class: "name" }, "turn"), this.turn.row, this.play);
  }

  toggle(): void {
    const runs = this.last === null;
    this.last = runs ? performance.now() : null;
    this.play.textContent = runs ? "⏸" : "▶";
    this.play.setAttribute("aria-label", runs ? "Stop" : "Run");
    this.play.title = runs ? "Stop" : "Run";
    if (runs) requestAnimationFrame((now) => this.step(now));
  }

  private step(now: number): void {
    if (this.last === null) return;
    let degrees = this.turn.value() + (this.sense * DEGREES_A_SECOND * Math.max(now - this.last, 0)) / 1000;
    if (Math.abs(degrees) > this.most) {
      if (this.most >= 180) degrees -= 2 * this.most * this.sense;
      else {
        degrees = this.most * this.sense;
        this.sense = -this.sense;
      }
    }
    this.last = now;
    this.turn.set(degrees);
    this.turned(degrees);
    requestAnimationFrame((later) => this.step(later));
  }
}
