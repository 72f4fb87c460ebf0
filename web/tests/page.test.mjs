// The designer page in a browser, with a server that says what a test wants: see designer_server.mjs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { launched } from "./browser.mjs";
import { ELEMENTS, frame, ORIGIN, prompt, served, values } from "./designer_server.mjs";

const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

let browser;
before(async () => {
  browser = await launched({ viewport: { width: 1400, height: 860 }, colorScheme: "light" });
});
after(() => browser?.close());

// A page that is shown; what went wrong in it is told when it is closed.
async function opened(t, { hash = "", within = browser, ...more } = {}) {
  const page = await within.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && /Content Security|Refused/.test(message.text())) errors.push(message.text());
  });
  const server = await served(page, more);
  t.after(async () => {
    await page.evaluate(() => localStorage.clear()).catch(() => {});
    await page.close();
    assert.deepEqual(errors, []);
  });
  await page.goto(`${ORIGIN}/${hash}`);
  await page.waitForSelector("html[data-ready]");
  return { page, server };
}

const field = (page, name) => page.locator(`[data-parameter="${name}"]`);
const text = (page, name) => field(page, name).locator('input[type="text"]').first();
const hashOf = (page) => page.evaluate(() => location.hash);
const until = (page, what, argument) => page.waitForFunction(what, argument, { timeout: 5000 });

// Sets a slider as a hand does that pulls it, as often as there are values.
const pull = (page, name, all) =>
  field(page, name).locator('input[type="range"]').first().evaluate((slider, all) => {
    for (const value of all) {
      slider.value = `${value}`;
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    }
    slider.dispatchEvent(new Event("change", { bubbles: true }));
  }, all);

test("an example is there at once, asked for and shown", async (t) => {
  const { page, server } = await opened(t);
  await until(page, () => document.querySelector(".strip").textContent.includes("41\u202f230 mm³"));
  assert.deepEqual(server.asks[0].design, { element: "spur", teeth: [16, 40], module: 3, face_width: 20 });
  assert.deepEqual([server.asks[0].ask, server.asks[0].density], ["design", null]);
  await until(page, () => document.querySelector("#spoken").textContent === "Volume 41\u202f230 mm³, mass 0.324 kg");
});

test("what is typed has units of its own", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await text(page, "face_width").fill("0.5 in");
  assert.equal(await field(page, "face_width").locator(".reading").textContent(), "= 12.7 mm");
  await until(page, () => location.hash.includes("face_width=12.7"));
  await text(page, "face_width").blur();
  assert.equal(await text(page, "face_width").inputValue(), "12.7");
  await text(page, "module").fill("DP 8");
  await until(page, () => location.hash.includes("diametral_pitch=8"));
  assert.ok(!(await hashOf(page)).includes("module"));
  await text(page, "module").blur();
  assert.equal(await text(page, "module").inputValue(), "");
  await until(page, () => document.querySelector('[data-parameter="diametral_pitch"] input').value === "8");
  await page.waitForTimeout(100);
  assert.deepEqual(server.asks.at(-1).design, { element: "spur", teeth: 24, diametral_pitch: 8, face_width: 12.7 });
});

test("a pitch typed key by key in the module's field is handed over whole, and a module likewise", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await text(page, "module").fill("");
  await text(page, "module").pressSequentially("DP 12", { delay: 20 });
  assert.equal(await text(page, "module").inputValue(), "DP 12");
  assert.equal(await text(page, "diametral_pitch").inputValue(), "12");
  await page.keyboard.press("Tab");
  assert.equal(await text(page, "module").inputValue(), "");
  await until(page, () => /diametral_pitch=12(&|$)/.test(location.hash) && !location.hash.includes("module"));
  await text(page, "diametral_pitch").fill("");
  await text(page, "diametral_pitch").pressSequentially("m 2.5", { delay: 20 });
  await page.keyboard.press("Enter");
  await until(page, () => location.hash.includes("module=2.5") && !location.hash.includes("pitch"));
  assert.equal(await text(page, "module").inputValue(), "2.5");
  await text(page, "module").fill("DP 8");
  await text(page, "module").fill("3"); // thought better of it
  await until(page, () => location.hash.includes("module=3") && !location.hash.includes("pitch"));
  await text(page, "face_width").fill("P 8");
  assert.match(await field(page, "face_width").locator(".problem").textContent(), /P 8 is no length/);
  await page.waitForTimeout(60);
  assert.deepEqual(server.asks.at(-1).design, { element: "spur", teeth: 24, module: 3, face_width: 16 });
});

test("a module that is typed takes the pitch's place, and a pitch the module's", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&diametral_pitch=8&face_width=16" });
  await text(page, "module").fill("3");
  await until(page, () => location.hash.includes("module=3") && !location.hash.includes("pitch"));
  assert.equal(await text(page, "diametral_pitch").inputValue(), "");
  await text(page, "diametral_pitch").fill("10");
  await until(page, () => location.hash.includes("diametral_pitch=10") && !location.hash.includes("module"));
  assert.equal(await text(page, "module").inputValue(), "");
});

test("a slider that is pulled asks once a frame, and the newest wins while an answer is under way", async (t) => {
  const open = [];
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16", answers: prompt });
  await until(page, () => document.querySelector(".strip").textContent);
  const before = server.asks.length;
  server.answers = (socket, ask) => open.push([socket, ask]);
  await pull(page, "face_width", Array.from({ length: 30 }, (_, i) => 10 + 0.5 * i));
  await page.waitForTimeout(120);
  assert.equal(server.asks.length, before + 1);
  assert.equal(server.asks.at(-1).design.face_width, 24.5);
  await pull(page, "face_width", [11, 12, 13]);
  await page.waitForTimeout(120);
  assert.equal(server.asks.length, before + 1, "waits for the answer");
  const [socket, ask] = open[0];
  prompt(socket, ask);
  await page.waitForTimeout(150);
  assert.equal(server.asks.length, before + 2);
  assert.equal(server.asks.at(-1).design.face_width, 13);
});

test("an ask that is not answered in time is overtaken, and what comes late is dropped", async (t) => {
  const open = [];
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await until(page, () => document.querySelector(".strip").textContent);
  server.answers = (socket, ask) => open.push([socket, ask]);
  await pull(page, "face_width", [20]);
  await page.waitForTimeout(60);
  await pull(page, "face_width", [30]);
  await page.waitForTimeout(1400);
  assert.deepEqual(open.map(([, ask]) => ask.design.face_width), [20, 30]);
  const [[socket, early], [, late]] = open;
  socket.send(frame(late.id, "late"));
  socket.send(JSON.stringify(values(late.id, 2000)));
  socket.send(frame(early.id, "early"));
  socket.send(JSON.stringify(values(early.id, 1000)));
  socket.send(JSON.stringify({ answer: "refused", id: early.id, headline: "never seen", problems: [] }));
  await page.waitForTimeout(150);
  assert.equal(await page.locator(".strip").textContent(), "Volume 2\u202f000 mm³, mass 0.0157 kg");
  assert.equal(await page.getByText("never seen").count(), 0);
});

test("the address is written seldom enough for every browser, and ends with the newest", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await page.evaluate(() => {
    window.written = 0;
    const replace = history.replaceState.bind(history);
    history.replaceState = (...words) => {
      window.written++;
      replace(...words);
    };
  });
  await pull(page, "face_width", Array.from({ length: 300 }, (_, i) => 5 + i / 10));
  await until(page, () => location.hash.endsWith("face_width=34.9"));
  assert.ok(await page.evaluate(() => window.written) <= 40);
});

test("a slow server is not overtaken by a hand that never rests", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await until(page, () => document.querySelector(".strip").textContent);
  const shown = new Set();
  server.answers = (socket, ask) => setTimeout(() => {
    if (ask.id === server.asks.at(-1).id) shown.add(ask.id);
    prompt(socket, ask);
  }, 1300); // a server that is busy answers only the newest
  await field(page, "face_width").locator('input[type="range"]').evaluate((slider) => new Promise((done) => {
    let count = 0;
    const timer = setInterval(() => {
      slider.value = `${10 + (count++ % 40) / 2}`;
      slider.dispatchEvent(new Event("input", { bubbles: true }));
      if (count > 160) done(clearInterval(timer));
    }, 50);
  }));
  assert.ok(shown.size >= 2, `${shown.size} answers while it was pulled, of ${server.asks.length} asks`);
});

test("a refusal stands at its field, in the server's words; the last good model stays; the focus too", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20,20" });
  await until(page, () => document.querySelector(".strip").textContent);
  server.answers = (socket, { id }) => socket.send(JSON.stringify({
    answer: "refused", id, headline: "This cannot be built", problems: [
      { parameter: "face_width", member: 1, subject: "face_width = -1 mm", message: "must be greater than 0" },
      { parameter: null, member: null, subject: "centre distance", message: "is too small" }],
  }));
  const inputs = field(page, "face_width").locator('input[type="text"]');
  await inputs.nth(1).fill("-1");
  await until(page, () => document.querySelector('[data-parameter="face_width"] .problem').textContent === "must be greater than 0");
  assert.deepEqual([await inputs.nth(0).getAttribute("aria-invalid"), await inputs.nth(1).getAttribute("aria-invalid")], [null, "true"]);
  const described = await inputs.nth(1).getAttribute("aria-describedby");
  assert.equal(await page.locator(`[id="${described}"]`).textContent(), "must be greater than 0");
  assert.equal(await page.locator(".refusals").innerText(), "This cannot be built\n\ncentre distance: is too small");
  assert.ok(await page.getByText("Shown: the last design that can be built.").isVisible());
  assert.equal(await page.locator(".strip").textContent(), "Volume 41\u202f230 mm³, mass 0.324 kg");
  assert.ok(await inputs.nth(1).evaluate((input) => input === document.activeElement));
  await until(page, () => document.querySelector("#spoken").textContent.includes("must be greater than 0"));
  server.answers = prompt;
  await inputs.nth(1).fill("21");
  await until(page, () => !document.querySelector("[aria-invalid]"));
  assert.ok(!(await page.getByText("Shown: the last design").isVisible()));
  assert.equal(await page.locator(".refusals").textContent(), "");
});

test("words that are no number are told at once and not asked", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await until(page, () => document.querySelector(".strip").textContent);
  const before = server.asks.length;
  await text(page, "module").fill("3 kg");
  assert.equal(await text(page, "module").getAttribute("aria-invalid"), "true");
  assert.match(await field(page, "module").locator(".problem").textContent(), /kg is no unit of length/);
  assert.ok(await page.getByText("Shown: the last design that can be built.").isVisible());
  await page.waitForTimeout(150);
  assert.equal(server.asks.length, before);
  await text(page, "module").fill("2");
  await until(page, () => !document.querySelector("[aria-invalid]"));
  await until(page, () => document.querySelector(".pane").dataset.state === "new");
});

test("a lost connection is told, made again, and asked again what was asked last", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await until(page, () => document.querySelector(".strip").textContent);
  await server.sockets[0].close({ code: 1012 });
  await until(page, () => /trying again/.test(document.querySelector(".link").textContent));
  await text(page, "face_width").fill("17");
  await until(page, () => document.querySelector(".link").textContent === "");
  await page.waitForTimeout(100);
  assert.equal(server.sockets.length, 2);
  assert.equal(server.asks.at(-1).design.face_width, 17);
  const before = server.asks.length;
  await server.sockets[1].close({ code: 1012 });
  await page.waitForTimeout(900);
  assert.equal(server.asks.length, before + 1);
  assert.equal(server.sockets.length, 3);
  assert.equal(server.asks.at(-1).design.face_width, 17);
  assert.ok(server.asks.at(-1).id > server.asks.at(-2).id);
});

test("undo and redo go over what was settled on, by keys and buttons; a text field has its own", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  const slider = field(page, "face_width").locator('input[type="range"]');
  await pull(page, "face_width", [20, 21, 22]);
  await page.waitForTimeout(750);
  await pull(page, "face_width", [30]);
  await slider.focus();
  await page.keyboard.press("Control+z");
  assert.ok((await hashOf(page)).endsWith("face_width=22"));
  assert.equal(await text(page, "face_width").inputValue(), "22");
  await page.keyboard.press("Control+z");
  assert.ok((await hashOf(page)).endsWith("face_width=16"));
  await page.keyboard.press("Control+z");
  assert.ok((await hashOf(page)).endsWith("face_width=16"));
  await page.keyboard.press("Control+Shift+z");
  assert.ok((await hashOf(page)).endsWith("face_width=22"));
  await page.keyboard.press("Control+y");
  assert.ok((await hashOf(page)).endsWith("face_width=30"));
  await page.getByRole("button", { name: "Undo" }).click();
  assert.ok((await hashOf(page)).endsWith("face_width=22"));
  await text(page, "module").focus();
  await page.keyboard.press("Control+z");
  await page.waitForTimeout(50);
  assert.ok((await hashOf(page)).endsWith("face_width=22"));
});

test("the address holds all: it opens again, by reload, by back, by hand", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20,22&bore=none,12&~material=steel&~unit=in&~tab=mass" });
  await until(page, () => document.querySelector(".strip").textContent.includes("in³"));
  const [first] = server.asks;
  assert.deepEqual(first.design, { element: "spur", teeth: [16, 40], module: 3, face_width: [20, 22], bore: [null, 12] });
  assert.equal(first.material, "steel");
  assert.equal(await page.getByRole("tab", { name: "Mass & inertia" }).getAttribute("aria-selected"), "true");
  assert.ok(await page.getByLabel("in", { exact: true }).isChecked());
  const hash = await hashOf(page);
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  assert.equal(await hashOf(page), hash);
  assert.equal(await field(page, "bore").locator('input[type="text"]').nth(1).inputValue(), "12");
  await page.getByLabel("Element").selectOption("sweep");
  assert.match(await hashOf(page), /^#sweep\?section=/);
  await page.goBack();
  await until(page, () => document.querySelector('[data-parameter="teeth"]'));
  assert.equal(await hashOf(page), hash);
  await page.evaluate(() => { location.hash = "#spur?teeth=30&module=1&face_width=5"; });
  await until(page, () => document.querySelector('[data-parameter="teeth"] input').value === "30");
  assert.equal(await page.getByLabel("Element").inputValue(), "spur gear");
});

test("the last design is open again where the address names none", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=31&module=2&face_width=16" });
  await page.waitForTimeout(700);
  await pull(page, "face_width", [19]);
  await page.waitForTimeout(800);
  await page.goto("about:blank");
  await page.goto(`${ORIGIN}/`);
  await page.waitForSelector("html[data-ready]");
  assert.equal(await hashOf(page), "#spur?teeth=31&module=2&face_width=19");
  await page.getByText("Your last design is open again").waitFor();
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await hashOf(page), "#spur?teeth=16,40&module=3&face_width=20&~material=steel");
});

test("what does not apply is hidden, left out and remembered", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16&trace=circular&cutter_radius=60" });
  await page.locator("summary", { hasText: "Shape" }).click();
  const trace = field(page, "trace").locator("select");
  assert.ok(await field(page, "cutter_radius").isVisible());
  await trace.selectOption("");
  assert.ok(!(await field(page, "cutter_radius").isVisible()));
  assert.ok(!(await hashOf(page)).includes("cutter_radius"));
  await trace.selectOption("circular");
  assert.ok((await hashOf(page)).includes("cutter_radius=60"));
});

test("one value for both members or one for each", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20" });
  await field(page, "face_width").getByRole("button", { name: "Two values" }).click();
  assert.match(await hashOf(page), /face_width=20,20/);
  await page.getByLabel("face width, gear", { exact: true }).fill("18");
  assert.match(await hashOf(page), /face_width=20,18/);
  await field(page, "face_width").getByRole("button", { name: "Two values" }).click();
  assert.match(await hashOf(page), /face_width=20$/);
});

test("lengths in inches make the same part", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=25.4" });
  await field(page, "length_unit").locator("select").selectOption("in");
  assert.equal(await hashOf(page), "#spur?teeth=24&module=2&face_width=1&length_unit=in");
  assert.equal(await field(page, "face_width").locator(".unit").textContent(), "in");
  await until(page, () => document.querySelector(".strip").textContent.includes("in³"));
});

test("a section is drawn by mouse and by keys", async (t) => {
  const { page } = await opened(t, { hash: '#sweep?section={"polygon":[[0,0],[20,0],[0,20]]}&length=30' });
  const drawing = page.getByRole("group", { name: "section, polygon, drawing" });
  assert.equal(await drawing.locator(".handle").count(), 3);
  await drawing.locator(".handle").nth(1).focus();
  await page.keyboard.press("ArrowRight");
  assert.match(decodeURIComponent(await hashOf(page)), /\[20\.1,0\]/);
  await page.keyboard.press("Shift+ArrowUp");
  assert.match(decodeURIComponent(await hashOf(page)), /\[20\.1,1\]/);
  await page.keyboard.press("Enter");
  assert.equal(await drawing.locator(".handle").count(), 4);
  await page.keyboard.press("Delete");
  assert.equal(await drawing.locator(".handle").count(), 3);
  const box = await drawing.boundingBox();
  await page.mouse.click(box.x + 0.9 * box.width, box.y + 0.1 * box.height);
  await until(page, () => document.querySelectorAll(".handle").length === 4);
  const { section } = await page.evaluate(() => ({ section: JSON.parse(decodeURIComponent(location.hash).match(/section=(\{.*?\})/)[1]) }));
  assert.equal(section.polygon.length, 4);
  assert.ok(section.polygon.some(([x, y]) => Math.abs(x - 20) < 1.5 && Math.abs(y - 20) < 1.5), JSON.stringify(section));
  await page.getByLabel("section, polygon: one point").fill("0, 0\n5, 0\n5");
  assert.match(await field(page, "section").locator(".problem").textContent(), /row 3/);
});

test("the drawing holds a point that is moved out of it by keys; a new hole lies inside", async (t) => {
  const { page } = await opened(t, { hash: '#sweep?section={"polygon":[[10,10],[30,10],[30,30],[10,30]]}&length=30' });
  const drawing = page.getByRole("group", { name: "section, polygon, drawing" });
  await drawing.locator(".handle").nth(1).focus();
  for (let press = 0; press < 15; press++) await page.keyboard.press("Shift+ArrowRight");
  const [place, focused] = await drawing.locator(".handle").nth(1).evaluate((circle) => [Number(circle.getAttribute("cx")), document.activeElement === circle]);
  assert.ok(place <= 300 && focused, `${place} ${focused}`);
  await page.getByRole("button", { name: "Add one to section, holes" }).click();
  const rows = (await page.getByLabel("section, holes 1: one point").inputValue()).split("\n").map((row) => row.split(", ").map(Number));
  assert.ok(rows.length === 4 && rows.every(([x, y]) => x > 10 && y > 10 && y < 30), JSON.stringify(rows));
});

test("another form of a section brings an example; a file is handed over", async (t) => {
  const { page, server } = await opened(t, { hash: "#sweep?section={\"circle\":5}&length=30" });
  const form = field(page, "section").locator("select").first();
  await form.selectOption({ label: "drawn section: polygon" });
  assert.match(decodeURIComponent(await hashOf(page)), /"polygon":\[\[/);
  await form.selectOption({ label: "a file (.dxf)" });
  await page.getByLabel("section, file").setInputFiles({ name: "plate.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from("0\nEOF\n") });
  await until(page, () => location.hash.includes("upload:1f/plate.dxf"));
  assert.deepEqual(server.uploads, ["plate.dxf"]);
  await form.selectOption({ label: "circle" });
  assert.match(decodeURIComponent(await hashOf(page)), /section=\{"circle":5\}/);
});

test("a design file is opened; one that is none is told", async (t) => {
  const { page, server } = await opened(t);
  server.read = (toml) => [{ design: { element: "spur", teeth: 12, module: 4, face_width: 8 } }, toml === "good" ? 200 : 422];
  const give = (content) => page.getByLabel("Design file", { exact: true }).setInputFiles({ name: "gear.toml", mimeType: "text/plain", buffer: Buffer.from(content) });
  await give("good");
  await until(page, () => location.hash === "#spur?teeth=12&module=4&face_width=8&~material=steel");
  const dropped = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    data.items.add(new File(["dropped"], "other.toml"));
    return data;
  });
  server.read = (toml) => [{ design: { element: "spur", teeth: 13, module: 4, face_width: 8 } }, toml === "dropped" ? 200 : 422];
  await page.dispatchEvent("main", "drop", { dataTransfer: dropped });
  await until(page, () => location.hash === "#spur?teeth=13&module=4&face_width=8&~material=steel");
  server.read = () => [{ headline: "line 1: this is no TOML", problems: [] }, 422];
  await give("bad");
  await page.getByText("line 1: this is no TOML").waitFor();
  assert.equal(await hashOf(page), "#spur?teeth=13&module=4&face_width=8&~material=steel");
});

test("an upload that arrives once its field is gone, or holds something else, is dropped", async (t) => {
  const { page } = await opened(t, { hash: "#sweep?section=plate.dxf&length=30" });
  let release;
  await page.route(`${ORIGIN}/api/uploads*`, async (route) => {
    await new Promise((go) => { release = go; });
    await route.fulfill({ status: 201, contentType: "application/json", body: '{"value":"upload:1f/late.dxf","name":"late.dxf","bytes":1}' }).catch(() => {});
  });
  const send = async () => {
    release = null;
    await page.getByLabel("section, file").or(field(page, "section").locator('input[type="file"]')).first().setInputFiles({ name: "late.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from("0") });
    for (let i = 0; i < 50 && !release; i++) await page.waitForTimeout(20);
  };
  await send();
  await page.getByLabel("Element").selectOption("spur gear");
  release();
  await page.waitForTimeout(150);
  assert.match(await hashOf(page), /^#spur/);
  assert.ok(await field(page, "teeth").isVisible());
  await page.goBack();
  await until(page, () => location.hash.startsWith("#sweep"));
  await send();
  await field(page, "section").locator("select").first().selectOption({ label: "circle" });
  release();
  await page.waitForTimeout(150);
  assert.doesNotMatch(await hashOf(page), /late/);
  await page.evaluate(() => { location.hash = "#sweep?section=plate.dxf&length=30"; });
  await until(page, () => document.querySelector('[data-parameter="section"] input[type="file"]'));
  await send();
  await page.evaluate(() => { location.hash = "#sweep?section=other.dxf&length=30"; });
  await until(page, () => document.querySelector('[data-parameter="section"] .reading')?.textContent === "other.dxf");
  release();
  await page.waitForTimeout(150);
  assert.match(await hashOf(page), /section=other.dxf/);
});

test("points that are none are shown as an empty field, by which the server's words stand", async (t) => {
  const refuse = (socket, { id }) => socket.send(JSON.stringify({
    answer: "refused", id, headline: "This cannot be built", problems: [{ parameter: "section", member: null, subject: "section", message: "points are needed" }] }));
  const { page, server } = await opened(t, { hash: "#sweep?section={\"polygon\":[1,2,3]}&length=30", answers: refuse });
  const rows = field(page, "section").locator("textarea").first();
  for (const polygon of ["[1,2,3]", '[["a","b"],["c","d"],[1,2]]', "[[0,0],[1,0],null]"]) {
    await page.evaluate((hash) => { location.hash = hash; }, `#sweep?section={"polygon":${polygon}}&length=31`);
    await until(page, () => document.querySelector('[data-parameter="length"] input').value === "31");
    assert.equal(await rows.inputValue(), "");
    await until(page, () => document.querySelector('[data-parameter="section"] .problem')?.textContent.includes("points are needed"));
    assert.deepEqual(server.asks.at(-1).design.section.polygon, JSON.parse(polygon));
    await page.evaluate(() => { location.hash = '#sweep?section={"polygon":[[0,0],[1,0],[0,1]]}&length=30'; });
    await until(page, () => document.querySelector('[data-parameter="length"] input').value === "30");
    assert.equal(await rows.inputValue(), "0, 0\n1, 0\n0, 1");
  }
});

test("a design that cannot be shown is told and not kept: the example, or the one before it, stays", async (t) => {
  const broken = { ...ELEMENTS.kinds[0], name: "broken", command: "broken", start: { element: "broken" }, parameters: [{ name: "odd" }] };
  const { page } = await opened(t, { elements: { ...ELEMENTS, kinds: [...ELEMENTS.kinds, broken] } });
  await page.evaluate(() => localStorage.setItem("gearwright.design", "#broken?odd=1"));
  await page.reload(); // the address is still the example's
  await page.goto("about:blank");
  await page.goto(ORIGIN);
  await page.waitForSelector("html[data-ready]");
  await page.getByText(/broken cannot be shown/).waitFor();
  assert.equal(await page.getByLabel("Element").inputValue(), "spur pair");
  assert.match(await page.evaluate(() => localStorage.getItem("gearwright.design")), /^#spur/);
  await text(page, "face_width").fill("21");
  await page.getByLabel("Element").selectOption("broken");
  assert.equal(await page.getByLabel("Element").inputValue(), "spur pair");
  assert.equal(await text(page, "face_width").inputValue(), "21");
  assert.match(await hashOf(page), /^#spur.*face_width=21/);
});

test("another unit of the design leaves the point of reference where it is", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16&~about=100,0,0&~tab=mass" });
  assert.equal(await page.locator(".weighing .field:has(.point) .unit").textContent(), "mm");
  await field(page, "length_unit").locator("select").selectOption("in");
  await until(page, () => location.hash.includes("~about=3.937007874015748,0,0"));
  assert.match(await page.getByLabel("x of the point").inputValue(), /^3\.937/);
  assert.equal(await page.locator(".weighing .field:has(.point) .unit").textContent(), "in");
});

test("a density that is none leaves the last one, says so, and keeps nothing else waiting", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16&~material=steel&~tab=mass" });
  await page.getByLabel("Material").selectOption("typed");
  assert.equal(await page.getByLabel("Density").getAttribute("aria-invalid"), "true");
  assert.equal(await page.locator(".weighing .problem").textContent(), "a density is needed; the masses are still those of steel");
  await page.getByLabel("Inertia about").selectOption("centroid");
  await until(page, () => location.hash.includes("~about=centroid"));
  await page.getByLabel("Density").fill("-3");
  assert.match(await page.locator(".weighing .problem").textContent(), /^must be greater than 0; .*steel$/);
  await page.getByLabel("Density").fill("2700");
  await until(page, () => location.hash.includes("~density=2700"));
  assert.equal(await page.locator(".weighing .problem").isHidden(), true);
  assert.equal(server.asks.at(-1).material, null);
});

test("what the kind does not have can be left out where it is refused", async (t) => {
  const answers = (socket, ask) => {
    if (!("bore_depth" in ask.design)) return prompt(socket, ask);
    const problems = [{ parameter: null, member: null, subject: "bore_depth = 3", message: "there is no such parameter" }];
    socket.send(JSON.stringify({ answer: "refused", id: ask.id, headline: "This cannot be built", problems }));
    socket.send(JSON.stringify({ answer: "done", id: ask.id, seconds: 0 }));
  };
  const { page } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16&bore_depth=3", answers });
  await page.getByRole("button", { name: "Leave out bore depth" }).click();
  await until(page, () => document.querySelector(".strip").textContent && !document.querySelector(".refusals").textContent);
  assert.equal(await hashOf(page), "#spur?teeth=24&module=2&face_width=16");
});

test("a pair whose numbers of teeth are cleared is a pair still, when it comes back, too", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20" });
  for (const input of await field(page, "teeth").locator('input[type="text"]').all()) await input.fill("");
  await until(page, () => location.hash.includes("teeth=none,none"));
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  assert.equal(await page.getByLabel("Element", { exact: true }).inputValue(), "spur pair");
  assert.deepEqual(await field(page, "teeth").locator('input[type="text"]').evaluateAll((all) => all.map((one) => one.value)), ["", ""]);
});

test("what it is made of and about which point", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16" });
  await page.getByRole("tab", { name: "Mass & inertia" }).click();
  await page.getByLabel("Material").selectOption("steel");
  await until(page, () => location.hash.includes("~material=steel"));
  await page.getByLabel("Material").selectOption({ label: "another density …" });
  await page.getByLabel("Density").fill("2,7 g/cm³");
  await page.getByLabel("Inertia about").selectOption("point");
  await page.getByLabel("z of the point").fill("1/2 in");
  await until(page, () => location.hash.includes("~density=2700&~about=0,0,12.7"));
  await page.waitForTimeout(150);
  const ask = server.asks.at(-1);
  assert.deepEqual([ask.material, ask.density], [null, 2700]);
});

test("a pinned design stays as it was, beside the one that changes", async (t) => {
  const volume = (ask) => 1000 * ask.design.face_width;
  const answers = (socket, ask) => {
    socket.send(frame(ask.id));
    socket.send(JSON.stringify(values(ask.id, volume(ask))));
    socket.send(JSON.stringify({ answer: "done", id: ask.id, seconds: 0 }));
  };
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16", answers });
  await until(page, () => document.querySelector(".strip").textContent);
  await page.getByRole("button", { name: "Keep this design" }).click();
  await until(page, () => document.querySelectorAll(".pane").length === 2);
  await pull(page, "face_width", [20]);
  const row = page.locator(".comparison tr", { has: page.locator("th", { hasText: /^Volume$/ }) });
  await until(page, () => /20\u202f000/.test(document.querySelector(".comparison").textContent));
  assert.deepEqual(await row.locator("td").allTextContents(), ["20\u202f000", "16\u202f000", "4\u202f000.0", "mm³"]);
  assert.equal(server.sockets.length, 2);
  await page.getByLabel("only what differs").check();
  assert.deepEqual(await page.locator(".comparison tbody th").allTextContents(), ["Volume", "Mass"]);
  await page.getByRole("button", { name: "Leave the comparison" }).click();
  assert.equal(await page.locator(".pane").count(), 1);
  assert.equal(await page.getByRole("tab", { name: "Compared" }).count(), 0);
});

test("a design that cannot be built is not pinned, but the last one that was", async (t) => {
  const none = (socket, { id }) => socket.send(JSON.stringify({ answer: "refused", id, headline: "no", problems: [] }));
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=-1", answers: none });
  await until(page, () => document.querySelector(".pane").dataset.state === "old");
  const compare = page.getByRole("button", { name: "Keep this design" });
  await compare.click();
  await page.getByText("There is nothing to compare with yet").waitFor();
  assert.equal(await page.locator(".pane").count(), 1);
  server.answers = byWidth(0);
  await text(page, "face_width").fill("16");
  await until(page, () => document.querySelector(".strip").textContent.includes("16\u202f000"));
  server.answers = (socket, ask) => (ask.design.face_width === 16 ? byWidth(0) : none)(socket, ask);
  await text(page, "face_width").fill("-3");
  await until(page, () => document.querySelector(".pane").dataset.state === "old");
  await compare.click();
  await page.getByText("B is the last design that was built").waitFor();
  await until(page, () => document.querySelectorAll(".comparison td").length > 0);
  assert.equal(server.asks.at(-1).design.face_width, 16);
});

test("landmarks have names of their own, headings their order", async (t) => {
  const { page } = await opened(t);
  await until(page, () => document.querySelector(".strip").textContent);
  await page.evaluate(readFileSync(AXE, "utf8"));
  for (const tab of ["Sizes", "Files"]) {
    await page.getByRole("tab", { name: tab }).click();
    const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ["landmark-unique", "heading-order", "region", "page-has-heading-one"] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join()}`), []);
  }
});

test("a note of the server is read out", async (t) => {
  const { page, server } = await opened(t);
  await until(page, () => document.querySelector(".strip").textContent);
  server.sockets[0].send(JSON.stringify({ answer: "note", text: "A worker was lost and has been replaced." }));
  const toast = page.getByText("A worker was lost");
  await toast.waitFor();
  assert.equal(await toast.evaluate((one) => one.closest("[aria-live]").getAttribute("aria-live")), "polite");
});

test("all of it by keys: skip link, fields, help, tabs", async (t) => {
  const { page } = await opened(t);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Skip to the parameters");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), "teeth, pinion");
  assert.match(await hashOf(page), /^#spur/);
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Enter");
  const help = field(page, "teeth").locator(".help");
  assert.match(await help.textContent(), /Meaning of teeth \(≥ 3, ≤ 10000\)/);
  await page.keyboard.press("Escape");
  assert.ok(!(await help.isVisible()));
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowRight");
  assert.match(await hashOf(page), /teeth=17,40/);
  await page.getByRole("tab", { name: "Sizes" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Mass & inertia");
  assert.ok(await page.getByLabel("Material").isVisible());
  await page.keyboard.press("End");
  assert.match(await hashOf(page), /~tab=files/);
});

// Contrast of each visible text against what is behind it, of those that have less than 4.5.
const pale = (page) => page.evaluate(() => {
  const channels = (colour) => {
    const pen = new OffscreenCanvas(1, 1).getContext("2d");
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data];
  };
  const light = (colour) => {
    const [r, g, b] = channels(colour).map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (element) => {
    for (let one = element; one; one = one.parentElement) {
      const colour = getComputedStyle(one).backgroundColor;
      if (channels(colour)[3] === 255) return colour;
    }
    return "white";
  };
  const found = [];
  for (const element of document.querySelectorAll("#page *")) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!own || !element.checkVisibility() || element.closest(".unseen, [aria-disabled=true]")) continue;
    const [a, b] = [light(getComputedStyle(element).color), light(ground(element))].sort((x, y) => y - x);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < 4.5) found.push(`${element.tagName}.${element.className}: ${contrast.toFixed(2)}`);
  }
  return found;
});

for (const theme of ["light", "dark"]) {
  test(`every text can be read: ${theme}`, async (t) => {
    const { page, server } = await opened(t);
    await page.emulateMedia({ colorScheme: theme });
    await until(page, (theme) => document.documentElement.dataset.theme === theme, theme);
    server.answers = (socket, { id }) => socket.send(JSON.stringify({
      answer: "refused", id, headline: "No", problems: [{ parameter: "module", member: null, subject: "module", message: "no" }],
    }));
    await text(page, "module").fill("9");
    await page.locator(".tip").nth(1).click();
    await page.locator("[aria-invalid]").first().waitFor();
    assert.deepEqual(await pale(page), []);
  });
}

test("the theme that is chosen stays", async (t) => {
  const { page } = await opened(t);
  await page.getByRole("button", { name: "Light or dark" }).click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
});

test("360 pixels are enough: one column, the view on top, nothing cut off", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20,22" });
  await page.setViewportSize({ width: 360, height: 740 });
  for (const summary of await page.locator("summary").all()) await summary.click();
  const tops = await page.evaluate(() => [".middle", ".form", ".results"].map((name) => document.querySelector(name).getBoundingClientRect().top));
  assert.deepEqual(tops, [...tops].sort((a, b) => a - b));
  const wide = await page.evaluate(() => [...document.querySelectorAll("header *, .form *, .strip, .weighing *")]
    .filter((one) => one.checkVisibility() && !one.closest(".unseen, .skip, svg"))
    .filter((one) => one.getBoundingClientRect().right > 360.5 || one.getBoundingClientRect().left < -0.5).map((one) => one.outerHTML.slice(0, 80)));
  assert.deepEqual(wide, []);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 360));
  const small = await page.evaluate(() => [...document.querySelectorAll("button, select, input, summary")]
    .filter((one) => one.checkVisibility() && !one.classList.contains("unseen"))
    .filter((one) => { const box = (one.closest("label") ?? one).getBoundingClientRect(); return box.width < 24 || box.height < 24; }).map((one) => one.outerHTML.slice(0, 80)));
  assert.deepEqual(small, []);
});

test("on paper there is a data sheet", async (t) => {
  const { page } = await opened(t, { hash: "#spur?teeth=16,40&module=3&face_width=20" });
  await until(page, () => document.querySelector(".strip").textContent);
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator(".sheet h1").isVisible());
  const rows = await page.locator(".sheet tr").allInnerTexts();
  assert.deepEqual(rows.map((row) => row.replaceAll(/\s+/g, " ").trim()), ["Teeth z 16 / 40", "Module m 3 mm", "Face width b 20 mm"]);
  for (const gone of ["header", ".form", ".middle", "[role=tablist]"]) assert.ok(!(await page.locator(gone).first().isVisible()), gone);
  assert.ok(await page.locator("[data-panel=sizes]").isVisible());
  await page.emulateMedia({ media: "screen" });
});

// Model and values of a width's volume; the values so many milliseconds late.
const byWidth = (late) => (socket, { id, design }) => {
  socket.send(frame(id, `spur gear: width ${design.face_width}`));
  setTimeout(() => {
    socket.send(JSON.stringify(values(id, 1000 * design.face_width)));
    socket.send(JSON.stringify({ answer: "done", id, seconds: 0 }));
  }, late);
};
const printed = async (page) => {
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  const sheet = page.locator(".sheet");
  const row = (await sheet.locator("tr").allTextContents()).find((one) => one.startsWith("Face width"));
  return { title: await sheet.locator("h1").textContent(), width: row, note: await sheet.locator(".sheet-note").allTextContents(), images: await sheet.locator("img").count() };
};

test("a sheet is of one design: that of its tables, which it says where it is not the form's", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16", answers: byWidth(0) });
  await until(page, () => document.querySelector(".strip").textContent);
  assert.deepEqual(await printed(page), { title: "Spur gear: width 16", width: "Face width b16mm", note: [], images: 1 });
  server.answers = byWidth(1500); // the new model is there before its values
  await text(page, "face_width").fill("19");
  await until(page, () => document.querySelector(".mv-title").textContent.endsWith("19"));
  const early = await printed(page);
  assert.deepEqual([early.title, early.width, early.images], ["Spur gear: width 16", "Face width b16mm", 0]);
  assert.match(early.note[0], /the last design that was built/);
  await until(page, () => document.querySelector(".strip").textContent.includes("19 000"));
  assert.deepEqual(await printed(page), { title: "Spur gear: width 19", width: "Face width b19mm", note: [], images: 1 });
  await text(page, "face_width").fill("-3x");
  assert.deepEqual([(await printed(page)).width, (await printed(page)).images, (await printed(page)).note.length], ["Face width b19mm", 1, 1]);
});

test("results of an earlier design are marked until those of the form's are there, and are not copied", async (t) => {
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16", answers: byWidth(0) });
  await until(page, () => document.querySelector(".strip").textContent);
  const old = () => page.evaluate(() => [...document.querySelectorAll("[data-old]")].map((one) => one.className));
  const copy = async () => {
    await page.getByRole("tab", { name: "Files" }).click();
    await page.getByRole("button", { name: "Copy TOML" }).click();
    return page.locator(".copies [role=status]").textContent();
  };
  assert.deepEqual(await old(), []);
  server.answers = (socket, { id }) => socket.send(JSON.stringify({ answer: "refused", id, headline: "no", problems: [] }));
  await text(page, "face_width").fill("-3");
  await until(page, () => document.querySelector(".strip[data-old]"));
  assert.deepEqual(await old(), ["strip", "scrolls", "scrolls"]);
  assert.match(await copy(), /^Not copied/);
  server.answers = byWidth(1200);
  await text(page, "face_width").fill("20");
  await until(page, () => document.querySelector(".mv-title").textContent.endsWith("20"));
  assert.deepEqual((await old()).length, 3, "the model is new, the values are not");
  await until(page, () => document.querySelector(".strip").textContent.includes("20 000"));
  assert.deepEqual(await old(), []);
  assert.match(await copy(), /^(Copied|The browser)/);
  await page.getByRole("tab", { name: "Mass & inertia" }).click();
  await page.getByLabel("Material").selectOption("steel");
  await until(page, () => document.querySelector("[data-panel=mass] [data-old]"));
  await until(page, () => !document.querySelector("[data-old]"));
});

test("the badge of an old model outlasts a late answer, and stands while the server is away", async (t) => {
  const open = [];
  const { page, server } = await opened(t, { hash: "#spur?teeth=24&module=2&face_width=16", answers: byWidth(0) });
  await until(page, () => document.querySelector(".strip").textContent);
  server.answers = (socket, ask) => open.push([socket, ask]);
  await text(page, "face_width").fill("18");
  await page.waitForTimeout(80);
  await text(page, "face_width").fill("18x");
  byWidth(0)(...open[0]);
  await until(page, () => document.querySelector(".strip").textContent.includes("18 000"));
  assert.ok(await page.locator(".about-view .old").isVisible());
  server.answers = byWidth(0);
  await text(page, "face_width").fill("18");
  await until(page, () => document.querySelector(".pane").dataset.state === "new" && !document.querySelector("[data-old]"));
  await server.sockets[0].close({ code: 1012 });
  await until(page, () => /trying again/.test(document.querySelector(".link").textContent));
  assert.ok(!(await page.locator(".about-view .old").isVisible()));
  server.answers = () => {};
  await text(page, "face_width").fill("17");
  await until(page, () => /server has answered/.test(document.querySelector(".about-view .old:not([hidden])")?.textContent));
  assert.ok(await page.locator(".strip[data-old]").isVisible());
  server.answers = byWidth(0);
  await server.sockets.at(-1).close({ code: 1012 });
  await until(page, () => document.querySelector(".strip").textContent.includes("17 000"));
  assert.ok(!(await page.locator(".about-view .old").isVisible()));
  assert.equal(await page.locator("[data-old]").count(), 0);
});

test("without a server the page says so, and tries again", async (t) => {
  const page = await browser.newPage();
  t.after(() => page.close());
  const server = await served(page);
  await page.route(`${ORIGIN}/api/elements`, (route) => route.fulfill({ status: 503, contentType: "application/json", body: '{"headline":"All workers are busy","problems":[]}' }));
  await page.goto(ORIGIN);
  assert.match(await page.getByRole("alert").textContent(), /All workers are busy/);
  await page.unroute(`${ORIGIN}/api/elements`);
  await page.getByRole("button", { name: "Try again" }).click();
  await page.waitForSelector("html[data-ready]");
  assert.equal(server.asks.length <= 1, true);
  assert.equal(ELEMENTS.kinds.length, await page.getByLabel("Element").locator("option").count());
});
