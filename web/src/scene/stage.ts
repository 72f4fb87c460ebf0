// Renderer, camera and light; pictures are drawn when something changed, not all the time.

import * as three from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Body } from "./body";
import type { Graphics } from "./graphics";
import type { Triple } from "./solid";
import { studio } from "./studio";
import { Triad } from "./triad";

const ASIDE = 24; // pixels left free at either side

export interface View {
  direction: Triple; // towards the eye
  up: Triple;
}

export class Stage {
  readonly renderer: three.WebGLRenderer;
  readonly scene = new three.Scene();
  readonly camera = new three.OrthographicCamera();
  orbit: OrbitControls;
  radius = 1; // of what is to be seen
  touched = false; // whether somebody has moved the camera since all was fitted into the view
  onDraw: () => void = () => {};
  onDrawn: () => void = () => {};
  // pixels above, to the right, below and to the left where something else stands
  taken: () => [number, number, number, number] = () => [ASIDE, ASIDE, ASIDE, ASIDE];
  private readonly triad = new Triad();
  private waiting = false;
  private readonly home = new three.Vector3(0, 0, 1);

  // Raises where there is no WebGL.
  constructor(private readonly canvas: HTMLCanvasElement, private readonly drawnBy: Graphics, view: View) {
    this.renderer = new three.WebGLRenderer({
      canvas, antialias: drawnBy !== "software", alpha: true, stencil: true, preserveDrawingBuffer: true,
    });
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    this.renderer.toneMapping = three.NeutralToneMapping;
    this.scene.add(this.camera);
    this.addLamps();
    this.light();
    this.orbit = this.face(view);
  }

  // Where it is seen from at first.
  face(view: View): OrbitControls {
    this.home.set(...view.direction).normalize();
    this.camera.up.set(...view.up).normalize();
    const upright = new three.Quaternion().setFromUnitVectors(new three.Vector3(0, 1, 0), this.camera.up);
    this.scene.environmentRotation.setFromQuaternion(upright);
    // controls take over what is up when they are made, and never again
    (this.orbit as OrbitControls | undefined)?.dispose();
    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.addEventListener("change", () => this.draw());
    this.orbit.addEventListener("start", () => (this.touched = true));
    return this.orbit;
  }

  // What metal mirrors; to be made anew when the graphics card was lost.
  light(): void {
    if (this.drawnBy === "software") return;
    this.scene.environment = studio(this.renderer);
    this.scene.environmentIntensity = 0.5;
  }

  // Lamps that go with the camera, so that no side is ever dark.
  private addLamps(): void {
    const plain = this.drawnBy === "software";
    const key = new three.DirectionalLight(0xffffff, plain ? 2.1 : 1.5);
    key.position.set(-0.7, 1.0, 1.2);
    const fill = new three.DirectionalLight(0xdde8ff, plain ? 0.7 : 0.5);
    fill.position.set(1.0, 0.1, 0.8);
    this.camera.add(key, fill);
    if (plain) this.scene.add(new three.AmbientLight(0xffffff, 1.2));
  }

  // Looks from a direction (none: the first one) and fits all bodies into the view.
  look(bodies: readonly Body[], direction: three.Vector3 = this.home): void {
    this.touched = false;
    this.camera.position.copy(direction).normalize().multiplyScalar(4 * this.radius);
    this.orbit.target.set(0, 0, 0);
    this.camera.lookAt(this.orbit.target);
    this.camera.updateMatrixWorld();
    const seen = this.seen(bodies);
    if (seen.isEmpty()) return;
    const middle = seen.getCenter(new three.Vector3());
    const sides = seen.getSize(new three.Vector3());
    const [width, height] = this.size();
    const [above, right, below, left] = this.taken();
    const room = [Math.max(width - left - right, 50), Math.max(height - above - below, 50)] as const;
    this.camera.zoom = Math.min(room[0] / sides.x, room[1] / sides.y);
    const aside = (right - left) / 2 / this.camera.zoom;
    const lowered = (below - above) / 2 / this.camera.zoom;
    const shift = new three.Vector3(middle.x + aside, middle.y - lowered, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(shift);
    this.orbit.target.add(shift);
    this.resize();
    this.orbit.update();
    this.draw();
  }

  // Whether all bodies lie in the view.
  holds(bodies: readonly Body[]): boolean {
    this.camera.updateMatrixWorld();
    const { min, max } = this.seen(bodies);
    const [width, height] = this.size().map((one) => one / 2 / this.camera.zoom) as [number, number];
    return min.x >= -width && max.x <= width && min.y >= -height && max.y <= height;
  }

  // Where the bodies are before the camera.
  private seen(bodies: readonly Body[]): three.Box3 {
    const box = new three.Box3();
    for (const body of bodies) body.reach(this.camera.matrixWorldInverse, box);
    return box;
  }

  // From where it is looked at now.
  direction(): three.Vector3 {
    return this.camera.position.clone().sub(this.orbit.target).normalize();
  }

  // Length units that one pixel (of the page) spans.
  unitsAPixel(): number {
    return 1 / this.camera.zoom;
  }

  size(): [number, number] {
    return [Math.max(this.canvas.clientWidth, 1), Math.max(this.canvas.clientHeight, 1)];
  }

  resize(): void {
    const [width, height] = this.size();
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, this.drawnBy === "software" ? 1 : 2));
    this.renderer.setSize(width, height, false);
    Object.assign(this.camera, { left: -width / 2, right: width / 2, top: height / 2, bottom: -height / 2 });
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // Asks for a picture with the next frame.
  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      if (this.renderer.getContext().isContextLost()) return;
      this.onDraw();
      this.span();
      this.renderer.clear();
      this.renderer.render(this.scene, this.camera);
      this.triad.render(this.renderer, this.camera);
      this.onDrawn();
    });
  }

  dispose(): void {
    this.orbit.dispose();
    this.scene.environment?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  // Depths from before all that is there to behind it, wherever the camera has been moved.
  private span(): void {
    this.camera.updateMatrixWorld();
    const depth = -new three.Vector3().applyMatrix4(this.camera.matrixWorldInverse).z;
    this.camera.near = depth - 3 * this.radius;
    this.camera.far = depth + 3 * this.radius;
    this.camera.updateProjectionMatrix();
  }
}
