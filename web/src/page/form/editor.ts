// What every field of the form does, and what it knows of the rest of the page.

import type { Api } from "../api";
import type { LengthUnit, Value } from "../protocol";

export interface Context {
  api: Api;
  members: [string, string]; // what the members of a pair are called
  unit(): LengthUnit; // of the design's lengths
  scale(): number; // the size of the design, in that unit
  outline?(): Value | undefined; // that of the section which is being edited
  put(values: Record<string, Value | undefined>): void; // sets other parameters
  problem(): void; // tells the form that a field has another problem than before
}

export interface Editor {
  readonly element: HTMLElement;
  readonly aside?: HTMLElement; // what stands beside the name
  readonly inputs: HTMLElement[]; // those that a problem is about
  set(value: Value | undefined): void; // undefined: nothing is given
  problem(): string | null; // what keeps its words from being a value
}

// undefined: nothing is given any more
export type Changed = (value: Value | undefined) => void;
