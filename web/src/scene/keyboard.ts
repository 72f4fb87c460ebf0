// The canvas by keys: what the mouse does, for those who have none at hand.

import * as three from "three";
import type { Stage } from "./stage";

const STEP = Math.PI / 36;

export const KEYS =
  "Arrow keys turn, with Shift they shift, + and − zoom, X, Y, Z look along an axis, 0 shows all, Space runs a pair.";

export function listen(stage: Stage, canvas: HTMLElement, actions: { look: (d?: three.Vector3) => void; run: () => void }): void {
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!handled(stage, event, actions)) return;
    event.preventDefault();
    event.stopPropagation(); // a notebook has keys of its own
  });
}

function handled(stage: Stage, event: KeyboardEvent, actions: { look: (d?: three.Vector3) => void; run: () => void }): boolean {
  const arrows: Record<string, [number, number]> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
  };
  const arrow = arrows[event.key];
  if (arrow) {
    stage.touched = true;
    if (event.shiftKey) shift(stage, arrow);
    else turn(stage, arrow);
    return true;
  }
  const key = event.key.toLowerCase();
  if (key === "+" || key === "=") return zoom(stage, 1.15);
  if (key === "-" || key === "−") return zoom(stage, 1 / 1.15);
  if (key === " ") actions.run();
  else if (key === "0" || key === "home") actions.look();
  else if (["x", "y", "z"].includes(key)) actions.look(along("xyz".indexOf(key), event.shiftKey, stage.camera.up));
  else return false;
  return true;
}

function turn(stage: Stage, [right, up]: [number, number]): void {
  const arm = stage.camera.position.clone().sub(stage.orbit.target);
  const upright = new three.Quaternion().setFromUnitVectors(stage.camera.up, new three.Vector3(0, 1, 0));
  const angles = new three.Spherical().setFromVector3(arm.applyQuaternion(upright));
  angles.theta += STEP * right;
  angles.phi -= STEP * up;
  angles.makeSafe();
  arm.setFromSpherical(angles).applyQuaternion(upright.invert());
  stage.camera.position.copy(stage.orbit.target).add(arm);
  stage.orbit.update();
}

function shift(stage: Stage, [right, up]: [number, number]): void {
  const way = new three.Vector3(right, up, 0).applyQuaternion(stage.camera.quaternion).multiplyScalar(30 * stage.unitsAPixel());
  stage.camera.position.add(way);
  stage.orbit.target.add(way);
  stage.orbit.update();
}

function zoom(stage: Stage, factor: number): boolean {
  stage.touched = true;
  stage.camera.zoom *= factor;
  stage.camera.updateProjectionMatrix();
  stage.draw();
  return true;
}

// From the positive end of an axis, or, with Shift, from the other; not quite along "up", where sideways is nowhere.
export function along(axis: number, reversed: boolean, up: three.Vector3): three.Vector3 {
  const direction = new three.Vector3().setComponent(axis, reversed ? -1 : 1);
  if (Math.abs(direction.dot(up)) < 0.999) return direction;
  const aside = new three.Vector3().setComponent(axis === 0 ? 1 : axis - 1, axis === 0 ? 1 : -1);
  return direction.addScaledVector(aside, 1e-4).normalize();
}
