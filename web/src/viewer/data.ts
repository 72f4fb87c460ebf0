// What Python hands over (src/gearwright/viewer/document.py), and its arrays as numbers.

import type { Solid, Triple } from "../scene/solid";

export interface BodyData {
  name: string;
  colour: Triple; // sRGB, 0 to 1
  positions: string; // float32, three a vertex, relative to the centre
  normals: string; // int16, three a vertex, of 32767
  triangles: string; // uint32
  edges: string; // uint32, two a sharp edge
  closed: boolean;
  centre: Triple; // in the body's own frame
  least: Triple; // corners of the box that it takes in the scene
  most: Triple;
  place: number[]; // 4 × 4, by rows: the body's frame in the scene
  spin: number; // degrees about the body's own z for one of the turn
  slide: Triple; // shift in the body's own frame for one degree of the turn
}

export interface SceneData {
  title: string;
  unit: string;
  direction: Triple; // towards the eye
  up: Triple;
  turns: number | null; // the turn goes from minus so many degrees to plus so many; null where nothing turns
  bodies: BodyData[];
}

export function readScene(): SceneData {
  return JSON.parse(document.getElementById("gearwright-scene")!.textContent!) as SceneData;
}

export function solidOf(data: BodyData): Solid {
  return {
    ...data,
    positions: new Float32Array(buffer(data.positions)),
    normals: new Int16Array(buffer(data.normals)),
    index: () => ({ triangles: new Uint32Array(buffer(data.triangles)), edges: new Uint32Array(buffer(data.edges)) }),
    topology: data.name,
  };
}

// Little-endian, as every machine is that runs a browser.
function buffer(text: string): ArrayBuffer {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}
