// What the page computes: typed quantities, states in the address, what is undone, designs of forms.
import assert from "node:assert/strict";
import { test } from "node:test";
import { ELEMENTS } from "./designer_server.mjs";
import { moduleOf } from "./page_modules.mjs";

const { quantity, shown } = await moduleOf("form/quantity");
const { faultOf, hashOf, stateOf, plain } = await moduleOf("hash");
const { History } = await moduleOf("history");
const { aboutIn, designOf, valuesOf, inUnit } = await moduleOf("design");
const { kindOf, startOf } = await moduleOf("kinds");
const { range } = await moduleOf("form/ranges");
const { rowsOf, rowsGiven } = await moduleOf("form/points_editor");
const { holeIn } = await moduleOf("form/inside");
const { listed } = await moduleOf("form/text_editor");
const { density, lightness } = await moduleOf("weighing");
const { summary, told } = await moduleOf("amounts");
const { lines } = await moduleOf("comparison");

const kind = (name) => ELEMENTS.kinds.find((one) => one.name === name);

const TYPED = [
  ["12.7", "mm", 12.7], ["12,7", "mm", 12.7], [" 0.5 in ", "mm", 12.7], ["1/2 in", "mm", 12.7], ['1 1/2"', "mm", 38.1], ["1-1/2 inch", "in", 1.5],
  ["25.4 mm", "in", 1], ["2 cm", "mm", 20], ["50 µm", "mm", 0.05], ["5 thou", "mm", 0.127], ["−3", "mm", -3], ["-1/4 in", "mm", -6.35],
  ["1e-3", "", 0.001], [".5", "", 0.5], ["20", "deg", 20], ["20 deg", "deg", 20], ["20°30'", "deg", 20.5], ["20° 15' 36\"", "deg", 20.26],
  ["-14°30'", "deg", -14.5], ["1 rad", "deg", 180 / Math.PI], ["8", "per inch", 8], ["0.1 in", "mm", 2.54], ["1\u202f1/2 in", "in", 1.5],
  ["½ in", "mm", 12.7], ["1½ in", "in", 1.5], ["1 ¾\"", "in", 1.75], ["-¼ in", "in", -0.25], ["1' 6\"", "in", 18], ["1'6\"", "mm", 457.2], ["2 ft", "in", 24],
  ["2'", "in", 24], ["1 ft 6 1/2 in", "in", 18.5], ["1' 6½\"", "in", 18.5], ["-1' 6\"", "in", -18], ["20'", "deg", 1 / 3],
];
for (const [text, unit, value] of TYPED) {
  test(`"${text}" is ${value} ${unit}`, () => assert.equal(quantity(text, unit).value, value));
}

test("words of another parameter name it", () => {
  assert.deepEqual(quantity("DP 8", "mm", true), { value: 8, bare: false, other: "diametral_pitch" });
  assert.deepEqual(quantity("8 dp", "mm", true), { value: 8, bare: false, other: "diametral_pitch" });
  assert.deepEqual(quantity("m 2,5", "per inch", true), { value: 2.5, bare: false, other: "module" });
  assert.equal(quantity("m 2.5", "mm", true).other, undefined);
  assert.equal(quantity("DP 8", "per inch", true).value, 8);
  assert.equal(quantity("3 m", "mm").value, 3000);
});

test("what is no value says what is needed", () => {
  for (const [text, unit] of [["", "mm"], ["ten", "mm"], ["3 kg", "mm"], ["3 mm", "deg"], ["3 mm", ""], ["1,234.5", "mm"], ["1/0", "mm"], ["DP 8", "deg"], ["DP 8", "mm"], ["P 8", "in"], ["8 DP", "mm"], ["8 P", ""], ["m 2.5", "mm"], ["P", "mm"], ["1' 6\" x", "in"]]) {
    assert.ok("problem" in quantity(text, unit), text);
  }
});

test("numbers are read as they are shown", () => {
  for (const value of [0, 1, -2.5, 1e-7, 0.1 + 0.2, 123456.789, -1e21]) {
    assert.ok(Math.abs(quantity(shown(value), "").value - value) <= 1e-13 * Math.abs(value), shown(value));
  }
});

const DESIGNS = [
  { element: "spur", teeth: [16, 40], module: 3, face_width: 20 },
  { element: "spur", teeth: 24, profile_shift: -0.1, bore: [null, 12.5] },
  { element: "cam", programme: "dwell 36, rise 72, dwell 144, return 108 & more + 100%=#?", lift: 1e-7 },
  { element: "sweep", section: { polygon: [[0, 0], [20, 0], [0, 20]], holes: [] }, layer: "0", length: 30, scale: [0.5, 1] },
  { element: "sweep", layer: "1,2", section: "upload:1f/a,b \"c\".dxf", words: ["1", "2"], one: [5], none: [], flag: true, nothing: null, empty: "", brace: "{x", tilde: "~a" },
];
for (const design of DESIGNS) {
  test(`a design comes back from the address: ${design.element} ${Object.keys(design).length}`, () => {
    const state = { design, density: 7.85e3, material: "steel 1.7131", about: [1, -2, 0.5], unit: "in", tab: "mass" };
    assert.deepEqual(stateOf(hashOf(state)), state);
    assert.deepEqual(stateOf(hashOf(plain(design))), plain(design));
    assert.match(hashOf(state), /^#[\x21-\x7e]+$/); // as browsers keep it
    assert.equal(new URL(`http://a/${hashOf(state)}`).hash.replaceAll("%22", '"'), hashOf(state));
  });
}

test("an address is for people to read", () => {
  assert.equal(hashOf(plain(DESIGNS[0])), "#spur?teeth=16,40&module=3&face_width=20");
  assert.equal(hashOf({ ...plain(DESIGNS[1]), material: "steel" }), "#spur?teeth=24&profile_shift=-0.1&bore=none,12.5&~material=steel");
});

test("what is no state is none", () => {
  for (const hash of ["", "#", "#?a=1", "#spur?=1", "#spur?teeth", "#spur?a=%zz", "#spur?a=[1"]) assert.equal(stateOf(hash), null, hash);
});

test("numbers beyond range are refused in words", () => {
  for (const entry of ["module=1e400", "~density=1e400", "~about=1e400,0,0", "teeth=16,-2e309", "section={\"polygon\":[[0,1e999],[1,0],[1,1]]}"]) {
    assert.equal(stateOf(`#spur?a=1&${entry}`), null, entry);
    assert.match(faultOf(`#spur?a=1&${entry}`), /beyond all range: \d/, entry);
  }
  assert.match(faultOf("#spur?a=%zz"), /no design/);
  assert.equal(stateOf("#spur?a=1e300").design.a, 1e300);
});

test("what was undone is done again, until something else is done", () => {
  const history = new History(String, 1);
  for (const state of [1, 2, 2, 3]) history.settle(state);
  assert.deepEqual([history.undo(), history.undo(), history.undo()], [2, 1, null]);
  assert.deepEqual([history.redo(), history.undoable, history.redoable], [2, true, true]);
  history.settle(4);
  assert.deepEqual([history.redo(), history.undo(), history.undo(), history.redo()], [null, 2, 1, 2]);
});

test("a design leaves out what does not apply, and the form remembers it", () => {
  const pair = kind("spur pair");
  const values = { teeth: [16, 40], trace: "circular", cutter_radius: 60, odd: 1 };
  const with_ = designOf(pair, values);
  assert.deepEqual(with_, { element: "spur", ...values });
  const without = designOf(pair, { ...values, trace: "straight" });
  assert.deepEqual(without, { element: "spur", teeth: [16, 40], trace: "straight", odd: 1 });
  assert.deepEqual(valuesOf(pair, without, values), { teeth: [16, 40], trace: "straight", odd: 1, cutter_radius: 60 });
  assert.equal(valuesOf(pair, { element: "spur", trace: "circular" }, values).cutter_radius, undefined);
});

test("another unit of length keeps the part", () => {
  const pair = kind("spur pair");
  const inches = inUnit(pair, { teeth: [16, 40], module: 3, face_width: [25.4, null], pressure_angle: 20 }, "mm", "in");
  assert.deepEqual(inches, { teeth: [16, 40], module: 3, face_width: [1, null], pressure_angle: 20, length_unit: "in" });
  const section = { polygon: [[0, 0], [25.4, 0], [0, 50.8]], holes: [[[1.27, 1.27], [2.54, 1.27], [1.27, 2.54]]] };
  const swept = inUnit(kind("sweep"), { section, length: 30, layer: "25.4" }, "mm", "in");
  assert.deepEqual(swept.section, { polygon: [[0, 0], [1, 0], [0, 2]], holes: [[[0.05, 0.05], [0.1, 0.05], [0.05, 0.1]]] });
  const back = inUnit(kind("sweep"), swept, "in", "mm");
  assert.deepEqual(back, { section, length: 30, layer: "25.4", length_unit: "mm" });
});

test("the number of teeth chooses the kind", () => {
  assert.equal(kindOf(ELEMENTS.kinds, { element: "spur", teeth: 16 }).name, "spur gear");
  assert.equal(kindOf(ELEMENTS.kinds, { element: "spur", teeth: [16, null] }).name, "spur pair");
  assert.equal(kindOf(ELEMENTS.kinds, { element: "nothing" }), null);
});

test("a kind like the last one takes over what they share", () => {
  const design = { element: "spur", teeth: [20, 30], diametral_pitch: 8, face_width: 25, bore: 10 };
  assert.deepEqual(startOf(kind("helical pair"), kind("spur pair"), design), { element: "helical", teeth: [20, 30], face_width: 25, diametral_pitch: 8 });
  assert.deepEqual(startOf(kind("sweep"), kind("spur pair"), design), kind("sweep").start);
});

test("a body that fits the example's teeth does not come along to teeth of another size", () => {
  const single = { ...kind("spur gear"), start: { ...kind("spur gear").start, bore: 8 } };
  const from = (more) => startOf(single, kind("spur gear"), { element: "helical", teeth: 24, module: 2, face_width: 16, ...more });
  assert.deepEqual(from({}), single.start);
  assert.deepEqual(from({ module: 1 }), { element: "spur", teeth: 24, module: 1, face_width: 16 });
  assert.deepEqual(from({ face_width: 1, length_unit: "in" }), { element: "spur", teeth: 24, module: 2, face_width: 1, length_unit: "in" });
});

test("a point of reference stays where it is in another unit", () => {
  assert.deepEqual(aboutIn([127, 0, -2.54], "mm", "in"), [5, 0, -0.1]);
  assert.deepEqual(aboutIn([5, 0, -0.1], "in", "mm"), [127, 0, -2.54]);
  assert.equal(aboutIn("centroid", "mm", "in"), "centroid");
});

test("sliders stay within the limits and reach the value", () => {
  const [teeth, module, , width, angle] = kind("spur gear").parameters;
  for (const [parameter, values] of [[teeth, [3, 24, 10000]], [module, [1e-3, 3, 400]], [width, [0.1, 2e4]], [angle, [1, 20, 59]]]) {
    for (const value of [null, ...values]) {
      const { least, most, step } = range(parameter, value, 100);
      assert.ok(step > 0 && least < most, parameter.name);
      assert.ok(least > (parameter.above ?? -Infinity) && least >= (parameter.minimum ?? -Infinity), `${parameter.name} ${least}`);
      assert.ok(most < (parameter.below ?? Infinity) && most <= (parameter.maximum ?? Infinity), `${parameter.name} ${most}`);
      if (value !== null && value > step) assert.ok(value >= least - step && value <= most, `${parameter.name} ${value}: ${least} to ${most}`);
    }
  }
});

test("a new hole lies inside its outline, clear of the others", () => {
  const outline = [[0, 0], [40, 0], [40, 10], [10, 10], [10, 40], [0, 40]]; // an L, whose middle is outside
  const free = ([x, y]) => x > 0 && y > 0 && x < 40 && y < 40 && (x < 10 || y < 10);
  const holes = [];
  for (let i = 0; i < 5; i++) {
    const hole = holeIn(outline, holes);
    assert.ok(hole.every(free), JSON.stringify(hole));
    const [[x0, y0], , [x1, y1]] = hole;
    assert.ok(x1 - x0 > 0.5 && y1 - y0 > 0.5, JSON.stringify(hole));
    assert.ok(holes.every(([[a0, b0], , [a1, b1]]) => x1 < a0 || x0 > a1 || y1 < b0 || y0 > b1), JSON.stringify(hole));
    holes.push(hole);
  }
  const clockwise = holeIn([...outline].reverse(), []);
  assert.ok(clockwise.every(free));
  assert.equal(holeIn([[0, 0], [1, 0], [2, 0]], []), undefined);
});

test("points are typed with commas of either sort", () => {
  assert.deepEqual(rowsOf("0, 0\n1.5,2\n1,5 2\n\n1/2 in;-3", ["x", "y"], "mm"), [[0, 0], [1.5, 2], [1.5, 2], [12.7, -3]]);
  assert.equal(rowsOf("1 2 3", ["x", "y"], "mm"), "row 1: x, y are needed, such as 0, 10");
  assert.deepEqual(listed("1 2,5; 3, 4"), [1, 2.5, 3, 4]);
  assert.match(listed("1 x"), /x/);
});

test("what is no list of points is none", () => {
  assert.deepEqual(rowsGiven([[0, 0], [1, 0.5]], 2), [[0, 0], [1, 0.5]]);
  for (const value of [undefined, 5, "ab", { a: 1 }, [1, 2, 3], [["a", "b"], ["c", "d"]], [[0, 0], [1, 0], null], [[0, 0, 0]], [[0, Infinity]]]) {
    assert.deepEqual(rowsGiven(value, 2), [], JSON.stringify(value));
  }
  const several = { ...kind("sweep").parameters[0], forms: [{ form: "several", of: { form: "table", entries: [] }, words: "" }] };
  assert.deepEqual(inUnit({ ...kind("sweep"), parameters: [several] }, { section: [null, 2] }, "mm", "in").section, [null, 2]);
});

test("densities have units of their own", () => {
  assert.equal(density("7850"), 7850);
  assert.equal(density("7,85 g/cm³"), 7850);
  assert.ok(Math.abs(density("0.284 lb/in3") - 7861) < 1);
  assert.equal(density("0"), "must be greater than 0");
  assert.match(density("1 kg/foo"), /unit/);
  for (const [typed, value] of [["7.85 g/cc", 7850], ["7.85 kg/dm^3", 7850], ["490 lb/ft³", 7849.052], ["0.5 LB/IN3", 13839.95]]) {
    assert.ok(Math.abs(density(typed) - value) < 0.01, `${typed}: ${density(typed)}`);
  }
});

test("a number that only g/cm³ can be meant by is doubted, not changed", () => {
  assert.match(lightness("7.85"), /type 7\.85 g\/cm³/);
  assert.match(lightness("7,85"), /type 7\.85 g\/cm³/);
  for (const typed of ["7850", "7.85 g/cm³", "20 kg/m³", "", "x"]) assert.equal(lightness(typed), "", typed);
});

const part = (volume, mass_unit = "kg") => ({
  sizes: { pitch_diameter: { value: 25.4, unit: "mm", symbol: "d" }, disk_area: { value: 1290.32, unit: "mm^2", symbol: "A" }, contact_ratio: { value: 1.6, unit: "", symbol: "" } },
  properties: { length_unit: "mm", mass_unit, volume, mass: 0.32361, centroid: [0, 0, 12.7], area: 645.16, principal_moments: [1, 2, 645.16], principal_axes: [] },
});

test("results in short, in the unit that is shown", () => {
  assert.equal(summary(part(41230.4), "mm"), "Volume 41\u202f230 mm³, mass 0.324 kg");
  assert.equal(summary(part(16387.064, "mm³"), "in"), "Volume 1.000 in³");
  assert.equal(summary({ pinion: part(1), gear: part(2), pair: { sizes: {} } }, "mm"), "Pinion: volume 1.000 mm³, mass 0.324 kg; gear: volume 2.000 mm³, mass 0.324 kg");
  assert.deepEqual([told(-1234567), told(0.00001234), told(99.996), told(0)], ["−1\u202f235\u202f000", "1.234e−5", "100.0", "0"]);
});

test("a comparison has both columns in the unit that is shown", () => {
  const found = lines(part(16387.064), { ...part(32774.128), sizes: {} }, "in");
  const of = (name) => found.find((line) => line.name === name);
  assert.deepEqual(of("pitch diameter"), { part: "", name: "pitch diameter", unit: "in", a: 1, b: null });
  assert.ok(Math.abs(of("volume").a - 1) < 1e-12 && Math.abs(of("volume").b - 2) < 1e-12);
  assert.equal(of("volume").unit, "in³");
  assert.ok(Math.abs(of("disk area").a - 2) < 1e-12 && of("disk area").unit === "in²");
  assert.equal(of("contact ratio").a, 1.6);
  const modules = { sizes: { outer_module: { value: 4, unit: "mm", symbol: "m" }, module: { value: 0.1, unit: "in", symbol: "m" } }, properties: part(1).properties };
  const told_ = lines(modules, modules, "in").filter(({ name }) => name.endsWith("module"));
  assert.deepEqual(told_.map(({ a, unit }) => [Number(a.toPrecision(12)), unit]), [[4, "mm"], [2.54, "mm"]]);
  assert.ok(Math.abs(of("centroid z").a - 0.5) < 1e-12 && Math.abs(of("principal moment 3").a - 1) < 1e-12);
});
