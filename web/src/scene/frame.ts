// A mesh frame of the server, decoded: bodies with all images of their patterns, ready to be drawn.

import { normalsInto, positionsInto } from "./packed";
import { joined, normalsOfImage, pointsInto, powers, type Repeated, type Rigid } from "./pattern";
import type { Index, Solid, Triple } from "./solid";
import { TopologyMissing, type Topologies } from "./topologies";

export { Topologies, TopologyMissing } from "./topologies";

export interface ShellHeader {
  key: string;
  order: number; // how many images, itself among them
  image: number[] | null; // 4 × 4, by rows: the map to image 1; image k is its k-th power
  vertices: number;
  least: Triple;
  step: Triple;
  positions: number; // offsets from the end of the header, in bytes
  normals: number | null;
  normal?: Triple | null; // of a flat shell
  triangles: [number, number] | null; // offset and count; null: to be had by the key
  edges: [number, number] | null;
}

export interface BodyHeader extends Pick<Solid, "name" | "called" | "colour" | "place" | "spin" | "slide" | "least" | "most" | "closed"> {
  shells: ShellHeader[];
}

interface Told {
  answer: "mesh";
  id: number;
  title: string;
  unit: string;
  direction: Triple; // towards the eye
  up: Triple;
  turns: number | null; // the turn goes from minus so many degrees to plus so many; null where nothing turns
  tolerance: number;
  triangles: number;
  bytes: number;
}

export interface MeshHeader extends Told {
  bodies: BodyHeader[];
}

export interface ModelFrame extends Told {
  bodies: Solid[];
}

// Raises TopologyMissing where the frame counts on a topology that is not known any more.
export function decodeMesh(data: ArrayBuffer, known: Topologies): ModelFrame {
  const length = new DataView(data).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))) as MeshHeader;
  return { ...header, bodies: header.bodies.map((body) => solid(body, data, 4 + length, known)) };
}

interface Decoded extends Repeated {
  points: Float64Array; // three a vertex
  normals: Float64Array; // three a vertex, or three in all
  images: Rigid[];
}

function solid(body: BodyHeader, data: ArrayBuffer, start: number, known: Topologies): Solid {
  const { shells, ...told } = body;
  const decoded = shells.map((shell) => decode(shell, data, start, known));
  const centre = middle(shells, decoded);
  const count = decoded.reduce((sum, shell) => sum + shell.order * shell.vertices, 0);
  const positions = new Float32Array(3 * count);
  const normals = new Int16Array(3 * count);
  let at = 0;
  for (const shell of decoded) {
    for (const map of shell.images) {
      pointsInto(positions, at, shell.points, map, centre);
      normalsOfImage(normals, at, shell.vertices, shell.normals, map);
      at += 3 * shell.vertices;
    }
  }
  const topology = shells.map((shell) => `${shell.key} ${shell.order} ${shell.vertices}`).join("|");
  return { ...told, positions, normals, index: () => joined(decoded), topology, centre };
}

function decode(shell: ShellHeader, data: ArrayBuffer, start: number, known: Topologies): Decoded {
  const points = new Float64Array(3 * shell.vertices);
  positionsInto(points, new Uint32Array(data, start + shell.positions, 2 * shell.vertices), shell.least, shell.step);
  let normals = Float64Array.from(shell.normal ?? []);
  if (shell.normals !== null) {
    normals = new Float64Array(3 * shell.vertices);
    normalsInto(normals, new Int16Array(data, start + shell.normals, 2 * shell.vertices));
  }
  const index = topology(shell, data, start, known);
  const images = powers(shell.image, shell.order);
  return { points, normals, images, index, order: shell.order, vertices: shell.vertices };
}

function topology(shell: ShellHeader, data: ArrayBuffer, start: number, known: Topologies): Index {
  if (shell.triangles && shell.edges) {
    // copies, so that the message itself need not be kept
    const triangles = new Uint32Array(data, start + shell.triangles[0], 3 * shell.triangles[1]).slice();
    const edges = new Uint32Array(data, start + shell.edges[0], 2 * shell.edges[1]).slice();
    known.keep(shell.key, { triangles, edges });
    return { triangles, edges };
  }
  const found = known.get(shell.key);
  if (!found) throw new TopologyMissing(shell.key);
  return found;
}

// The middle of the boxes of all images: relative to it, 32 bits hold positions wherever the body lies.
function middle(shells: readonly ShellHeader[], decoded: readonly Decoded[]): Triple {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  shells.forEach(({ least: corner, step }, number) => {
    const half = step.map((one) => 0x100000 * one);
    const [x, y, z] = corner.map((one, axis) => one + half[axis]!) as Triple;
    for (const map of decoded[number]!.images) {
      for (let axis = 0; axis < 3; axis++) {
        const [a, b, c, shift] = map.slice(4 * axis, 4 * axis + 4) as [number, number, number, number];
        const at = a * x + b * y + c * z + shift;
        least[axis] = Math.min(least[axis]!, at);
        most[axis] = Math.max(most[axis]!, at);
      }
    }
  });
  return [0, 1, 2].map((axis) => (least[axis]! + most[axis]!) / 2) as Triple;
}
