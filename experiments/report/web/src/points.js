import * as THREE from 'three';
import vertexShader from './points.glsl';

const fragmentShader = `
varying vec3 shade;
void main() {
  vec2 fromCentre = gl_PointCoord - 0.5;
  if (dot(fromCentre, fromCentre) > 0.25) discard;
  gl_FragColor = vec4(shade, 1.0);
}`;

export const colorings = ['scan', 'height', 'reflectance'];

function ramp(hexColors, filter) {
  const data = new Uint8Array(hexColors.flatMap((hex) => [1, 3, 5, 7].map((i) => parseInt(hex.slice(i, i + 2) || 'ff', 16))));
  const texture = new THREE.DataTexture(data, hexColors.length, 1);
  texture.minFilter = texture.magFilter = filter;
  texture.needsUpdate = true;
  return texture;
}

// All points, of which a first part is drawn: those of the stops up to a step.
export function makePoints(scene) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(scene.positions, 3));
  geometry.setAttribute('info', new THREE.BufferAttribute(scene.info, 2));
  const uniforms = {
    coloring: { value: 1 },
    heights: { value: new THREE.Vector2(...scene.heights) },
    cut: { value: 0 },
    dotSize: { value: 0.03 },
    screenHeight: { value: 1 },
    lightening: { value: 0 },
    scanColors: { value: ramp(scene.colors.scan, THREE.NearestFilter) },
    heightColors: { value: ramp(scene.colors.height, THREE.LinearFilter) },
    reflectanceColors: { value: ramp(scene.colors.reflectance, THREE.LinearFilter) },
  };
  const object = new THREE.Points(geometry, new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms }));
  object.frustumCulled = false;
  const setStep = (step) => {
    const shown = scene.stops.filter((stop) => stop.step <= step);
    geometry.setDrawRange(0, shown.reduce((sum, stop) => sum + stop.points, 0));
  };
  return { object, uniforms, setStep };
}
