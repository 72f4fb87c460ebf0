// Charts of a design: one at a time, asked for only while they are seen, and given up when a newer one is wanted.

import { type Api, ApiError } from "./api";
import { Chart } from "./charts/chart";
import { button, element, options, unique } from "./dom";
import type { Design, Kind, PlotData } from "./protocol";
import { saved } from "./saving";

const PAUSE = 180; // ms without a change before a chart is asked for

export function plots(host: HTMLElement, api: Api) {
  return new Plots(host, api);
}

class Plots {
  private readonly choice = element("select", { id: unique("chart") });
  private readonly chart = new Chart();
  private readonly wrong = element("p", { class: "problem chart-wrong", role: "status" });
  private readonly tools: HTMLElement;
  private which: Kind | null = null;
  private wanted: Design | null = null;
  private seen = false;
  private shown = ""; // chart and design, as text
  private shownChart = "";
  private asking: AbortController | null = null;
  private timer = 0;

  constructor(host: HTMLElement, private readonly api: Api) {
    this.tools = element("div", { class: "chart-tools" }, element("label", { for: this.choice.id, class: "unseen" }, "Chart"), this.choice,
      button("+", () => this.chart.enlarge(1), "Larger"), button("−", () => this.chart.enlarge(-1), "Smaller"),
      button("All", () => this.chart.enlarge(0), "Show all of it"),
      button("SVG", () => saved(`${this.name()}.svg`, "image/svg+xml", this.chart.file()), "Save as an SVG file"));
    host.append(this.tools, this.wrong, this.chart.element);
    this.chart.element.hidden = true;
    this.choice.addEventListener("change", () => this.soon(0));
    new IntersectionObserver((entries) => {
      this.seen = entries[entries.length - 1]!.isIntersecting;
      if (this.seen) this.soon(0);
      else this.asking?.abort();
    }).observe(this.tools);
  }

  kind(kind: Kind): void {
    const before = this.choice.value;
    this.which = kind;
    this.choice.replaceChildren();
    options(this.choice, kind.plots.map(({ name, title }): [string, string] => [name, title]));
    if (kind.plots.some(({ name }) => name === before)) this.choice.value = before;
    this.tools.hidden = kind.plots.length === 0;
    this.wanted = null;
  }

  design(design: Design): void {
    this.wanted = design;
    this.soon(PAUSE);
  }

  // There is a connection again: a chart that could not be had is asked for again.
  again(): void {
    if (this.wrong.textContent) this.soon(0);
  }

  private name(): string {
    return `${this.which?.name ?? "chart"} ${this.choice.value}`.replaceAll(" ", "-");
  }

  private soon(pause: number): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.ask(), pause);
  }

  private async ask(): Promise<void> {
    const [design, plot] = [this.wanted, this.choice.value];
    const key = `${plot} ${JSON.stringify(design)}`;
    if (!this.seen || !design || !plot || key === this.shown) return;
    this.asking?.abort();
    const asking = this.asking = new AbortController();
    this.chart.element.setAttribute("aria-busy", "true");
    try {
      const data: PlotData = await this.api.plot(design, plot, asking.signal);
      if (asking.signal.aborted) return;
      this.tell("");
      this.chart.element.hidden = false;
      this.chart.show(data, `${this.which?.name} ${plot}` === this.shownChart);
      this.shown = key;
      this.shownChart = `${this.which?.name} ${plot}`;
    } catch (error) {
      if (asking.signal.aborted) return;
      if (!(error instanceof ApiError)) throw error;
      this.tell(error.message);
      this.shown = "";
    } finally {
      if (this.asking === asking) this.chart.element.removeAttribute("aria-busy");
    }
  }

  // The chart of the last design stays, faint, beside what is wrong with this one.
  private tell(text: string): void {
    this.wrong.textContent = text;
    this.wrong.hidden = !text;
    if (text) this.chart.element.setAttribute("data-old", "");
    else this.chart.element.removeAttribute("data-old");
  }
}
