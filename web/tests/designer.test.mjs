// The designer page with its own server, driven as a person would: what it shows is what the command line says.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launched } from "./browser.mjs";
import { command, PYTHON, python, started } from "./serving.mjs";

const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const SHOTS = process.env.SHOTS ?? mkdtempSync(join(tmpdir(), "gearwright-shots-"));
let browser, server;
const requested = new Set();

before(async () => {
  mkdirSync(SHOTS, { recursive: true });
  server = await started();
  browser = await launched({ viewport: { width: 1400, height: 860 }, acceptDownloads: true });
  browser.on("request", (request) => requested.add(new URL(request.url()).origin));
});
after(async () => {
  await browser?.close();
  await server?.end();
});

async function opened(t, hash = "", within = browser) {
  const page = await within.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  t.after(async () => {
    await page.evaluate(() => localStorage.clear()).catch(() => {});
    await page.close();
    assert.deepEqual(errors, []);
  });
  await page.goto(server.address + hash);
  await shown(page);
  return page;
}

// Until the answer is whole: values of the design in the address and nothing under way.
const shown = (page) =>
  page.waitForFunction(() => {
    const pane = document.querySelector(".pane");
    return document.querySelector("html[data-ready]") && pane?.getAttribute("aria-busy") === "false" && document.querySelector(".strip").textContent;
  }, null, { timeout: 60_000 });

const input = (page, name, at = 0) => page.locator(`[data-parameter="${name}"] input[type="text"]`).nth(at);
const tab = (page, name) => page.locator(`[data-tab="${name}"]`).click();

// The exact volumes of the members, to the last digit.
const volumes = (page) =>
  page.locator('table.mass tr:has(th:text-is("Volume")) td:nth-of-type(1)').evaluateAll((cells) => cells.map((cell) => Number.parseFloat(cell.title)));

const until = async (page, wanted) => {
  for (let i = 0; ; i++) {
    const found = await volumes(page);
    if (found.length === wanted.length && found.every((one, k) => Math.abs(one / wanted[k] - 1) < 1e-12)) return;
    assert.ok(i < 200, `volumes are ${found}, not ${wanted}`);
    await page.waitForTimeout(100);
  }
};

test("teeth typed by keyboard give the command line's volume and mass", async (t) => {
  const page = await opened(t);
  await input(page, "teeth", 1).focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("43");
  const told = command("spur", "--teeth", "17", "43", "--module", "2", "--face-width", "16", "--bore", "8", "16");
  await until(page, [told.pinion.properties.volume, told.gear.properties.volume]);
  assert.match(await page.evaluate(() => location.hash), /teeth=17,43/);
});

test("a refusal stands at its field in the server's words, and is got over", async (t) => {
  const page = await opened(t, "#bevel?teeth=16,20&module=4&face_width=20");
  const width = input(page, "face_width");
  await width.fill("90");
  const problem = page.locator('[data-parameter="face_width"] .problem');
  await problem.waitFor();
  assert.match(await problem.textContent(), /more than the cone distance, 51\.2\d* mm/);
  assert.equal(await width.getAttribute("aria-invalid"), "true");
  assert.ok(await page.getByText("the last design that can be built").isVisible());
  await width.fill("18");
  await problem.waitFor({ state: "detached" }).catch(() => problem.waitFor({ state: "hidden" }));
  assert.notEqual(await width.getAttribute("aria-invalid"), "true");
  const told = command("bevel", "--teeth", "16", "20", "--module", "4", "--face-width", "18");
  await until(page, [told.pinion.properties.volume, told.gear.properties.volume]);
});

test("a pair turns in mesh", async (t) => {
  const page = await opened(t, "#spur?teeth=16,40&module=3&face_width=20");
  const before = await page.locator("canvas").first().screenshot();
  await page.getByLabel(/Turn of the pinion/).first().evaluate((slider) => {
    slider.value = "9";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await page.waitForTimeout(500);
  assert.notDeepEqual(await page.locator("canvas").first().screenshot(), before);
});

test("a link reopens the design, and undo takes back", async (t) => {
  const page = await opened(t, "#helical?teeth=19,41&module=2&face_width=16&helix_angle=22");
  const hash = await page.evaluate(() => location.hash);
  await input(page, "helix_angle").fill("15");
  await input(page, "helix_angle").blur();
  await page.waitForTimeout(900);
  await shown(page);
  assert.match(await page.evaluate(() => location.hash), /helix_angle=15/);
  await page.locator("canvas").first().focus();
  await page.keyboard.press("Control+Z");
  await page.waitForFunction((hash) => location.hash === hash, hash);
  assert.equal(await input(page, "helix_angle").inputValue(), "22");
  await page.keyboard.press("Control+Shift+Z");
  await page.waitForFunction(() => location.hash.includes("helix_angle=15"));
  await page.reload();
  await shown(page);
  assert.equal(await input(page, "helix_angle").inputValue(), "15");
});

test("a lost worker is replaced, and the page says so", async (t) => {
  const page = await opened(t, "#spur?teeth=24&module=2&face_width=16");
  const children = () => execFileSync("ps", ["-o", "pid=,ppid=", "-e"], { encoding: "utf8" }).trim().split("\n").map((line) => line.trim().split(/\s+/).map(Number));
  const workers = () => {
    const all = children();
    const below = new Set([server.pid]);
    for (let grew = true; grew; ) {
      grew = false;
      for (const [pid, parent] of all) if (below.has(parent) && !below.has(pid)) grew = Boolean(below.add(pid));
    }
    below.delete(server.pid);
    return [...below];
  };
  assert.ok(workers().length >= 3);
  // a cam whose profile is searched for takes its time: killed in the middle of it
  const design = "#cam?programme=dwell 36, rise 72, dwell 144, return 108&swing=30&pivot_distance=20&thickness=40&minimise=area";
  await page.evaluate((hash) => (location.hash = hash), encodeURI(design));
  const note = page.getByText("A worker was lost and has been replaced.").first();
  for (let i = 0; i < 40 && !(await note.count()); i++) {
    const health = await (await fetch(`${server.address}api/health`)).json();
    if (health.workers.quick.busy) {
      const busiest = workers().map((pid) => [pid, Number(readFileSync(`/proc/${pid}/stat`, "utf8").split(" ")[13])]).sort((a, b) => b[1] - a[1]);
      for (const [pid] of busiest.slice(0, 2)) {
        try {
          if (readFileSync(`/proc/${pid}/stat`, "utf8").split(" ")[2] === "R") process.kill(pid, "SIGKILL");
        } catch { /* it has ended */ }
      }
    }
    await page.waitForTimeout(100);
  }
  await note.waitFor({ timeout: 10_000 });
  await page.evaluate(() => (location.hash = "#spur?teeth=25&module=2&face_width=16"));
  const told = command("spur", "--teeth", "25", "--module", "2", "--face-width", "16");
  await until(page, [told.properties.volume]);
});

test("files of each format come and are read by their readers", { timeout: 240_000 }, async (t) => {
  const page = await opened(t, "#spur?teeth=16,24&module=3&face_width=12&~material=steel");
  await tab(page, "files");
  const form = page.locator("form.making");
  const offered = await form.locator("select").first().locator("option").evaluateAll((all) => all.map((one) => one.value));
  assert.ok(offered.length >= 18);
  const folder = mkdtempSync(join(tmpdir(), "gearwright-files-"));
  const names = {};
  for (const value of offered) {
    await form.locator("select").first().selectOption(value);
    const [download] = await Promise.all([page.waitForEvent("download", { timeout: 60_000 }), form.locator("button.go").click()]);
    names[value] = join(folder, `${value.replace(/\W+/g, "-")}-${download.suggestedFilename()}`);
    await download.saveAs(names[value]);
  }
  const volume = command("spur", "--teeth", "16", "24", "--module", "3", "--face-width", "12");
  const exact = volume.pinion.properties.volume + volume.gear.properties.volume;
  const read = python(READERS, JSON.stringify(names));
  for (const value of offered) {
    const [what, suffix] = value.split(" ");
    const found = read[value];
    if (what === "body" && found.volume) {
      const scale = found.volume / exact;
      assert.ok(Math.abs(scale - 1) < ([".step", ".stp"].includes(suffix) ? 1e-6 : 3e-3), `${value}: ${scale}`);
    } else assert.ok(found.sound, `${value}: ${JSON.stringify(found)}`);
  }
});

const READERS = `
import io, json, sys, zipfile
from pathlib import Path
from xml.etree import ElementTree
import gearwright as gw
found = {}
for value, name in json.loads(sys.argv[1]).items():
    what, suffix = value.split()
    path = Path(name)
    if zipfile.is_zipfile(path) and suffix != ".3mf":
        with zipfile.ZipFile(path) as files:
            models = [one for one in files.namelist() if one.endswith(suffix)]
            roots = [ElementTree.fromstring(files.read(one)) for one in models]
            meshes = [one for one in files.namelist() if one.lower().endswith((".stl", ".obj"))]
            found[value] = {"sound": len(roots) == 1 and len(meshes) == 2}
    elif what == "body" and suffix in (".urdf", ".sdf", ".mjcf", ".xml"):
        found[value] = {"sound": len(list(ElementTree.parse(path).iter("inertial"))) == 2}
    elif what == "body":
        model = gw.Model.load(path)
        smooth = model.smooth
        scale = {"m": 1e9, "mm": 1.0, None: 1.0}[model.length_unit]
        volumes = [one.volume for one in smooth.values()] or [one.properties().volume for one in model.bodies.values()]
        found[value] = {"volume": sum(volumes) * scale}
    elif suffix == ".dxf":
        import ezdxf
        found[value] = {"sound": len(ezdxf.readfile(path).modelspace()) > 4}
    elif suffix == ".svg":
        found[value] = {"sound": ElementTree.parse(path).getroot().tag.endswith("svg")}
    elif suffix == ".pdf":
        found[value] = {"sound": path.read_bytes().startswith(b"%PDF-") and b"%%EOF" in path.read_bytes()[-32:]}
    else:
        import tomllib
        found[value] = {"sound": tomllib.loads(path.read_text())["teeth"] == [16, 24]}
print(json.dumps(found))
`;

test("each element of the catalog is shown without a serious problem of access", { timeout: 300_000 }, async (t) => {
  const kinds = (await (await fetch(`${server.address}api/elements`)).json()).kinds;
  const page = await opened(t);
  for (const kind of kinds) {
    await page.getByLabel("Element").selectOption({ label: kind.name.charAt(0).toUpperCase() + kind.name.slice(1) });
    await page.waitForTimeout(200);
    await shown(page);
    await page.screenshot({ path: join(SHOTS, `${kind.name.replaceAll(" ", "-")}.png`) });
  }
  await audited(page, "desktop");
  for (const name of ["mass", "plots", "files"]) {
    await tab(page, name);
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(SHOTS, `tab-${name}.png`) });
    await audited(page, name);
  }
});

async function audited(page, where) {
  await page.evaluate(readFileSync(AXE, "utf8")); // the page's policy lets no script element in
  const { violations } = await page.evaluate(() => window.axe.run());
  const serious = violations.filter((one) => ["serious", "critical"].includes(one.impact));
  assert.deepEqual(serious.map((one) => `${where}: ${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
}

test("a telephone's width, dark, shows everything", async (t) => {
  const phone = await launched({ viewport: { width: 360, height: 740 }, hasTouch: true, colorScheme: "dark" });
  t.after(() => phone.close());
  const page = await opened(t, "#bevel?teeth=16,24&module=4&face_width=20&trace=logarithmic&spiral_angle=35&~material=steel", phone);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
  await page.screenshot({ path: join(SHOTS, "telephone.png"), fullPage: true });
  await audited(page, "telephone, dark");
  await input(page, "face_width").fill("15");
  const told = command("bevel", "--teeth", "16", "24", "--module", "4", "--face-width", "15", "--trace", "logarithmic", "--spiral-angle", "35");
  await tab(page, "mass");
  await until(page, [told.pinion.properties.volume, told.gear.properties.volume]);
});

test("no request leaves this machine", () => {
  assert.deepEqual([...requested].filter((origin) => origin !== "null" && origin !== new URL(server.address).origin), []);
});
