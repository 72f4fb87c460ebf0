// The face of a cut, hatched as in a technical drawing: lines across the screen, another way for each body.

import * as three from "three";

const VERTEX = `
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

const FRAGMENT = `
uniform vec3 colour;
uniform float slope;
uniform float spacing;
void main() {
  float across = abs(mod(gl_FragCoord.x + slope * gl_FragCoord.y, spacing) - 0.5 * spacing);
  float line = 1.0 - smoothstep(0.06 * spacing, 0.06 * spacing + 1.2, across);
  gl_FragColor = vec4(mix(colour, colour * 0.16, 0.8 * line), 1.0);
  #include <colorspace_fragment>
}`;

// The colour is set where the body's is known.
export function hatched(index: number): three.ShaderMaterial {
  return new three.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      colour: { value: new three.Color() },
      slope: { value: index % 2 ? -1 : 1 },
      spacing: { value: 11 * Math.min(window.devicePixelRatio, 2) },
    },
    side: three.DoubleSide,
    stencilWrite: true, stencilRef: 0, stencilFunc: three.NotEqualStencilFunc,
    stencilFail: three.ReplaceStencilOp, stencilZFail: three.ReplaceStencilOp, stencilZPass: three.ReplaceStencilOp,
  });
}
