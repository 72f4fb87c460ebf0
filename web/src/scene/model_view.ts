// The 3D view of the designer page: what frames bring, turned, cut and measured by hand.

import * as three from "three";
import type { Overlays, Values } from "./answers";
import { spreadOf } from "./answers";
import { Body } from "./body";
import type { ModelFrame } from "./frame";
import { graphics, type Graphics } from "./graphics";
import { along as direction, KEYS, listen } from "./keyboard";
import { factor, readOut } from "./lengths";
import { Legend } from "./legend";
import { Marks } from "./marks";
import "./model_view.css";
import { element } from "./panel";
import { Running } from "./running";
import { ScaleBar } from "./scale_bar";
import { Section } from "./section";
import { SectionRow } from "./section_row";
import { keepSizes } from "./sprites";
import { Stage } from "./stage";
import { ContactLines } from "./contact";
import { Choices, speedRow, ViewPanel } from "./view_panel";

const INK = { light: "#1b2026", dark: "#e8edf2" };
const EDGES: Record<string, [string, number]> = { light: ["#1b2026", 0.75], dark: ["#05070a", 0.9] };
const [MUCH_LESS, MUCH_MORE] = [0.5, 1.5]; // of the size that was fitted into the view
const WIDE = 700; // pixels that leave room for the panel beside the bodies
const FREE = 16;
const RPM = 5;

export class ModelView {
  private readonly root: HTMLElement;
  private readonly stage: Stage | null;
  private readonly canvas: HTMLCanvasElement;
  private readonly caption = element("p", { class: "mv-title" });
  private readonly legend = new Legend(() => this.stage?.draw());
  private readonly head: HTMLElement;
  private readonly foot: HTMLElement;
  private readonly notice = element("p", { class: "mv-notice", role: "status" });
  private readonly choices = new Choices();
  private readonly section = new Section();
  private readonly scale = new ScaleBar("mm");
  private readonly running: Running;
  private readonly cutting: SectionRow | null = null;
  private readonly panel: ViewPanel | null = null;
  private readonly watch: ResizeObserver;
  private readonly drawnBy: Graphics;
  private readonly middle = new three.Vector3();
  private readonly listening = new AbortController();
  private bodies: Body[] = [];
  private marks: Marks[] = [];
  private readonly contact = new ContactLines();
  private frame: ModelFrame | null = null;
  private values: Values | null = null;
  private overlays: Overlays | null = null;
  old = { values: false, overlays: false }; // whether they are of another design than the bodies
  private kind = "";
  private fitted = 0; // the radius that was fitted into the view
  private wanted: "mm" | "in" = "mm";
  private theme: "light" | "dark" = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";

  // drawnBy: what draws, where that is not to be found out
  constructor(host: HTMLElement, private readonly options: { label?: string; drawnBy?: Graphics } = {}) {
    this.drawnBy = options.drawnBy ?? graphics();
    this.canvas = element("canvas", { tabindex: "0", role: "img", "aria-label": `${options.label ?? "Model"}. ${KEYS}` });
    this.head = element("div", { class: "mv-head" }, element("div", { class: "mv-what" }, this.caption, this.legend.element));
    this.running = new Running(180, (degrees) => this.turnTo(degrees));
    this.running.rate = 6 * RPM;
    this.running.row.hidden = true;
    this.foot = element("div", { class: "mv-foot" }, this.running.row);
    this.root = element("section", { class: "model-view", "aria-label": options.label ?? "3D view" }, this.canvas);
    host.append(this.root);
    this.watch = new ResizeObserver(() => this.resized());
    this.stage = this.staged();
    this.root.dataset.drawing = this.stage ? this.drawnBy : "none";
    if (this.stage) [this.cutting, this.panel] = this.furnish(this.stage);
    this.setTheme(this.theme);
  }

  // Keeps the camera while values change, and fits what is there where it is something else, of another size or cut off.
  show(frame: ModelFrame): void {
    const { stage } = this;
    if (!stage) return;
    const kind = [frame.title.split(":")[0], ...frame.bodies.map((body) => body.name)].join("|");
    const other = kind !== this.kind;
    if (other) this.values = this.overlays = null;
    const box = new three.Box3();
    for (const { least, most } of frame.bodies) box.expandByPoint(new three.Vector3(...least)).expandByPoint(new three.Vector3(...most));
    const centre = box.getCenter(new three.Vector3());
    const radius = 0.5 * box.getSize(new three.Vector3()).length();
    const refit = other || radius > MUCH_MORE * this.fitted || radius < MUCH_LESS * this.fitted;
    if (refit) this.middle.copy(centre);
    stage.radius = radius + centre.distanceTo(this.middle);
    this.frame = frame;
    this.kind = kind;
    this.take(frame, stage.radius);
    this.contact.group.position.copy(this.middle).negate();
    this.caption.textContent = frame.title;
    this.canvas.setAttribute("aria-label", `${this.options.label ? `${this.options.label}: ` : ""}${frame.title}. ${KEYS}`);
    this.root.dataset.triangles = `${frame.triangles}`;
    this.running.row.hidden = frame.turns === null;
    if (frame.turns === null) this.running.stop();
    this.running.limit(frame.turns ?? 180);
    this.running.set(frame.turns === null ? 0 : this.running.value());
    this.contain();
    this.cutting?.refresh();
    this.setUnit(this.wanted);
    const grown = radius > this.fitted && !stage.touched;
    if (refit || (grown && !stage.holds(this.bodies))) {
      this.fitted = radius;
      const from = other ? undefined : stage.direction();
      if (other) stage.face(frame);
      stage.look(this.bodies, from);
    }
    this.root.dataset.ready = "true";
  }

  setValues(values: Values | null): void {
    this.values = values;
    this.mark();
  }

  setOverlays(answer: Overlays | null): void {
    this.overlays = answer;
    this.contact.show(answer?.lines ?? []);
    this.turnTo(this.running.value());
    this.mark();
  }

  // Marks of values or overlays that are of another design are not drawn, though still offered.
  setOld(values: boolean, overlays: boolean): void {
    if (values === this.old.values && overlays === this.old.overlays) return;
    this.old = { values, overlays };
    this.turnTo(this.running.value());
    this.mark();
  }

  // What lengths are read out in: scale bar, place of the cut, radii of gyration.
  setUnit(unit: "mm" | "in"): void {
    this.wanted = unit;
    const own = this.frame?.unit ?? "mm";
    const shown = readOut(own, unit);
    this.scale.readIn(shown, factor(own, shown));
    this.cutting?.readIn(shown, factor(own, shown));
    this.mark();
  }

  setTheme(theme: "light" | "dark"): void {
    this.theme = theme;
    this.root.dataset.theme = theme;
    this.dress();
    this.mark();
  }

  dispose(): void {
    this.running.stop();
    this.watch.disconnect();
    this.listening.abort();
    for (const mark of this.marks) mark.dispose();
    for (const body of this.bodies) body.dispose();
    this.contact.show([]);
    this.stage?.dispose();
    this.root.remove();
  }

  private staged(): Stage | null {
    try {
      return new Stage(this.canvas, this.drawnBy, { direction: [0.5, -0.7, 0.5], up: [0, 0, 1] });
    } catch {
      this.canvas.remove();
      this.root.append(element("p", { class: "mv-refusal", role: "alert" },
        "This browser draws nothing in three dimensions (WebGL is switched off or not there). All else works without it."));
      return null;
    }
  }

  private furnish(stage: Stage): [SectionRow, ViewPanel] {
    const cutting = new SectionRow(stage, this.section, (place) => this.cut(place), "mm");
    const look = (towards?: three.Vector3) => stage.look(this.bodies, towards);
    const speed = speedRow(RPM, (rpm, settled) => {
      this.running.rate = 6 * rpm;
      if (settled && rpm === 0) this.running.stop();
    });
    const panel = new ViewPanel(this.choices, {
      look: (axis) => look(axis === null ? undefined : direction(axis, false, stage.camera.up)),
      drawn: () => this.dress(),
      marked: () => this.mark(),
      contact: () => this.turnTo(this.running.value()),
    }, cutting.row, speed);
    panel.disclosure.open = this.root.clientWidth >= WIDE;
    panel.disclosure.addEventListener("toggle", () => this.resized());
    this.head.append(panel.views);
    this.root.append(this.head, this.foot, this.scale.element, this.notice);
    stage.taken = () => this.taken();
    stage.scene.add(this.contact.group);
    stage.onDraw = () => keepSizes(stage.scene, stage.unitsAPixel());
    stage.onDrawn = () => this.scale.show(stage.unitsAPixel());
    listen(stage, this.canvas, { look, run: () => this.frame?.turns != null && this.running.toggle() });
    this.watch.observe(this.canvas);
    this.mind(stage);
    return [cutting, panel];
  }

  // A graphics card may be taken away, and come back.
  private mind(stage: Stage): void {
    const { signal } = this.listening;
    this.canvas.addEventListener("webglcontextlost", () => {
      this.root.dataset.lost = "true";
      this.notice.textContent = "The graphics card was lost. The view comes back when the browser gives it again.";
    }, { signal });
    this.canvas.addEventListener("webglcontextrestored", () => {
      delete this.root.dataset.lost;
      this.notice.textContent = "";
      stage.light();
      stage.resize();
    }, { signal });
  }

  private take(frame: ModelFrame, radius: number): void {
    while (this.bodies.length > frame.bodies.length) {
      this.marks.pop()!.dispose();
      const gone = this.bodies.pop()!;
      gone.group.removeFromParent();
      gone.dispose();
    }
    frame.bodies.forEach((solid, index) => {
      if (!this.bodies[index]) {
        const made = new Body(index, this.drawnBy);
        this.bodies.push(made);
        this.marks.push(new Marks(made));
        this.stage!.scene.add(made.group);
      }
      this.bodies[index]!.show(solid, this.middle, radius);
    });
    this.legend.show(this.bodies);
    this.dress();
  }

  private dress(): void {
    for (const body of this.bodies) {
      body.showEdges(this.choices.edges, ...EDGES[this.theme]!);
      body.setOpacity(this.choices.opacity);
    }
    this.stage?.draw();
  }

  private mark(): void {
    if (!this.stage || !this.frame) return;
    const { unit } = this.frame;
    const cut = this.section.axis ? this.section.plane : null;
    const kinds = new Set<string>();
    let inertia = false;
    for (const mark of this.marks) {
      const { name } = mark.body.solid;
      const spread = this.values && spreadOf(this.values, name, this.bodies.length === 1);
      const surfaces = this.overlays?.bodies.find((body) => body.name === name)?.surfaces ?? [];
      inertia ||= Boolean(spread);
      for (const { kind } of surfaces) kinds.add(kind);
      mark.spread = this.old.values ? null : spread;
      mark.surfaces = this.old.overlays ? [] : surfaces;
      mark.refresh(this.choices, this.stage.radius, INK[this.theme], unit, readOut(unit, this.wanted), cut);
    }
    this.panel?.offer([...kinds], this.overlays !== null && this.overlays.lines.length > 0,
      inertia, this.frame.turns !== null);
    this.stage.draw();
  }

  // The cut reaches as far as the bodies do where they are now.
  private contain(): void {
    const box = new three.Box3();
    for (const body of this.bodies) body.extend(box);
    this.section.contain(box, this.middle);
  }

  private cut(place: number): void {
    const before = this.bodies[0]?.cutting ?? null;
    this.section.cut(this.bodies, place);
    if ((before === null) !== (this.section.axis === null)) this.mark();
    this.stage?.draw();
  }

  private turnTo(degrees: number): void {
    for (const body of this.bodies) body.turnTo(degrees);
    if (this.bodies.some((body) => body.slides)) {
      this.contain();
      if (this.section.axis) this.cutting?.refresh();
    }
    this.contact.at(degrees, this.choices.contact && !this.old.overlays);
    this.stage?.draw();
  }

  private taken(): [number, number, number, number] {
    const { disclosure, panel, views } = this.panel!;
    const around = this.root.getBoundingClientRect();
    const beside = disclosure.open && around.width >= WIDE;
    const above = this.head.getBoundingClientRect().bottom - around.top;
    const below = this.running.row.hidden ? 40 : around.bottom - this.foot.getBoundingClientRect().top;
    const right = beside ? around.right - panel.getBoundingClientRect().left : 0;
    return [Math.max(above, views.getBoundingClientRect().bottom - around.top) + 10, right + FREE, below + 10, FREE];
  }

  // What nobody has moved by hand goes on filling the view.
  private resized(): void {
    const { stage } = this;
    if (!stage) return;
    stage.resize();
    if (this.frame && !stage.touched) stage.look(this.bodies, stage.direction());
  }
}
