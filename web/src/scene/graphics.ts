// What draws: a graphics card, software in its place (many times slower), or nothing at all.

export type Graphics = "hardware" | "software" | "none";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

let found: Graphics | null = null;

// Tried once a page, on a canvas that nobody sees.
export function graphics(): Graphics {
  found ??= tried();
  return found;
}

function tried(): Graphics {
  const willing = context(true);
  const gl = willing ?? context(false);
  if (!gl) return "none";
  const named = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return willing && !SOFTWARE.test(name) ? "hardware" : "software";
}

function context(failIfMajorPerformanceCaveat: boolean): WebGL2RenderingContext | null {
  return document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat });
}
