// Small pictures that stand in the scene and stay as large on the screen as they are: labels, and the sign of a centroid.

import * as three from "three";

const SHARP = 2; // pixels of the picture a pixel of the page

export function sprite(width: number, height: number, paint: (pen: CanvasRenderingContext2D) => void): three.Sprite {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [SHARP * width, SHARP * height];
  const pen = canvas.getContext("2d")!;
  pen.scale(SHARP, SHARP);
  paint(pen);
  const texture = new three.CanvasTexture(canvas);
  texture.colorSpace = three.SRGBColorSpace;
  const made = new three.Sprite(new three.SpriteMaterial({ map: texture, depthTest: false, toneMapped: false }));
  made.userData.pixels = [width, height];
  made.renderOrder = 2001;
  return made;
}

// To be called before each picture.
export function keepSizes(scene: three.Object3D, unitsAPixel: number): void {
  scene.traverseVisible((part) => {
    const pixels = part.userData.pixels as [number, number] | undefined;
    if (pixels) part.scale.set(pixels[0] * unitsAPixel, pixels[1] * unitsAPixel, 1);
  });
}

const FONT = "600 11px system-ui, sans-serif";

// Text on a ground of its own, beside the point where it stands.
export function label(text: string, ink: string): three.Sprite {
  const measure = document.createElement("canvas").getContext("2d")!;
  measure.font = FONT;
  const width = Math.ceil(measure.measureText(text).width) + 8;
  const made = sprite(width, 16, (pen) => {
    pen.fillStyle = "#ffffffd9";
    pen.beginPath();
    pen.roundRect(0, 0, width, 16, 4);
    pen.fill();
    pen.font = FONT;
    pen.fillStyle = ink;
    pen.textBaseline = "middle";
    pen.fillText(text, 4, 8.5);
  });
  made.center.set(-6 / width, 0.5);
  return made;
}

// A disc in quarters, black and white by turns.
export function centroidSign(): three.Sprite {
  return sprite(22, 22, (pen) => {
    const disc = (radius: number, from = 0, to = 2 * Math.PI) => {
      pen.beginPath();
      pen.moveTo(11, 11);
      pen.arc(11, 11, radius, from, to);
      pen.fill();
    };
    pen.fillStyle = "#000";
    disc(10);
    pen.fillStyle = "#fff";
    disc(8.5);
    pen.fillStyle = "#000";
    disc(8.5, 0, Math.PI / 2);
    disc(8.5, Math.PI, 1.5 * Math.PI);
  });
}
