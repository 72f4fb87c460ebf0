// The view in a browser: what is drawn is the body, inputs do what they say, and nothing is asked of any network.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launched } from "./browser.mjs";
import { ANY, count, difference, keep, settled, slide, unitsAPixel } from "./pictures.mjs";

const folder = mkdtempSync(join(tmpdir(), "gearwright-pages-"));
let browser;
const requested = [];

before(async () => {
  execFileSync(process.env.PYTHON ?? "python3", [join(import.meta.dirname, "pages.py"), folder], { stdio: "inherit" });
  browser = await launched();
  browser.on("request", (request) => requested.push(request.url()));
});
after(() => browser?.close());

async function opened(name, within = browser) {
  const page = await within.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(`file://${join(folder, name)}.html`);
  await page.waitForSelector("html[data-ready]");
  await settled(page);
  page.errors = errors;
  return page;
}

const BRASS = "r > b + 30";

test("a rod seen along its axis is as large as the scale bar says, far from the origin, too", async () => {
  for (const name of ["rod", "far"]) {
    const page = await opened(name);
    await page.getByRole("button", { name: "Look from +z" }).click();
    await keep(page, "disc");
    const scale = await unitsAPixel(page);
    const area = (await count(page, "disc", ANY)) * scale ** 2;
    assert.ok(Math.abs(area / (Math.PI * 100) - 1) < 0.02, `${name}: ${area}`);
    assert.deepEqual(page.errors, []);
    await page.close();
  }
});

test("a turn by a pitch brings all teeth to where others were, by half a pitch not", async () => {
  const page = await opened("pair");
  await keep(page, "start");
  await slide(page, "Turn of the pinion", 18); // 360° / 20; the gear by 12°, a pitch of its 30
  await keep(page, "pitch");
  await slide(page, "Turn of the pinion", 9);
  await keep(page, "half");
  assert.ok((await difference(page, "start", "pitch")) < 2e-3);
  assert.ok((await difference(page, "start", "half")) > 2e-2);
  await page.close();
});

test("the pair runs when asked to, and rests then", async () => {
  const page = await opened("pair");
  const turn = () => page.getByLabel("Turn of the pinion").evaluate((input) => input.valueAsNumber);
  assert.equal(await turn(), 0);
  await page.getByRole("button", { name: "Run" }).click();
  await page.waitForFunction(() => document.querySelector("input[type=range]").valueAsNumber > 3);
  await page.getByRole("button", { name: "Stop" }).click();
  await settled(page);
  const rest = await turn();
  await page.waitForTimeout(300);
  assert.equal(await turn(), rest);
  await page.close();
});

test("a rack runs as far as it reaches; one part does not run", async () => {
  const page = await opened("rack");
  const limits = await page.getByLabel("Turn of the pinion").evaluate((input) => [+input.min, +input.max]);
  assert.ok(Math.abs(limits[1] - 45) < 1e-6 && limits[0] === -limits[1], `${limits}`); // 6 of 24 teeth, half either way
  await page.close();
  const alone = await opened("rod");
  assert.equal(await alone.getByLabel("Turn of the pinion").count(), 0);
  await alone.close();
});

test("a cut is hatched where there is material, and only there", async () => {
  const hatched = {};
  for (const name of ["rod", "tube"]) {
    const page = await opened(name);
    await page.getByRole("button", { name: "Look from +x" }).click();
    await page.getByLabel("Section plane", { exact: true }).selectOption("x");
    await keep(page, "cut");
    // the paler colour of the cut, between its lines: without light and shade, so all of it alike
    const pale = await page.evaluate(() => {
      const canvas = document.querySelector("canvas");
      const data = window.kept.cut;
      const tally = {};
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 3] === 255) {
          const colour = `${data[i]},${data[i + 1]},${data[i + 2]}`;
          tally[colour] = (tally[colour] ?? 0) + 1;
        }
      }
      return Object.entries(tally).sort((a, b) => b[1] - a[1])[0][0].split(",").map(Number);
    });
    const near = pale.map((value, k) => `Math.abs(${"rgb"[k]} - ${value}) < 3`).join(" && ");
    hatched[name] = (await count(page, "cut", near)) * (await unitsAPixel(page)) ** 2;
    await page.close();
  }
  assert.ok(hatched.rod > 0.6 * 400, `${hatched.rod}`); // 20 × 20, less the lines
  assert.ok(Math.abs(hatched.tube / hatched.rod - 160 / 400) < 0.03, `${hatched.tube} ${hatched.rod}`);
});

test("the section plane moves, and shows the other side", async () => {
  const page = await opened("rod");
  await page.getByLabel("Section plane", { exact: true }).selectOption("z");
  assert.equal(await page.locator(".slider output").last().innerText(), "10.0 mm");
  await keep(page, "middle");
  const whole = await count(page, "middle", ANY);
  await slide(page, "Place of the cut", 2);
  await keep(page, "low");
  assert.ok((await count(page, "low", ANY)) < 0.8 * whole);
  await page.getByRole("button", { name: "Show the other side" }).click();
  await keep(page, "other");
  assert.ok((await count(page, "other", ANY)) > whole);
  await page.getByLabel("Section plane", { exact: true }).selectOption("");
  await keep(page, "none");
  assert.ok((await count(page, "none", ANY)) > (await count(page, "other", ANY)));
  await page.close();
});

test("keys turn, zoom and shift, and 0 shows all again", async () => {
  const page = await opened("pair");
  await page.locator("canvas").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "y"]) {
    await keep(page, "before");
    await page.keyboard.press(key);
    await keep(page, "after");
    assert.ok((await difference(page, "before", "after")) > 1e-2, key);
    await page.keyboard.press("0");
  }
  const scale = await unitsAPixel(page);
  await page.keyboard.press("-");
  await settled(page);
  assert.ok((await unitsAPixel(page)) > 1.1 * scale);
  await page.close();
});

test("the mouse turns and its wheel zooms; so do fingers", async () => {
  const page = await opened("pair");
  await keep(page, "start");
  await page.mouse.move(500, 300);
  await page.mouse.down();
  await page.mouse.move(620, 340, { steps: 4 });
  await page.mouse.up();
  await keep(page, "turned");
  assert.ok((await difference(page, "start", "turned")) > 2e-2);
  const scale = await unitsAPixel(page);
  await page.mouse.wheel(0, -400);
  await settled(page);
  assert.ok((await unitsAPixel(page)) < 0.95 * scale);
  const client = await page.context().newCDPSession(page);
  await keep(page, "untouched");
  const touch = (type, x, y) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
  await touch("touchStart", 500, 300);
  await touch("touchMove", 560, 330);
  await touch("touchMove", 620, 350);
  await touch("touchEnd");
  await keep(page, "touched");
  assert.ok((await difference(page, "untouched", "touched")) > 2e-2);
  await page.close();
});

test("bodies are hidden by their names, and edges with them", async () => {
  const page = await opened("pair");
  await keep(page, "both");
  assert.ok((await count(page, "both", BRASS)) > 5000);
  await page.getByLabel("Show pinion").uncheck();
  await keep(page, "gear");
  assert.equal(await count(page, "gear", BRASS), 0);
  await page.getByLabel("Sharp edges").uncheck();
  await keep(page, "plain");
  assert.ok((await count(page, "plain", "r < 50")) < 0.2 * (await count(page, "gear", "r < 50")));
  await page.close();
});

test("everything to operate has a name, and the picture says what it is", async () => {
  const page = await opened("pair");
  const canvas = page.getByRole("img");
  assert.match(await canvas.getAttribute("aria-label"), /^Gear pair: 20\/30 teeth.*Arrow keys turn/);
  const nameless = await page.$$eval("button, select, input", (all) => all.filter((one) => !one.ariaLabel).length);
  assert.equal(nameless, 0);
  await page.close();
});

test("the page is dark where the reader wants it dark, and can be changed", async () => {
  const page = await opened("pair");
  const light = () => page.evaluate(() => parseInt(getComputedStyle(document.body).backgroundColor.split("(")[1]));
  assert.ok((await light()) > 240);
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  assert.ok((await light()) < 60);
  await page.getByRole("button", { name: "Light or dark" }).click();
  assert.ok((await light()) > 240);
  await page.close();
});

test("in a notebook it stands in a frame that may run its script and nothing else", async () => {
  const page = await browser.newPage();
  await page.goto(`file://${join(folder, "notebook")}.html`);
  const frame = page.frames()[1] ?? (await page.waitForEvent("frameattached"));
  await frame.waitForSelector("html[data-ready]");
  assert.ok(await frame.evaluate(() => document.querySelector("canvas").width > 300));
  assert.equal(await frame.evaluate(() => window.origin), "null");
  // what is forbidden is refused by the browser, not only never tried
  assert.equal(await frame.evaluate(() => fetch("https://example.org/").then(() => "sent", () => "refused")), "refused");
  await page.close();
});

test("without WebGL it says so", async () => {
  const plain = await launched({}, ["--disable-3d-apis"]);
  const page = await plain.newPage();
  await page.goto(`file://${join(folder, "rod")}.html`);
  assert.match(await page.getByRole("alert").innerText(), /^rod: this browser draws nothing in three dimensions/);
  await plain.close();
});

// the last one: all that came before has been listened to
test("no request left any page", () => {
  const pages = requested.filter((url) => !url.startsWith(`file://${folder}/`) && !/^(data|blob|about):/.test(url));
  assert.deepEqual(pages, []);
  assert.ok(requested.length > 10);
});
