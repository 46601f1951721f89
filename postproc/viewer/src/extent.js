// How far the scene reaches, over all frames.

const REACH = 0.6; // how much of a body beyond the cloth is fitted into the view, over the cloth's largest side
const STATIONS = 24; // frames that are looked at

/** Farthest points of what it is shown, in 26 directions: enough to fit a view to. */
class Outline {
  constructor() {
    this.directions = [];
    for (const x of [-1, 0, 1]) {
      for (const y of [-1, 0, 1]) {
        for (const z of [-1, 0, 1]) {
          const length = Math.hypot(x, y, z);
          if (length > 0) this.directions.push([x / length, y / length, z / length]);
        }
      }
    }
    this.best = new Float64Array(26).fill(-Infinity);
    this.points = new Float32Array(78);
  }

  add(x, y, z) {
    for (let k = 0; k < 26; k += 1) {
      const d = this.directions[k];
      const far = d[0] * x + d[1] * y + d[2] * z;
      if (far <= this.best[k]) continue;
      this.best[k] = far;
      this.points[3 * k] = x;
      this.points[3 * k + 1] = y;
      this.points[3 * k + 2] = z;
    }
  }
}

/** Outermost places of the cloth in all frames and of the near parts of the bodies [m], x, y, z in a row. */
export function shownPoints(about, cloth, bodies) {
  const { codes, nodes } = cloth;
  const outlines = [];
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const frame of stations(about.frames, STATIONS)) {
    const outline = new Outline();
    const start = 3 * frame * nodes;
    for (let k = start; k < start + nodes; k += 1) outline.add(codes[k], codes[k + nodes], codes[k + 2 * nodes]);
    outline.points.forEach((code, k) => {
      const axis = k % 3;
      const value = about.low[axis] + about.quantum * code;
      outline.points[k] = value;
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    });
    outlines.push(outline);
  }
  const reach = REACH * Math.max(...high.map((value, axis) => value - low[axis]), 1e-9);
  const near = (value, axis) => Math.min(high[axis] + reach, Math.max(low[axis] - reach, value));
  eachPlace(about, bodies, (body) => {
    const outline = new Outline();
    body.eachPoint((x, y, z) => outline.add(near(x, 0), near(y, 1), near(z, 2)));
    outlines.push(outline);
  });
  return new Float32Array(outlines.flatMap((outline) => [...outline.points]));
}

/** Lowest height of cloth and bodies in all frames [m]. */
export function lowestOf(about, bodies) {
  let lowest = about.low[2];
  eachPlace(about, bodies, (body) => body.eachPoint((x, y, z) => { lowest = Math.min(lowest, z); }));
  return lowest;
}

/** Mean length of the quads' sides as the cloth is now [m]. */
export function meanSide(cloth) {
  const { quads, position } = cloth;
  let sum = 0;
  for (let q = 0; q < quads.length; q += 4) {
    const [a, b] = [3 * quads[q], 3 * quads[q + 1]];
    sum += Math.hypot(position[b] - position[a], position[b + 1] - position[a + 1], position[b + 2] - position[a + 2]);
  }
  return sum / (quads.length / 4);
}

/** Bodies where they stand; those that move at some of their places. */
function eachPlace(about, bodies, visit) {
  for (const body of bodies) {
    for (const frame of body.path === null ? [0] : stations(about.frames, STATIONS / 2)) {
      body.place(frame, 0);
      visit(body);
    }
    body.place(0, 0);
  }
}

/** So many frames at most, evenly spaced, the first and the last among them. */
function stations(frames, most) {
  const count = Math.min(frames, most);
  return Array.from({ length: count }, (_, k) => Math.round((k * (frames - 1)) / Math.max(1, count - 1)));
}
