// Files of a design.

import type { Api } from "./api";
import type { Design, Kind } from "./protocol";

export function outputs(_host: HTMLElement, _api: Api) {
  return {
    kind(_kind: Kind): void {},
    design(_design: Design, _options: { density: number | null; material: string | null }): void {},
  };
}
