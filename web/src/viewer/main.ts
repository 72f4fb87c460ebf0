// A view of placed bodies that turns: reads the scene that stands in the page, and asks nothing of any network.

import * as three from "three";
import { Body } from "./body";
import { readScene, type SceneData } from "./data";
import { along, KEYS, listen } from "./keyboard";
import { button, check, choice, element, slider } from "./panel";
import { Running } from "./running";
import { ScaleBar } from "./scale_bar";
import { Section, type Axis } from "./section";
import { Stage } from "./stage";
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
  let stage: Stage;
  try {
    stage = new Stage(canvas, data, radius);
  } catch {
    canvas.remove();
    main.append(element("p", { class: "refusal", role: "alert" },
      `${data.title}: this browser draws nothing in three dimensions (WebGL is switched off or not there).`));
    return;
  }
  const bodies = data.bodies.map((body, index) => new Body(body, index, middle, radius));
  stage.scene.add(...bodies.map((body) => body.group));
  furnish(main, canvas, stage, bodies, data, new Section(box.translate(middle.clone().negate()), middle));
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
    button("fit", "Show all, from where it was first seen (0)", () => look()),
    ...["x", "y", "z"].map((name, axis) =>
      button(name, `Look from +${name} (${name.toUpperCase()})`, () => look(along(axis, false, stage.camera.up)))),
    check(["edges"], "Sharp edges", true, (on) => {
      edges = on;
      theme(current());
    }),
    button("◐", "Light or dark", () => theme(current() === "dark" ? "light" : "dark")));
  const rows = [...(running ? [running.row] : []), sectionRow(stage, bodies, section, data.unit)];
  const header = element("header", {}, element("h1", {}, data.title), ...(bodies.length > 1 ? [legend(stage, bodies)] : []));
  const panel = element("div", { class: "panel" }, ...rows);
  main.append(header, views, panel, scale.element);
  stage.taken = () => [
    Math.max(header.getBoundingClientRect().bottom, views.getBoundingClientRect().bottom) + 10,
    main.clientHeight - panel.getBoundingClientRect().top + 10,
  ];
}

function legend(stage: Stage, bodies: Body[]): HTMLElement {
  const items = bodies.map((body) => {
    const swatch = element("i", { style: `background:#${body.colour.getHexString()}` });
    return check([swatch, body.data.name], `Show ${body.data.name}`, true, (on) => {
      body.group.visible = on;
      stage.draw();
    });
  });
  return element("div", { class: "legend", role: "group", "aria-label": "Bodies" }, ...items);
}

function sectionRow(stage: Stage, bodies: Body[], section: Section, unit: string): HTMLElement {
  const cut = () => {
    section.cut(bodies, place.value());
    stage.draw();
  };
  const place = slider("Place of the cut", (value) => `${value.toFixed(digits).replace(/^-(?=[0.]*$)/, "")} ${unit}`, cut);
  const flip = button("⇄", "Show the other side", () => {
    section.flipped = !section.flipped;
    cut();
  });
  let digits = 1;
  const chosen = (value: string) => {
    const axis = value ? (value as Axis) : null;
    section.choose(axis, stage.camera.position.clone().sub(stage.orbit.target));
    place.row.hidden = flip.hidden = !axis;
    if (axis) {
      const [least, most] = section.limits(axis);
      digits = Math.max(0, 2 - Math.floor(Math.log10(most - least)));
      place.limit(least, most);
      place.set((least + most) / 2);
    }
    cut();
  };
  const options = { "": "none", x: "across x", y: "across y", z: "across z" };
  const axes = choice("Section plane", options, chosen);
  place.row.hidden = flip.hidden = true;
  return element("div", { class: "row" }, element("span", { class: "name" }, "section"), axes, place.row, flip);
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
