// A bar of a round length, true in this parallel projection wherever a part is seen square on.

export class ScaleBar {
  readonly element = document.createElement("div");
  private readonly bar = document.createElement("span");
  private readonly text = document.createElement("span");

  // factor: a length of the scene, by so much, is one in that unit
  constructor(private unit: string, private factor = 1) {
    this.element.className = "scale";
    this.bar.className = "bar";
    this.element.append(this.bar, this.text);
  }

  readIn(unit: string, factor: number): void {
    Object.assign(this, { unit, factor });
  }

  show(unitsOfSceneAPixel: number): void {
    const unitsAPixel = unitsOfSceneAPixel * this.factor;
    const length = roundLength(130 * unitsAPixel);
    this.bar.style.width = `${length / unitsAPixel}px`;
    this.text.textContent = `${Number(length.toPrecision(3))} ${this.unit}`;
  }
}

// The largest of 1, 2, 5 × a power of ten that is not above a length.
function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2, 1].find((step) => step * power <= most) ?? 1);
}
