// One diagram of curves over the axis of the slider, with a cursor that moves with it. SVG.
import { draw, make } from './dom.js';
import { decimals, decimalsOf, digits, scaleFor, ticks } from './units.js';

const ROOM = { left: 58, right: 12, top: 22, bottom: 34 }; // pixels about the frame

/**
 * @typedef {object} Curve
 * @property {string} label
 * @property {string} colour
 * @property {string} dashes of SVG
 * @property {ArrayLike<number>} x on the axis of the slider
 * @property {ArrayLike<number | null>} y SI; null and NaN are gaps
 */

export class Plot {
  /**
   * @param {{title: string, unit: string, logarithmic?: boolean, size?: number}} what `size`: of the values that are shown beside
   *   these in the same unit; changes far below it are no curve
   * @param {Curve[]} curves
   * @param {{name: string, unit: string, values: number[]}} axis
   * @param {(x: number) => void} chosen called with the place on the axis that was clicked
   */
  constructor(what, curves, axis, chosen) {
    Object.assign(this, { what, curves, axis, chosen });
    this.element = make('div', { class: 'plot', role: 'img', 'aria-label': `${what.title} over ${axis.name}` });
    this.element.addEventListener('pointerdown', (event) => {
      this.element.setPointerCapture?.(event.pointerId);
      this.choose(event);
    });
    this.element.addEventListener('pointermove', (event) => {
      if (event.buttons & 1) this.choose(event);
    });
  }

  choose(event) {
    const box = this.element.getBoundingClientRect();
    const share = (event.clientX - box.left - ROOM.left) / (box.width - ROOM.left - ROOM.right);
    this.chosen(this.low + Math.min(1, Math.max(0, share)) * (this.high - this.low));
  }

  /** Draws it all for the size that it has now. */
  render() {
    const { width, height } = this.element.getBoundingClientRect();
    if (width < 80 || height < 60) return;
    const { axis, what } = this;
    this.width = width - ROOM.left - ROOM.right;
    this.height = height - ROOM.top - ROOM.bottom;
    [this.low, this.high] = [axis.values[0], axis.values[axis.values.length - 1]];
    if (!(this.high > this.low)) this.high = this.low + 1;
    const extent = extentOf(this.curves, what);
    [this.bottom, this.top] = extent;
    const size = what.size ?? Math.max(Math.abs(this.bottom), Math.abs(this.top));
    this.scale = what.logarithmic ? { factor: 1, unit: '' } : scaleFor(size, what.unit === '1' ? '' : what.unit);
    const time = scaleFor(this.high, axis.unit);

    const svg = draw('svg', { viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' });
    const frame = draw('g', { transform: `translate(${ROOM.left} ${ROOM.top})` });
    svg.append(frame);
    this.drawAcross(frame, time);
    this.drawUp(frame);
    frame.append(draw('rect', { class: 'frame', width: this.width, height: this.height }));
    const unit = this.scale.unit ? ` [${this.scale.unit}]` : '';
    svg.append(draw('text', { class: 'title', x: ROOM.left, y: 14 }, `${what.title}${unit}`));
    const below = `${axis.name}${time.unit ? ` [${time.unit}]` : ''}`;
    svg.append(draw('text', { x: ROOM.left + this.width, y: height - 3, 'text-anchor': 'end' }, below));

    for (const curve of this.curves) {
      const d = this.path(curve);
      frame.append(draw('path', { class: 'curve', d, stroke: curve.colour, 'stroke-dasharray': curve.dashes || null }));
    }
    this.cursor = draw('line', { class: 'cursor', y1: 0, y2: this.height });
    this.dots = this.curves.map((curve) => draw('circle', { class: 'dot', r: 4, fill: curve.colour }));
    this.readout = draw('text', { class: 'readout', x: ROOM.left + this.width, y: 14, 'text-anchor': 'end' });
    frame.append(this.cursor, ...this.dots);
    svg.append(this.readout);
    this.element.replaceChildren(svg);
    if (this.now !== undefined) this.mark(this.now);
  }

  drawAcross(frame, time) {
    const marks = ticks(this.low * time.factor, this.high * time.factor, this.width / 75);
    const places = decimalsOf(marks);
    for (const mark of marks) {
      const x = this.x(mark / time.factor);
      frame.append(draw('line', { class: 'grid', x1: x, x2: x, y1: 0, y2: this.height }));
      frame.append(draw('text', { x, y: this.height + 15, 'text-anchor': 'middle' }, decimals(mark, places)));
    }
  }

  drawUp(frame) {
    if (this.what.logarithmic) {
      const decades = ticks(this.bottom, this.top, this.height / 26).filter((mark) => Number.isInteger(mark));
      for (const mark of decades) this.drawLevel(frame, mark, `1e${mark}`.replace('-', '−'));
      return;
    }
    const { factor } = this.scale;
    const marks = ticks(this.bottom * factor, this.top * factor, this.height / 30);
    const places = decimalsOf(marks);
    for (const mark of marks) this.drawLevel(frame, mark / factor, decimals(mark, places));
  }

  drawLevel(frame, level, text) {
    const y = this.y(level);
    frame.append(draw('line', { class: 'grid', x1: 0, x2: this.width, y1: y, y2: y }));
    frame.append(draw('text', { x: -7, y: y + 4, 'text-anchor': 'end' }, text));
  }

  x(value) { return ((value - this.low) / (this.high - this.low)) * this.width; }
  y(value) { return this.height - ((value - this.bottom) / (this.top - this.bottom)) * this.height; }
  level(value) { return this.what.logarithmic ? Math.log10(value) : value; }

  path({ x, y }) {
    let d = '';
    let pen = 'M';
    for (let k = 0; k < x.length; k += 1) {
      if (!isNumber(y[k])) {
        pen = 'M';
        continue;
      }
      d += `${pen}${this.x(x[k]).toFixed(1)} ${this.y(this.level(y[k])).toFixed(1)}`;
      pen = 'L';
    }
    return d;
  }

  /** Moves the cursor. */
  mark(now) {
    const { what } = this;
    this.now = now;
    if (!this.cursor) return;
    const x = this.x(now).toFixed(1);
    this.cursor.setAttribute('x1', x);
    this.cursor.setAttribute('x2', x);
    const values = this.curves.map((curve) => valueAt(curve, now));
    values.forEach((value, k) => {
      this.dots[k].setAttribute('visibility', isNumber(value) ? 'visible' : 'hidden');
      if (!isNumber(value)) return;
      this.dots[k].setAttribute('cx', x);
      this.dots[k].setAttribute('cy', this.y(this.level(value)).toFixed(1));
    });
    const single = values.length === 1 && isNumber(values[0]);
    const value = Math.abs(values[0]) < 1e-6 * (what.size ?? 0) ? 0 : values[0];
    const text = single ? `${digits(value * this.scale.factor, 4)}${this.scale.unit ? ` ${this.scale.unit}` : ''}` : '';
    this.readout.textContent = text;
  }
}

const isNumber = (value) => value !== null && value !== undefined && Number.isFinite(value);

/** Of a curve, in a line between its points. */
function valueAt({ x, y }, now) {
  let low = 0;
  let high = x.length - 1;
  if (high < 0) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= now) low = middle;
    else high = middle;
  }
  if (high === low || x[high] === x[low]) return y[low];
  const share = Math.min(1, Math.max(0, (now - x[low]) / (x[high] - x[low])));
  if (!isNumber(y[low]) || !isNumber(y[high])) return share < 0.5 ? y[low] : y[high];
  return y[low] + share * (y[high] - y[low]);
}

/** Lowest and highest value, with some room; of a logarithmic diagram their decimal logarithms. */
function extentOf(curves, { logarithmic, size: beside = 0 }) {
  let low = Infinity;
  let high = -Infinity;
  for (const { y } of curves) {
    for (let k = 0; k < y.length; k += 1) {
      if (!isNumber(y[k])) continue;
      const value = logarithmic ? Math.log10(y[k]) : y[k];
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  if (!Number.isFinite(low)) return [0, 1];
  if (logarithmic) return [Math.floor(low), Math.max(Math.ceil(high), Math.floor(low) + 1)];
  const size = Math.max(Math.abs(low), Math.abs(high), beside);
  if (high - low < 1e-4 * size || size < 1e-15) { // hardly any change: the noise of a number is no curve
    const room = Math.max(0.05 * size, 1e-12);
    return [low - room, high + room];
  }
  const room = 0.06 * (high - low);
  return [low - room, high + room];
}
