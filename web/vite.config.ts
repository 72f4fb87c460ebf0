// One script a page, each with all it needs: Python puts the script into a page that loads nothing.
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  build: {
    outDir: "../src/gearwright/web_assets",
    emptyOutDir: false,
    target: "es2022",
    lib: { entry: "src/viewer/main.ts", formats: ["iife"], name: "gearwrightViewer", fileName: () => "viewer.js" },
  },
});
