// A server of the designer page as small as the tests need: routes that playwright answers, and a scripted connection.
import { readFileSync } from "node:fs";
import { join } from "node:path";

export const ORIGIN = "http://designer.test";
const FOLDER = join(import.meta.dirname, "../../src/gearwright/web_assets/page");
const TYPES = { html: "text/html", js: "text/javascript", css: "text/css" };
const POLICY = "default-src 'self'; img-src 'self' data: blob:; connect-src 'self' ws://designer.test; object-src 'none'";

const parameter = (name, more = {}) => ({
  name, meaning: `meaning of ${name}`, symbol: "", unit: "", kind: "number", choices: [], above: null, minimum: null, maximum: null,
  below: null, components: [], members: "one", required: false, default: null, only: {}, topic: "", figure: null, forms: [], ...more,
});

const gear = (members) => [
  parameter("teeth", { kind: "integer", symbol: "z", minimum: 3, maximum: 10000, required: true, members: members === 2 ? "each" : "one" }),
  parameter("module", { symbol: "m", unit: "mm", above: 0 }),
  parameter("diametral_pitch", { symbol: "P_d", unit: "per inch", above: 0 }),
  parameter("face_width", { symbol: "b", unit: "length", above: 0, required: true, members: members === 2 ? "both" : "one" }),
  parameter("pressure_angle", { symbol: "α_n", unit: "angle", above: 0, below: 60, default: 20 }),
  parameter("trace", { kind: "choice", choices: ["straight", "circular"], default: "straight" }),
  parameter("cutter_radius", { symbol: "r_c0", unit: "length", above: 0, only: { trace: ["circular"] } }),
  parameter("bore", { symbol: "d_bore", unit: "length", above: 0, topic: "Body inside the teeth", members: members === 2 ? "both" : "one" }),
  parameter("length_unit", { kind: "choice", choices: ["mm", "in"], default: "mm" }),
];

const points = { form: "points", coordinates: ["x", "y"], least: 3, words: "points [[x, y], …]" };
const entry = (name, more) => parameter(name, { required: true, ...more });

export const ELEMENTS = {
  length_units: ["mm", "in"],
  kinds: [
    ["spur gear", "spur", 1, { element: "spur", teeth: 24, module: 2, face_width: 16 }, gear(1)],
    ["spur pair", "spur", 2, { element: "spur", teeth: [16, 40], module: 3, face_width: 20 }, gear(2)],
    ["helical pair", "helical", 2, { element: "helical", teeth: [17, 43], module: 2, face_width: 25 }, gear(2)],
    ["sweep", "sweep", 1, { element: "sweep", section: { circle: 5 }, length: 30 }, [
      parameter("section", { kind: "form", symbol: "S", required: true, forms: [
        { form: "file", suffixes: [".dxf"], words: "the name of a file (.dxf)" },
        { form: "table", keys: ["polygon"], words: "a table", entries: [
          entry("polygon", { kind: "form", forms: [points] }),
          parameter("holes", { kind: "form", default: [], forms: [{ form: "several", of: points, words: "a list" }] })] },
        { form: "table", keys: ["circle"], words: "a table", entries: [
          entry("circle", { unit: "length", above: 0 }), parameter("centre", { unit: "length", components: ["x", "y"], default: [0, 0] })] },
      ] }),
      parameter("length", { symbol: "L", unit: "length", above: 0 }),
      parameter("layer", { kind: "form", forms: [{ form: "text", words: "the name of a layer" }] }),
      parameter("twist", { symbol: "φ", unit: "angle", default: 0 }),
      parameter("length_unit", { kind: "choice", choices: ["mm", "in"], default: "mm" }),
    ]],
  ].map(([name, command, members, start, parameters]) => ({
    name, command, members, mate: command === "rack" ? "rack" : "gear", summary: name, origin: "on the axis", plane: true, start, plots: [], formats: [], parameters,
  })),
};

// A frame with nothing in it but its header.
export function frame(id, title = `model ${id}`) {
  const header = { answer: "mesh", id, title, unit: "mm", direction: [1, 1, 1], up: [0, 0, 1], turns: null, tolerance: 1, triangles: 0, bytes: 0, bodies: [] };
  const text = Buffer.from(JSON.stringify(header));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 8) + 8) % 8, " ")]);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(padded.length);
  return Buffer.concat([length, padded]);
}

const properties = (volume) => ({
  length_unit: "mm", mass_unit: "kg", volume, mass: volume * 7.85e-6, centroid: [0, 0, 10], area: 100,
  principal_moments: [1, 2, 3], principal_axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], radii_of_gyration: [4, 5, 6], density: 7.85e-6,
  bounding_box: [[-24, -24, 0], [24, 24, 20]], error_bound: 2e-15, central_inertia: [[1, 0, 0], [0, 2, 0], [0, 0, 3]],
});
export const values = (id, volume = 41230) => ({
  answer: "values", id, remarks: [], texts: { toml: "", python: "", command: "" },
  document: { parameters: {}, sizes: { pitch_diameter: { value: 48, unit: "mm", symbol: "d" } }, properties: properties(volume) },
});

// Serves the page to a browser's page; what it asks is kept, and answered unless a test does so itself.
export async function served(page, { answers = prompt, elements = ELEMENTS } = {}) {
  const server = { asks: [], sockets: [], answers, read: null, uploads: [] };
  await page.route(`${ORIGIN}/**`, async (route) => {
    const url = new URL(route.request().url());
    const json = (body, status = 200) => route.fulfill({ status, contentType: "application/json", body: JSON.stringify(body) });
    if (url.pathname === "/api/elements") return json(elements);
    if (url.pathname === "/api/materials") return json([{ name: "steel", density: 7850 }]);
    if (url.pathname === "/api/read") return json(...server.read(JSON.parse(route.request().postData()).toml));
    if (url.pathname === "/api/uploads") {
      server.uploads.push(url.searchParams.get("name"));
      return json({ value: `upload:1f/${url.searchParams.get("name")}`, name: url.searchParams.get("name"), bytes: 1 }, 201);
    }
    if (url.pathname.startsWith("/api/")) return json({ headline: "not there", problems: [] }, 404);
    const name = url.pathname === "/" ? "index.html" : url.pathname.slice(1);
    const headers = { "content-security-policy": POLICY };
    return route.fulfill({ headers, contentType: TYPES[name.split(".").pop()], body: readFileSync(join(FOLDER, name), "utf8") });
  });
  await page.routeWebSocket(/designer\.test\/api\/live/, (socket) => {
    server.sockets.push(socket);
    socket.onMessage((text) => {
      const ask = JSON.parse(text);
      server.asks.push(ask);
      server.answers(socket, ask);
    });
  });
  return server;
}

// All there is to say, at once.
export function prompt(socket, { id }) {
  socket.send(frame(id));
  socket.send(JSON.stringify(values(id)));
  socket.send(JSON.stringify({ answer: "done", id, seconds: 0 }));
}
