// What is copied into a bundle must bring its licence along.
import { existsSync, readFileSync } from "node:fs";

const MODULES = new URL("node_modules/", import.meta.url);

interface File {
  type: string;
  code?: string;
  moduleIds?: string[];
}

export const licence = {
  name: "licence",
  generateBundle(_: unknown, bundle: Record<string, File>) {
    for (const file of Object.values(bundle)) {
      if (file.type !== "chunk") continue;
      const packages = [...new Set((file.moduleIds ?? []).flatMap(packageOf))].sort();
      file.code = `${packages.map((name) => `/*! with ${name}:\n${textOf(name)}\n*/\n`).join("")}${file.code}`;
    }
  },
};

const packageOf = (path: string) => /node_modules\/((?:@[^/]+\/)?[^/]+)\/(?!.*node_modules)/.exec(path)?.slice(1, 2) ?? [];

function textOf(name: string): string {
  const file = ["LICENSE", "LICENSE.md", "LICENSE.txt"].map((one) => new URL(`${name}/${one}`, MODULES)).find((one) => existsSync(one));
  if (!file) throw new Error(`${name} has no licence file`);
  return readFileSync(file, "utf8").trim();
}
