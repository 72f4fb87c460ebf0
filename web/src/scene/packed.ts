// Numbers as a mesh frame packs them: positions of 21 bits a coordinate, normals as points of an unfolded octahedron.

export const FULL = 32767;

// Vertex by vertex 8 bytes, two uint32; position = least + step · integer. Out: three a vertex.
export function positionsInto(
  out: Float64Array, packed: Uint32Array, least: readonly number[], step: readonly number[],
): void {
  const [x0, y0, z0] = least as [number, number, number];
  const [dx, dy, dz] = step as [number, number, number];
  for (let i = 0, at = 0; i < packed.length; i += 2, at += 3) {
    const low = packed[i]!;
    const high = packed[i + 1]!;
    out[at] = x0 + dx * (low & 0x1fffff);
    out[at + 1] = y0 + dy * ((low >>> 21) | ((high & 0x3ff) << 11));
    out[at + 2] = z0 + dz * ((high >>> 10) & 0x1fffff);
  }
}

// Vertex by vertex two int16: the upper half of the octahedron is the inner square, the lower its four corners.
export function normalsInto(out: Float64Array, packed: Int16Array): void {
  for (let i = 0, at = 0; i < packed.length; i += 2, at += 3) {
    let x = packed[i]! / FULL;
    let y = packed[i + 1]! / FULL;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      const folded = x;
      x = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
      y = (1 - Math.abs(folded)) * (y < 0 ? -1 : 1);
    }
    const length = Math.hypot(x, y, z);
    out[at] = x / length;
    out[at + 1] = y / length;
    out[at + 2] = z / length;
  }
}
