// One script a page, each with all it needs: Python puts the script into a page that loads nothing.
import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

// What is copied must bring its licence along.
const licence = {
  name: "licence",
  generateBundle(_: unknown, bundle: Record<string, { type: string; code?: string }>) {
    const text = readFileSync("node_modules/three/LICENSE", "utf8").trim();
    for (const file of Object.values(bundle)) {
      if (file.type === "chunk") file.code = `/*! with three.js:\n${text}\n*/\n${file.code}`;
    }
  },
};

export default defineConfig({
  publicDir: false,
  plugins: [licence],
  build: {
    outDir: "../src/gearwright/web_assets",
    emptyOutDir: false,
    target: "es2022",
    lib: { entry: "src/viewer/main.ts", formats: ["iife"], name: "gearwrightViewer", fileName: () => "viewer.js" },
  },
});
