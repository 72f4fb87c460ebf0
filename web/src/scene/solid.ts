// One body as it is drawn, whatever brought it here: arrays in a frame of its own, and how that frame stands and moves.

export type Triple = [number, number, number];

export interface Index {
  triangles: Uint32Array; // three a triangle, counter-clockwise seen from outside
  edges: Uint32Array; // two a sharp edge
}

export interface Solid {
  name: string;
  called?: string; // by people, where that is not its name
  colour: Triple; // sRGB, 0 to 1
  positions: Float32Array; // three a vertex, relative to the centre
  normals: Int16Array; // three a vertex, of 32767
  index: () => Index;
  topology: string; // solids with the same have the same index, so that it needs no second look
  closed: boolean; // only then is there an inside
  centre: Triple; // in the body's own frame
  least: Triple; // corners of the box that it takes in the scene
  most: Triple;
  place: number[]; // 4 × 4, by rows: the body's frame in the scene
  spin: number; // degrees about the body's own z for one of the turn
  slide: Triple; // shift in the body's own frame for one degree of the turn
}
