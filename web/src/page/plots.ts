// Plots of a design.

import type { Api } from "./api";
import type { Design, Kind } from "./protocol";

export function plots(_host: HTMLElement, _api: Api) {
  return { kind(_kind: Kind): void {}, design(_design: Design): void {} };
}
