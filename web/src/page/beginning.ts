// What the page opens with: the design of the address, the last one, or an example.

import { faultOf, type State, stateOf } from "./hash";
import { kindOf } from "./kinds";
import type { Kind } from "./protocol";

export interface Beginning {
  state: State;
  again: boolean; // whether it is the last design
  note: string; // what is to be said about it
}

// hash: of the address; last: of the last design, or null
export function beginning(kinds: Kind[], hash: string, last: string | null, example: State): Beginning {
  const known = (text: string): State | null => {
    const state = stateOf(text);
    return state && kindOf(kinds, state.design) ? state : null;
  };
  const named = known(hash);
  if (named) return { state: named, again: false, note: "" };
  const note = hash.length > 1 ? faultOf(hash) : "";
  const kept = known(last ?? "");
  if (kept) return { state: kept, again: true, note: note || "Your last design is open again; Undo leads to the example." };
  return { state: example, again: false, note };
}
