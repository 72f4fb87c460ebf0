// Sizes and properties as tables.

import type { ApproximationAnswer, ValuesAnswer } from "./protocol";

export function tables(hosts: { sizes: HTMLElement; mass: HTMLElement }) {
  return {
    show(values: ValuesAnswer, _approximation: ApproximationAnswer | null, _unit: "mm" | "in"): void {
      hosts.sizes.textContent = JSON.stringify(values.document);
    },
    clear(): void {
      hosts.sizes.replaceChildren();
      hosts.mass.replaceChildren();
    },
  };
}
