// States that were settled on, to go back to and forth again.

const MOST = 200;

export class History<T> {
  private past: T[] = [];
  private future: T[] = [];

  constructor(private readonly key: (state: T) => string, private now: T) {}

  // What was settled on; what was undone before cannot be redone after it.
  settle(state: T): void {
    if (this.key(state) === this.key(this.now)) {
      this.now = state;
      return;
    }
    this.past = [...this.past, this.now].slice(-MOST);
    this.now = state;
    this.future = [];
  }

  undo(): T | null {
    const before = this.past.pop();
    if (before === undefined) return null;
    this.future.push(this.now);
    this.now = before;
    return before;
  }

  redo(): T | null {
    const after = this.future.pop();
    if (after === undefined) return null;
    this.past.push(this.now);
    this.now = after;
    return after;
  }

  get undoable(): boolean {
    return this.past.length > 0;
  }

  get redoable(): boolean {
    return this.future.length > 0;
  }
}
