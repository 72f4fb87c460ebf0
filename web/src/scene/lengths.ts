// Lengths in the unit that is read out, which need not be the one that the design is in.

const MILLIMETRES: Record<string, number> = { mm: 1, in: 25.4 };

// By how much a length in one unit is to be multiplied for another; units without a size stay what they are.
export function factor(from: string, to: string): number {
  const [one, other] = [MILLIMETRES[from], MILLIMETRES[to]];
  return one && other ? one / other : 1;
}

// The unit to read out: the one that is wanted, unless lengths have none.
export const readOut = (unit: string, wanted: string) => (unit in MILLIMETRES ? wanted : unit);

// Four digits, without an exponent where that can be.
export function figures(value: number): string {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(3);
  return value.toFixed(Math.max(0, 3 - Math.floor(Math.log10(size || 1))));
}
