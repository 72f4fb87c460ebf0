// Which figure defines a parameter: by its name, as the server says or as is known here.

import { bevel, spiral } from "./bevel";
import { blank } from "./blank";
import { cam } from "./cam";
import { helix } from "./helix";
import { sweep } from "./sweep";
import { measured, shift, tooth } from "./tooth";

type Draw = (marked: string) => SVGSVGElement;

const FIGURES: Record<string, Draw> = { tooth, shift, measured, blank, helix, bevel, spiral, cutter: spiral, cam, sweep, path: sweep };

const OF: [Draw, string[]][] = [
  [shift, ["profile_shift", "centre_distance", "basic_rack"]],
  [measured, ["pin_diameter", "span_teeth"]],
  [blank, ["face_width", "bore", "keyway", "keyway_width", "keyway_depth", "hub_diameter", "hub_length", "hub_offset", "rim_diameter",
    "web_thickness", "web_holes", "web_hole_diameter", "web_hole_circle", "outer_diameter"]],
  [helix, ["helix_angle", "transverse_module"]],
  [spiral, ["spiral_angle", "cutter_radius", "blade_groups", "hand", "trace"]],
  [tooth, ["module", "diametral_pitch", "pressure_angle", "addendum", "addendum_coefficient", "dedendum", "dedendum_coefficient",
    "tip_diameter", "tip_shortening", "circular_thickness", "thickness_modification", "backlash", "normal_backlash", "root",
    "rack_tip_radius", "rack_tip_coefficient", "fillet_radius", "crown_tip_radius", "tip_relief", "tip_relief_height",
    "tip_relief_form", "tip_chamfer"]],
];
const BEVEL = ["teeth", "mate_teeth", "pitch_angle", "shaft_angle", "face_width", "addendum", "dedendum", "addendum_angle",
  "dedendum_angle", "working_depth", "whole_depth", "gear_addendum", "taper", "ends", "mounting_distance"];
const CAM = ["programme", "follower", "law", "swing", "lift", "sense", "pivot_distance", "face_offset", "initial_angle", "arm_length",
  "roller_radius", "base_radius", "offset", "curvature_limit", "eccentricity_limit", "pressure_angle_limit"];
const SWEEP = ["section", "layer", "around", "length", "path", "angle", "frame", "twist", "scale", "skew", "transform"];

// null where no figure says more than words. named: what the server calls it
export function figureOf(command: string, name: string, named: string | null): SVGSVGElement | null {
  const draw = (named !== null && FIGURES[named]) || known(command, name);
  return draw ? draw(name) : null;
}

function known(command: string, name: string): Draw | undefined {
  if (command === "bevel" && BEVEL.includes(name)) return bevel;
  if (command === "cam") return CAM.includes(name) ? cam : undefined;
  if (command === "sweep") return SWEEP.includes(name) ? sweep : undefined;
  return OF.find(([, names]) => names.includes(name))?.[0];
}
