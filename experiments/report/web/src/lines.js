import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

// Segments (pairs of points, one after another) with a width in pixels.
export function segments(points, color, { width = 2, onTop = false, dashed = false } = {}) {
  const geometry = new LineSegmentsGeometry().setPositions(points.flat());
  const material = new LineMaterial({
    color, linewidth: width, depthTest: !onTop, depthWrite: !onTop, dashed, dashSize: 0.15, gapSize: 0.1,
  });
  const lines = new LineSegments2(geometry, material);
  if (dashed) lines.computeLineDistances();
  lines.renderOrder = onTop ? 1 : 0;
  return lines;
}

const pairs = (points) => points.slice(1).flatMap((p, i) => [points[i], p]);

// A group of objects, one for each of some things with a step. `latest`: only the last of those known is shown.
function stepped(things, make, latest) {
  const object = new THREE.Group();
  things.forEach((thing) => object.add(make(thing)));
  const setStep = (step) => {
    const newest = Math.max(...things.filter((thing) => thing.step <= step).map((thing) => thing.step));
    object.children.forEach((child, i) => {
      child.visible = latest ? things[i].step === newest : things[i].step <= step;
    });
  };
  return { object, setStep };
}

export function makePaths(paths, color, { latest = false, dashed = false } = {}) {
  const longEnough = paths.filter((path) => path.points.length > 1);
  return stepped(longEnough, (path) => segments(pairs(path.points), color, { width: 3, onTop: true, dashed }), latest);
}

export function makePolygons(polygons, colors) {
  return stepped(polygons, (polygon) => {
    const group = new THREE.Group();
    for (const seen of [0, 1]) {
      const edges = polygon.rings.flatMap((ring) => ring.flatMap((corner, i) => {
        const next = ring[(i + 1) % ring.length];
        return corner[2] === seen ? [[corner[0], corner[1], polygon.z], [next[0], next[1], polygon.z]] : [];
      }));
      if (edges.length) group.add(segments(edges, seen ? colors.seen : colors.unseen, { width: 3, onTop: true }));
    }
    return group;
  }, true);
}

export function makeBoxes(boxes, color) {
  return stepped(boxes, ({ center, size, rotation }) => {
    const box = new THREE.BoxGeometry(...size);
    const edges = new THREE.EdgesGeometry(box).getAttribute('position').array;
    const points = Array.from({ length: edges.length / 3 }, (_, i) => [...edges.subarray(3 * i, 3 * i + 3)]);
    const group = new THREE.Group();
    group.add(segments(points, color));
    group.add(new THREE.Mesh(box, new THREE.MeshBasicMaterial({ color, transparent: true, opacity: 0.12, depthWrite: false })));
    group.position.set(...center);
    group.quaternion.set(...rotation);
    return group;
  }, false);
}
