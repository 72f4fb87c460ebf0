// A model on show: its connection, the view, and what is to be said about both.

import { ModelView } from "../scene/model_view";
import { Connection, type Link, type Wish } from "./connection";
import { element } from "./dom";
import type { ApproximationAnswer, LengthUnit, Problem, ValuesAnswer } from "./protocol";
import type { Theme } from "./theme";

export interface Watcher {
  values(values: ValuesAnswer, approximation: ApproximationAnswer | null): void;
  built(): void;
  refused(headline: string, problems: Problem[]): void;
  link(state: Link): void;
  note(text: string): void;
}

const OLD = "Shown: the last design that can be built.";

export class Pane {
  readonly element: HTMLElement;
  private readonly host: HTMLElement;
  title = "";
  values: ValuesAnswer | null = null;
  private readonly stage = element("p", { class: "stage" });
  private readonly old = element("p", { class: "old" }, OLD);
  private readonly view: ModelView;
  private readonly connection: Connection;
  private approximation: ApproximationAnswer | null = null;
  private showing = false;
  private readonly waiting: HTMLElement;
  private timer = 0;

  constructor(label: string, private readonly watcher: Watcher) {
    this.host = element("div", { class: "view" });
    this.waiting = element("p", { class: "waiting" }, "The model is on its way.");
    this.element = element("section", { class: "pane", "aria-label": label }, this.host, this.waiting,
      element("div", { class: "about-view" }, this.old, this.stage));
    this.old.hidden = this.stage.hidden = true;
    this.view = new ModelView(this.host, { label });
    this.connection = new Connection({
      mesh: (frame) => {
        this.view.show(frame);
        this.title = frame.title;
        this.showing = true;
        this.waiting.hidden = true;
        this.fresh();
        watcher.built();
      },
      answer: (answer) => this.take(answer),
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
    this.values = this.approximation = null;
    this.view.setValues(null);
    this.view.setOverlays(null);
  }

  // What is shown is not what the form says.
  stale(): void {
    this.old.hidden = !this.showing;
    this.waiting.hidden = this.showing;
    if (!this.showing) this.waiting.textContent = "Nothing to show yet: the design cannot be built as it is.";
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

  close(): void {
    this.connection.close();
    this.view.dispose();
    this.element.remove();
  }

  private take(answer: Parameters<ConstructorParameters<typeof Connection>[0]["answer"]>[0]): void {
    switch (answer.answer) {
      case "stage":
        this.stage.textContent = `${answer.text} …`;
        this.stage.hidden = false;
        break;
      case "values":
        this.values = answer;
        this.approximation = null;
        this.view.setValues(answer);
        this.watcher.values(answer, null);
        break;
      case "approximation":
        this.approximation = answer;
        if (this.values?.id === answer.id) this.watcher.values(this.values, answer);
        break;
      case "overlays":
        this.view.setOverlays(answer);
        break;
      case "refused":
        this.stale();
        this.watcher.refused(answer.headline, answer.problems);
        break;
      case "failed":
        this.stale();
        this.watcher.refused(answer.text, []);
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
