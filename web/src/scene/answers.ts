// What the server says about a design beside its mesh, as far as the view draws it.

import type { Triple } from "./solid";

export interface Values {
  document: object; // of one part, or of both under the names of the members
}

export interface Surface {
  name: string;
  kind: string; // pitch, base, face, root, tip
  form: "cone" | "cylinder" | "plane";
  half_angle?: number; // degrees
  apex?: number; // of a cone, on the part's z
  radius?: number;
  least?: number; // along z
  most?: number;
  point?: Triple;
  normal?: Triple;
  sides?: [number, number];
}

export interface Overlays {
  bodies: { name: string; surfaces: Surface[] }[];
  lines: ContactSteps[];
}

// Lines along which a pair touches while its pinion turns by a pitch.
export interface ContactSteps {
  name: string;
  pitch: number; // degrees of the pinion, after which they repeat
  steps: Triple[][][]; // polylines at the turns k / count · pitch, in the frame of the scene
}

// How a part's mass is spread, in its own frame.
export interface Spread {
  unit: string; // of lengths
  massUnit: string;
  centroid: Triple;
  axes: Triple[]; // three, unit
  moments: Triple; // about them, through the centroid
  radii: Triple; // of gyration, about them
}

export function spreadOf(values: Values, name: string, alone: boolean): Spread | null {
  const told = values.document as Record<string, { properties?: Told } | undefined> & { properties?: Told };
  const found = told[name]?.properties ?? (alone ? told.properties : undefined);
  if (!found?.centroid || !found.principal_axes || !found.principal_moments || !found.mass) return null;
  const columns = found.principal_axes;
  const moments = found.principal_moments as Triple;
  return {
    unit: found.length_unit,
    massUnit: found.mass_unit,
    centroid: found.centroid as Triple,
    axes: [0, 1, 2].map((k) => columns.map((row) => row[k]!) as Triple),
    moments,
    radii: moments.map((moment) => Math.sqrt(Math.max(moment, 0) / found.mass)) as Triple,
  };
}

interface Told {
  length_unit: string;
  mass_unit: string;
  mass: number;
  centroid: number[];
  principal_axes: number[][]; // by columns
  principal_moments: number[];
}
