import * as THREE from 'three';

// The mesh of the finished map, lit from above, cut open with the points.
export function makeMesh({ positions, indices, rgb }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  if (rgb.length) geometry.setAttribute('color', new THREE.BufferAttribute(rgb, 3, true));
  geometry.computeVertexNormals();
  const cut = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0);
  const material = new THREE.MeshLambertMaterial({
    color: rgb.length ? 0xffffff : 0xc9c4ba, vertexColors: rgb.length > 0, side: THREE.DoubleSide, clippingPlanes: [cut],
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const object = new THREE.Mesh(geometry, material);
  return { object, setCut: (height) => { cut.constant = height; } };
}

export function makeLights() {
  const lights = new THREE.Group();
  const sky = new THREE.HemisphereLight(0xffffff, 0x888888, 2.2);
  sky.position.set(0, 0, 1);
  const sun = new THREE.DirectionalLight(0xffffff, 1.4);
  sun.position.set(0.5, -0.8, 1);
  lights.add(sky, sun);
  return lights;
}
