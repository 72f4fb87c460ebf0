// How what is shown stands to what is typed: which of it is current, what of it can be pinned, and what goes on paper.

import type { Ageing } from "./ageing";
import type { Link, Wish } from "./connection";
import { sameWish } from "./hash";
import type { Kind } from "./protocol";
import type { Pane } from "./pane";
import type { Sheet } from "./sheet";

const EARLIER = "This sheet is of the last design that was built. What has been typed since is not on it.";
const UNBUILT = "This design has not been built: there are no values of it.";

export interface Typed {
  wish: Wish;
  broken: boolean; // a field holds no value
}

export class Standing {
  private lost = false; // the server does not answer

  constructor(private readonly pane: Pane, private readonly ageing: Ageing, private readonly typed: () => Typed) {}

  // Whether the values that are known are of what is typed.
  get current(): boolean {
    const { wish, broken } = this.typed();
    const { valued } = this.pane;
    return valued !== null && !broken && sameWish(valued, wish);
  }

  // Whether what is typed cannot be built, as far as is known.
  get unbuilt(): boolean {
    return this.typed().broken || this.pane.element.dataset.state === "old";
  }

  // What is shown of an earlier design than what is typed says so.
  mark(): void {
    const { wish, broken } = this.typed();
    const { drawn } = this.pane;
    if (broken) this.pane.stale();
    else if (this.lost && !(drawn && sameWish(drawn, wish))) this.pane.stale("lost");
    this.ageing.mark(this.pane.values !== null && !this.current, this.unbuilt);
  }

  // Values have come, though maybe not the newest.
  came(): void {
    this.ageing.came();
    this.mark();
  }

  linked(link: Link): void {
    if (link === "connecting") return;
    this.lost = link === "lost";
    this.mark();
  }

  // A sheet is of the design that its tables are of, even where another one is typed.
  print(sheet: Sheet, kindOf: (wish: Wish) => Kind): void {
    const { valued, drawn, valuedTitle } = this.pane;
    const note = this.current ? "" : valued ? EARLIER : UNBUILT;
    const of = valued ?? this.typed().wish;
    const picture = drawn && sameWish(drawn, of) ? this.pane.picture() : null;
    sheet.show(kindOf(of), of.design, valued ? valuedTitle : "", picture, note);
  }
}
