// States to come back to: step by step, and the last one when the page is opened again.

import { hashOf, type State } from "./hash";
import { History } from "./history";
import { keep, recalled } from "./storage";

const KEY = "gearwright.design";
const SETTLED = 600; // ms without a change

// How a state is displayed is nothing to come back to.
const bare = (state: State): State => ({ ...state, tab: "", unit: null });

// Whether two states differ in nothing but how they are displayed.
export const alike = (one: State, other: State): boolean => hashOf(bare(one)) === hashOf(bare(other));

export const lastKept = (): string | null => recalled(KEY);

export class Past {
  private history!: History<State>; // begun at once
  private timer = 0;

  // before: what undoing leads to from the first state; now: the state that is settled on; changed: there may be more
  // to undo, or less
  constructor(before: State, first: State, private readonly now: () => State, private readonly changed: () => void) {
    this.begin(before);
    this.history.settle(bare(first));
  }

  get undoable(): boolean {
    return this.history.undoable;
  }

  get redoable(): boolean {
    return this.history.redoable;
  }

  begin(first: State): void {
    this.history = new History(hashOf, bare(first));
  }

  soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.settle(), SETTLED);
  }

  settle(): void {
    clearTimeout(this.timer);
    this.history.settle(bare(this.now()));
    keep(KEY, hashOf(bare(this.now())));
    this.changed();
  }

  // The state to go to, displayed as the one that is left; null where there is none.
  step(way: "undo" | "redo"): State | null {
    this.settle();
    const state = this.history[way]();
    const { tab, unit } = this.now();
    return state && { ...state, tab, unit };
  }
}
