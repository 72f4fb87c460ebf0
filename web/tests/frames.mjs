// Mesh frames as the server sends them, made here: cog wheels of one tooth and its images.

const FULL = 0x1fffff;

const turned = (angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
};

export const at = (x, y, z, angle = 0) => turned(angle).map((value, k) => ({ 3: x, 7: y, 11: z })[k] ?? value);

// A unit normal as two int16 of an octahedron.
export function octahedral([x, y, z]) {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
  let [u, v] = [x / sum, y / sum];
  if (z < 0) [u, v] = [(1 - Math.abs(v)) * (u < 0 ? -1 : 1), (1 - Math.abs(u)) * (v < 0 ? -1 : 1)];
  return [Math.round(32767 * u), Math.round(32767 * v)];
}

// Points as integers of 21 bits over their box, two uint32 a point.
export function packed(points) {
  const least = [0, 1, 2].map((k) => Math.min(...points.map((point) => point[k])));
  const most = [0, 1, 2].map((k) => Math.max(...points.map((point) => point[k])));
  const step = least.map((from, k) => (most[k] - from) / FULL);
  const words = new Uint32Array(2 * points.length);
  points.forEach((point, i) => {
    const [x, y, z] = point.map((value, k) => (step[k] ? Math.round((value - least[k]) / step[k]) : 0));
    words[2 * i] = (x | (y << 11 << 10)) >>> 0;
    words[2 * i + 1] = ((y >>> 11) | (z << 10)) >>> 0;
  });
  return { least, step, words };
}

// Shells of a cog wheel about z from z = 0 to width: a tooth's sides, and its part of either end.
// teeth stand from the root to the tip over half of a pitch, the first one about x
export function cog(key, { teeth, root, tip, width, bore = 0 }) {
  const pitch = (2 * Math.PI) / teeth;
  const outline = [
    [root, -0.5], [root, -0.25], [tip, -0.18], [tip, 0.18], [root, 0.25], [root, 0.5],
  ].map(([radius, share]) => [radius * Math.cos(share * pitch), radius * Math.sin(share * pitch)]);
  const image = teeth > 1 ? turned(pitch) : null;
  const shared = { order: teeth, image };
  return [{ ...shared, key: `${key} sides`, ...sides(outline, width) },
    ...(bore ? [{ ...shared, key: `${key} bore`, ...sides([0.5, 0, -0.5].map((share) =>
      [bore * Math.cos(share * pitch), bore * Math.sin(share * pitch)]), width) }] : []),
    ...[0, width].map((z) => ({ ...shared, key: `${key} end ${z ? 1 : 0}`, ...end(outline, bore, pitch, z) }))];
}

function sides(outline, width) {
  const [points, normals, triangles, edges] = [[], [], [], []];
  outline.slice(1).forEach(([x, y], k) => {
    const [x0, y0] = outline[k];
    const length = Math.hypot(x - x0, y - y0);
    const first = points.length;
    points.push([x0, y0, 0], [x, y, 0], [x, y, width], [x0, y0, width]);
    for (let i = 0; i < 4; i++) normals.push([(y - y0) / length, (x0 - x) / length, 0]);
    triangles.push([first, first + 1, first + 2], [first, first + 2, first + 3]);
    edges.push([first, first + 1], [first + 2, first + 3], ...(k ? [[first, first + 3]] : []));
  });
  return { points, normals, triangles, edges };
}

function end(outline, bore, pitch, z) {
  const inner = bore ? outline.map(([x, y]) => [x, y].map((value) => (bore * value) / Math.hypot(x, y))) : [[0, 0]];
  // on the bore only its ends and middle are points of its sides; the others lie a little off, as nothing sees
  const points = [...outline, ...inner].map(([x, y]) => [x, y, z]);
  const count = outline.length;
  const triangles = [];
  for (let k = 0; k + 1 < count; k++) {
    if (bore) triangles.push([count + k, k, k + 1], [count + k, k + 1, count + k + 1]);
    else triangles.push([count, k, k + 1]);
  }
  return { points, normal: [0, 0, z ? 1 : -1], triangles: z ? triangles : triangles.map(([a, b, c]) => [a, c, b]), edges: [] };
}

// have: keys whose triangles and edges are left out
export function frame({ bodies, have = [], id = 1, ...told }) {
  const buffers = [];
  let bytes = 0;
  const add = (array) => {
    const start = bytes;
    const padded = new Uint8Array(4 * Math.ceil(array.byteLength / 4));
    padded.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
    buffers.push(padded);
    bytes += padded.length;
    return start;
  };
  let drawn = 0;
  const headers = bodies.map(({ shells, ...body }) => ({
    colour: [0.8, 0.64, 0.36], place: at(0, 0, 0), spin: 0, slide: [0, 0, 0], closed: true, ...boxOf(shells, body.place), ...body,
    shells: shells.map(({ key, order, image, points, normals, normal, triangles, edges }) => {
      const { least, step, words } = packed(points);
      drawn += order * triangles.length;
      const sent = !have.includes(key);
      return {
        key, order, image, vertices: points.length, least, step, positions: add(words),
        normals: normals ? add(Int16Array.from(normals.flatMap(octahedral))) : null, ...(normal ? { normal } : {}),
        triangles: sent ? [add(Uint32Array.from(triangles.flat())), triangles.length] : null,
        edges: sent ? [add(Uint32Array.from(edges.flat())), edges.length] : null,
      };
    }),
  }));
  const header = new TextEncoder().encode(JSON.stringify({
    answer: "mesh", id, title: "cog: one", unit: "mm", direction: [0.5, -0.7, 0.5], up: [0, 0, 1], turns: null,
    tolerance: 0.01, triangles: drawn, bytes, bodies: headers, ...told,
  }));
  const length = 8 * Math.ceil((4 + header.length) / 8) - 4;
  const whole = new Uint8Array(4 + length + bytes).fill(32, 0, 4 + length);
  new DataView(whole.buffer).setUint32(0, length, true);
  whole.set(header, 4);
  let start = 4 + length;
  for (const buffer of buffers) {
    whole.set(buffer, start);
    start += buffer.length;
  }
  return whole.buffer;
}

function boxOf(shells, place = at(0, 0, 0)) {
  const [least, most] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (const { points, order, image } of shells) {
    for (let k = 0; k < order; k++) {
      const map = image ? turned(Math.atan2(image[4], image[0]) * k) : at(0, 0, 0);
      for (const point of points) {
        moved(place, moved(map, point)).forEach((value, axis) => {
          least[axis] = Math.min(least[axis], value);
          most[axis] = Math.max(most[axis], value);
        });
      }
    }
  }
  return { least, most };
}

const moved = (map, [x, y, z]) =>
  [0, 4, 8].map((row) => map[row] * x + map[row + 1] * y + map[row + 2] * z + map[row + 3]);
