// One body: faces, sharp edges, and the hatched face where the section plane cuts it.

import * as three from "three";
import { counts, floats, shorts, type BodyData } from "./data";
import { hatched } from "./hatching";

const DEGREE = Math.PI / 180;

export class Body {
  readonly group = new three.Group();
  readonly colour: three.Color;
  private readonly faces: three.Mesh;
  private readonly lines: three.LineSegments;
  private readonly counters: three.Mesh[];
  private readonly cap: three.Mesh;
  private readonly place: three.Matrix4;
  private readonly centre: three.Matrix4;

  // middle: what becomes the origin, so that coordinates on the graphics card stay small
  constructor(readonly data: BodyData, index: number, middle: three.Vector3, radius: number) {
    this.colour = new three.Color().setRGB(...data.colour, three.SRGBColorSpace);
    this.place = new three.Matrix4().fromArray(data.place).transpose();
    this.place.premultiply(new three.Matrix4().makeTranslation(middle.clone().negate()));
    this.centre = new three.Matrix4().makeTranslation(...data.centre);
    const geometry = faceGeometry(data);
    this.faces = new three.Mesh(
      geometry,
      new three.MeshStandardMaterial({
        color: this.colour, metalness: 0.55, roughness: 0.42, side: three.DoubleSide,
        polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
      }),
    );
    this.faces.renderOrder = 1000;
    this.lines = new three.LineSegments(edgeGeometry(data), new three.LineBasicMaterial({ transparent: true }));
    this.lines.renderOrder = 1001;
    this.counters = [counter(geometry, three.BackSide), counter(geometry, three.FrontSide)];
    this.cap = new three.Mesh(new three.PlaneGeometry(6 * radius, 6 * radius), hatched(this.colour, index));
    this.cap.onAfterRender = (renderer) => (renderer as three.WebGLRenderer).clearStencil();
    for (const part of [this.faces, this.lines, ...this.counters]) part.matrixAutoUpdate = false;
    this.counters.forEach((part) => (part.renderOrder = 10 * index));
    this.cap.renderOrder = 10 * index + 1;
    this.group.add(this.faces, this.lines, ...this.counters, this.cap);
    this.cutBy(null);
    this.turnTo(0);
  }

  // Puts the body where it is at a turn (degrees): its place · the slide · the spin about its own z.
  turnTo(turn: number): void {
    const { spin, slide } = this.data;
    const matrix = this.place
      .clone()
      .multiply(new three.Matrix4().makeTranslation(slide[0] * turn, slide[1] * turn, slide[2] * turn))
      .multiply(new three.Matrix4().makeRotationZ(spin * turn * DEGREE))
      .multiply(this.centre);
    for (const part of [this.faces, this.lines, ...this.counters]) part.matrix.copy(matrix);
  }

  // Leaves out what lies beyond a plane; null shows all. An open surface has no inside to be hatched.
  cutBy(plane: three.Plane | null): void {
    const planes = plane ? [plane] : null;
    for (const part of [this.faces, this.lines, ...this.counters]) {
      (part.material as three.Material).clippingPlanes = planes;
    }
    const capped = plane !== null && this.data.closed;
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

  // Every vertex where it is now, one after another.
  *points(): Generator<three.Vector3> {
    const positions = this.faces.geometry.getAttribute("position");
    const point = new three.Vector3();
    for (let i = 0; i < positions.count; i++) yield point.fromBufferAttribute(positions, i).applyMatrix4(this.faces.matrix);
  }
}

function faceGeometry(data: BodyData): three.BufferGeometry {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute("position", new three.BufferAttribute(floats(data.positions), 3));
  geometry.setAttribute("normal", new three.BufferAttribute(shorts(data.normals), 3, true));
  geometry.setIndex(new three.BufferAttribute(counts(data.triangles), 1));
  return geometry;
}

function edgeGeometry(data: BodyData): three.BufferGeometry {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute("position", new three.BufferAttribute(floats(data.positions), 3));
  geometry.setIndex(new three.BufferAttribute(counts(data.edges), 1));
  return geometry;
}

// Counts in the stencil how many faces of one side stand beyond the plane: where backs and fronts differ, it is inside.
function counter(geometry: three.BufferGeometry, side: three.Side): three.Mesh {
  const step = side === three.BackSide ? three.IncrementWrapStencilOp : three.DecrementWrapStencilOp;
  const material = new three.MeshBasicMaterial({
    side, depthWrite: false, depthTest: false, colorWrite: false,
    stencilWrite: true, stencilFunc: three.AlwaysStencilFunc,
    stencilFail: step, stencilZFail: step, stencilZPass: step,
  });
  return new three.Mesh(geometry, material);
}
