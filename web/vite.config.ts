// One script a page, each with all it needs: Python puts the script into a page that loads nothing.
import { defineConfig } from "vite";
import { licence } from "./licence.ts";

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
