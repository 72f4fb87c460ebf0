// The view of the designer page in a browser: what frames bring is drawn, moves, and is measured where it is.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launched } from "./browser.mjs";
import { bundled } from "./bundles.mjs";
import { at, cog, frame } from "./frames.mjs";
import { ANY, count, difference, keep, settled, slide, unitsAPixel } from "./pictures.mjs";

const DEGREE = Math.PI / 180;
const BRASS = "r > b + 30";
const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>scene</title>
<meta name="viewport" content="width=device-width"><link rel="stylesheet" href="scene.css">
<style>html, body { margin: 0; height: 100% }</style><body><script src="scene.js"></script></body></html>`;

let browser, address;

before(async () => {
  const folder = await bundled("scene", "tests/scene_entry.ts");
  writeFileSync(join(folder, "index.html"), PAGE);
  address = `file://${folder}/index.html`;
  browser = await launched();
});
after(() => browser?.close());

const WHEEL = { teeth: 8, root: 20, tip: 25, width: 6 };
const STEEL = [0.6, 0.66, 0.73];
const PAIR = {
  title: "spur pair: 16/40 teeth", turns: 180,
  bodies: [
    { name: "pinion", shells: cog("p", { teeth: 16, root: 20, tip: 27, width: 20, bore: 6 }), spin: 1 },
    { name: "gear", shells: cog("g", { teeth: 40, root: 56, tip: 63, width: 20, bore: 15 }), spin: -0.4, colour: STEEL,
      place: at(84, 0, 0, Math.PI) },
  ],
};
const one = (told = {}, wheel = WHEEL, key = "w") => ({ title: "cog: one", bodies: [{ name: "cog", shells: cog(key, wheel), ...told }] });

async function opened(model, { within = browser, options = {}, prepare = async () => {} } = {}) {
  const page = await within.newPage();
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  await prepare(page);
  await page.goto(address);
  await page.evaluate((options) => {
    window.view = new scene.ModelView(document.body, options);
    window.known = new scene.Topologies();
  }, options);
  if (model) await show(page, model);
  return page;
}

async function show(page, model) {
  await page.evaluate((bytes) => view.show(scene.decodeMesh(Uint8Array.from(bytes).buffer, known)),
    [...new Uint8Array(frame(model))]);
}

const from = (page, axis) => page.getByRole("button", { name: `Look from +${axis}` }).click();
const tick = (page, label, on = true) => page.getByLabel(label).setChecked(on);

// Corners of the box of the pixels of a kept picture that satisfy a test, and their mean.
const extent = (page, name, text) =>
  page.evaluate(([name, text]) => {
    const wanted = new Function("r", "g", "b", "a", `return ${text}`);
    const { width, height } = document.querySelector("canvas");
    const data = window.kept[name];
    let [left, right, top, bottom, number, x, y] = [width, -1, height, -1, 0, 0, 0];
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) {
        const i = 4 * (row * width + column);
        if (column < 110 && row > height - 110) continue; // the axes in the corner
        if (!wanted(data[i], data[i + 1], data[i + 2], data[i + 3])) continue;
        [left, right, top, bottom] = [Math.min(left, column), Math.max(right, column), Math.min(top, row), Math.max(bottom, row)];
        [number, x, y] = [number + 1, x + column, y + row];
      }
    }
    return { left, right: right + 1, top, bottom: bottom + 1, number, x: x / number + 0.5, y: y / number + 0.5 };
  }, [name, text]);

const middle = ({ left, right, top, bottom }) => [(left + right) / 2, (top + bottom) / 2];

// The pixels in which two kept pictures differ, as a picture of a third name: opaque white.
const compare = (page, first, second, name) =>
  page.evaluate(([first, second, name]) => {
    const [a, b] = [window.kept[first], window.kept[second]];
    window.kept[name] = a.map((_, i) => {
      const pixel = i - (i % 4);
      return [0, 1, 2, 3].some((k) => Math.abs(a[pixel + k] - b[pixel + k]) > 25) ? 255 : 0;
    });
  }, [first, second, name]);

// The colour that most pixels have which are drawn.
const commonest = (page, name) =>
  page.evaluate((name) => {
    const tally = {};
    const data = window.kept[name];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 255) continue;
      const colour = `${data[i]},${data[i + 1]},${data[i + 2]}`;
      tally[colour] = (tally[colour] ?? 0) + 1;
    }
    const [first] = Object.entries(tally).sort((a, b) => b[1] - a[1]);
    return [first[0].split(",").map(Number), first[1]];
  }, name);

// The area of a cog across its axis.
function areaOf({ teeth, root, tip, bore = 0 }) {
  const pitch = (2 * Math.PI) / teeth;
  const triangle = (p, q, share) => 0.5 * p * q * Math.sin(share * pitch);
  const sector = 2 * triangle(root, root, 0.25) + 2 * triangle(root, tip, 0.07) + triangle(tip, tip, 0.36);
  return teeth * (sector - (bore ? 2 * triangle(bore, bore, 0.5) : 0));
}

test("all images of a tooth are drawn, as large as the scale bar says, by software and by a card", async () => {
  for (const options of [{}, { drawnBy: "hardware" }]) {
    const page = await opened(one({ place: at(1e5, 0, 0) }), { options });
    assert.equal(await page.locator(".model-view").getAttribute("data-drawing"), options.drawnBy ?? "software");
    await tick(page, "Axes of the parts", false);
    await from(page, "z");
    await keep(page, "wheel");
    const area = (await count(page, "wheel", ANY)) * (await unitsAPixel(page)) ** 2;
    assert.ok(Math.abs(area / areaOf(WHEEL) - 1) < 0.012, `${area} ${areaOf(WHEEL)}`);
    assert.ok((await count(page, "wheel", BRASS)) > 0.9 * (await count(page, "wheel", ANY)));
    assert.deepEqual(page.errors, []);
    await page.close();
  }
});

test("where software draws, it draws no more pixels than the page has", async () => {
  const fine = await launched({ deviceScaleFactor: 2 });
  for (const [options, ratio] of [[{}, 1], [{ drawnBy: "hardware" }, 2]]) {
    const page = await opened(one(), { within: fine, options });
    assert.equal(await page.evaluate(() => document.querySelector("canvas").width / document.body.clientWidth), ratio);
    await page.close();
  }
  await fine.close();
});

test("a pitch of the pinion brings the pair to where it was, half a pitch does not", async () => {
  const page = await opened(PAIR);
  await keep(page, "start");
  await slide(page, "Turn of the pinion", 22.5);
  await keep(page, "pitch");
  await slide(page, "Turn of the pinion", 11.25);
  await keep(page, "half");
  assert.ok((await difference(page, "start", "pitch")) < 2e-3);
  assert.ok((await difference(page, "start", "half")) > 2e-2);
  await page.close();
});

test("a body turns by its spin about its own axis, and slides along its own frame", async () => {
  const bar = { teeth: 1, root: 0, tip: 0, width: 4 };
  const [shell] = cog("bar", bar);
  const points = [[0, -2, 0], [30, -2, 0], [30, 2, 0], [0, 2, 0], [0, -2, 4], [30, -2, 4], [30, 2, 4], [0, 2, 4]];
  const quads = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
  const shells = [{ ...shell, points, normals: undefined, normal: [0, 0, 1], edges: [],
    triangles: quads.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]) }];
  const page = await opened({ title: "bar: one", turns: 180, bodies: [
    { name: "bar", shells, spin: -0.5, slide: [0, 0.1, 0], place: at(10, 20, 0, 90 * DEGREE) }] });
  await tick(page, "Axes of the parts", false);
  await from(page, "z");
  await keep(page, "start");
  const scale = await unitsAPixel(page);
  await slide(page, "Turn of the pinion", 60);
  await keep(page, "turned");
  const [before, now] = [await extent(page, "start", "a > 250"), await extent(page, "turned", "a > 250")];
  // the middle of the bar is 15 from its axis, that at rest is turned by 90°: then by -30° more, and 6 along its y, that is -x
  const moved = [(now.x - before.x) * scale, -(now.y - before.y) * scale];
  const wanted = [15 * Math.cos(60 * DEGREE) - 6, 15 * Math.sin(60 * DEGREE) - 15];
  assert.ok(Math.hypot(moved[0] - wanted[0], moved[1] - wanted[1]) < 0.15, `${moved} ${wanted}`);
  await page.close();
});

test("the cut reaches as far as a body that has slid away", async () => {
  const bar = cog("bar", { teeth: 4, root: 10, tip: 10, width: 6 });
  const page = await opened({ turns: 30, bodies: [{ name: "bar", shells: bar, slide: [0, 0.5, 0], place: at(0, 0, 0, 90 * DEGREE) }] });
  await page.getByLabel("Section plane").selectOption("x");
  const limits = () => page.getByLabel("Place of the cut").evaluate((input) => [Number(input.min), Number(input.max), input.valueAsNumber]);
  const [least, most, place] = await limits();
  await slide(page, "Turn of the pinion", 30); // 15 along its own y, that is -x
  const there = await limits();
  assert.ok([least - 15, most - 15].every((x, i) => Math.abs(there[i] - x) < 1e-6), `${there}`);
  assert.ok(there[2] <= there[1] && there[2] <= place);
  await slide(page, "Turn of the pinion", -30);
  assert.ok(Math.abs((await limits())[0] - least - 15) < 1e-6, `${await limits()}`);
  await page.close();
});

test("a speed that is typed is the one that is taken, and nought stops", async () => {
  const page = await opened(PAIR);
  const typed = page.getByLabel("Speed of the pinion, rpm");
  await typed.fill("5000");
  await typed.press("Enter");
  assert.equal(await typed.inputValue(), "600");
  await typed.fill("");
  await typed.blur();
  assert.equal(await typed.inputValue(), "600");
  await page.getByRole("button", { name: "Run" }).click();
  await typed.fill("0");
  const turn = () => page.getByLabel("Turn of the pinion").evaluate((input) => input.valueAsNumber);
  await page.waitForTimeout(60);
  const rest = await turn();
  await page.waitForTimeout(150);
  assert.equal(await turn(), rest);
  await typed.press("Enter");
  await page.getByRole("button", { name: "Run" }).waitFor();
  await page.close();
});

test("the pinion runs at the speed that is set, and a section and values leave it running", async () => {
  const clocked = await launched(); // a clock is that of all pages of a browser
  const page = await opened(null, { within: clocked, prepare: (page) => page.clock.install({ time: 0 }) });
  await page.clock.pauseAt(60_000);
  await show(page, PAIR);
  await page.getByLabel("Speed of the pinion, rpm").fill("10");
  await page.getByRole("button", { name: "Run" }).click();
  await page.clock.runFor(1000);
  const turn = () => page.getByLabel("Turn of the pinion").evaluate((input) => input.valueAsNumber);
  assert.ok(Math.abs((await turn()) - 60) < 2, `${await turn()}`);
  await slide(page, "Speed of the pinion by feel", 2.5);
  await show(page, PAIR);
  await page.clock.runFor(1000);
  assert.ok(Math.abs((await turn()) - 75) < 2, `${await turn()}`);
  await page.getByRole("button", { name: "Stop" }).click();
  const rest = await turn();
  await page.clock.runFor(1000);
  assert.equal(await turn(), rest);
  await clocked.close();
});

test("who wants no motion gets steps, each of a press", async () => {
  const page = await opened(PAIR, { prepare: (page) => page.emulateMedia({ reducedMotion: "reduce" }) });
  const turn = () => page.getByLabel("Turn of the pinion").evaluate((input) => input.valueAsNumber);
  const step = page.getByRole("button", { name: "Turn on by 2°" });
  await step.focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  assert.equal(await turn(), 4);
  await page.waitForTimeout(400);
  assert.equal(await turn(), 4);
  await page.locator("canvas").focus();
  await page.keyboard.press("Space");
  assert.equal(await turn(), 6);
  await step.hover();
  await page.mouse.down();
  await page.waitForFunction(() => document.querySelector(".mv-foot input").valueAsNumber >= 10);
  await page.mouse.up();
  const rest = await turn();
  await page.waitForTimeout(400);
  assert.equal(await turn(), rest);
  await page.close();
});

test("a cut is hatched where there is material", async () => {
  const found = {};
  for (const bore of [0, 12]) {
    const page = await opened(one({}, { ...WHEEL, bore }));
    await tick(page, "Axes of the parts", false);
    await from(page, "z");
    await page.getByLabel("Section plane", { exact: true }).selectOption("z");
    assert.equal(await page.locator(".mv-panel output").nth(1).innerText(), "3.00 mm");
    await keep(page, "cut");
    found[bore] = (await commonest(page, "cut"))[1] * (await unitsAPixel(page)) ** 2;
    await page.close();
  }
  const ratio = areaOf({ ...WHEEL, bore: 12 }) / areaOf(WHEEL);
  assert.ok(found[0] > 0.6 * areaOf(WHEEL) && found[0] < 0.95 * areaOf(WHEEL), `${found[0]}`); // the rest are lines
  assert.ok(Math.abs(found[12] / found[0] - ratio) < 0.02, `${found[12] / found[0]} ${ratio}`);
});

test("inches are read out where they are wanted", async () => {
  const page = await opened(one());
  const scale = await unitsAPixel(page);
  await page.getByLabel("Section plane", { exact: true }).selectOption("x");
  await slide(page, "Place of the cut", 12.7);
  await page.evaluate(() => view.setUnit("in"));
  await settled(page);
  assert.match(await page.locator(".scale").innerText(), / in$/);
  assert.ok(Math.abs((await unitsAPixel(page)) * 25.4 / scale - 1) < 0.03);
  assert.match(await page.locator(".mv-panel output").nth(1).innerText(), /^0\.5\d* in$/);
  await page.close();
});

const axesAt = (angle) => [[Math.cos(angle), -Math.sin(angle), 0], [Math.sin(angle), Math.cos(angle), 0], [0, 0, 1]];

test("the centroid stands where the values say, and principal axes are as long as the radii of gyration", async () => {
  const page = await opened({ ...one({ place: at(50, 30, 0, 90 * DEGREE), spin: 1 }), turns: 180 });
  await tick(page, "Axes of the parts", false);
  await from(page, "z");
  assert.equal(await page.getByLabel("Centroid and principal axes").isVisible(), false);
  await page.evaluate((axes) => view.setValues({ document: { properties: {
    length_unit: "mm", mass_unit: "kg", mass: 2, centroid: [8, -3, 3], principal_axes: axes, principal_moments: [32, 128, 150],
  } } }), axesAt(20 * DEGREE));
  await slide(page, "Turn of the pinion", 45); // a pitch: the wheel looks as before
  await keep(page, "without");
  await tick(page, "Centroid and principal axes");
  await keep(page, "with");
  await compare(page, "without", "with", "marked");
  const scale = await unitsAPixel(page);
  const axis = middle(await extent(page, "without", "a > 250"));
  const turned = ([x, y], angle) => [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
  const pixel = ([x, y]) => {
    const [u, v] = turned([x, y], 135 * DEGREE);
    return [axis[0] + u / scale, axis[1] - v / scale];
  };
  // quarters of black and white meet there
  const around = async ([x, y]) => page.evaluate(([x, y]) => [[4, 4], [-4, 4], [-4, -4], [4, -4]].map(([u, v]) =>
    window.kept.with[4 * (Math.round(y + v) * document.querySelector("canvas").width + Math.round(x + u))]), [x, y]);
  const quarters = await around(pixel([8, -3]));
  assert.deepEqual(quarters.map((value) => (value > 200 ? "white" : value < 50 ? "black" : value)), ["black", "white", "black", "white"]);
  // radii 4, 8 and √75: tails of the axes, away from the labels at their heads
  const orange = (spot) => page.evaluate(([x, y]) => {
    const { width } = document.querySelector("canvas");
    for (let v = -2; v <= 2; v++) for (let u = -2; u <= 2; u++) {
      const i = 4 * (Math.round(y + v) * width + Math.round(x + u));
      const [r, g, b] = window.kept.with.slice(i, i + 3);
      if (r > 170 && g < 90 && b < 50) return true;
    }
    return false;
  }, pixel(spot));
  const along = (angle, length) => [8 - length * Math.cos(angle), -3 - length * Math.sin(angle)];
  for (const [angle, radius] of [[20 * DEGREE, 4], [110 * DEGREE, 8]]) {
    assert.equal(await orange(along(angle, 0.95 * radius)), true, `${radius}`);
    assert.equal(await orange(along(angle, 1.25 * radius)), false, `${radius}`);
  }
  await page.getByLabel("Lengths of the principal axes").selectOption("moments");
  await keep(page, "with");
  // 128 of 150 of half of the radius of the scene
  const radius = Math.hypot(25, 25, 3);
  const extents = await page.evaluate(() => view.stage.radius);
  assert.ok(Math.abs(extents / radius - 1) < 0.03, `${extents}`);
  assert.equal(await orange(along(110 * DEGREE, 0.95 * (128 / 150) * 0.5 * extents)), true);
  assert.equal(await orange(along(110 * DEGREE, 1.1 * (128 / 150) * 0.5 * extents)), false);
  await page.evaluate(() => view.setOld(true, false)); // values of another design: offered, not drawn
  await keep(page, "with");
  assert.equal(await orange(along(110 * DEGREE, 0.95 * (128 / 150) * 0.5 * extents)), false);
  assert.equal(await page.getByLabel("Centroid and principal axes").isVisible(), true);
  await page.evaluate(() => view.setOld(false, true));
  await keep(page, "with");
  assert.equal(await orange(along(110 * DEGREE, 0.95 * (128 / 150) * 0.5 * extents)), true);
  await page.close();
});

test("values of a pair go to the members of their names", async () => {
  const page = await opened(PAIR);
  const spread = (x) => ({ properties: { length_unit: "mm", mass_unit: "kg", mass: 1, centroid: [x, 0, 10],
    principal_axes: axesAt(0), principal_moments: [4, 4, 4] } });
  await from(page, "z");
  await tick(page, "Axes of the parts", false);
  await page.evaluate((document) => view.setValues({ document }), { gear: spread(20), pinion: spread(5), pair: { sizes: {} } });
  await tick(page, "Centroid and principal axes");
  await keep(page, "with");
  const scale = await unitsAPixel(page);
  await tick(page, "Show gear", false);
  await keep(page, "pinion");
  await compare(page, "with", "pinion", "gear");
  const white = "r > 250 && g > 250 && b > 250 && a === 255";
  const [pinion, both] = [await extent(page, "pinion", white), await extent(page, "with", white)];
  // 84 apart, the gear turned by 180°: 84 - 20 - 5
  const right = both.right - (pinion.right - pinion.left) / 2;
  assert.ok(pinion.number > 50 && both.number > pinion.number);
  const apart = (right - middle(pinion)[0]) * scale;
  assert.ok(Math.abs(apart - 59) < 12 * scale + 20, `${apart}`);
  await page.close();
});

test("what turns has an axis, what only slides has none", async () => {
  const page = await opened(one());
  for (const [told, drawn] of [[{}, true], [{ spin: 1 }, true], [{ slide: [0.1, 0, 0] }, false]]) {
    await show(page, { ...one(told), turns: 90 });
    await from(page, "y");
    await keep(page, "with");
    await tick(page, "Axes of the parts", false);
    await keep(page, "without");
    await compare(page, "with", "without", "axis");
    const box = await extent(page, "axis", "a > 0");
    if (drawn) {
      // the wheel's width, and at either end 0.12 of the radius of the scene, upright through its middle
      const high = 6 + 0.24 * (await page.evaluate(() => view.stage.radius));
      assert.ok(Math.abs((box.bottom - box.top) * (await unitsAPixel(page)) / high - 1) < 0.03);
      assert.ok(box.right - box.left <= 4);
      assert.ok(Math.abs(middle(box)[0] - middle(await extent(page, "without", "a > 250"))[0]) < 1.5);
    } else assert.equal(box.number, 0);
    await tick(page, "Axes of the parts");
  }
  await page.close();
});

test("reference surfaces are drawn on request, by kind, as large as they are", async () => {
  const page = await opened(one());
  await tick(page, "Axes of the parts", false);
  assert.equal(await page.getByLabel("Show pitch surfaces").count(), 0);
  await from(page, "z");
  const surfaces = [
    { name: "pitch cone", kind: "pitch", form: "cone", half_angle: 60, apex: -1, least: 2, most: 12 },
    { name: "tip cylinder", kind: "tip", form: "cylinder", radius: 24, least: 0, most: 6 },
    { name: "plane", kind: "face", form: "plane", point: [4, 0, 8], normal: [0, 0, 1], sides: [10, 30] },
  ];
  await page.evaluate((surfaces) => view.setOverlays({ bodies: [{ name: "cog", surfaces }], lines: [] }), surfaces);
  await keep(page, "none");
  const scale = await unitsAPixel(page);
  const wanted = {
    pitch: [26 * Math.tan(60 * DEGREE), 26 * Math.tan(60 * DEGREE)], tip: [48, 48], face: [10, 30],
  };
  for (const [kind, [width, height]] of Object.entries(wanted)) {
    await tick(page, `Show ${kind} surfaces`);
    await keep(page, "some");
    await compare(page, "none", "some", "surface");
    const box = await extent(page, "surface", "a > 0");
    assert.ok(Math.abs((box.right - box.left) * scale - width) < 4 * scale, `${kind}: ${(box.right - box.left) * scale}`);
    assert.ok(Math.abs((box.bottom - box.top) * scale - height) < 4 * scale, `${kind}: ${(box.bottom - box.top) * scale}`);
    await tick(page, `Show ${kind} surfaces`, false);
  }
  await page.evaluate(() => view.setOverlays(null));
  assert.equal(await page.getByLabel("Show pitch surfaces").count(), 0);
  await page.close();
});

const RED = "r > 180 && g < 60 && b < 70";

test("lines of contact are those of the turn next to now, pitch by pitch", async () => {
  const page = await opened(PAIR);
  await from(page, "y");
  const steps = [8, 16, 4].map((high) => [[[24, 0, 2], [24, 0, 2 + high]]]);
  await page.evaluate((steps) => view.setOverlays({ bodies: [], lines: [{ name: "lines of contact", pitch: 22.5, steps }] }), steps);
  await keep(page, "none");
  assert.equal((await extent(page, "none", RED)).number, 0);
  await tick(page, "Lines of contact");
  const scale = await unitsAPixel(page);
  for (const [turn, high] of [[0, 8], [7.5, 16], [-7.5, 4], [3, 8], [20, 8], [45 + 15, 4], [-45 - 15, 16]]) {
    await slide(page, "Turn of the pinion", turn);
    await keep(page, "drawn");
    const box = await extent(page, "drawn", RED);
    assert.ok(Math.abs((box.bottom - box.top) * scale - high) < 4 * scale, `${turn}: ${(box.bottom - box.top) * scale}`);
  }
  for (const old of [true, false]) {
    await page.evaluate((old) => view.setOld(false, old), old);
    await keep(page, "drawn");
    assert.equal((await extent(page, "drawn", RED)).number === 0, old);
    assert.equal(await page.getByLabel("Lines of contact").isVisible(), true);
  }
  await page.close();
});

test("other values keep the camera and need no topology; another size or element is fitted", async () => {
  const page = await opened(one());
  await from(page, "z");
  await keep(page, "first");
  const scale = await unitsAPixel(page);
  const area = await count(page, "first", ANY);
  const have = await page.evaluate(() => known.held());
  assert.equal(have.length, 3);
  const wider = { ...WHEEL, root: 22, tip: 29 };
  await show(page, { ...one({}, wider), have });
  await keep(page, "wider");
  assert.equal(await unitsAPixel(page), scale);
  assert.ok(Math.abs((await count(page, "wider", ANY)) / area - areaOf(wider) / areaOf(WHEEL)) < 0.02);
  // more teeth: another topology, the same view
  const more = { ...wider, teeth: 12 };
  await show(page, one({}, more, "m"));
  await keep(page, "more");
  assert.equal(await unitsAPixel(page), scale);
  assert.ok(Math.abs((await count(page, "more", ANY)) / area - areaOf(more) / areaOf(WHEEL)) < 0.02);
  const large = { ...WHEEL, root: 60, tip: 75, width: 18 };
  await show(page, one({}, large));
  await keep(page, "large");
  assert.ok(Math.abs((await unitsAPixel(page)) / scale - 3) < 0.1, `${(await unitsAPixel(page)) / scale}`);
  assert.ok(Math.abs((await count(page, "large", ANY)) / area - 1) < 0.02); // from where it was looked at
  await show(page, { ...one({}, { ...large, tip: 76 }), title: "spur gear: one" });
  await keep(page, "other");
  assert.ok((await difference(page, "large", "other")) > 0.1); // from where that element is first seen
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("what grows out of the view is fitted again, until somebody has chosen a view", async () => {
  const page = await opened(one());
  await from(page, "z");
  const scale = await unitsAPixel(page);
  const wide = one({}, { ...WHEEL, root: 29, tip: 36 }, "wide");
  await show(page, wide);
  await keep(page, "wide");
  const fitted = await unitsAPixel(page);
  assert.ok(fitted / scale > 1.2, `${fitted / scale}`);
  const { left, right, top, bottom } = await extent(page, "wide", "a > 250");
  const [width, height] = await page.evaluate(() => [document.querySelector("canvas").width, document.querySelector("canvas").height]);
  assert.ok(left > 0 && right < width - 1 && top > 0 && bottom < height - 1, JSON.stringify({ left, right, top, bottom }));
  await show(page, one());
  assert.equal(await unitsAPixel(page), fitted);
  await from(page, "z");
  await page.locator("canvas").press("+");
  await keep(page, "chosen");
  const chosen = await unitsAPixel(page);
  await show(page, wide);
  assert.equal(await unitsAPixel(page), chosen);
  await page.close();
});

test("from one part to a pair and back", async () => {
  const page = await opened(one());
  assert.equal(await page.getByRole("button", { name: "Run" }).isVisible(), false);
  await show(page, PAIR);
  assert.equal(await page.getByLabel("Show gear").isVisible(), true);
  assert.equal(await page.getByRole("button", { name: "Run" }).isVisible(), true);
  await tick(page, "Show pinion", false);
  await keep(page, "gear");
  assert.equal(await count(page, "gear", BRASS), 0);
  await show(page, one());
  await keep(page, "one");
  assert.ok((await count(page, "one", BRASS)) > 10000);
  assert.equal(await page.getByLabel("Show gear").count(), 0);
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("what is transparent lets through what lies behind", async () => {
  const page = await opened(one());
  await keep(page, "whole");
  await slide(page, "Transparency", 60);
  await keep(page, "glass");
  const [whole, glass] = [await extent(page, "whole", "a > 250"), await extent(page, "glass", "a > 60 && a < 250")];
  assert.ok(glass.number > 0.8 * whole.number, `${glass.number} ${whole.number}`);
  await slide(page, "Transparency", 0);
  await keep(page, "again");
  assert.ok((await difference(page, "whole", "again")) < 1e-3);
  await page.close();
});

test("keys turn, shift, zoom and run, and 0 shows all again", async () => {
  const page = await opened(PAIR);
  await page.locator("canvas").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "y"]) {
    await page.keyboard.press("0");
    await keep(page, "before");
    await page.keyboard.press(key);
    await keep(page, "after");
    assert.ok((await difference(page, "before", "after")) > 1e-2, key);
  }
  await page.keyboard.press("Space");
  await page.waitForFunction(() => document.querySelector(".mv-foot input").valueAsNumber > 1);
  await page.keyboard.press("Space");
  assert.equal(await page.getByRole("button", { name: "Run" }).isVisible(), true);
  await page.getByText("View", { exact: true }).focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.getByLabel("Sharp edges").isVisible(), false);
  await page.close();
});

test("a finger turns, two zoom", async () => {
  const page = await opened(PAIR);
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await keep(page, "untouched");
  await touch("touchStart", [300, 300]);
  for (const x of [340, 400, 440]) await touch("touchMove", [x, 330]);
  await touch("touchEnd");
  await keep(page, "touched");
  assert.ok((await difference(page, "untouched", "touched")) > 2e-2);
  const scale = await unitsAPixel(page);
  await touch("touchStart", [300, 300], [340, 300]);
  for (const x of [360, 400, 440]) await touch("touchMove", [300, 300], [x, 300]);
  await touch("touchEnd");
  await settled(page);
  assert.ok((await unitsAPixel(page)) < 0.7 * scale);
  await page.close();
});

test("on 360 pixels all is there under View, large enough for a finger, and nothing stands out", async () => {
  const page = await opened(null, { prepare: (page) => page.setViewportSize({ width: 360, height: 400 }) });
  await show(page, PAIR);
  await settled(page);
  assert.equal(await page.getByLabel("Sharp edges").isVisible(), false);
  await keep(page, "narrow");
  const box = await extent(page, "narrow", "a > 250");
  assert.ok(box.left >= 8 && box.right <= 352 && box.right - box.left > 280, JSON.stringify(box));
  await page.getByText("View", { exact: true }).click();
  await page.getByLabel("Section plane", { exact: true }).selectOption("x");
  const out = await page.$$eval(".model-view :is(button, select, input, summary, label)", (all) =>
    all.filter((each) => each.checkVisibility()).map((each) => ({ text: each.outerHTML.slice(0, 80), ...each.getBoundingClientRect().toJSON() }))
      .filter(({ left, right, height, width, text }) => left < 0 || right > 360 || (!text.includes("checkbox") || text.startsWith("<label")) && (height < 24 || width < 24)));
  assert.deepEqual(out, []);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 360));
  await page.close();
});

test("everything to operate has a name, and the picture says what it is", async () => {
  const page = await opened(PAIR, { options: { label: "B" } });
  assert.match(await page.getByRole("img").getAttribute("aria-label"), /^B: spur pair: 16\/40 teeth.*Arrow keys turn/);
  const nameless = await page.$$eval("button, select, input", (all) => all.filter((each) => !each.ariaLabel).length);
  assert.equal(nameless, 0);
  await page.close();
});

test("the view is dark or light as it is told", async () => {
  const page = await opened(PAIR);
  const ink = () => page.locator(".model-view").evaluate((view) => parseInt(getComputedStyle(view).color.split("(")[1]));
  assert.ok((await ink()) < 60);
  await page.evaluate(() => view.setTheme("dark"));
  assert.ok((await ink()) > 200);
  await page.close();
});

test("a lost graphics card is told, and the view comes back with it", async () => {
  const page = await opened(PAIR, { options: { drawnBy: "hardware" } });
  await keep(page, "before");
  await page.evaluate(() => {
    window.loss = document.querySelector("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
    loss.loseContext();
  });
  await page.waitForSelector(".model-view[data-lost]");
  assert.match(await page.locator(".mv-notice").innerText(), /^The graphics card was lost/);
  await show(page, PAIR);
  await page.evaluate(() => loss.restoreContext());
  await page.waitForSelector(".model-view:not([data-lost])");
  await keep(page, "after");
  assert.ok((await difference(page, "before", "after")) < 2e-3);
  assert.equal(await page.locator(".mv-notice").isVisible(), false);
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("without WebGL it says so, and nothing breaks", async () => {
  const plain = await launched({}, ["--disable-3d-apis"]);
  const page = await opened(PAIR, { within: plain });
  assert.match(await page.getByRole("alert").innerText(), /draws nothing in three dimensions/);
  await page.evaluate(() => {
    view.setValues(null);
    view.setOverlays(null);
    view.setUnit("in");
    view.setTheme("dark");
    view.dispose();
  });
  assert.equal(await page.locator(".model-view").count(), 0);
  assert.deepEqual(page.errors, []);
  await plain.close();
});

test("a view that is closed leaves nothing behind", async () => {
  const page = await opened(PAIR);
  await page.getByRole("button", { name: "Run" }).click();
  await page.evaluate(() => view.dispose());
  await settled(page);
  assert.equal(await page.locator(".model-view, canvas").count(), 0);
  assert.deepEqual(page.errors, []);
  await page.close();
});
