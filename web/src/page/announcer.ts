// What is said aloud and shown in passing: short results, problems, notes of the server.

import { button, element } from "./dom";

const PAUSE = 700; // ms: while values follow a slider nothing is said
const STAY = 8000;
const MOST = 3; // notes at a time

export class Announcer {
  readonly spoken = element("p", { class: "unseen", role: "status", "aria-live": "polite", id: "spoken" });
  readonly toasts = element("div", { class: "toasts", role: "status", "aria-live": "polite" });
  private timer = 0;

  // The newest of what is to be said, once there is a pause.
  say(text: string): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      if (this.spoken.textContent !== text) this.spoken.textContent = text;
    }, PAUSE);
  }

  note(text: string, stay = STAY): void {
    const toast = element("div", { class: "toast" }, element("span", {}, text), button("✕", () => toast.remove(), "Close this note"));
    for (const old of [...this.toasts.children].filter((one) => one.firstChild?.textContent === text)) old.remove();
    this.toasts.append(toast);
    if (this.toasts.children.length > MOST) this.toasts.firstElementChild!.remove();
    const leave = () => {
      if (toast.contains(document.activeElement) || toast.matches(":hover")) setTimeout(leave, 1000);
      else toast.remove();
    };
    setTimeout(leave, stay);
  }
}
