// Which kind of element a design is of, and what it is called.

import { inUnit, unitOf, type Values } from "./design";
import type { Design, Kind } from "./protocol";

// As the server chooses: a pair where two numbers of teeth are given.
export function kindOf(kinds: Kind[], design: Design): Kind | null {
  const same = kinds.filter((kind) => kind.command === design.element);
  const members = Array.isArray(design.teeth) ? 2 : 1;
  return same.find((kind) => kind.members === members) ?? same[0] ?? null;
}

// Kinds by their commands, in the order of an engineer's shelf; unknown ones last.
export function grouped(kinds: Kind[]): [command: string, kinds: Kind[]][] {
  const order = ["spur", "helical", "herringbone", "internal", "rack", "bevel", "cam", "sweep"];
  const place = (command: string) => (order.includes(command) ? order.indexOf(command) : order.length);
  const commands = [...new Set(kinds.map((kind) => kind.command))].sort((a, b) => place(a) - place(b));
  return commands.map((command) => [
    command, kinds.filter((kind) => kind.command === command).sort((a, b) => b.members - a.members),
  ]);
}

// The two members of a pair, in words.
export const memberNames = (kind: Kind): [string, string] => ["pinion", kind.mate];

const ALIKE = ["spur", "helical", "herringbone"];
const SHARED = ["teeth", "module", "diametral_pitch", "face_width", "pressure_angle", "length_unit"];

// What to start with: the kind's example, with what the design before it has in common where the kinds are alike.
export function startOf(kind: Kind, before: Kind | null, design: Design | null): Design {
  const own = { ...kind.start };
  if (!before || !design || before.members !== kind.members) return own;
  if (!ALIKE.includes(kind.command) || !ALIKE.includes(before.command)) return own;
  const kept = inUnit(kind, withoutBody(kind, design), unitOf(kind.start), unitOf(design));
  for (const name of SHARED) {
    if (name in design) kept[name] = design[name]!;
    else delete kept[name];
  }
  return { ...kept, element: kind.command };
}

// The kind's example; of teeth of another size, without the lengths that it can do without, since they fit its own.
function withoutBody(kind: Kind, design: Design): Values {
  const same = SHARED.every((name) => JSON.stringify(kind.start[name]) === JSON.stringify(design[name]));
  const fits = (name: string) => {
    const parameter = kind.parameters.find((one) => one.name === name);
    return same || parameter?.unit !== "length" || parameter.required || SHARED.includes(name);
  };
  return Object.fromEntries(Object.entries(kind.start).filter(([name]) => fits(name)));
}
