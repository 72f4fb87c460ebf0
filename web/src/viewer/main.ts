// A view of placed bodies that turns: reads the scene that stands in the page, and asks nothing of any network.

import * as three from "three";
import { Body } from "../scene/body";
import { graphics } from "../scene/graphics";
import { along, KEYS, listen } from "../scene/keyboard";
import { button, check, element } from "../scene/panel";
import { Running } from "../scene/running";
import { ScaleBar } from "../scene/scale_bar";
import { Section } from "../scene/section";
import { SectionRow } from "../scene/section_row";
import { Stage } from "../scene/stage";
import { readScene, solidOf, type SceneData } from "./data";
import style from "./style.css?inline";

const EDGES = { light: "#1b2026", dark: "#05070a" };

function start(): void {
  document.head.append(element("style", {}, style));
  const data = readScene();
  const canvas = element("canvas", { tabindex: "0", role: "img", "aria-label": `${data.title}. ${KEYS}` });
  const main = element("main", {}, canvas);
  document.body.append(main);
  const box = boxOf(data);
  const middle = box.getCenter(new three.Vector3());
  const radius = 0.5 * box.getSize(new three.Vector3()).length();
  const drawnBy = graphics();
  let stage: Stage;
  try {
    stage = new Stage(canvas, drawnBy, data);
  } catch {
    canvas.remove();
    main.append(element("p", { class: "refusal", role: "alert" },
      `${data.title}: this browser draws nothing in three dimensions (WebGL is switched off or not there).`));
    return;
  }
  stage.radius = radius;
  const bodies = data.bodies.map((body, index) => {
    const made = new Body(index, drawnBy);
    made.show(solidOf(body), middle, radius);
    return made;
  });
  stage.scene.add(...bodies.map((body) => body.group));
  const section = new Section();
  section.contain(box, middle);
  furnish(main, canvas, stage, bodies, data, section);
  stage.resize();
  stage.look(bodies);
  document.documentElement.dataset.ready = "true";
}

function furnish(
  main: HTMLElement, canvas: HTMLElement, stage: Stage, bodies: Body[], data: SceneData, section: Section,
): void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let edges = true;
  const theme = (name: string) => {
    document.documentElement.dataset.theme = name;
    for (const body of bodies) body.showEdges(edges, EDGES[name as keyof typeof EDGES], name === "dark" ? 0.9 : 0.75);
    stage.draw();
  };
  const current = () => document.documentElement.dataset.theme ?? "light";
  theme(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => theme(dark.matches ? "dark" : "light"));

  const running = data.turns === null ? null : new Running(data.turns, (degrees) => {
    for (const body of bodies) body.turnTo(degrees);
    stage.draw();
  });
  const look = (direction?: three.Vector3) => stage.look(bodies, direction);
  const scale = new ScaleBar(data.unit);
  stage.onDrawn = () => scale.show(stage.unitsAPixel());
  listen(stage, canvas, { look, run: () => running?.toggle() });
  new ResizeObserver(() => stage.resize()).observe(canvas);

  const views = element("div", { class: "views", role: "group", "aria-label": "Views" },
    button("fit", "fit: show all, from where it was first seen (0)", () => look()),
    ...["x", "y", "z"].map((name, axis) =>
      button(name, `Look from +${name} (${name.toUpperCase()})`, () => look(along(axis, false, stage.camera.up)))),
    check(["edges"], "Sharp edges", true, (on) => {
      edges = on;
      theme(current());
    }),
    button("◐", "Light or dark", () => theme(current() === "dark" ? "light" : "dark")));
  const cut = (place: number) => {
    section.cut(bodies, place);
    stage.draw();
  };
  const rows = [...(running ? [running.row] : []), new SectionRow(stage, section, cut, data.unit).row];
  const header = element("header", {}, element("h1", {}, data.title), ...(bodies.length > 1 ? [legend(stage, bodies)] : []));
  const panel = element("div", { class: "panel" }, ...rows);
  main.append(header, views, panel, scale.element);
  stage.taken = () => [
    Math.max(header.getBoundingClientRect().bottom, views.getBoundingClientRect().bottom) + 10,
    24,
    main.clientHeight - panel.getBoundingClientRect().top + 10,
    24,
  ];
}

function legend(stage: Stage, bodies: Body[]): HTMLElement {
  const items = bodies.map((body) => {
    const swatch = element("i", { style: `background:#${body.colour.getHexString()}` });
    return check([swatch, body.solid.name], `Show ${body.solid.name}`, true, (on) => {
      body.group.visible = on;
      stage.draw();
    });
  });
  return element("div", { class: "legend", role: "group", "aria-label": "Bodies" }, ...items);
}

// What the bodies take together.
function boxOf(data: SceneData): three.Box3 {
  const box = new three.Box3();
  for (const body of data.bodies) {
    box.union(new three.Box3(new three.Vector3(...body.least), new three.Vector3(...body.most)));
  }
  return box;
}

start();
