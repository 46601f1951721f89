// The bar of colours with its ticks in physical units.
import { byId, make } from './dom.js';
import { colourBytes } from './look.js';
import { decimals, decimalsOf, digits, scaleFor, ticks } from './units.js';

/** The factor and the unit in which a field is shown. */
export const scaleOf = (field) => scaleFor(Math.max(Math.abs(field.low), Math.abs(field.high)), field.unit);

/** @param {object | null} field of the description; null hides the legend */
export function showLegend(field, colours) {
  byId('legend').hidden = field === null;
  if (field === null) return;
  paintBar(byId('legend-bar'), colours);
  const { factor, unit } = scaleOf(field);
  byId('legend-title').textContent = `${field.label} [${unit}]`;
  const [low, high] = [field.low * factor, field.high * factor];
  const marks = ticks(low, high, 4);
  const places = decimalsOf(marks);
  const labels = marks.map((mark) => ({ at: (mark - low) / (high - low), text: decimals(mark, places) }));
  if (field.cutAbove) endLabel(labels, 1, `≥ ${digits(high, 2)}`);
  if (field.cutBelow) endLabel(labels, 0, `≤ ${digits(low, 2)}`);
  const spans = labels.map(({ at, text }) => make('span', { style: `left:${(100 * at).toFixed(2)}%` }, text));
  byId('legend-ticks').replaceChildren(...spans);
}

/** The colours go on beyond this end: its label says so and takes the place of a tick that is too near. */
function endLabel(labels, at, text) {
  for (let k = labels.length - 1; k >= 0; k -= 1) {
    if (Math.abs(labels[k].at - at) < 0.16) labels.splice(k, 1);
  }
  labels.push({ at, text });
}

function paintBar(canvas, colours) {
  const context = canvas.getContext('2d');
  const image = context.createImageData(256, 1);
  const rgb = colourBytes(colours);
  for (let k = 0; k < 256; k += 1) image.data.set([rgb[3 * k], rgb[3 * k + 1], rgb[3 * k + 2], 255], 4 * k);
  context.putImageData(image, 0, 0);
}
