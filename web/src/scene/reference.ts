// Surfaces that a part is measured from, in its own frame: translucent, with rims that shine through.

import * as three from "three";
import type { Surface } from "./answers";
import type { Triple } from "./solid";
import { along, strokes } from "./strokes";

const AROUND = 96;
const DEGREE = Math.PI / 180;

const COLOURS: Record<string, string> = {
  pitch: "#1f6feb", base: "#8250df", face: "#0b8a8a", tip: "#2da44e", root: "#b35900",
};

export const colourOf = (kind: string) => COLOURS[kind] ?? "#57606a";

// cut: the plane beyond which nothing is drawn
export function reference(surface: Surface, cut: three.Plane | null): three.Group {
  const { geometry, rims } = surface.form === "plane" ? plane(surface) : round(surface);
  const colour = colourOf(surface.kind);
  const material = new three.MeshBasicMaterial({
    color: colour, transparent: true, opacity: 0.28, side: three.DoubleSide, depthWrite: false, toneMapped: false,
  });
  const skin = new three.Mesh(geometry, material);
  skin.renderOrder = 1500;
  const edge = strokes(rims.flatMap(along), colour, 1.5);
  for (const part of [skin, edge]) part.material.clippingPlanes = cut ? [cut] : null;
  const group = new three.Group().add(skin, edge);
  group.name = surface.name;
  return group;
}

interface Drawn {
  geometry: three.BufferGeometry;
  rims: Triple[][];
}

// A cylinder, or a cone, about z.
function round(surface: Surface): Drawn {
  const { least = 0, most = 0, radius, half_angle, apex = 0 } = surface;
  const radiusAt = (z: number) => radius ?? Math.abs((z - apex) * Math.tan((half_angle ?? 0) * DEGREE));
  const rims = [least, most].map((z) =>
    Array.from({ length: AROUND + 1 }, (_, k): Triple => {
      const angle = (2 * Math.PI * k) / AROUND;
      return [radiusAt(z) * Math.cos(angle), radiusAt(z) * Math.sin(angle), z];
    }));
  const [low, high] = rims as [Triple[], Triple[]];
  const quads = low.slice(1).flatMap((_, k) => quad(low[k]!, low[k + 1]!, high[k + 1]!, high[k]!));
  return { geometry: geometryOf(quads), rims: rims.filter((rim) => rim[0]![0] > 0) };
}

// A rectangle about a point: its first side along x (along y, where x is across it), as far as that lies in the plane.
function plane(surface: Surface): Drawn {
  const { point = [0, 0, 0], normal = [0, 0, 1], sides = [1, 1] } = surface;
  const across = new three.Vector3(...normal).normalize();
  const first = new three.Vector3(...(Math.abs(across.x) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
  first.addScaledVector(across, -first.dot(across)).normalize();
  const second = across.clone().cross(first);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) =>
    new three.Vector3(...point)
      .addScaledVector(first, (a! * sides[0]) / 2).addScaledVector(second, (b! * sides[1]) / 2).toArray() as Triple);
  const [a, b, c, d] = corners as [Triple, Triple, Triple, Triple];
  return { geometry: geometryOf(quad(a, b, c, d)), rims: [[a, b, c, d, a]] };
}

const quad = (a: Triple, b: Triple, c: Triple, d: Triple): number[] => [a, b, c, a, c, d].flat();

function geometryOf(triangles: number[]): three.BufferGeometry {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute("position", new three.Float32BufferAttribute(triangles, 3));
  return geometry;
}
