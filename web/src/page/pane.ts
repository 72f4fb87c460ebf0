// A model on show: its connection, the view, and what is to be said about both.

import { ModelView } from "../scene/model_view";
import { Connection, type Link, type Wish } from "./connection";
import { element } from "./dom";
import { sameWish } from "./hash";
import type { Answer, ApproximationAnswer, LengthUnit, Problem, ValuesAnswer } from "./protocol";
import type { Theme } from "./theme";

export interface Watcher {
  values(values: ValuesAnswer, approximation: ApproximationAnswer | null): void;
  built(): void;
  refused(headline: string, problems: Problem[]): void;
  link(state: Link): void;
  note(text: string): void;
}

const OLD = {
  refused: "Shown: the last design that can be built.", lost: "Shown: the last design that the server has answered.",
  undrawn: "Shown: an earlier design. This one can be computed, but not drawn.",
};
const NONE = {
  refused: "Nothing to show yet: the design cannot be built as it is.", lost: "Nothing to show yet: the server does not answer.",
  undrawn: "This design can be computed, but not drawn.",
};
const GRACE = 250; // ms for which marks of the design before stay, else they would flicker under a slider

export class Pane {
  readonly element: HTMLElement;
  private readonly host: HTMLElement;
  title = "";
  values: ValuesAnswer | null = null;
  drawn: Wish | null = null; // whose model is shown
  valued: Wish | null = null; // whose values are known
  valuedTitle = "";
  private overlaid: Wish | null = null;
  private ageing = 0;
  private readonly stage = element("p", { class: "stage" });
  private readonly old = element("p", { class: "old" }, OLD.refused);
  private readonly view: ModelView;
  private readonly connection: Connection;
  private approximation: ApproximationAnswer | null = null;
  private showing = false;
  private readonly waiting: HTMLElement;
  private timer = 0;

  constructor(label: string, private readonly watcher: Watcher) {
    this.host = element("div", { class: "view" });
    this.waiting = element("p", { class: "waiting" }, "The model is on its way.");
    this.element = element("div", { class: "pane" }, this.host, this.waiting,
      element("div", { class: "about-view" }, this.old, this.stage));
    this.old.hidden = this.stage.hidden = true;
    this.view = new ModelView(this.host, { label });
    this.connection = new Connection({
      mesh: (frame, of) => {
        this.view.show(frame);
        this.title = frame.title;
        this.drawn = of;
        this.age();
        this.showing = true;
        this.waiting.hidden = true;
        this.fresh();
        watcher.built();
      },
      answer: (answer, of) => this.take(answer, of),
      link: (state) => watcher.link(state),
      busy: (on) => this.busy(on),
    });
  }

  ask(wish: Wish): void {
    this.connection.ask(wish);
  }

  theme(theme: Theme): void {
    this.view.setTheme(theme);
  }

  unit(unit: LengthUnit): void {
    this.view.setUnit(unit);
    if (this.values) this.watcher.values(this.values, this.approximation);
  }

  // Another kind of thing comes: what is known of the last one is of no use.
  forget(): void {
    this.values = this.approximation = this.valued = this.overlaid = null;
    this.view.setValues(null);
    this.view.setOverlays(null);
  }

  // What is shown is not what the form says.
  stale(why: keyof typeof OLD = "refused"): void {
    this.old.hidden = !this.showing;
    this.old.textContent = OLD[why];
    this.waiting.hidden = this.showing;
    if (!this.showing) this.waiting.textContent = NONE[why];
    this.element.dataset.state = "old";
  }

  fresh(): void {
    this.old.hidden = true;
    this.element.dataset.state = "new";
  }

  // The picture as it is, for paper.
  picture(): string | null {
    const canvas = this.host.querySelector("canvas");
    return canvas && canvas.width > 0 ? canvas.toDataURL("image/png") : null;
  }

  // Marks of an earlier design are not drawn on the model of a newer one.
  private age(): void {
    const [values, overlays] = this.older();
    this.view.setOld(values && this.view.old.values, overlays && this.view.old.overlays); // what has come is drawn at once
    if (!values && !overlays) {
      clearTimeout(this.ageing);
      this.ageing = 0;
    } else {
      this.ageing ||= window.setTimeout(() => {
        this.ageing = 0;
        this.view.setOld(...this.older());
      }, GRACE);
    }
  }

  // Whether values and overlays are of another design than the model.
  private older(): [values: boolean, overlays: boolean] {
    const { drawn } = this;
    const older = (of: Wish | null) => of !== null && drawn !== null && !sameWish(of, drawn);
    return [older(this.valued), older(this.overlaid)];
  }

  close(): void {
    clearTimeout(this.ageing);
    this.connection.close();
    this.view.dispose();
    this.element.remove();
  }

  private take(answer: Answer, of: Wish | null): void {
    switch (answer.answer) {
      case "stage":
        this.stage.textContent = `${answer.text} …`;
        this.stage.hidden = false;
        break;
      case "values":
        this.values = answer;
        this.valued = of;
        this.valuedTitle = this.title;
        this.approximation = null;
        this.view.setValues(answer);
        this.age();
        this.watcher.values(answer, null);
        break;
      case "approximation":
        this.approximation = answer;
        if (this.values?.id === answer.id) this.watcher.values(this.values, answer);
        break;
      case "overlays":
        this.view.setOverlays(answer);
        this.overlaid = of;
        this.age();
        break;
      case "refused":
        this.stale();
        this.watcher.refused(answer.headline, answer.problems);
        break;
      case "failed":
        this.stale();
        this.watcher.refused(answer.text, []);
        break;
      case "undrawn":
        this.watcher.built();
        this.stale("undrawn");
        this.watcher.note(answer.text);
        break;
      case "note":
        this.watcher.note(answer.text);
        break;
      case "done":
        break;
    }
  }

  // Only what takes long is worth a word.
  private busy(on: boolean): void {
    clearTimeout(this.timer);
    if (on) {
      this.timer = window.setTimeout(() => {
        if (this.stage.hidden) this.stage.textContent = "working …";
        this.stage.hidden = false;
      }, 400);
    } else this.stage.hidden = true;
    this.element.setAttribute("aria-busy", `${on}`);
  }
}
