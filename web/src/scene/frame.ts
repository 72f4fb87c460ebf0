// A mesh frame as it comes, and the topologies that are kept by their keys.

export interface ModelFrame {
  id: number;
  title: string;
}

export class Topologies {
  held(): string[] {
    return [];
  }
}

export function decodeMesh(data: ArrayBuffer, _known: Topologies): ModelFrame {
  const length = new DataView(data).getUint32(0, true);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))) as ModelFrame;
}

export class TopologyMissing extends Error {}
