// Numbers of tables and charts, by formulas and by hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import { moduleOf } from "./page_modules.mjs";

const { inertiaAbout, clean, norm } = await moduleOf("inertia");
const { shownSize, toldSize } = await moduleOf("size_rows");
const { whole, equalled, zoomed, moved } = await moduleOf("charts/domain");
const { valueAt, readable, readingAt } = await moduleOf("charts/reading");
const { strokes, LIGHT } = await moduleOf("charts/strokes");
const near = (a, b, tolerance = 1e-12) => assert.ok(Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(b)), `${a} is not ${b}`);

const chart = (more = {}) => ({
  title: "a chart", x: { label: "angle", unit: "°" }, y: { label: "lift", unit: "mm" }, equal: false, log: "none", notes: [], window: null,
  lines: [{ name: "s", x: [0, 90, 180, 270], y: [0, 10, 10, 0], style: "solid" }], ...more,
});

test("inertia about a point is the sum over the masses about that point", () => {
  const masses = [[2, [1, 0, 3]], [5, [-2, 4, 1]], [1.5, [0, -1, -2]], [3, [2, 2, 2]]];
  const about = (point) => [0, 1, 2].map((i) => [0, 1, 2].map((j) => masses.reduce((sum, [m, r]) => {
    const d = r.map((x, k) => x - point[k]);
    return sum + m * ((i === j ? d[0] ** 2 + d[1] ** 2 + d[2] ** 2 : 0) - d[i] * d[j]);
  }, 0)));
  const mass = masses.reduce((sum, [m]) => sum + m, 0);
  const centroid = [0, 1, 2].map((i) => masses.reduce((sum, [m, r]) => sum + m * r[i], 0) / mass);
  const body = { mass, centroid, central_inertia: about(centroid) };
  for (const [asked, point] of [[null, [0, 0, 0]], ["origin", [0, 0, 0]], ["centroid", centroid], [[7, -3, 0.5], [7, -3, 0.5]]]) {
    const expected = about(point);
    inertiaAbout(body, asked).forEach((row, i) => row.forEach((value, j) => near(value, expected[i][j])));
  }
});

test("what is rounding of the largest value is nought", () => {
  assert.equal(clean(1e-13, 100), 0);
  assert.equal(clean(1e-11, 100), 1e-11);
  near(norm([[3, 0, 0], [0, 4, 0], [0, 0, 12]]), 13);
});

test("lengths and areas go into the unit that is shown, angles and modules stay", () => {
  assert.deepEqual(shownSize({ value: 50.8, unit: "mm", symbol: "" }, "in"), { value: 2, unit: "in" });
  const area = shownSize({ value: 2, unit: "in^2", symbol: "" }, "mm");
  near(area.value, 1290.32);
  assert.equal(area.unit, "mm²");
  assert.deepEqual(shownSize({ value: 20, unit: "deg", symbol: "" }, "in"), { value: 20, unit: "°" });
  assert.deepEqual(shownSize({ value: 3, unit: "mm", symbol: "" }, "in", true), { value: 3, unit: "mm" });
  assert.deepEqual(shownSize({ value: 8, unit: "1/in", symbol: "" }, "mm"), { value: 8, unit: "1/in" });
});

test("sizes are told to a micrometre, or to four digits", () => {
  assert.equal(toldSize({ value: 48.0004, unit: "mm" }), "48.000");
  assert.equal(toldSize({ value: 123.45678, unit: "mm" }), "123.457");
  assert.equal(toldSize({ value: 0.012345, unit: "mm" }), "0.01235");
  assert.equal(toldSize({ value: 1.89, unit: "in" }), "1.8900");
  assert.equal(toldSize({ value: 17, unit: "" }), "17");
  assert.equal(toldSize({ value: -1.33964, unit: "" }), "−1.3396");
  assert.equal(toldSize({ value: 0, unit: "mm" }), "0");
  assert.equal(toldSize({ value: null, unit: "mm" }), "–");
});

test("all of a chart is what its shown lines reach, gaps left out", () => {
  const data = chart({ lines: [
    { name: "a", x: [0, null, 4], y: [1, null, 3], style: "solid" }, { name: "b", x: [-9, 9], y: [0, 50], style: "solid" },
  ] });
  assert.deepEqual(whole(data, new Set(["b"])), { x: [0, 4], y: [0.9, 3.1] });
  assert.deepEqual(whole(data, new Set()).x, [-9, 9]);
  const level = whole(chart({ lines: [{ name: "a", x: [0, 1], y: [0, 0], style: "solid" }] }), new Set());
  assert.ok(level.y[0] < 0 && level.y[1] > 0);
});

test("drawings have one scale on both axes and lose nothing", () => {
  const found = equalled({ x: [0, 10], y: [0, 2] }, 200, 100);
  near((found.x[1] - found.x[0]) / 200, (found.y[1] - found.y[0]) / 100);
  assert.deepEqual(found, { x: [0, 10], y: [-1.5, 3.5] });
});

test("enlarging keeps the place it is about, moving goes by shares; logarithms on logarithmic axes", () => {
  const start = { x: [0, 8], y: [2, 4] };
  assert.deepEqual(zoomed(start, 0.5, [0.25, 1], false), { x: [1, 5], y: [3, 4] });
  assert.deepEqual(moved(start, [0.5, -1], false), { x: [4, 12], y: [0, 2] });
  const logs = zoomed({ x: [1, 1e4], y: [1, 1e4] }, 0.5, [0.5, 0.5], true);
  near(logs.x[0], 10);
  near(logs.x[1], 1000);
  near(moved({ x: [1, 100], y: [1, 100] }, [0.5, 0], true).x[1], 1000);
});

test("curves are read between their points, in logarithms where the axes have them, and not in gaps", () => {
  const [line] = chart().lines;
  assert.equal(valueAt(line, 45, false), 5);
  assert.equal(valueAt(line, 180, false), 10);
  assert.equal(valueAt(line, 271, false), null);
  near(valueAt({ name: "e", x: [1, 100], y: [1, 1e4], style: "solid" }, 10, true), 100);
  assert.equal(valueAt({ name: "g", x: [0, null, 2], y: [0, null, 2], style: "solid" }, 1, false), null);
  assert.deepEqual(readable(chart()), [0, 90, 180, 270]);
  assert.deepEqual(readable(chart({ equal: true })), []);
  assert.equal(readingAt(chart(), new Set(), 90), "angle 90.000\u2009°; s 10.000\u2009mm");
  assert.equal(readingAt(chart(), new Set(["s"]), 90), "angle 90.000\u2009°");
});

test("a member's circles have its colour, and pitch circles are chain lines", () => {
  const line = (name, style = "dashed") => ({ name, x: [0], y: [0], style });
  const data = chart({ equal: true, lines: [
    line("pinion", "solid"), line("pitch circle d, pinion"), line("base circle d_b, pinion"), line("gear", "solid"), line("pitch circle d, gear"),
  ] });
  const [pinion, pitch, base, gear, other] = strokes(data, LIGHT);
  assert.equal(pitch.colour, pinion.colour);
  assert.equal(other.colour, gear.colour);
  assert.notEqual(pinion.colour, gear.colour);
  assert.notEqual(pitch.dash, base.dash);
  assert.equal(other.dash, pitch.dash);
  assert.equal(pinion.dash, "");
});
