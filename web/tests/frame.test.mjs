// Mesh frames decoded: positions, normals and images are where formulas say, and topologies are kept by their keys.
import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";
import { bundled } from "./bundles.mjs";
import { at, cog, frame, octahedral } from "./frames.mjs";

let decodeMesh, Topologies, TopologyMissing;

before(async () => {
  const folder = await bundled("frame", "src/scene/frame.ts", "es");
  ({ decodeMesh, Topologies, TopologyMissing } = await import(join(folder, "frame.js")));
});

const WHEEL = { teeth: 7, root: 20, tip: 25, width: 6 };
const decoded = (shells, told = {}, known = new Topologies()) =>
  decodeMesh(frame({ bodies: [{ name: "one", shells, ...told }] }), known).bodies[0];

// Volume and area enclosed by triangles, by the divergence theorem.
function measured({ positions, index }) {
  const { triangles } = index();
  const point = (k) => [...positions.slice(3 * triangles[k], 3 * triangles[k] + 3)];
  let volume = 0;
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [point(k), point(k + 1), point(k + 2)];
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return volume;
}

test("all images of a tooth enclose what the wheel does", () => {
  const pitch = (2 * Math.PI) / 7;
  const triangle = (p, q, angle) => 0.5 * p * q * Math.sin(angle * pitch);
  const sector = 2 * triangle(20, 20, 0.25) + 2 * triangle(20, 25, 0.07) + triangle(25, 25, 0.36);
  const volume = measured(decoded(cog("a", WHEEL)));
  assert.ok(Math.abs(volume / (7 * sector * 6) - 1) < 1e-5, `${volume} ${7 * sector * 6}`);
});

test("a wheel is closed, and every normal stands outwards on its triangle", () => {
  const { positions, normals, index } = decoded(cog("a", WHEEL));
  const { triangles } = index();
  const triple = (array, k) => [...array.slice(3 * k, 3 * k + 3)];
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => triple(positions, triangles[k + corner]));
    const [u, v] = [b, c].map((point) => point.map((value, axis) => value - a[axis]));
    const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const normal = triple(normals, triangles[k]).map((value) => value / 32767);
    const cosine = cross.reduce((sum, value, axis) => sum + value * normal[axis], 0) / Math.hypot(...cross) / Math.hypot(...normal);
    assert.ok(cosine > 1 - 1e-7 && Math.abs(Math.hypot(...normal) - 1) < 3e-5, `triangle ${k / 3}: ${cosine}`);
  }
});

test("image k is the k-th power of the map, in the order of the vertices", () => {
  const shells = cog("a", WHEEL);
  const { positions, centre } = decoded(shells);
  const count = shells[0].points.length;
  for (const k of [0, 1, 3, 6]) {
    const angle = (2 * Math.PI * k) / 7;
    shells[0].points.forEach(([x, y, z], vertex) => {
      const wanted = [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), z];
      const found = [0, 1, 2].map((axis) => positions[3 * (k * count + vertex) + axis] + centre[axis]);
      assert.ok(Math.hypot(...wanted.map((value, axis) => value - found[axis])) < 1e-4, `image ${k}, vertex ${vertex}`);
    });
  }
});

test("21 bits a coordinate are 21 bits, over the words, far from the origin, too", () => {
  const shell = { key: "p", order: 1, image: null, normal: [0, 0, 1], triangles: [[0, 1, 2]], edges: [] };
  const points = Array.from({ length: 200 }, (_, k) =>
    [1e6 + Math.sin(k), 40 * Math.cos(3 * k), k === 7 ? -1e-3 : 1e-3 * Math.sin(5 * k)]);
  const { positions, centre } = decoded([{ ...shell, points }]);
  [2, 80, 2e-3].forEach((extent, axis) => {
    const worst = Math.max(...points.map((point, k) => Math.abs(positions[3 * k + axis] + centre[axis] - point[axis])));
    assert.ok(worst < 0.51 * (extent / 0x1fffff) + 2e-7 * extent + 1.2e-10, `axis ${axis}: ${worst}`);
  });
});

test("normals come out of the octahedron as they went in, on either half", () => {
  const normals = Array.from({ length: 300 }, (_, k) => {
    const z = 1 - (2 * (k + 0.5)) / 300;
    return [Math.sqrt(1 - z * z) * Math.cos(2.4 * k), Math.sqrt(1 - z * z) * Math.sin(2.4 * k), z];
  });
  normals.push([1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]);
  assert.ok(octahedral([0, 0, -1]).every((value) => Math.abs(value) === 32767));
  const body = decoded([{ key: "n", order: 1, image: null, points: normals, normals, triangles: [[0, 1, 2]], edges: [] }]);
  normals.forEach((normal, k) => {
    const found = [...body.normals.slice(3 * k, 3 * k + 3)].map((value) => value / 32767);
    assert.ok(Math.hypot(...normal.map((value, axis) => value - found[axis])) < 1.5e-4, `${normal} ${found}`);
  });
});

test("a frame without triangles takes those of its key, and says so where they are unknown", () => {
  const known = new Topologies();
  const first = decoded(cog("a", WHEEL), {}, known);
  assert.deepEqual(known.held(), ["a sides", "a end 0", "a end 1"]);
  const larger = cog("a", { ...WHEEL, tip: 27 });
  const data = frame({ bodies: [{ name: "one", shells: larger }], have: known.held() });
  const second = decodeMesh(data, known).bodies[0];
  assert.equal(second.topology, first.topology);
  assert.deepEqual(second.index(), first.index());
  assert.ok(measured(second) > 1.02 * measured(first));
  assert.throws(() => decodeMesh(data, new Topologies()), (error) => error instanceof TopologyMissing && error.key === "a sides");
  const more = decoded(cog("a", { ...WHEEL, teeth: 8 }), {}, known);
  assert.notEqual(more.topology, first.topology);
});

test("topologies make room, those asked for longest ago first", () => {
  const known = new Topologies(3);
  const index = { triangles: new Uint32Array(3), edges: new Uint32Array(2) };
  for (const key of ["a", "b", "c"]) known.keep(key, index);
  known.get("a");
  known.keep("d", index);
  assert.deepEqual(known.held(), ["c", "a", "d"]);
  assert.equal(known.get("b"), undefined);
  const many = new Topologies();
  for (let k = 0; k < 100; k++) many.keep(`${k}`, index);
  assert.equal(many.held().length, 64);
});

test("the centre is the middle of all images, and positions are relative to it", () => {
  const { centre, positions } = decoded(cog("a", { ...WHEEL, teeth: 8 }));
  assert.ok(Math.hypot(centre[0], centre[1]) < 1e-5 && Math.abs(centre[2] - 3) < 1e-5, `${centre}`);
  assert.ok(Math.abs(Math.max(...positions.filter((_, k) => k % 3 === 2)) - 3) < 1e-5);
  assert.deepEqual(decoded(cog("a", WHEEL), { place: at(1, 2, 3) }).place.filter((_, k) => k % 4 === 3), [1, 2, 3, 1]);
});
