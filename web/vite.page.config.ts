// The designer page: one page, one script, one style sheet, all of them named without hashes.
import { defineConfig } from "vite";
import { licence } from "./licence.ts";

export default defineConfig({
  root: "src/page",
  base: "./",
  publicDir: false,
  plugins: [licence],
  build: {
    outDir: "../../../src/gearwright/web_assets/page",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      output: { entryFileNames: "page.js", assetFileNames: "page.[ext]", codeSplitting: false },
    },
  },
});
