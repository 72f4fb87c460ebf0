// Light from all around for metal to mirror: a grey room with a bright ceiling and three lamps, drawn from formulas.

import * as three from "three";

const WIDTH = 64;
const HEIGHT = 32; // a latitude a row; small, because where software draws, each pixel takes its time

// Lamps: azimuth and height (radians), their half widths, and how bright they are.
const LAMPS = [
  [-2.1, 0.75, 0.5, 0.3, 9],
  [0.4, 0.55, 0.3, 0.35, 6],
  [1.9, 0.3, 0.22, 0.5, 4],
] as const;

export function studio(renderer: three.WebGLRenderer): three.Texture {
  const light = new Float32Array(4 * WIDTH * HEIGHT);
  for (let row = 0; row < HEIGHT; row++) {
    for (let column = 0; column < WIDTH; column++) {
      const height = ((row + 0.5) / HEIGHT - 0.5) * Math.PI;
      const azimuth = ((column + 0.5) / WIDTH - 0.5) * 2 * Math.PI;
      const value = brightness(azimuth, height);
      light.set([value, value, value * 1.03, 1], 4 * (row * WIDTH + column));
    }
  }
  const around = new three.DataTexture(light, WIDTH, HEIGHT, three.RGBAFormat, three.FloatType);
  around.mapping = three.EquirectangularReflectionMapping;
  around.minFilter = around.magFilter = three.LinearFilter;
  around.needsUpdate = true;
  const blurring = new three.PMREMGenerator(renderer);
  const texture = blurring.fromEquirectangular(around).texture;
  blurring.dispose();
  around.dispose();
  return texture;
}

function brightness(azimuth: number, height: number): number {
  let value = 0.45 + 0.55 * smooth(-0.5, 1.2, height);
  for (const [where, high, wide, tall, strength] of LAMPS) {
    const aside = Math.abs(((azimuth - where + 3 * Math.PI) % (2 * Math.PI)) - Math.PI);
    value += strength * (1 - smooth(0.7 * wide, 1.2 * wide, aside)) * (1 - smooth(0.7 * tall, 1.2 * tall, Math.abs(height - high)));
  }
  return value;
}

function smooth(from: number, to: number, at: number): number {
  const t = Math.min(Math.max((at - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}
