import * as THREE from 'three';
import { makeDepthShading } from './depth_shading.js';
import { makeEye } from './eye.js';
import { makeBoxes, makePaths, makePolygons } from './lines.js';
import { makeLights, makeMesh } from './mesh.js';
import { makePoints } from './points.js';
import { makeStops } from './stops.js';

export const kColors = { driven: '#d6336c', planned: '#e17800', boxes: '#e8590c', seen: '#2b8a3e', unseen: '#f03e3e' };

THREE.ColorManagement.enabled = false; // colours are those of the screen, from end to end

// The picture of a scene on a canvas: drawn when something has changed, and only then. Throws without WebGL.
export function makePicture(canvas, scene) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.localClippingEnabled = true;
  renderer.autoClear = false;
  renderer.setClearColor(0x000000, 0);

  const parts = {
    points: makePoints(scene),
    mesh: makeMesh(scene.mesh),
    boxes: makeBoxes(scene.boxes, kColors.boxes),
    driven: makePaths(scene.driven, kColors.driven),
    planned: makePaths(scene.planned, kColors.planned, { latest: true, dashed: true }),
    polygons: makePolygons(scene.polygons, kColors),
    stops: makeStops(scene.stops, kColors.driven),
  };
  const solid = new THREE.Scene(), overlay = new THREE.Scene();
  solid.add(parts.points.object, parts.mesh.object, makeLights());
  overlay.add(parts.boxes.object, parts.polygons.object, parts.planned.object, parts.driven.object, parts.stops.object);
  const shading = makeDepthShading();
  const { uniforms } = parts.points;

  let pending = false;
  const redraw = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => { pending = false; draw(); });
  };
  const eye = makeEye(canvas, scene.bounds, redraw);
  const draw = () => {
    eye.fitDepth(canvas.width / canvas.height);
    uniforms.screenHeight.value = canvas.height;
    parts.stops.setScreen(canvas.clientHeight, eye.camera.fov);
    shading.render(renderer, solid, overlay, eye.camera);
  };
  const resize = () => {
    const { clientWidth, clientHeight } = canvas;
    if (!clientWidth || !clientHeight) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight, false);
    shading.setSize(canvas.width, canvas.height);
    eye.fitDepth(canvas.width / canvas.height);
    draw(); // at once: a resized canvas is empty
  };
  new ResizeObserver(resize).observe(canvas);
  resize();

  const setCut = (height) => {
    uniforms.cut.value = height;
    parts.mesh.setCut(height);
    redraw();
  };
  const setStep = (step) => {
    Object.values(parts).forEach((part) => part.setStep?.(step));
    redraw();
  };
  const setUniform = (name, value) => {
    uniforms[name].value = value;
    redraw();
  };
  const show = (name, visible) => {
    parts[name].object.visible = visible;
    redraw();
  };
  const toDataUrl = () => {
    draw(); // the picture is only there until the browser shows it
    return canvas.toDataURL('image/png');
  };
  return { eye, redraw, setCut, setStep, setUniform, show, toDataUrl };
}
