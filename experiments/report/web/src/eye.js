import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

// Where one looks from: whole views around the middle of the map, and the view of a scanner.
export function makeEye(canvas, bounds, onMove) {
  const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 1000);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.zoomToCursor = true;
  controls.screenSpacePanning = true;
  controls.minDistance = 0.02;
  controls.addEventListener('change', onMove);
  const box = new THREE.Box3(new THREE.Vector3(...bounds.min), new THREE.Vector3(...bounds.max));
  const radius = Math.max(0.5, box.getSize(new THREE.Vector3()).length() / 2);
  let standing = false;

  const place = (position, target, fov, stands) => {
    standing = stands;
    camera.fov = fov;
    camera.position.copy(position);
    controls.target.copy(target);
    controls.enableZoom = controls.enablePan = !stands;
    controls.rotateSpeed = stands ? -0.35 : 1; // standing, one drags the surroundings
    controls.maxDistance = 60 * radius;
    controls.update();
    onMove();
  };

  // Looks along a direction at the middle of the picture, from as near as all places allow.
  const frame = (direction, fov) => {
    const middle = box.getCenter(new THREE.Vector3());
    const probe = new THREE.PerspectiveCamera(fov, camera.aspect, 0.1, 10);
    probe.up.copy(camera.up);
    probe.position.copy(direction);
    probe.lookAt(0, 0, 0);
    probe.updateMatrixWorld();
    const tan = Math.tan((fov * Math.PI) / 360);
    const turned = probe.quaternion.clone().invert();
    const seen = bounds.places.map((p) => new THREE.Vector3(...p).sub(middle).applyQuaternion(turned));
    const centre = (axis) => (Math.min(...seen.map((p) => p[axis])) + Math.max(...seen.map((p) => p[axis]))) / 2;
    const shift = new THREE.Vector3(centre('x'), centre('y'), 0);
    let distance = 0;
    for (const p of seen) {
      const needed = Math.max(Math.abs(p.y - shift.y) / tan, Math.abs(p.x - shift.x) / (tan * camera.aspect));
      distance = Math.max(distance, 1.06 * needed + p.z);
    }
    middle.add(shift.applyQuaternion(probe.quaternion));
    place(middle.clone().addScaledVector(direction.normalize(), distance), middle, fov, false);
  };

  const views = {
    oblique: () => frame(new THREE.Vector3(-0.45, -0.75, 0.85), 30),
    top: () => frame(new THREE.Vector3(0, -1e-3, 1), 6), // from far away, nearly to scale
    stand: (stop) => {
      const position = new THREE.Vector3(...stop.position);
      place(position, position.clone().addScaledVector(new THREE.Vector3(...stop.ahead), 0.05), 75, true);
    },
  };

  const zoom = (factor) => {
    if (standing) {
      camera.fov = Math.min(110, Math.max(10, camera.fov * factor));
      onMove();
    } else if (factor < 1) controls.dollyIn(factor);
    else controls.dollyOut(1 / factor);
  };
  canvas.addEventListener('wheel', (event) => {
    if (!standing) return;
    event.preventDefault();
    zoom(event.deltaY > 0 ? 1.1 : 1 / 1.1);
  }, { passive: false });

  const turn = (x, y, event) => {
    if (event.shiftKey && !standing) return controls.pan(-40 * x, -40 * y);
    controls.rotateLeft(0.1 * x);
    return controls.rotateUp(0.1 * y);
  };
  const keys = {
    ArrowLeft: (event) => turn(1, 0, event),
    ArrowRight: (event) => turn(-1, 0, event),
    ArrowUp: (event) => turn(0, 1, event),
    ArrowDown: (event) => turn(0, -1, event),
    '+': () => zoom(1 / 1.15),
    '-': () => zoom(1.15),
  };
  canvas.addEventListener('keydown', (event) => {
    if (!keys[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key](event);
  });

  // Planes of the frustum as near to the scene as possible, for the precision of depths.
  const fitDepth = (aspect) => {
    const distance = camera.position.distanceTo(box.getCenter(new THREE.Vector3()));
    camera.aspect = aspect;
    camera.near = Math.max(0.05, distance - 3 * radius);
    camera.far = distance + 6 * radius;
    camera.updateProjectionMatrix();
  };
  return { camera, controls, views, fitDepth };
}
