import * as THREE from 'three';
import { segments } from './lines.js';

const kDisc = 64; // [px]

function disc(text, color) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = kDisc;
  const ink = canvas.getContext('2d');
  ink.fillStyle = '#ffffff';
  ink.arc(kDisc / 2, kDisc / 2, kDisc / 2 - 1, 0, 2 * Math.PI);
  ink.fill();
  ink.beginPath();
  ink.fillStyle = color;
  ink.arc(kDisc / 2, kDisc / 2, kDisc / 2 - 5, 0, 2 * Math.PI);
  ink.fill();
  ink.fillStyle = '#ffffff';
  ink.font = `bold ${text.length > 2 ? 24 : 34}px sans-serif`;
  ink.textAlign = 'center';
  ink.textBaseline = 'middle';
  ink.fillText(text, kDisc / 2, kDisc / 2 + 2);
  const texture = new THREE.CanvasTexture(canvas);
  const material = new THREE.SpriteMaterial({ map: texture, sizeAttenuation: false, depthTest: false, depthWrite: false });
  return new THREE.Sprite(material);
}

// A numbered disc for each stop, and an arrow half a metre ahead.
export function makeStops(stops, arrowColor) {
  const object = new THREE.Group();
  const discs = [];
  stops.forEach((stop, i) => {
    const group = new THREE.Group();
    const number = disc(String(stop.step), '#1a1a1a');
    number.position.set(...stop.position);
    number.renderOrder = 3 + i;
    const along = (ahead, aside) => stop.position.map((x, a) => {
      const left = cross(stop.up, stop.ahead)[a];
      return x + ahead * stop.ahead[a] + aside * left;
    });
    const tip = along(0.6, 0);
    const arrow = [stop.position, tip, tip, along(0.42, 0.12), tip, along(0.42, -0.12)];
    group.add(segments(arrow, arrowColor, { width: 3, onTop: true }), number);
    object.add(group);
    discs.push(number);
  });
  const setStep = (step) => object.children.forEach((child, i) => { child.visible = stops[i].step <= step; });
  // Discs stay equally large on the screen.
  const setScreen = (height, fov) => {
    const size = (26 / height) * 2 * Math.tan((fov * Math.PI) / 360);
    discs.forEach((one) => one.scale.set(size, size, 1));
  };
  return { object, setStep, setScreen };
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
