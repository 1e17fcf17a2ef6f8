import { decode } from './decode.js';
import { makeLegend, captionOf } from './legend.js';
import * as panel from './panel.js';
import { kColors, makePicture } from './picture.js';
import { colorings } from './points.js';
import style from './style.css';

// The heights at which the map can be cut, and that at which one looks into the rooms.
function cutsOf({ bounds }) {
  const [low, high] = [bounds.min[2], bounds.max[2]];
  return { low, high: high + 0.05, open: low + 0.85 * (high - low) };
}

function viewControls(scene, picture, setCut, setStep) {
  const { views } = picture.eye;
  const cuts = cutsOf(scene);
  const stand = panel.select('Stand where a scan was taken', [
    ['', 'choose …'], ...scene.stops.map((stop, i) => [i, `${stop.step}: ${stop.name}`]),
  ], '', (i) => {
    if (i === '') return;
    setCut(cuts.high);
    views.stand(scene.stops[i]);
  });
  const look = (view) => () => {
    stand.box.value = '';
    setCut(cuts.open);
    view();
  };
  const reset = () => {
    setStep(scene.lastStep);
    look(views.oblique)();
  };
  return panel.group('Look from', panel.button('Oblique', 'from above at an angle', look(views.oblique)),
    panel.button('Top', 'straight from above, nearly to scale', look(views.top)),
    panel.button('Reset', 'the whole map, as at first', reset),
    ...(scene.stops.length ? [stand.object] : []));
}

function pointControls(scene, picture, legend) {
  const usable = colorings.filter((name) => name !== 'reflectance' || scene.points.reflectance);
  const color = (name) => {
    picture.setUniform('coloring', colorings.indexOf(name));
    legend.show(name);
  };
  const usual = Math.min(0.1, Math.max(0.03, 1.3 * scene.points.spacing));
  color('height');
  return panel.group('Points',
    panel.select('Colour by', usable.map((name) => [name, name]), 'height', color).object,
    panel.slider('Size', { min: 0.005, max: 0.15, step: 0.005, value: usual }, (size) => `${(100 * size).toFixed(1)} cm`,
      (size) => picture.setUniform('dotSize', size)).object);
}

function shownControls(scene, picture, legend) {
  const parts = [
    ['points', 'points', scene.points.count, true],
    ['mesh', 'mesh', scene.mesh.triangles, scene.points.count === 0],
    ['stops', 'numbered scans', scene.stops.length, true],
    ['driven', 'driven path', scene.driven.length, true, kColors.driven],
    ['planned', 'planned path', scene.planned.length, true, kColors.planned],
    ['boxes', 'boxes of objects', scene.boxes.length, true, kColors.boxes],
    ['polygons', 'known area: seen, unseen edges', scene.polygons.length, true,
      `linear-gradient(90deg, ${kColors.seen} 50%, ${kColors.unseen} 50%)`],
  ];
  return panel.group('Show', ...parts.filter((part) => part[2]).map(([name, label, , on, color]) =>
    panel.checkbox(label, on, (visible) => {
      picture.show(name, visible);
      if (name === 'points') legend.setVisible(visible);
    }, color)));
}

function growthControl(scene, picture) {
  const nameOf = (step) => scene.stops.filter((stop) => stop.step <= step).at(-1)?.name ?? '';
  return panel.slider('The map after step', { min: 0, max: scene.lastStep, step: 1, value: scene.lastStep },
    (step) => `${step} of ${scene.lastStep}${nameOf(step) ? ` (${nameOf(step)})` : ''}`, picture.setStep);
}

function followTheme(picture, root) {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  const apply = () => picture.setUniform('lightening', dark.matches ? 0.3 : 0);
  dark.addEventListener('change', apply);
  apply();
  root.dataset.ready = 'true';
}

function start(root) {
  const text = (name) => root.querySelector(`script.${name}`).textContent;
  const scene = decode(text('header'), text('arrays'));
  const canvas = panel.element('canvas', { tabindex: 0, role: 'img',
    'aria-label': '3D view of the map. Arrow keys turn it, with shift they move it, plus and minus zoom.' });
  const stage = panel.element('div', { class: 'stage' }, canvas);
  const side = panel.element('div', { class: 'panel', role: 'group', 'aria-label': 'Controls of the 3D view' });
  const frame = panel.element('div', { class: 'frame' }, stage, side);
  root.append(frame);
  let picture;
  try {
    picture = makePicture(canvas, scene);
  } catch (error) {
    frame.replaceWith(panel.element('p', {}, `This browser shows no 3D view, because it has no WebGL (${error.message}). `
      + 'The pictures and tables of this page do not need it.'));
    root.dataset.ready = 'no webgl';
    return;
  }
  const cuts = cutsOf(scene);
  const whole = (height) => height > cuts.high - 0.05; // strays above count as well
  const cut = panel.slider('Cut off above', { min: cuts.low, max: cuts.high, step: 0.05, value: cuts.open },
    (height) => (whole(height) ? 'nothing' : `${height.toFixed(2)} m`),
    (height) => picture.setCut(whole(height) ? 1e6 : height));
  const growth = growthControl(scene, picture);
  const legend = makeLegend(stage, scene);
  side.append(viewControls(scene, picture, cut.set, growth.set), panel.group('Map', ...(scene.lastStep > 0 ? [growth.object] : []), cut.object),
    ...(scene.points.count ? [pointControls(scene, picture, legend)] : []), shownControls(scene, picture, legend));
  root.append(panel.element('p', { class: 'caption' }, captionOf(scene)));
  picture.eye.views.oblique();
  root.picture = picture; // for scripts and tests
  followTheme(picture, root);
}

document.head.append(panel.element('style', {}, style));
document.querySelectorAll('.ariadne-viewer:not([data-ready])').forEach(start);
