// A design to copy as text.

import type { ValuesAnswer } from "./protocol";

export function copying(_host: HTMLElement) {
  return { show(_values: ValuesAnswer): void {}, clear(): void {} };
}
