// A pair that runs: the turn as a slider, and by itself when asked to; only in steps where motion is not wanted.

import { button, element, slider, type Slider } from "./panel";

const STEP = 2; // degrees at a press
const EVERY = 250; // milliseconds, while the button is held
const LONGEST = 250; // milliseconds that count between two pictures: a page left alone does not jump

export class Running {
  readonly row: HTMLElement;
  rate = 30; // degrees a second
  private readonly turn: Slider;
  private readonly play: HTMLButtonElement;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");
  private last: number | null = null; // when the last step was, ms; null at rest
  private held = 0;
  private sense = 1;
  private most = 180;
  private degrees = 0; // finer than the steps of the slider

  // most: degrees either way; a full turn begins anew, less goes back and forth
  constructor(most: number, private readonly turned: (degrees: number) => void) {
    this.turn = slider("Turn of the pinion, degrees", (degrees) => `${degrees.toFixed(1).replace(/^-(?=[0.]*$)/, "")}°`, (degrees) => this.set(degrees));
    this.limit(most);
    this.play = button("▶", "Run", () => this.toggle());
    this.still.addEventListener("change", () => this.name());
    this.holdable();
    this.name();
    this.row = element("div", { class: "row" }, element("span", { class: "name" }, "turn"), this.turn.row, this.play);
  }

  limit(most: number): void {
    this.most = most;
    this.degrees = Math.min(Math.max(this.degrees, -most), most);
    this.turn.limit(-most, most);
    this.turn.set(this.degrees);
  }

  value(): number {
    return this.degrees;
  }

  set(degrees: number): void {
    this.degrees = degrees;
    this.turn.set(degrees);
    this.turned(degrees);
  }

  toggle(): void {
    if (this.still.matches && this.last === null) this.advance(STEP);
    else this.last === null ? this.start() : this.stop();
  }

  start(): void {
    this.last = performance.now();
    this.name();
    requestAnimationFrame((now) => this.step(now));
  }

  stop(): void {
    this.last = null;
    this.name();
  }

  private name(): void {
    const name = this.last !== null ? "Stop" : this.still.matches ? "Turn on by 2°, on and on while held" : "Run";
    this.play.textContent = this.last !== null ? "⏸" : this.still.matches ? "▸|" : "▶";
    this.play.setAttribute("aria-label", name);
    this.play.title = name;
  }

  private holdable(): void {
    const release = () => window.clearInterval(this.held);
    this.play.addEventListener("pointerdown", () => {
      if (!this.still.matches) return;
      release();
      this.held = window.setInterval(() => this.advance(STEP), EVERY);
    });
    for (const ending of ["pointerup", "pointerleave", "pointercancel", "blur"]) this.play.addEventListener(ending, release);
  }

  private step(now: number): void {
    if (this.last === null) return;
    this.advance((this.rate * Math.min(Math.max(now - this.last, 0), LONGEST)) / 1000);
    this.last = now;
    requestAnimationFrame((later) => this.step(later));
  }

  private advance(by: number): void {
    let degrees = this.degrees + this.sense * by;
    if (Math.abs(degrees) > this.most) {
      if (this.most >= 180) degrees -= 2 * this.most * this.sense;
      else {
        degrees = this.most * this.sense;
        this.sense = -this.sense;
      }
    }
    this.set(degrees);
  }
}
