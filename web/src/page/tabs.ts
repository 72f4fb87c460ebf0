// A list of tabs: arrow keys go from one to the next.

import { element, unique } from "./dom";

export class Tabs {
  readonly element: HTMLElement;
  private readonly list: HTMLElement;
  private readonly tabs = new Map<string, { tab: HTMLButtonElement; panel: HTMLElement }>();
  chosen = "";

  constructor(label: string, private readonly changed: (name: string) => void) {
    this.list = element("div", { role: "tablist", "aria-label": label });
    this.list.addEventListener("keydown", (event) => this.keyed(event));
    this.element = element("section", { class: "results", "aria-label": label }, this.list);
  }

  add(name: string, title: string, ...children: HTMLElement[]): void {
    const [id, panelId] = [unique("tab"), unique("panel")];
    const tab = element("button", { type: "button", role: "tab", id, "aria-controls": panelId, "data-tab": name }, title);
    const panel = element("div", { role: "tabpanel", id: panelId, "aria-labelledby": id, tabindex: "0", "data-panel": name }, ...children);
    tab.addEventListener("click", () => this.choose(name, true));
    this.list.append(tab);
    this.element.append(panel);
    this.tabs.set(name, { tab, panel });
    this.choose(this.chosen || name, false);
  }

  remove(name: string): void {
    const found = this.tabs.get(name);
    if (!found) return;
    found.tab.remove();
    found.panel.remove();
    this.tabs.delete(name);
    if (this.chosen === name) this.choose([...this.tabs.keys()][0]!, true);
  }

  // tell: whether somebody chose it
  choose(name: string, tell: boolean): void {
    this.chosen = this.tabs.has(name) ? name : [...this.tabs.keys()][0] ?? "";
    for (const [other, { tab, panel }] of this.tabs) {
      const on = other === this.chosen;
      tab.setAttribute("aria-selected", `${on}`);
      tab.tabIndex = on ? 0 : -1;
      panel.hidden = !on;
    }
    if (tell) this.changed(this.chosen);
  }

  private keyed(event: KeyboardEvent): void {
    const names = [...this.tabs.keys()];
    const at = names.indexOf(this.chosen);
    const next = { ArrowRight: at + 1, ArrowLeft: at - 1 + names.length, Home: 0, End: names.length - 1 }[event.key];
    if (next === undefined) return;
    event.preventDefault();
    const name = names[next % names.length]!;
    this.choose(name, true);
    this.tabs.get(name)!.tab.focus();
  }
}
