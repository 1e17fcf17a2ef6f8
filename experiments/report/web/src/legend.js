import { element } from './panel.js';

// What the colours of the points mean, in a corner of the picture.
export function makeLegend(stage, scene) {
  const legend = element('div', { class: 'legend' });
  stage.append(legend);
  const bar = (colors, low, high) => [
    element('div', { class: 'bar', style: `background: linear-gradient(90deg, ${colors.join(', ')})` }),
    element('div', { class: 'ends' }, element('span', {}, low), element('span', {}, high)),
  ];
  const show = (coloring) => {
    const [low, high] = scene.heights.map((z) => `${(Math.round(10 * z) / 10 + 0).toFixed(1)} m`);
    const contents = {
      scan: ['one colour per scan'],
      height: bar(scene.colors.height, low, `height ${high}`),
      reflectance: bar(scene.colors.reflectance, 'dark', 'reflectance bright'),
    };
    legend.replaceChildren(...contents[coloring]);
  };
  const setVisible = (visible) => { legend.hidden = !visible; };
  setVisible(scene.points.count > 0);
  return { show, setVisible };
}

const plural = (count, word) => `${count.toLocaleString('en')} ${word}${count === 1 ? '' : 's'}`;

// What there is, how large it is, what was thinned, and how to move.
export function captionOf(scene) {
  const size = [0, 1, 2].map((a) => (scene.bounds.max[a] - scene.bounds.min[a]).toFixed(1));
  const { points, mesh } = scene;
  let text = `${plural(scene.stops.length, 'scan')}, ${plural(points.of, 'point')}, ${size.join(' × ')} m. `;
  if (points.count < points.of) {
    text += `Shown are ${plural(points.count, 'point')}: one per scan in each cube of ${(100 * points.spacing).toFixed(1)} cm. `;
  }
  if (mesh.triangles < mesh.of) {
    text += `The mesh has ${plural(mesh.of, 'triangle')}; shown are ${plural(mesh.triangles, 'triangle')} at ${(100 * mesh.spacing).toFixed(1)} cm. `;
  }
  return `${text}Drag to turn, drag with the right button (or two fingers) to move, scroll to zoom; with the keyboard arrows, shift and arrows, + and −.`;
}
