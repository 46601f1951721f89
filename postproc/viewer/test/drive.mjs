// Opens pages in headless Chromium and tells what happened, as JSON on stdout; tests/test_view.py says what should have.
// usage: node drive.mjs TASK.json   with {chromium, page, big, failed, frames, nodes, position}
import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';

const task = JSON.parse(await readFile(process.argv[2], 'utf8'));
const messages = [];
const requests = [];
const LOADS = 4; // the first warms the browser up and does not count

const browser = await launch(task.chromium);

async function open(path, context = {}) {
  const opened = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...context });
  const page = await opened.newPage();
  page.on('console', (message) => {
    if (['error', 'warning', 'assert'].includes(message.type())) messages.push(message.text());
  });
  page.on('pageerror', (error) => messages.push(String(error.stack ?? error)));
  const url = pathToFileURL(path).href;
  page.on('request', (request) => { if (request.url() !== url) requests.push(request.url().slice(0, 200)); });
  await page.goto(url);
  await page.waitForFunction(() => window.sundrape?.firstFrame);
  return page;
}

const state = (page) => page.evaluate(() => {
  const { time, frame, playing, picked, colour } = window.sundrape;
  return { time, frame, playing, picked, colour };
});

/** How far the time goes while it plays, and how long that takes. */
const played = (page, speed) => page.evaluate(async (asked) => {
  const { sundrape } = window;
  sundrape.setFrame(0);
  sundrape.setSpeed(asked);
  document.getElementById('play').click();
  const tick = () => new Promise((resolve) => { requestAnimationFrame(resolve); });
  await tick();
  const [began, from] = [await tick(), sundrape.time];
  let [now, pictures] = [began, 0];
  while (now - began < 500) {
    now = await tick();
    pictures += 1;
  }
  const advanced = sundrape.time - from;
  document.getElementById('play').click();
  const values = sundrape.about.axis.values;
  return { speed: asked, seconds: (now - began) / 1000, advanced, pictures, stands: values.includes(sundrape.time) };
}, speed);

/** Where a place [m] is in the window, from the camera's matrix alone. */
async function pixelOf(page, place) {
  const { matrix, box } = await page.evaluate(() => {
    const { left, top, width, height } = document.getElementById('canvas').getBoundingClientRect();
    return { matrix: window.sundrape.camera, box: { left, top, width, height } };
  });
  const at = [0, 1, 2, 3].map((row) => [...place, 1].reduce((sum, value, column) => sum + matrix[4 * column + row] * value, 0));
  return { x: box.left + ((at[0] / at[3] + 1) / 2) * box.width, y: box.top + ((1 - at[1] / at[3]) / 2) * box.height };
}

/** Pixels of the canvas that differ between two screenshots, by share. */
const differing = (page, one, two) => page.evaluate(async ([a, b]) => {
  const read = async (text) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
  };
  const [p, q] = [await read(a), await read(b)];
  let count = 0;
  for (let k = 0; k < p.length; k += 4) {
    if (Math.abs(p[k] - q[k]) + Math.abs(p[k + 1] - q[k + 1]) + Math.abs(p[k + 2] - q[k + 2]) > 30) count += 1;
  }
  return count / (p.length / 4);
}, [one, two]);

/** Of the middle of the stage, without the legend and the card. */
async function look(page) {
  const box = await page.locator('#stage').boundingBox();
  const clip = { x: box.x + 0.3 * box.width, y: box.y + 0.25 * box.height, width: 0.4 * box.width, height: 0.5 * box.height };
  return (await page.screenshot({ clip })).toString('base64');
}

const report = {};

report.firstFrames = [];
let page;
for (let k = 0; k < LOADS; k += 1) {
  if (page) await page.context().close();
  page = await open(task.page);
  report.firstFrames.push(await page.evaluate(() => window.sundrape.firstFrame));
}
report.title = await page.title();
report.heading = await page.locator('#title').textContent();

report.played = [await played(page, 0.5), await played(page, 1)];
report.end = await page.evaluate(async () => {
  const { sundrape } = window;
  document.getElementById('loop').click();
  sundrape.setSpeed(2);
  sundrape.setTime(sundrape.about.axis.values.at(-1) - 0.1);
  sundrape.play();
  await new Promise((resolve) => { setTimeout(resolve, 500); });
  document.getElementById('loop').click();
  return { time: sundrape.time, playing: sundrape.playing, last: sundrape.about.axis.values.at(-1) };
});

report.frames = {};
for (const frame of task.frames) {
  await page.locator('#slider').fill(String(frame));
  const positions = await page.evaluate(() => window.sundrape.positions());
  const clock = await page.locator('#clock').textContent();
  const cursor = await page.locator('.plot .cursor').first().evaluate((line) => {
    const width = Number(line.parentNode.querySelector('.frame').getAttribute('width'));
    return Number(line.getAttribute('x1')) / width;
  });
  report.frames[frame] = { ...(await state(page)), positions, clock, cursor };
}

await page.evaluate(() => window.sundrape.setFrame(0));
report.picks = [];
for (const node of task.nodes) {
  const { x, y } = await pixelOf(page, task.position[node]);
  await page.mouse.click(x, y);
  const card = await page.locator('#picked').innerText();
  report.picks.push({ node, picked: (await state(page)).picked, card });
}
await page.evaluate(() => window.sundrape.setFrame(30));
report.marker = await page.evaluate(() => {
  const box = document.querySelector('.mark.picked').getBoundingClientRect();
  return { shown: { x: box.left, y: box.top }, wanted: window.sundrape.project(window.sundrape.picked) };
});
const stage = await page.locator('#stage').boundingBox();
await page.mouse.click(stage.x + 0.5 * stage.width, stage.y + 6);
report.pickedInTheSky = (await state(page)).picked;

const before = await page.evaluate(() => window.sundrape.camera);
await page.mouse.move(stage.x + 500, stage.y + 200);
await page.mouse.down();
await page.mouse.move(stage.x + 620, stage.y + 240, { steps: 4 });
await page.mouse.up();
await page.waitForTimeout(800);
const turned = await page.evaluate(() => window.sundrape.camera);
const pickedByDragging = (await state(page)).picked;
await page.locator('#reset').click();
await page.waitForTimeout(200);
const reset = await page.evaluate(() => window.sundrape.camera);
const apart = (one, two) => Math.max(...one.map((value, k) => Math.abs(value - two[k])));
report.orbit = { turned: apart(before, turned), back: apart(before, reset), pickedByDragging };

report.colours = {};
await page.evaluate(() => window.sundrape.setFrame(60));
const weave = await look(page);
for (const name of await page.locator('#colour option').evaluateAll((options) => options.map((o) => o.value).filter(Boolean))) {
  await page.locator('#colour').selectOption(name);
  await page.waitForFunction((wanted) => window.sundrape.colour === wanted, name);
  const values = await page.evaluate(() => window.sundrape.values());
  report.colours[name] = { changed: await differing(page, weave, await look(page)), legend: await page.locator('#legend').innerText(), values };
}
await page.locator('#colour').selectOption('');
report.legendOfTheWeave = await page.locator('#legend').isVisible();

const plot = await page.locator('.plot').first().boundingBox();
const frameBox = await page.locator('.plot .frame').first().boundingBox();
await page.mouse.click(frameBox.x + 0.25 * frameBox.width, plot.y + plot.height / 2);
report.plotClick = await state(page);
report.axes = await page.locator('.plot').first().locator('text').allTextContents();
await page.locator('#tabs button').nth(1).click();
report.energies = await page.locator('#panels text').allTextContents();
report.chips = await page.locator('#chips button').allTextContents();

await page.locator('#title').click();
const keyed = {};
for (const key of ['Home', 'ArrowRight', 'ArrowRight', 'ArrowLeft', 'End', 'Space']) {
  await page.keyboard.press(key);
  keyed[key] = await state(page);
}
await page.keyboard.press('Space');
await page.keyboard.press('c');
keyed.c = await state(page);
report.keyed = keyed;
await page.context().close();

const phone = await open(task.page, { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
report.phone = await phone.evaluate(() => {
  const small = [];
  const outside = [];
  for (const element of document.querySelectorAll('button, select, input')) {
    const box = element.getBoundingClientRect();
    if (box.width === 0) continue;
    if (box.height < 40 || box.width < 40) small.push(element.id || element.className);
    if (box.left < 0 || box.right > 390) outside.push(element.id || element.className);
  }
  return { scrollWidth: document.documentElement.scrollWidth, small, outside, canvas: document.getElementById('canvas').getBoundingClientRect().toJSON() };
});
const finger = await pixelOf(phone, task.position[task.nodes[0]]);
await phone.touchscreen.tap(finger.x, finger.y);
report.phone.tapped = (await state(phone)).picked;
await phone.locator('#play').tap();
await phone.waitForTimeout(300);
report.phone.playing = (await state(phone)).playing;
await phone.setViewportSize({ width: 844, height: 390 });
await phone.waitForTimeout(200);
report.phone.turnedWidth = await phone.evaluate(() => document.documentElement.scrollWidth);
await phone.context().close();

const failed = await open(task.failed);
report.failed = await failed.locator('#trouble').innerText();
await failed.locator('#info-button').click();
report.failedInfo = await failed.locator('#info').innerText();
await failed.context().close();

const big = await open(task.big);
report.big = { firstFrame: await big.evaluate(() => window.sundrape.firstFrame) };
await big.locator('#colour').selectOption('strain');
await big.waitForFunction(() => window.sundrape.colour === 'strain');
report.big.played = await played(big, 0.5);
await big.evaluate(() => window.sundrape.measure(100)); // until the browser has compiled what is called often
report.big.costs = await big.evaluate(() => window.sundrape.measure(300));
await big.context().close();

await browser.close();
console.log(JSON.stringify({ ...report, messages, requests }));
