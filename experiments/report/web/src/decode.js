// The scene as experiments/report/viewer_data.h writes it, as arrays in metres.

function bytesOf(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// x, y, z in metres, of 16-bit shares of the box.
function places(shares, box) {
  const p = new Float32Array(shares.length);
  for (let i = 0; i < shares.length; ++i) p[i] = box.min[i % 3] + (box.size[i % 3] * shares[i]) / 65535;
  return p;
}

// Which stop each point belongs to, and its reflectance from 0 to 1.
function infoOf(header, reflectance) {
  const info = new Float32Array(2 * header.points.count);
  let i = 0;
  header.stops.forEach((stop, s) => {
    for (const end = i + stop.points; i < end; ++i) {
      info[2 * i] = s;
      info[2 * i + 1] = reflectance.length ? reflectance[i] / 255 : 0.5;
    }
  });
  return info;
}

// The values without one percent at each end.
function robustRange(values) {
  if (!values.length) return [0, 0];
  const sorted = Float32Array.from(values).sort();
  return [sorted[Math.round(0.01 * (sorted.length - 1))], sorted[Math.round(0.99 * (sorted.length - 1))]];
}

// Where things are, apart from stray points far away: a box, and places within it that a view must show.
function boundsOf(scene) {
  const columns = [[], [], []];
  const sample = [];
  for (const cloud of [scene.positions, scene.mesh.positions]) {
    const stride = 3 * Math.ceil(cloud.length / 3 / 20000);
    for (let i = 0; i < cloud.length; i += stride) sample.push([cloud[i], cloud[i + 1], cloud[i + 2]]);
  }
  for (const p of sample) columns.forEach((column, a) => column.push(p[a]));
  const ranges = columns.map(robustRange);
  const certain = scene.stops.map((stop) => stop.position);
  for (const path of [...scene.driven, ...scene.planned]) certain.push(...path.points);
  for (const box of scene.boxes) certain.push(box.center);
  for (const polygon of scene.polygons) {
    for (const corner of polygon.rings[0]) certain.push([corner[0], corner[1], polygon.z]);
  }
  const seen = columns[0].length > 0;
  const at = (a) => certain.map((p) => p[a]).concat(seen ? ranges[a] : []);
  const min = [0, 1, 2].map((a) => Math.min(...at(a))), max = [0, 1, 2].map((a) => Math.max(...at(a)));
  const within = sample.filter((p) => p.every((x, a) => x >= min[a] && x <= max[a]));
  return { min, max, places: within.concat(certain) };
}

function lastStep(header) {
  const all = ['stops', 'boxes', 'driven', 'planned', 'polygons'].flatMap((part) => header[part]);
  return Math.max(0, ...all.map((one) => one.step));
}

export function decode(headerText, arraysText) {
  const scene = JSON.parse(headerText);
  const { buffer } = bytesOf(arraysText);
  let offset = 0;
  const take = (Type, count) => {
    const array = new Type(buffer, offset, count);
    offset += array.byteLength;
    return array;
  };
  const { points, mesh, box } = scene;
  mesh.indices = take(Uint32Array, 3 * mesh.triangles);
  scene.positions = places(take(Uint16Array, 3 * points.count), box);
  mesh.positions = places(take(Uint16Array, 3 * mesh.vertices), box);
  scene.info = infoOf(scene, take(Uint8Array, points.reflectance ? points.count : 0));
  mesh.rgb = take(Uint8Array, mesh.colors ? 3 * mesh.vertices : 0);
  scene.bounds = boundsOf(scene);
  scene.heights = [scene.bounds.min[2], scene.bounds.max[2]];
  scene.lastStep = lastStep(scene);
  return scene;
}
