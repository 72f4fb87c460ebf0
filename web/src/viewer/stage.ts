// Renderer, camera and light; pictures are drawn when something changed, not all the time.

import * as three from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Body } from "./body";
import type { SceneData } from "./data";
import { studio } from "./studio";
import { Triad } from "./triad";

const ASIDE = 24; // pixels left free at either side

export class Stage {
  readonly renderer: three.WebGLRenderer;
  readonly scene = new three.Scene();
  readonly camera = new three.OrthographicCamera();
  readonly orbit: OrbitControls;
  onDrawn: () => void = () => {};
  taken: () => [number, number] = () => [ASIDE, ASIDE]; // pixels above and below where something else stands
  private readonly triad = new Triad();
  private waiting = false;
  private readonly home: three.Vector3;

  // Raises where there is no WebGL.
  constructor(private readonly canvas: HTMLCanvasElement, data: SceneData, private readonly radius: number) {
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    this.renderer.toneMapping = three.NeutralToneMapping;
    this.home = new three.Vector3(...data.direction).normalize();
    this.camera.up.set(...data.up).normalize();
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.addEventListener("change", () => this.draw());
    this.addLight();
  }

  private addLight(): void {
    this.scene.environment = studio(this.renderer);
    this.scene.environmentIntensity = 0.5;
    const upright = new three.Quaternion().setFromUnitVectors(new three.Vector3(0, 1, 0), this.camera.up);
    this.scene.environmentRotation.setFromQuaternion(upright);
    const key = new three.DirectionalLight(0xffffff, 1.5);
    key.position.set(-0.7, 1.0, 1.2);
    const fill = new three.DirectionalLight(0xdde8ff, 0.5);
    fill.position.set(1.0, 0.1, 0.8);
    this.camera.add(key, fill); // so that no side is ever dark
    this.scene.add(this.camera);
  }

  // Looks from a direction (None: the first one) and fits all bodies into the view.
  look(bodies: readonly Body[], direction: three.Vector3 = this.home): void {
    this.camera.position.copy(direction).normalize().multiplyScalar(4 * this.radius);
    this.orbit.target.set(0, 0, 0);
    this.camera.lookAt(this.orbit.target);
    this.camera.near = 0.01 * this.radius;
    this.camera.far = 8 * this.radius;
    this.camera.updateMatrixWorld();
    const seen = new three.Box3();
    const point = new three.Vector3();
    for (const body of bodies) {
      for (const vertex of body.points()) seen.expandByPoint(point.copy(vertex).applyMatrix4(this.camera.matrixWorldInverse));
    }
    const middle = seen.getCenter(new three.Vector3());
    const sides = seen.getSize(new three.Vector3());
    const [width, height] = this.size();
    const [above, below] = this.taken();
    const room = [Math.max(width - 2 * ASIDE, 50), Math.max(height - above - below, 50)] as const;
    this.camera.zoom = Math.min(room[0] / sides.x, room[1] / sides.y);
    const lowered = (below - above) / 2 / this.camera.zoom;
    const shift = new three.Vector3(middle.x, middle.y - lowered, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(shift);
    this.orbit.target.add(shift);
    this.resize();
    this.orbit.update();
    this.draw();
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
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
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
      this.renderer.clear();
      this.renderer.render(this.scene, this.camera);
      this.triad.render(this.renderer, this.camera);
      this.onDrawn();
    });
  }
}
