// One file that the server makes: how far it is, how it is cancelled, and that it comes by itself when it is done.

import { type Api, ApiError, lineOf } from "./api";
import { button, element } from "./dom";
import type { FileJob, FileWish, Problem } from "./protocol";
import { fetched } from "./saving";

const PAUSE = 350; // ms between looks at it
const STATES: Record<FileJob["state"], string> = {
  waiting: "Waiting for its turn", working: "Working", done: "Done; it is in your downloads", failed: "Failed", cancelled: "Cancelled",
};

export class Job {
  readonly element = element("li");
  private readonly name: HTMLElement;
  private readonly buttons = element("span");
  private readonly bar = element("progress", { "aria-label": "Progress" });
  private readonly stage = element("p", { role: "status" });
  private readonly seconds = element("span", { class: "seconds", "aria-hidden": "true" });
  private readonly began = performance.now();
  private started: { id: string; url: string } | null = null;
  private over = false;

  constructor(private readonly api: Api, private readonly wish: FileWish, words: string) {
    this.name = element("span", { class: "name" }, words);
    this.buttons.append(button("Cancel", () => void this.cancel(), `Cancel ${words}`));
    this.element.append(this.name, this.buttons, this.bar, this.stage, this.seconds);
  }

  async run(): Promise<void> {
    this.say("Starting");
    try {
      this.started = await this.api.startFile(this.wish);
      if (this.over) return await this.api.cancelFile(this.started.id);
      while (!this.over) {
        const job = await this.api.file(this.started.id);
        if (this.over) return;
        this.take(job, this.started.url);
        await new Promise((go) => setTimeout(go, PAUSE));
      }
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      if (!this.over) this.failed(error.headline, error.problems);
    }
  }

  private take(job: FileJob, url: string): void {
    if (job.name) this.name.textContent = job.name;
    this.seconds.textContent = `${((performance.now() - this.began) / 1000).toFixed(1)}\u2009s`;
    switch (job.state) {
      case "waiting":
      case "working":
        this.say(job.stage ? `${job.stage.charAt(0).toUpperCase()}${job.stage.slice(1)} …` : STATES[job.state]);
        break;
      case "done":
        this.end(STATES.done + (job.bytes === null ? "" : ` (${size(job.bytes)})`));
        this.buttons.prepend(element("a", { href: `${url}/content`, download: job.name }, "Download again"));
        fetched(job.name, `${url}/content`);
        break;
      case "cancelled":
        this.end(STATES.cancelled);
        break;
      case "failed":
        this.failed(job.headline || STATES.failed, job.problems ?? []);
    }
  }

  private async cancel(): Promise<void> {
    this.end(STATES.cancelled);
    if (this.started) await this.api.cancelFile(this.started.id).catch(() => undefined); // it may be over by now
  }

  private failed(headline: string, problems: Problem[]): void {
    this.end([headline, ...problems.map(lineOf)].join("\n"));
    this.stage.classList.add("problem");
  }

  private end(text: string): void {
    this.over = true;
    this.bar.hidden = true;
    this.buttons.replaceChildren(button("✕", () => this.forget(), `Remove ${this.name.textContent} from the list`));
    this.say(text);
  }

  private forget(): void {
    if (this.started) void this.api.cancelFile(this.started.id).catch(() => undefined);
    this.element.remove();
  }

  // Said aloud once, however often it is looked at.
  private say(text: string): void {
    if (this.stage.textContent !== text) this.stage.textContent = text;
  }
}

export function size(bytes: number): string {
  if (bytes < 1000) return `${bytes} bytes`;
  const power = Math.min(3, Math.floor(Math.log10(bytes) / 3));
  return `${Number((bytes / 1000 ** power).toPrecision(3))} ${["", "kB", "MB", "GB"][power]}`;
}
