// Triangles and sharp edges by their keys: what was sent once need not be sent again. The oldest make room.

import type { Index } from "./solid";

export class Topologies {
  private readonly kept = new Map<string, Index>();

  constructor(private readonly most = 64) {}

  // The keys that need not be sent, for `have` of a question.
  held(): string[] {
    return [...this.kept.keys()];
  }

  // The last one asked for is the last one to go.
  get(key: string): Index | undefined {
    const found = this.kept.get(key);
    if (found) this.keep(key, found);
    return found;
  }

  keep(key: string, index: Index): void {
    this.kept.delete(key);
    this.kept.set(key, index);
    for (const oldest of this.kept.keys()) {
      if (this.kept.size <= this.most) break;
      this.kept.delete(oldest);
    }
  }
}

// A frame counts on a topology that has had to make room: to be asked for again.
export class TopologyMissing extends Error {
  constructor(readonly key: string) {
    super(`the topology ${key} is not held any more`);
    this.name = "TopologyMissing";
  }
}
