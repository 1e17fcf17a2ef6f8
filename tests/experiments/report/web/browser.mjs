// Chromium without a display, spoken to over a pipe by the DevTools protocol: no package is needed for it.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kFlags = ['--headless=new', '--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--hide-scrollbars',
  '--disable-dev-shm-usage', '--no-first-run', '--disable-background-networking', '--disable-extensions',
  '--remote-debugging-pipe'];

// Starts the program; `send` calls a method, `events` are those that came, `close` ends it.
export async function startBrowser(program, flags = []) {
  const profile = mkdtempSync(join(tmpdir(), 'ariadne-chromium-'));
  const browser = spawn(program, [...kFlags, ...flags, `--user-data-dir=${profile}`, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const waiting = new Map();
  const events = [];
  let received = '', next = 0;
  browser.stdio[4].on('data', (chunk) => {
    const messages = (received + chunk).split('\0');
    received = messages.pop();
    for (const message of messages.map((text) => JSON.parse(text))) {
      if (message.id === undefined) events.push(message);
      else waiting.get(message.id)(message);
    }
  });
  const send = (method, params = {}, sessionId = undefined) => new Promise((resolve, reject) => {
    const id = ++next;
    waiting.set(id, (answer) => (answer.error ? reject(new Error(`${method}: ${answer.error.message}`)) : resolve(answer.result)));
    browser.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
  });
  const close = async () => {
    const ended = new Promise((resolve) => { browser.on('exit', resolve); });
    send('Browser.close').catch(() => {});
    const impatient = setTimeout(() => browser.kill('SIGKILL'), 10000);
    await ended;
    clearTimeout(impatient);
    try {
      rmSync(profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
    } catch {
      // A process of the browser that ends late still writes there; that is nothing about the page.
    }
  };
  return { send, events, close };
}

// A page of the browser at a file, ready when its 3D views are.
export async function openPage(browser, url, { width = 1200, height = 900, dark = false } = {}) {
  const { targetId } = await browser.send('Target.createTarget', { url: 'about:blank' });
  const { sessionId } = await browser.send('Target.attachToTarget', { targetId, flatten: true });
  const send = (method, params) => browser.send(method, params, sessionId);
  for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await send(`${domain}.enable`);
  await send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
  await send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
  await send('Page.navigate', { url });
  const evaluate = async (expression) => {
    const { result, exceptionDetails } = await send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  const until = async (expression) => {
    while (!(await evaluate(expression))) await new Promise((resolve) => { setTimeout(resolve, 50); });
  };
  await until("document.readyState === 'complete' && location.protocol === 'file:'");
  const screenshot = async () => Buffer.from((await send('Page.captureScreenshot', { format: 'png' })).data, 'base64');
  const eventsOf = (...methods) => browser.events.filter((event) => event.sessionId === sessionId && methods.includes(event.method));
  return { send, evaluate, until, screenshot, eventsOf };
}
