// Times a page: node test/time.mjs PAGE.html [CHROMIUM]
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { launch } from './browser.mjs';

const [file, executable = '/usr/bin/chromium'] = process.argv.slice(2);
const browser = await launch(executable);
const firstFrames = [];
let page;
for (let k = 0; k < 6; k += 1) {
  await page?.close();
  page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(() => window.sundrape?.firstFrame);
  firstFrames.push(Math.round(await page.evaluate(() => window.sundrape.firstFrame)));
}
const played = await page.evaluate(async () => {
  const { sundrape } = window;
  await sundrape.setColour(sundrape.about.fields[0]?.name ?? '');
  sundrape.play();
  const later = (milliseconds) => new Promise((done) => { setTimeout(done, milliseconds); });
  await later(3000);
  let pictures = 0;
  const count = () => {
    pictures += 1;
    requestAnimationFrame(count);
  };
  count();
  await later(5000);
  const perSecond = pictures / 5;
  sundrape.pause();
  sundrape.measure(100); // until the browser has compiled what is called often
  const costs = sundrape.measure(400).sort((a, b) => a - b);
  return { perSecond, median: costs[200], most: costs[380] };
});
await browser.close();
console.log(`first picture: ${firstFrames.slice(1).join(', ')} ms; of the browser's first page: ${firstFrames[0]} ms`);
console.log(`own work a picture: median ${played.median.toFixed(1)} ms, 95 % below ${played.most.toFixed(1)} ms`);
console.log(`pictures a second: ${played.perSecond.toFixed(0)}`);
