// node check_page.mjs REPORT.html: opens a page with a 3D view in Chromium and uses everything on it. Ends with 1
// where something is wrong, and with 77 and the reason where there is no browser.
import { spawnSync } from 'node:child_process';
import { pathToFileURL } from 'node:url';
import { openPage, startBrowser } from './browser.mjs';

const kPrograms = ['chromium', 'chromium-browser', 'google-chrome'];
const program = kPrograms.find((name) => spawnSync('sh', ['-c', `command -v ${name}`]).status === 0);
if (!program) {
  console.log('chromium is not installed');
  process.exit(77);
}
const url = pathToFileURL(process.argv[2]).href;
let failures = 0;
const expect = (condition, sentence) => {
  if (condition) return;
  failures += 1;
  console.log(`WRONG: ${sentence}`);
};

const kReady = "document.querySelector('.ariadne-viewer').dataset.ready";
const kPicture = "document.querySelector('.ariadne-viewer').picture";

// Helpers within the page: `share` of the picture that is not empty, `colors` in it; `use` sets a control.
const kHelpers = `
globalThis.look = async () => {
  const image = new Image();
  image.src = ${kPicture}.toDataUrl();
  await image.decode();
  const copy = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
  copy.getContext('2d').drawImage(image, 0, 0);
  const words = new Uint32Array(copy.getContext('2d').getImageData(0, 0, copy.width, copy.height).data.buffer);
  return { share: words.filter((w) => w !== 0).length / words.length, colors: new Set(words).size };
};
globalThis.controls = () => [...document.querySelectorAll('.panel input, .panel select, .panel button')];
globalThis.use = (control) => {
  if (control.type === 'checkbox' || control.type === 'button') return control.click();
  if (control.type === 'range') {
    control.value = (Number(control.min) + Number(control.max)) / 2.2;
    return control.dispatchEvent(new Event('input'));
  }
  const other = [...control.options].find((option) => option.value !== '' && option.value !== control.value);
  control.value = other.value;
  return control.dispatchEvent(new Event('change'));
};
globalThis.nameOf = (control) => control.closest('label')?.textContent || control.textContent;`;

const settle = (page) => page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');

async function checkControls(page) {
  const picture = () => page.evaluate(`${kPicture}.toDataUrl()`);
  const count = await page.evaluate('controls().length');
  expect(count >= 6, `there are only ${count} controls`);
  await page.evaluate("controls().filter((c) => c.type === 'checkbox' && !c.checked).forEach(use)");
  for (let i = 0; i < count; ++i) {
    const name = await page.evaluate(`nameOf(controls()[${i}])`);
    expect(name.length > 2, `control ${i} has no name`);
    const before = await picture();
    await page.evaluate(`use(controls()[${i}])`);
    if (!['Oblique', 'Reset'].includes(name)) expect((await picture()) !== before, `'${name}' changes nothing`);
    await page.evaluate(`controls()[${i}].type === 'checkbox' && use(controls()[${i}])`);
    await page.evaluate("controls().find((c) => c.textContent === 'Reset').click()");
  }
  const first = await picture();
  await page.evaluate("controls().find((c) => c.textContent === 'Top').click()");
  await page.evaluate("controls().find((c) => c.textContent === 'Reset').click()");
  expect((await picture()) === first, 'Reset does not lead back');
}

async function checkHands(page) {
  const view = () => page.evaluate(`JSON.stringify(${kPicture}.eye.camera.matrixWorld.elements)`);
  const mouse = (type, x, y, more) => page.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1, ...more });
  const touch = (type, ...points) => page.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const key = (name) => page.send('Input.dispatchKeyEvent', { type: 'keyDown', key: name });
  const { x, y } = await page.evaluate(`(() => { const c = document.querySelector('.ariadne-viewer canvas'); c.scrollIntoView({ block: 'center' });
    c.focus({ preventScroll: true }); const box = c.getBoundingClientRect(); return { x: box.x + box.width / 2, y: box.y + box.height / 2 }; })()`);
  const hands = {
    'dragging with the mouse': async () => { await mouse('mousePressed', x, y); await mouse('mouseMoved', x + 80, y + 30); await mouse('mouseReleased', x + 80, y + 30); },
    'the wheel': () => mouse('mouseWheel', x, y, { deltaX: 0, deltaY: -240, button: 'none', buttons: 0 }),
    'an arrow key': () => key('ArrowLeft'),
    'the plus key': () => key('+'),
    'a finger': async () => { await touch('touchStart', [x, y]); await touch('touchMove', [x + 90, y]); await touch('touchEnd'); },
    'two fingers': async () => { await touch('touchStart', [x - 50, y], [x + 50, y]); await touch('touchMove', [x - 120, y], [x + 120, y]); await touch('touchEnd'); },
  };
  for (const [name, act] of Object.entries(hands)) {
    const before = await view();
    await act();
    await settle(page);
    expect((await view()) !== before, `${name} does not move the view`);
  }
}

async function checkView() {
  const browser = await startBrowser(program);
  try {
    const page = await openPage(browser, url, { width: 800, height: 500 });
    await page.until(kReady);
    expect((await page.evaluate(kReady)) === 'true', 'there is no picture: the browser has no WebGL');
    await page.evaluate(kHelpers);
    const light = await page.evaluate('look()');
    expect(light.share > 0.02 && light.share < 0.98 && light.colors > 20, `the picture is blank: ${JSON.stringify(light)}`);
    await checkControls(page);
    await checkHands(page);
    const picture = await page.evaluate(`${kPicture}.toDataUrl()`);
    await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: 'dark' }] });
    await settle(page);
    expect((await page.evaluate(`${kPicture}.toDataUrl()`)) !== picture, 'a dark theme looks the same');
    const said = page.eventsOf('Runtime.exceptionThrown', 'Runtime.consoleAPICalled', 'Log.entryAdded').map((event) => JSON.stringify(event.params));
    expect(said.length === 0, `the console says ${said.join('\n').slice(0, 2000)}`);
    const asked = page.eventsOf('Network.requestWillBeSent').map((event) => event.params.request.url).filter((at) => !/^(file|data|blob):/.test(at));
    expect(asked.length === 0, `the page asks for ${asked}`);
  } finally {
    await browser.close();
  }
}

async function checkWithoutWebGl() {
  const browser = await startBrowser(program, ['--disable-3d-apis']);
  try {
    const page = await openPage(browser, url, { width: 800, height: 500 });
    await page.until(kReady);
    const text = await page.evaluate("document.querySelector('.ariadne-viewer').innerText");
    expect(/no WebGL/.test(text), `without WebGL the page says '${text}'`);
  } finally {
    await browser.close();
  }
}

const tooLong = setTimeout(() => { console.log('WRONG: the browser does not answer'); process.exit(1); }, 240000);
await checkView();
await checkWithoutWebGl();
clearTimeout(tooLong);
process.exit(failures ? 1 : 0);
