// The page's address, written no more often than browsers bear: some refuse more than a hundred changes in half a minute.

const AT_ONCE = 30;
const A_SECOND = 2;

export class Address {
  private left = AT_ONCE;
  private at = 0;
  private timer = 0;
  private late = ""; // what is still to be written

  // The newest is written at last, if not at once.
  put(hash: string, how: "replace" | "push" = "replace"): void {
    clearTimeout(this.timer);
    if (how === "push" && this.late) history.replaceState(null, "", this.late); // what is left behind
    this.late = "";
    if (how === "replace" && location.hash === hash) return;
    const now = performance.now();
    this.left = Math.min(AT_ONCE, this.left + ((now - this.at) * A_SECOND) / 1000);
    this.at = now;
    if (how === "replace" && this.left < 1) {
      this.late = hash;
      this.timer = window.setTimeout(() => this.put(hash), ((1 - this.left) * 1000) / A_SECOND + 10);
      return;
    }
    this.left -= 1;
    if (how === "push") history.pushState(null, "", hash);
    else history.replaceState(null, "", hash);
  }
}
