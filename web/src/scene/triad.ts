// The axes x, y and z in the lower left corner, as the camera sees them.

import * as three from "three";

const SIDE = 96; // pixels
const COLOURS = ["#d9483b", "#3f9a4a", "#3a78d8"];

export class Triad {
  private readonly scene = new three.Scene();
  private readonly camera = new three.OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.1, 10);

  constructor() {
    COLOURS.forEach((colour, axis) => {
      const direction = new three.Vector3().setComponent(axis, 1);
      const material = new three.MeshBasicMaterial({ color: colour, toneMapped: false });
      const shaft = new three.Mesh(new three.CylinderGeometry(0.035, 0.035, 0.8, 12), material);
      const head = new three.Mesh(new three.ConeGeometry(0.11, 0.28, 16), material);
      shaft.position.y = 0.4;
      head.position.y = 0.9;
      const arrow = new three.Group().add(shaft, head);
      arrow.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), direction);
      const name = letter("xyz".charAt(axis), colour);
      name.position.copy(direction).multiplyScalar(1.28);
      this.scene.add(arrow, name);
    });
  }

  render(renderer: three.WebGLRenderer, camera: three.Camera): void {
    this.camera.quaternion.copy(camera.quaternion);
    this.camera.position.set(0, 0, 5).applyQuaternion(camera.quaternion);
    const full = renderer.getViewport(new three.Vector4());
    renderer.setViewport(6, 6, SIDE, SIDE);
    renderer.clearDepth();
    renderer.render(this.scene, this.camera);
    renderer.setViewport(full);
  }
}

function letter(text: string, colour: string): three.Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d")!;
  pen.font = "italic 600 46px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = colour;
  pen.fillText(text, 32, 32);
  const texture = new three.CanvasTexture(canvas);
  texture.colorSpace = three.SRGBColorSpace;
  const sprite = new three.Sprite(new three.SpriteMaterial({ map: texture, depthTest: false, toneMapped: false }));
  sprite.scale.setScalar(0.52);
  return sprite;
}
