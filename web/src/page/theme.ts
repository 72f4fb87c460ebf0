// Light or dark: as the system says, until somebody chooses.

import { keep, recalled } from "./storage";

export type Theme = "light" | "dark";

const KEY = "gearwright.theme";

export class Themes {
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private chosen: Theme | null;

  private changed: (theme: Theme) => void = () => {};

  constructor() {
    const kept = recalled(KEY);
    this.chosen = kept === "light" || kept === "dark" ? kept : null;
    this.dark.addEventListener("change", () => this.apply());
    this.apply();
  }

  follow(changed: (theme: Theme) => void): void {
    this.changed = changed;
    changed(this.current);
  }

  get current(): Theme {
    return this.chosen ?? (this.dark.matches ? "dark" : "light");
  }

  toggle(): void {
    const other = this.current === "dark" ? "light" : "dark";
    this.chosen = other === (this.dark.matches ? "dark" : "light") ? null : other;
    keep(KEY, this.chosen ?? "");
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset.theme = this.current;
    this.changed(this.current);
  }
}
