// The real server, as a person starts it: an address on the loopback, and an end by Ctrl-C.
import { execFileSync, spawn } from "node:child_process";

export const PYTHON = process.env.PYTHON ?? "python3";

export async function started(...more) {
  const server = spawn(PYTHON, ["-m", "gearwright", "serve", "--port", "0", ...more], { stdio: ["ignore", "pipe", "pipe"] });
  let [said, complained] = ["", ""];
  server.stderr.on("data", (data) => (complained += data));
  const address = await new Promise((found, failed) => {
    const timer = setTimeout(() => failed(new Error(`no address within a minute: ${said}${complained}`)), 60_000);
    server.stdout.on("data", (data) => {
      said += data;
      const match = /http:\S+/.exec(said);
      if (match) {
        clearTimeout(timer);
        found(match[0]);
      }
    });
    server.on("exit", (code) => failed(new Error(`ended with ${code}: ${complained}`)));
  });
  const ended = new Promise((done) => server.on("exit", (code) => done({ code, said, complained })));
  return {
    address,
    pid: server.pid,
    end: async (signal = "SIGINT") => {
      server.kill(signal);
      return ended;
    },
  };
}

// What a Python program prints as JSON.
export const python = (program, ...words) =>
  JSON.parse(execFileSync(PYTHON, ["-c", program, ...words], { encoding: "utf8", maxBuffer: 1 << 26 }));

// What the command line says with --json.
export const command = (...words) =>
  JSON.parse(execFileSync(PYTHON, ["-m", "gearwright", ...words, "--json"], { encoding: "utf8", maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "ignore"] }));
