// Chromium without a display, drawing in software, and nothing of it asking for anything.
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const FLAGS = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
];

// A browser with a profile of its own, new and empty. extra: more flags
export function launched(options = {}, extra = []) {
  const profile = mkdtempSync(join(tmpdir(), "gearwright-browser-"));
  return chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: [...FLAGS, ...extra],
    viewport: { width: 1000, height: 620 },
    ...options,
  });
}
