// The place of the view in three dimensions.

import type { OverlaysAnswer, ValuesAnswer } from "../page/protocol";
import type { ModelFrame } from "./frame";

export class ModelView {
  private readonly text = document.createElement("p");

  constructor(host: HTMLElement, options: { label?: string } = {}) {
    if (options.label) this.text.setAttribute("aria-label", options.label);
    host.append(this.text);
  }

  show(frame: ModelFrame): void {
    this.text.textContent = frame.title;
  }

  setValues(_values: ValuesAnswer | null): void {}
  setOverlays(_answer: OverlaysAnswer | null): void {}
  setUnit(_unit: "mm" | "in"): void {}
  setTheme(_theme: "light" | "dark"): void {}
  dispose(): void {
    this.text.remove();
  }
}
