// A soft shadow on the floor: points thrown along the light onto a grid and blurred, the high ones more than the low ones.

const SIDE = 128; // cells
const LIGHT = [-0.25, 0.3]; // of the lamp's direction, over its height
const DEPTH = 0.5; // of the darkest shadow

export class Shadow {
  /**
   * @param {number[]} centre of the grid on the floor [m]
   * @param {number} half side of the grid [m]
   * @param {number} radius of what is shown [m]
   */
  constructor(centre, half, radius) {
    this.side = SIDE;
    this.centre = centre;
    this.half = half;
    this.cell = (2 * half) / SIDE;
    this.high = 0.35 * radius; // from here on the blur is wide
    this.bytes = new Uint8Array(SIDE * SIDE);
    this.layers = [new Float32Array(SIDE * SIDE), new Float32Array(SIDE * SIDE)];
    this.spare = new Float32Array(SIDE * SIDE);
  }

  /** Quads, filled with as many points as cells need. */
  addQuads(position, quads) {
    for (let q = 0; q < quads.length; q += 4) {
      const [a, b, c, d] = [3 * quads[q], 3 * quads[q + 1], 3 * quads[q + 2], 3 * quads[q + 3]];
      const longest = Math.max(
        Math.abs(position[c] - position[a]), Math.abs(position[c + 1] - position[a + 1]),
        Math.abs(position[d] - position[b]), Math.abs(position[d + 1] - position[b + 1]),
      );
      const n = Math.min(24, Math.ceil(longest / this.cell) + 1);
      for (let i = 0; i < n; i += 1) {
        const s = (i + 0.5) / n;
        for (let j = 0; j < n; j += 1) {
          const t = (j + 0.5) / n;
          const wa = (1 - s) * (1 - t);
          const wb = s * (1 - t);
          const wc = s * t;
          const wd = (1 - s) * t;
          this.add(
            wa * position[a] + wb * position[b] + wc * position[c] + wd * position[d],
            wa * position[a + 1] + wb * position[b + 1] + wc * position[c + 1] + wd * position[d + 1],
            wa * position[a + 2] + wb * position[b + 2] + wc * position[c + 2] + wd * position[d + 2],
          );
        }
      }
    }
  }

  add(x, y, z) {
    const rise = z - this.centre[2];
    if (rise < -this.cell) return;
    const i = Math.floor((x - rise * LIGHT[0] - this.centre[0] + this.half) / this.cell);
    const j = Math.floor((y - rise * LIGHT[1] - this.centre[1] + this.half) / this.cell);
    if (i < 0 || j < 0 || i >= SIDE || j >= SIDE) return;
    this.layers[rise > this.high ? 1 : 0][j * SIDE + i] = 1;
  }

  clear() {
    for (const layer of this.layers) layer.fill(0);
  }

  /** Blurs what was added, into `this.bytes`. */
  finish() {
    const [low, high] = this.layers;
    const narrow = Math.max(1, Math.round((0.03 * this.high) / 0.35 / this.cell));
    for (let pass = 0; pass < 3; pass += 1) {
      this.blur(low, narrow + 1);
      this.blur(high, 3 * narrow + 2);
    }
    for (let k = 0; k < low.length; k += 1) {
      this.bytes[k] = 255 * (1 - (1 - DEPTH * low[k]) * (1 - 0.7 * DEPTH * high[k]));
    }
  }

  /** Means over 2 reach + 1 cells, across, then down. */
  blur(layer, reach) {
    sweep(layer, this.spare, 1, SIDE, reach);
    sweep(this.spare, layer, SIDE, 1, reach);
  }
}

function sweep(from, to, step, across, reach) {
  const width = 2 * reach + 1;
  for (let line = 0; line < SIDE; line += 1) {
    const start = line * across;
    let sum = 0;
    for (let k = 0; k < reach; k += 1) sum += from[start + k * step];
    for (let k = 0; k < SIDE; k += 1) {
      if (k + reach < SIDE) sum += from[start + (k + reach) * step];
      if (k - reach > 0) sum -= from[start + (k - reach - 1) * step];
      to[start + k * step] = sum / width;
    }
  }
}
