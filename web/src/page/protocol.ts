// What server and page say to each other: designs, kinds of element, answers.

export type Value = number | string | boolean | null | Value[] | { [name: string]: Value };
export type Design = { element: string } & { [name: string]: Value };
export type LengthUnit = "mm" | "in";
export type Point = [number, number, number];

export type Form =
  | { form: "file"; suffixes: string[]; words: string }
  | { form: "text"; words: string }
  | { form: "points"; coordinates: string[]; least: number; words: string }
  | { form: "numbers"; most: number; words: string }
  | { form: "several"; of: Form; words: string }
  | { form: "table"; keys: string[]; entries: Parameter[]; words: string };

export interface Parameter {
  name: string;
  meaning: string;
  symbol: string;
  unit: "length" | "angle" | "mm" | "per inch" | "";
  kind: "number" | "integer" | "choice" | "form";
  choices: string[];
  above: number | null;
  minimum: number | null;
  maximum: number | null;
  below: number | null;
  components: string[]; // names of numbers that make up one value
  members: "one" | "both" | "each";
  required: boolean;
  default: Value;
  only: Record<string, string[]>; // choices of other parameters with which alone it applies
  topic: string;
  figure: string | null;
  forms: Form[];
}

export interface FileFormat {
  suffix: string;
  words: string;
  needs_density: boolean;
  has_clearance: boolean;
  what: "body" | "drawing" | "sheet" | "design";
}

export interface Kind {
  name: string;
  command: string;
  members: 1 | 2;
  mate: string; // what a pair's second member is called
  summary: string;
  origin: string;
  plane: boolean;
  start: Design;
  plots: { name: string; title: string }[];
  formats: FileFormat[];
  parameters: Parameter[];
}

export interface Elements {
  length_units: LengthUnit[];
  kinds: Kind[];
}

export interface Material {
  name: string;
  density: number;
}

export interface Problem {
  parameter: string | null;
  member: 0 | 1 | null;
  subject: string;
  message: string;
}

export interface Size {
  value: number | string | null;
  unit: string;
  symbol: string;
}

export interface Properties {
  length_unit: LengthUnit;
  mass_unit: string;
  volume: number;
  mass: number;
  centroid: number[];
  principal_moments: number[];
  principal_axes: number[][];
  area: number | null;
  [name: string]: unknown;
}

// Of one part; a pair has one of these under the name of each member, and "pair" with sizes alone.
export interface PartDocument {
  parameters?: Record<string, Value>;
  sizes?: Record<string, Size>;
  properties?: Properties;
  [name: string]: unknown;
}

export type Document = PartDocument | Record<string, PartDocument>;

export interface Texts {
  toml: string;
  python: string;
  command: string;
}

export type About = null | "origin" | "centroid" | Point;

export interface Ask {
  ask: "design";
  id: number;
  design: Design;
  density: number | null;
  material: string | null;
  have: string[];
}

export interface StageAnswer { answer: "stage"; id: number; text: string }
export interface ValuesAnswer { answer: "values"; id: number; document: Document; remarks: string[]; texts: Texts }
export interface ApproximationAnswer {
  answer: "approximation";
  id: number;
  parts: Record<string, Record<string, unknown>>;
  errors: Record<string, Record<string, number>>;
}
export interface Surface {
  name: string;
  kind: "pitch" | "base" | "face" | "root" | "tip";
  form: "cone" | "cylinder" | "plane";
  half_angle?: number; // degrees
  apex?: number; // of a cone, along the part's axis
  radius?: number;
  least?: number;
  most?: number;
  point?: Point;
  normal?: Point;
  sides?: [number, number];
}
export interface OverlaysAnswer {
  answer: "overlays";
  id: number;
  bodies: { name: string; surfaces: Surface[] }[];
  lines: { name: string; pitch: number; steps: Point[][][] }[]; // where it touches over a pitch of so many degrees
}
export interface DoneAnswer { answer: "done"; id: number; seconds: number }
export interface RefusedAnswer { answer: "refused"; id: number; headline: string; problems: Problem[] }
export interface FailedAnswer { answer: "failed"; id: number; text: string }
export interface UndrawnAnswer { answer: "undrawn"; id: number; text: string } // values come all the same
export interface NoteAnswer { answer: "note"; text: string }

export type Answer =
  | StageAnswer | ValuesAnswer | ApproximationAnswer | OverlaysAnswer
  | DoneAnswer | RefusedAnswer | FailedAnswer | UndrawnAnswer | NoteAnswer;

export interface PlotData {
  title: string;
  x: { label: string; unit: string };
  y: { label: string; unit: string };
  equal: boolean;
  lines: { name: string; x: (number | null)[]; y: (number | null)[]; style: "solid" | "dashed" | "points" }[]; // null: a gap
  log: "none" | "both";
  notes: string[];
  window: [number, number, number, number] | null; // least and most x, least and most y that are looked at first
}

export interface FileWish {
  design: Design;
  suffix: string;
  what: "body" | "drawing" | "sheet" | "design";
  tolerance: number | null;
  clearance: number | null;
  placed: boolean;
  separate: boolean;
  density: number | null;
  material: string | null;
  step_schema: null | "AP242";
  paper: "A3" | "A4";
}

export interface FileJob {
  state: "waiting" | "working" | "done" | "failed" | "cancelled";
  stage: string;
  seconds: number;
  name: string;
  bytes: number | null;
  headline?: string | null;
  problems?: Problem[] | null;
}
