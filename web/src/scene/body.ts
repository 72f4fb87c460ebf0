// One body: faces, sharp edges, and the hatched face where the section plane cuts it.

import * as three from "three";
import type { Graphics } from "./graphics";
import { hatched } from "./hatching";
import type { Solid } from "./solid";

const DEGREE = Math.PI / 180;

export class Body {
  readonly group = new three.Group();
  readonly placed = new three.Group(); // the body's own frame where it is now: what is fixed to the body hangs here
  readonly colour = new three.Color();
  solid!: Solid;
  cutting: three.Plane | null = null;
  private readonly surface: three.MeshStandardMaterial | three.MeshLambertMaterial;
  private readonly faces: three.Mesh;
  private readonly lines: three.LineSegments;
  private readonly counters: three.Mesh[];
  private readonly cap: three.Mesh<three.PlaneGeometry, three.ShaderMaterial>;
  private readonly place = new three.Matrix4();
  private turn = 0; // degrees

  constructor(readonly index: number, drawnBy: Graphics) {
    this.surface = metal(drawnBy);
    this.faces = new three.Mesh(new three.BufferGeometry(), this.surface);
    this.faces.renderOrder = 1000;
    this.lines = new three.LineSegments(new three.BufferGeometry(), new three.LineBasicMaterial({ transparent: true }));
    this.lines.renderOrder = 1001;
    this.counters = [counter(three.BackSide), counter(three.FrontSide)];
    this.counters.forEach((part) => (part.renderOrder = 10 * index));
    this.cap = new three.Mesh(new three.PlaneGeometry(6, 6), hatched(index));
    this.cap.renderOrder = 10 * index + 1;
    this.cap.onAfterRender = (renderer) => (renderer as three.WebGLRenderer).clearStencil();
    for (const part of [this.placed, ...this.parts()]) part.matrixAutoUpdate = false;
    // what is in view is found once, at the fit, and arrays change under the cached bounds
    for (const part of this.parts()) part.frustumCulled = false;
    this.placed.add(...this.parts());
    this.group.add(this.placed, this.cap);
    this.cutBy(null);
  }

  // middle: what becomes the origin, so that coordinates on the graphics card stay small; radius: of the whole scene
  show(solid: Solid, middle: three.Vector3, radius: number): void {
    const before = this.solid as Solid | undefined;
    this.solid = solid;
    this.colour.setRGB(...solid.colour, three.SRGBColorSpace);
    this.surface.color.copy(this.colour);
    this.cap.material.uniforms.colour!.value.copy(this.colour).lerp(new three.Color(1, 1, 1), 0.45);
    this.cap.scale.setScalar(radius);
    if (before?.topology === solid.topology && before.positions.length === solid.positions.length) this.replace(solid);
    else this.rebuild(solid);
    for (const part of this.parts()) part.matrix.makeTranslation(...solid.centre);
    this.moveTo(middle);
  }

  // Another point of the scene becomes the origin.
  moveTo(middle: three.Vector3): void {
    this.place.fromArray(this.solid.place).transpose();
    this.place.premultiply(new three.Matrix4().makeTranslation(middle.clone().negate()));
    this.turnTo(0);
  }

  // Puts the body where it is at a turn (degrees): its place · the slide · the spin about its own z.
  turnTo(turn: number): void {
    this.turn = turn;
    const { spin, slide } = this.solid;
    this.placed.matrix
      .copy(this.place)
      .multiply(new three.Matrix4().makeTranslation(slide[0] * turn, slide[1] * turn, slide[2] * turn))
      .multiply(new three.Matrix4().makeRotationZ(spin * turn * DEGREE));
    this.placed.matrixWorldNeedsUpdate = true;
  }

  get slides(): boolean {
    return this.solid.slide.some((x) => x !== 0);
  }

  // Widens a box, of the scene's own frame, by that of the body where it has slid to.
  extend(box: three.Box3): void {
    const { slide, least, most } = this.solid;
    const by = new three.Vector3(...slide).multiplyScalar(this.turn).applyMatrix3(new three.Matrix3().setFromMatrix4(this.place));
    for (const corner of [least, most]) box.expandByPoint(new three.Vector3(...corner).add(by));
  }

  // Leaves out what lies beyond a plane; null shows all. An open surface has no inside to be hatched.
  cutBy(plane: three.Plane | null): void {
    this.cutting = plane;
    const planes = plane ? [plane] : null;
    for (const part of this.parts()) (part.material as three.Material).clippingPlanes = planes;
    const capped = plane !== null && (this.solid as Solid | undefined)?.closed === true;
    for (const part of [...this.counters, this.cap]) part.visible = capped;
    if (plane && capped) {
      plane.coplanarPoint(this.cap.position);
      this.cap.lookAt(this.cap.position.clone().sub(plane.normal));
    }
  }

  showEdges(shown: boolean, colour: string, opacity: number): void {
    this.lines.visible = shown;
    const material = this.lines.material as three.LineBasicMaterial;
    material.color.set(colour);
    material.opacity = opacity;
  }

  // opacity: 1 hides all that lies behind, less lets it shine through
  setOpacity(opacity: number): void {
    const whole = opacity >= 1;
    if (this.surface.transparent === whole) this.surface.needsUpdate = true;
    Object.assign(this.surface, { opacity, transparent: !whole, depthWrite: whole });
  }

  // Widens a box by every vertex where it is now, seen through another matrix.
  reach(seen: three.Matrix4, box: three.Box3): void {
    const matrix = seen.clone().multiply(this.placed.matrix).multiply(this.faces.matrix);
    const { positions } = this.solid;
    const point = new three.Vector3();
    for (let i = 0; i < positions.length; i += 3) box.expandByPoint(point.fromArray(positions, i).applyMatrix4(matrix));
  }

  // From where to where the body is along its own z.
  ends(): [number, number] {
    const { positions, centre } = this.solid;
    let [least, most] = [Infinity, -Infinity];
    for (let i = 2; i < positions.length; i += 3) {
      least = Math.min(least, positions[i]!);
      most = Math.max(most, positions[i]!);
    }
    return [centre[2] + least, centre[2] + most];
  }

  dispose(): void {
    for (const part of [...this.parts(), this.cap]) {
      part.geometry.dispose();
      (part.material as three.Material).dispose();
    }
  }

  private parts(): (three.Mesh | three.LineSegments)[] {
    return [this.faces, this.lines, ...this.counters];
  }

  // Other values in arrays of the same size: the buffers on the graphics card stay.
  private replace(solid: Solid): void {
    const { position, normal } = this.faces.geometry.attributes as Record<string, three.BufferAttribute>;
    position!.array = solid.positions;
    normal!.array = solid.normals;
    position!.needsUpdate = normal!.needsUpdate = true;
  }

  private rebuild(solid: Solid): void {
    for (const part of this.parts()) part.geometry.dispose();
    const { triangles, edges } = solid.index();
    const position = new three.BufferAttribute(solid.positions, 3);
    const faces = new three.BufferGeometry();
    faces.setAttribute("position", position);
    faces.setAttribute("normal", new three.BufferAttribute(solid.normals, 3, true));
    faces.setIndex(new three.BufferAttribute(triangles, 1));
    this.lines.geometry = new three.BufferGeometry();
    this.lines.geometry.setAttribute("position", position);
    this.lines.geometry.setIndex(new three.BufferAttribute(edges, 1));
    for (const part of [this.faces, ...this.counters]) part.geometry = faces;
  }
}

// Metal mirrors a studio; where software draws, it only scatters light.
function metal(drawnBy: Graphics): three.MeshStandardMaterial | three.MeshLambertMaterial {
  const common = {
    side: three.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  } as const;
  if (drawnBy === "software") return new three.MeshLambertMaterial(common);
  return new three.MeshStandardMaterial({ ...common, metalness: 0.55, roughness: 0.42 });
}

// Counts in the stencil how many faces of one side stand beyond the plane: where backs and fronts differ, it is inside.
function counter(side: three.Side): three.Mesh {
  const step = side === three.BackSide ? three.IncrementWrapStencilOp : three.DecrementWrapStencilOp;
  const material = new three.MeshBasicMaterial({
    side, depthWrite: false, depthTest: false, colorWrite: false,
    stencilWrite: true, stencilFunc: three.AlwaysStencilFunc,
    stencilFail: step, stencilZFail: step, stencilZPass: step,
  });
  return new three.Mesh(new three.BufferGeometry(), material);
}
