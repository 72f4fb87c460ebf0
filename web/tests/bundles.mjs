// Modules of web/src built for a test, into a folder of their own.
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build } from "vite";

// A folder with NAME.js (and NAME.css): the module as a script whose exports are in the global NAME, or to be imported.
export async function bundled(name, source, format = "iife") {
  const folder = mkdtempSync(join(tmpdir(), "gearwright-bundle-"));
  await build({
    configFile: false, logLevel: "error", publicDir: false, root: join(import.meta.dirname, ".."),
    build: {
      outDir: folder, emptyOutDir: false, target: "es2022", minify: false,
      lib: { entry: source, formats: [format], name, fileName: () => `${name}.js`, cssFileName: name },
    },
  });
  return folder;
}
