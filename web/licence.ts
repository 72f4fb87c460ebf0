// What is copied into a bundle must bring its licence along.
import { readFileSync } from "node:fs";

export const licence = {
  name: "licence",
  generateBundle(_: unknown, bundle: Record<string, { type: string; code?: string }>) {
    const text = readFileSync(new URL("node_modules/three/LICENSE", import.meta.url), "utf8").trim();
    for (const file of Object.values(bundle)) {
      if (file.type === "chunk") file.code = `/*! with three.js:\n${text}\n*/\n${file.code}`;
    }
  },
};
