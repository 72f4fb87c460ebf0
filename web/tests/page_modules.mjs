// Modules of the page as node sees them.
import { join } from "node:path";
import { runnerImport } from "vite";

export async function moduleOf(name) {
  const options = { configFile: false, root: join(import.meta.dirname, ".."), logLevel: "error" };
  return (await runnerImport(join(import.meta.dirname, "../src/page", `${name}.ts`), options)).module;
}
