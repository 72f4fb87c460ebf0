// Tables, charts, files and texts of the page, in a browser with a server that says what a test wants.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launched } from "./browser.mjs";
import { ELEMENTS, frame, ORIGIN, served, values } from "./designer_server.mjs";

let browser;
before(async () => {
  browser = await launched({ viewport: { width: 1400, height: 860 }, colorScheme: "light", acceptDownloads: true });
});
after(() => browser?.close());

const body = (suffix, more = {}) => ({ suffix, words: suffix.slice(1).toUpperCase(), needs_density: false, has_clearance: true, what: "body", ...more });
const FORMATS = [
  body(".stl"), body(".step", { has_clearance: false }), body(".urdf", { needs_density: true, has_clearance: false }),
  { suffix: ".pdf", words: "sheet", needs_density: false, has_clearance: false, what: "sheet" },
];
const PLOTS = [{ name: "profile", title: "Transverse profile" }, { name: "errors", title: "Errors" }];
const elements = { ...ELEMENTS, kinds: ELEMENTS.kinds.map((kind) => ({ ...kind, formats: FORMATS, plots: PLOTS })) };

const CHARTS = {
  profile: {
    title: "Profile", x: { label: "x", unit: "mm" }, y: { label: "y", unit: "mm" }, equal: true, log: "none", notes: ["a note"], window: [-1, 1, -1, 1],
    lines: [
      { name: "pinion", x: [-10, 10, 10, null, -1, 1], y: [-10, -10, 10, null, 0, 0], style: "solid" },
      { name: "tip circle d_a, pinion", x: [-10, 10], y: [5, 5], style: "dashed" },
    ],
  },
  errors: {
    title: "Errors", x: { label: "tolerance", unit: "mm" }, y: { label: "error", unit: "" }, equal: false, log: "both", notes: [], window: null,
    lines: [{ name: "volume, order 1.00", x: [0.1, 0.01], y: [1e-3, 1e-4], style: "solid" }],
  },
};

// Everything that is said of a pair, the polyhedron included.
function talkative(socket, { id }) {
  const said = values(id);
  const polyhedron = { ...said.document.properties, volume: 41188.77 };
  const { properties, sizes } = said.document;
  const document = {
    pinion: { properties, sizes: { ...sizes, base_diameter: { value: 45.106, unit: "mm", symbol: "d_b" } } },
    gear: { properties, sizes: { pitch_diameter: { value: 120, unit: "mm", symbol: "d" } } },
    pair: { sizes: { centre_distance: { value: 84, unit: "mm", symbol: "a_w" } }, running: { transmission_error: { value: 12.5, unit: "urad", symbol: "TE" } } },
  };
  socket.send(frame(id));
  socket.send(JSON.stringify({ ...said, document, remarks: ["thin tips"], texts: { toml: "element = \"spur\"\n", python: "import gearwright as gw\n", command: "gearwright spur" } }));
  socket.send(JSON.stringify({ answer: "approximation", id, parts: { pinion: polyhedron, gear: polyhedron }, errors: {} }));
  socket.send(JSON.stringify({ answer: "done", id, seconds: 0 }));
}

async function opened(t, { hash = "", within = browser, ...more } = {}) {
  const page = await within.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && /Content Security|Refused/.test(message.text())) errors.push(message.text());
  });
  await served(page, { elements, answers: talkative, ...more });
  t.after(async () => {
    await page.evaluate(() => localStorage.clear()).catch(() => {});
    await page.close();
    assert.deepEqual(errors, []);
  });
  await page.goto(`${ORIGIN}/${hash}`);
  await page.waitForSelector("html[data-ready]");
  await page.waitForSelector("[data-panel=sizes] table", { state: "attached" });
  return page;
}

const rowOf = (page, panel, head) => page.locator(`[data-panel=${panel}] tr`).filter({ has: page.getByRole("rowheader", { name: head, exact: true }) }).first();
const cells = (row) => row.locator("td").allTextContents();

async function charted(page, answer = (name) => CHARTS[name]) {
  const asked = [];
  await page.route(`${ORIGIN}/api/plots`, async (route) => {
    const { plot, design } = JSON.parse(route.request().postData());
    asked.push({ plot, design });
    const found = await answer(plot, asked.length);
    await route.fulfill({ status: found.headline ? 422 : 200, contentType: "application/json", body: JSON.stringify(found) }).catch(() => {});
  });
  return asked;
}

test("sizes stand in a column a member, with symbols and units, and the pair's below", async (t) => {
  const page = await opened(t);
  assert.deepEqual(await cells(rowOf(page, "sizes", "Pitch diameter")), ["d", "48.000", "120.000", "mm"]);
  assert.deepEqual(await cells(rowOf(page, "sizes", "Base diameter")), ["db", "45.106", "", "mm"]);
  assert.equal(await rowOf(page, "sizes", "Base diameter").locator("sub").textContent(), "b");
  assert.deepEqual(await cells(rowOf(page, "sizes", "Centre distance")), ["aw", "84.000", "mm"]);
  assert.deepEqual(await cells(rowOf(page, "sizes", "Transmission error")), ["TE", "12.500", "µrad"]);
  assert.equal(await page.locator(".remarks li").textContent(), "thin tips");
  await page.locator(".units label", { hasText: "in" }).click();
  assert.deepEqual(await cells(rowOf(page, "sizes", "Pitch diameter")), ["d", "1.8898", "4.7244", "in"]);
});

test("the polyhedron stands beside what is exact, with how far it is off", async (t) => {
  const page = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20&~tab=mass" });
  await page.waitForSelector("[data-panel=mass] .off");
  assert.deepEqual(await cells(rowOf(page, "mass", "Volume V")), ["41\u202f230.000", "41\u202f188.770", "0.10\u2009%", "mm³"]);
  assert.match(await page.locator("[data-panel=mass] caption").first().textContent(), /Density 7\u202f850 kg\/m³\. Inertia about the part's origin/);
});

test("inertia is told about the point that is chosen", async (t) => {
  const page = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20&~tab=mass" });
  const mass = 41230 * 7.85e-6;
  const inertia = async () => Number((await cells(rowOf(page, "mass", "Inertia Ixx")))[0].replaceAll("\u202f", ""));
  assert.ok(Math.abs((await inertia()) - (1 + mass * 100)) < 1e-5);
  await page.getByLabel("Inertia about").selectOption("centroid");
  await page.waitForFunction(() => document.querySelector("[data-panel=mass] caption").textContent.includes("about the centroid, axes"));
  assert.equal(await inertia(), 1);
});

test("a chart is asked for only while it is seen, and again when the design changes", async (t) => {
  const page = await opened(t);
  const asked = await charted(page);
  await page.waitForTimeout(400);
  assert.equal(asked.length, 0);
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForSelector(".chart svg");
  assert.deepEqual(asked.map(({ plot, design }) => [plot, design.module]), [["profile", 3]]);
  await page.locator('[data-parameter="module"] input[type="text"]').fill("4");
  await page.waitForFunction(() => true);
  await page.waitForTimeout(600);
  assert.deepEqual(asked.map(({ design }) => design.module), [3, 4]);
  await page.getByRole("tab", { name: "Sizes" }).click();
  await page.locator('[data-parameter="module"] input[type="text"]').fill("5");
  await page.waitForTimeout(600);
  assert.equal(asked.length, 2);
});

test("a slow chart does not come after a newer one", async (t) => {
  const page = await opened(t);
  await charted(page, async (name) => {
    if (name === "profile") await new Promise((go) => setTimeout(go, 900));
    return CHARTS[name];
  });
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForTimeout(150);
  await page.getByLabel("Chart", { exact: true }).selectOption("errors");
  await page.waitForSelector(".chart svg");
  await page.waitForTimeout(1200);
  assert.equal(await page.locator(".chart figcaption").textContent(), "Errors");
});

test("a drawing has one scale, begins with its window and shows all of itself", async (t) => {
  const page = await opened(t);
  await charted(page);
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForSelector(".chart svg");
  const square = () => page.locator(".chart svg path[stroke-width='1.8']").evaluate((path) => {
    const [first, second, third] = path.getAttribute("d").split("M")[1].split("L").map((pair) => pair.split(",").map(Number));
    return [second[0] - first[0], second[1] - third[1]];
  });
  const [width, height] = await square();
  assert.ok(Math.abs(width - height) < 0.1, "a square stays one");
  assert.ok(width > 1000, "enlarged to the window, of 2 in 20");
  await page.getByRole("button", { name: "Show all of it" }).click();
  assert.ok((await square())[0] < 320);
  assert.equal(await page.locator(".chart svg path[stroke-width='1.8']").evaluate((path) => path.getAttribute("d").split("M").length - 1), 2, "a gap");
  await page.getByLabel("pinion", { exact: true }).uncheck();
  assert.equal(await page.locator(".chart svg path[stroke-width='1.8']").count(), 0);
});

test("a chart is read with keys, and saved as a light SVG file", async (t) => {
  const page = await opened(t);
  await charted(page);
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.getByLabel("Chart", { exact: true }).selectOption("errors");
  await page.waitForFunction(() => document.querySelector(".chart figcaption").textContent === "Errors");
  await page.getByLabel("Read at").focus();
  await page.keyboard.press("End");
  assert.match(await page.locator(".chart output").textContent(), /^tolerance 0\.10000\u2009mm; volume 0\.0010000$/);
  await page.evaluate(() => { document.documentElement.dataset.theme = "dark"; });
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as an SVG file" }).click();
  const file = await download;
  assert.equal(file.suggestedFilename(), "spur-pair-errors.svg");
  const chunks = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk);
  const svg = Buffer.concat(chunks).toString();
  assert.match(svg, /fill="#ffffff"/);
  assert.match(svg, /volume, order 1\.00/);
  assert.doesNotMatch(svg, /style=|<script/);
});

test("a chart that cannot be made says why, in the server's words", async (t) => {
  const page = await opened(t);
  await charted(page, () => ({ headline: "No chart", problems: [{ parameter: null, member: null, subject: "teeth = 2", message: "at least 3" }] }));
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForFunction(() => document.querySelector(".chart-wrong").textContent);
  assert.equal(await page.locator(".chart-wrong").textContent(), "No chart\nteeth = 2: at least 3");
});

test("a chart that was not had is asked for again once there is a connection again", async (t) => {
  let last;
  const page = await opened(t, { answers: (socket, ask) => talkative(last = socket, ask) });
  await page.route(`${ORIGIN}/api/plots`, (route) => route.abort());
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForFunction(() => /does not answer/.test(document.querySelector(".chart-wrong").textContent));
  await charted(page);
  await last.close({ code: 1012 });
  await page.waitForSelector(".chart svg");
  assert.equal(await page.locator(".chart-wrong").textContent(), "");
});

// A server's file: states one after another, each for one look at it.
async function filed(page, states) {
  const seen = { wishes: [], cancelled: 0 };
  await page.route(`${ORIGIN}/api/files**`, async (route) => {
    seen.wishes.push(JSON.parse(route.request().postData()));
    await route.fulfill({ status: 202, contentType: "application/json", body: JSON.stringify({ id: "f1", url: "/api/files/f1" }) });
  });
  await page.route(`${ORIGIN}/api/files/f1`, async (route) => {
    if (route.request().method() === "DELETE") {
      seen.cancelled++;
      return route.fulfill({ status: 204 });
    }
    const state = states.length > 1 ? states.shift() : states[0];
    return route.fulfill({ contentType: "application/json", body: JSON.stringify({ stage: "", seconds: 0, name: "spur.stl", bytes: null, ...state }) });
  });
  await page.route(`${ORIGIN}/api/files/f1/content`, (route) =>
    route.fulfill({ headers: { "content-disposition": 'attachment; filename="spur.stl"' }, body: "solid" }));
  return seen;
}

async function making(t, states) {
  const page = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20&~tab=files" });
  return { page, seen: await filed(page, states) };
}

test("a file is made with its options, tells how far it is, and comes by itself", async (t) => {
  const { page, seen } = await making(t, [{ state: "waiting" }, { state: "working", stage: "writing spur.stl" }, { state: "done", bytes: 3_210_000 }]);
  await page.getByLabel("Format").selectOption("body .stl");
  await page.getByLabel("Chord tolerance").fill("0.001 in");
  await page.getByLabel("Members in files of their own (zip)").check();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Make the file" }).click();
  await page.waitForFunction(() => document.querySelector(".jobs p").textContent === "Writing spur.stl …");
  assert.equal((await download).suggestedFilename(), "spur.stl");
  assert.match(await page.locator(".jobs p").textContent(), /^Done.*\(3\.21 MB\)$/);
  const [{ design, ...wish }] = seen.wishes;
  assert.deepEqual(wish, {
    suffix: ".stl", what: "body", tolerance: 0.0254, clearance: null, placed: true, separate: true, density: null, material: null,
    step_schema: null, paper: "A3",
  });
  assert.deepEqual(design.teeth, [16, 40]);
});

test("what is not wanted any more is cancelled", async (t) => {
  const { page, seen } = await making(t, [{ state: "working", stage: "building" }]);
  await page.getByRole("button", { name: "Make the file" }).click();
  await page.waitForFunction(() => document.querySelector(".jobs p")?.textContent === "Building …");
  await page.getByRole("button", { name: /^Cancel/ }).click();
  await page.waitForFunction(() => document.querySelector(".jobs p").textContent === "Cancelled");
  await page.waitForTimeout(500);
  assert.equal(seen.cancelled, 1);
});

test("a file that fails says why; a wrong option is told at its field", async (t) => {
  const { page, seen } = await making(t, [{ state: "failed", headline: "Too fine", problems: [{ subject: "tolerance", message: "try 0.01" }] }]);
  await page.getByLabel("Chord tolerance").fill("-1");
  await page.getByRole("button", { name: "Make the file" }).click();
  assert.equal(seen.wishes.length, 0);
  assert.equal(await page.getByLabel("Chord tolerance").getAttribute("aria-invalid"), "true");
  await page.getByLabel("Chord tolerance").fill("");
  await page.getByRole("button", { name: "Make the file" }).click();
  await page.waitForSelector(".jobs .problem");
  assert.equal(await page.locator(".jobs .problem").textContent(), "Too fine\ntolerance: try 0.01");
});

test("a format that holds masses needs a material, and leads to it", async (t) => {
  const { page, seen } = await making(t, [{ state: "done" }]);
  await page.getByLabel("Format").selectOption("body .urdf");
  await page.getByRole("button", { name: "Make the file" }).click();
  assert.equal(seen.wishes.length, 0);
  await page.getByRole("button", { name: "Choose a material" }).click();
  await page.getByLabel("Material").selectOption("steel");
  await page.getByRole("tab", { name: "Files" }).click();
  await page.getByRole("button", { name: "Make the file" }).click();
  await page.waitForSelector(".jobs li");
  assert.equal(seen.wishes[0].material, "steel");
});

test("options are those of the format", async (t) => {
  const { page } = await making(t, [{ state: "done" }]);
  const shown = async () => (await page.locator(".making fieldset > *:visible label, .making fieldset > label:visible").allTextContents());
  await page.getByLabel("Format").selectOption("body .step");
  assert.deepEqual((await shown()).slice(0, 2), ["Chord tolerance", "STEP schema"]);
  await page.getByLabel("Format").selectOption("sheet .pdf");
  assert.deepEqual(await shown(), ["Paper"]);
});

test("texts are copied, also where the page may not write to the clipboard", async (t) => {
  const page = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20&~tab=files" });
  await page.evaluate(() => {
    window.written = [];
    Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => void window.written.push(text) }, configurable: true });
  });
  for (const name of ["Copy the command line", "Copy TOML", "Copy Python", "Copy the values as JSON", "Copy the values as a table"]) {
    await page.getByRole("button", { name }).click();
    await page.waitForFunction(() => document.querySelector(".copies [role=status]").textContent.startsWith("Copied"));
  }
  const [command, toml, python, json, table] = await page.evaluate(() => window.written);
  assert.deepEqual([command, toml, python], ["gearwright spur", 'element = "spur"\n', "import gearwright as gw\n"]);
  assert.equal(JSON.parse(json).pair.sizes.centre_distance.value, 84);
  assert.ok(table.includes("pinion\tBase diameter\td_b\t45.106\tmm\n") && table.includes("gear\tVolume\t\t41230\tmm^3\n"));
  assert.ok(table.includes("pair\tTransmission error\tTE\t12.5\turad\n"));
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("no")) }, configurable: true });
    document.execCommand = (what) => { window.fallback = [what, document.activeElement.value]; return true; };
  });
  await page.getByRole("button", { name: "Copy TOML" }).click();
  await page.waitForFunction(() => window.fallback);
  assert.deepEqual(await page.evaluate(() => window.fallback), ["copy", 'element = "spur"\n']);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "TOML");
});

test("at 360 pixels tables scroll by themselves, by keys too, and the page does not", async (t) => {
  const page = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20&~tab=mass" });
  await page.setViewportSize({ width: 360, height: 780 });
  await page.waitForSelector("[data-panel=mass] .off");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  const region = page.getByRole("region", { name: "Mass and inertia" });
  await region.focus();
  assert.ok(await region.evaluate((one) => one.scrollWidth > one.clientWidth));
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.querySelector("[data-panel=mass] .scrolls").scrollLeft > 0);
});
